// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/SideLayout.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
/// Radians: a smaller angle between two curves of a side face is a corner.
constexpr double CornerAngle = 0.75 * Pi;

bool contains(const std::vector<Index>& sorted, Index value)
{
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

/// The angles of a face's triangles at a point, together.
std::map<Index, double> anglesAt(
  const AssemblyComplex& complex, const ComplexFace& face, const std::set<Index>& points)
{
  std::map<Index, double> angles;
  for (const Index t : face.triangles)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index point = complex.triangles(t, c);
      if (points.count(point) > 0)
      {
        const Eigen::RowVector3d here = complex.points.row(point);
        const Eigen::RowVector3d a = complex.points.row(complex.triangles(t, (c + 1) % 3)) - here;
        const Eigen::RowVector3d b = complex.points.row(complex.triangles(t, (c + 2) % 3)) - here;
        angles[point] += std::atan2(a.cross(b).norm(), a.dot(b));
      }
    }
  }
  return angles;
}

[[noreturn]] void refuseFace(
  const AssemblyComplex& complex, const ComplexFace& face, const std::string& why)
{
  throw InvalidInput("face " + std::to_string(face.id) + " at " +
    describe(complex.points.row(complex.triangles(face.triangles.front(), 0))) + " " + why);
}

bool hasCurve(const std::vector<DirectedUse>& uses, Index curve)
{
  return std::any_of(
    uses.begin(), uses.end(), [curve](const DirectedUse& use) { return use.use.curve == curve; });
}

/// The way the grid turns at a point of a rim, in right angles to the left, by the angle within.
int turnAt(double angle)
{
  return 2 - static_cast<int>(std::lround(angle / (0.5 * Pi)));
}

/// Directions along a loop, the curve in row `start` having `direction`.
/// @return what the turns add up to, in right angles.
int direct(const AssemblyComplex& complex, const std::vector<CurveUse>& loop, std::size_t start,
  int direction, const std::map<Index, double>& angles, std::vector<DirectedUse>& rim)
{
  int turns = 0;
  const std::size_t n = loop.size();
  for (std::size_t k = 0; k < n; ++k)
  {
    const CurveUse& use = loop[(start + k) % n];
    if (k > 0)
    {
      turns += turnAt(angles.at(firstPointOf(complex, use)));
    }
    rim.push_back({ use, (((direction + turns) % 4) + 4) % 4 });
  }
  return turns + turnAt(angles.at(firstPointOf(complex, loop[start])));
}

std::map<Index, double> anglesOf(const AssemblyComplex& complex, const ComplexFace& face)
{
  std::set<Index> vertices;
  for (const std::vector<CurveUse>& loop : face.loops)
  {
    for (const CurveUse& use : loop)
    {
      vertices.insert(firstPointOf(complex, use));
    }
  }
  return anglesAt(complex, face, vertices);
}

/// The loops of a face with directions; the given curve has layers above it.
void layOutPolygon(
  const AssemblyComplex& complex, const ComplexFace& face, Index curve, SideFace& side)
{
  const std::string refusal =
    "has corners that are no right angles, or a face inside it that has none: quads in rows and "
    "layers do not fit on it. Cut it into faces with four corners, or sweep the volume between "
    "other caps.";
  const std::map<Index, double> angles = anglesOf(complex, face);
  const auto has = [curve](const CurveUse& use) { return use.curve == curve; };
  for (const bool outer : { true, false })
  {
    for (const std::vector<CurveUse>& loop : face.loops)
    {
      const auto start = std::find_if(loop.begin(), loop.end(), has);
      std::vector<DirectedUse> rim;
      const int turns = direct(complex, loop,
        start == loop.end() ? 0 : static_cast<std::size_t>(start - loop.begin()), 0, angles, rim);
      if ((turns == 4) != outer)
      {
        continue;
      }
      if (turns != 4 && turns != -4)
      {
        refuseFace(complex, face, refusal);
      }
      side.rims.push_back(std::move(rim));
    }
  }
  // What reaches the face is on its outer rim: a hole is turned as it lies to that.
  if (side.rims.size() != face.loops.size() || side.rims.size() > 2 ||
    curvesAlong(side, 0).empty() || !hasCurve(side.rims.front(), curve))
  {
    refuseFace(complex, face, refusal);
  }
  if (side.rims.size() == 2)
  {
    const std::vector<DirectedUse>& outer = side.rims.front();
    std::size_t corners = 0;
    for (std::size_t k = 0; k < outer.size(); ++k)
    {
      corners += outer[k].direction != outer[(k + 1) % outer.size()].direction ? 1 : 0;
    }
    if (corners != 4)
    {
      refuseFace(complex, face, refusal);
    }
    SideFace whole;
    whole.rims.push_back(side.rims.front());
    const Eigen::RowVector3d chord = chordOf(complex, { side.rims[1].front() });
    int best = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (int direction = 0; direction < 4; ++direction)
    {
      const double along = chord.dot(chordOf(complex, curvesAlong(whole, direction)).normalized());
      if (along > most)
      {
        most = along;
        best = direction;
      }
    }
    for (DirectedUse& use : side.rims[1])
    {
      use.direction = (use.direction + best) % 4;
    }
  }
}

/// Cuts the rim of a face with four corners into chains; chain 0 is the one with a given curve.
void layOutQuadrilateral(
  const AssemblyComplex& complex, const ComplexFace& face, Index curve, SideFace& side)
{
  const std::vector<CurveUse>& loop = face.loops.front();
  std::vector<std::pair<double, Index>> byAngle;
  for (const auto& [point, angle] : anglesOf(complex, face))
  {
    byAngle.emplace_back(angle, point);
  }
  std::sort(byAngle.begin(), byAngle.end());
  const bool hasFour = byAngle.size() >= 4 && byAngle[3].first < CornerAngle &&
    (byAngle.size() == 4 || byAngle[4].first > CornerAngle);
  const bool isConvex = byAngle.back().first < 2.0 * Pi - CornerAngle;
  if (!hasFour || !isConvex)
  {
    layOutPolygon(complex, face, curve, side);
    return;
  }
  std::set<Index> corners;
  for (std::size_t k = 0; k < 4; ++k)
  {
    corners.insert(byAngle[k].second);
  }
  const std::size_t n = loop.size();
  std::size_t start = 0;
  while (loop[start].curve != curve)
  {
    ++start;
  }
  while (corners.count(firstPointOf(complex, loop[start])) == 0)
  {
    start = (start + n - 1) % n;
  }
  std::size_t chain = 0;
  for (std::size_t k = 0; k < n; ++k)
  {
    const CurveUse& use = loop[(start + k) % n];
    if (k > 0 && corners.count(firstPointOf(complex, use)) > 0)
    {
      ++chain;
    }
    side.chains[chain].push_back(use);
  }
}

/// Whether both loops of a face lie round each other like those of a tube: neither has corners, or
/// they turn as little as a tube's do.
bool isTube(const AssemblyComplex& complex, const ComplexFace& face)
{
  const std::map<Index, double> angles = anglesOf(complex, face);
  return std::all_of(face.loops.begin(), face.loops.end(), [&](const std::vector<CurveUse>& loop) {
    std::vector<DirectedUse> rim;
    const bool isClosed = loop.size() == 1;
    return isClosed || direct(complex, loop, 0, 0, angles, rim) == 0;
  });
}

/// Chain 0 begins at a loop with this curve.
std::array<std::vector<CurveUse>, 4> tubeChains(const ComplexFace& face, Index curve)
{
  std::array<std::vector<CurveUse>, 4> chains;
  const auto has = [curve](const CurveUse& use) { return use.curve == curve; };
  const bool isFirst = std::any_of(face.loops[0].begin(), face.loops[0].end(), has);
  chains[0] = face.loops[isFirst ? 0 : 1];
  chains[2] = face.loops[isFirst ? 1 : 0];
  return chains;
}

/// Layers that run along a curve on one face must not end at it on the next.
void checkDirections(const AssemblyComplex& complex, const SweepLayout& layout)
{
  std::map<Index, int> kinds;
  for (const SideFace& side : layout.sides)
  {
    for (int direction = 0; direction < 4; ++direction)
    {
      for (const DirectedUse& use : curvesAlong(side, direction))
      {
        if (kinds.try_emplace(use.use.curve, direction % 2).first->second != direction % 2)
        {
          refuseFace(complex, complex.faces[at(side.face)],
            "has layers that run crosswise to those of its neighbour. Sweep the volume between "
            "other caps.");
        }
      }
    }
  }
}
}

Eigen::RowVector3d chordOf(const AssemblyComplex& complex, const std::vector<DirectedUse>& uses)
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const DirectedUse& use : uses)
  {
    const std::vector<Index>& points = complex.curves[at(use.use.curve)].points;
    const Eigen::RowVector3d chord =
      complex.points.row(points.back()) - complex.points.row(points.front());
    sum += use.use.reversed ? Eigen::RowVector3d(-chord) : chord;
  }
  return sum;
}

std::vector<DirectedUse> curvesAlong(const SideFace& side, int direction)
{
  std::vector<DirectedUse> uses;
  for (const CurveUse& use : side.chains[static_cast<std::size_t>(direction)])
  {
    uses.push_back({ use, direction });
  }
  for (const std::vector<DirectedUse>& rim : side.rims)
  {
    for (const DirectedUse& use : rim)
    {
      if (use.direction == direction)
      {
        uses.push_back(use);
      }
    }
  }
  return uses;
}

SweepLayout layOutSides(const AssemblyComplex& complex, Index volume, std::vector<Index> sources,
  std::vector<Index> targets)
{
  SweepLayout layout;
  layout.sources = std::move(sources);
  layout.targets = std::move(targets);
  std::vector<Index> sides;
  for (const Index face : complex.volumes[at(volume)].faces)
  {
    if (!contains(layout.sources, face) && !contains(layout.targets, face))
    {
      sides.push_back(face);
    }
  }
  // The faces of the sides at each curve.
  std::map<Index, std::vector<Index>> sidesAt;
  for (const Index face : sides)
  {
    for (const std::vector<CurveUse>& loop : complex.faces[at(face)].loops)
    {
      for (const CurveUse& use : loop)
      {
        sidesAt[use.curve].push_back(face);
      }
    }
  }
  const auto touches = [&](Index curve, const std::vector<Index>& caps) {
    const std::vector<Index>& faces = complex.curves[at(curve)].faces;
    return std::any_of(
      faces.begin(), faces.end(), [&](Index face) { return contains(caps, face); });
  };
  std::deque<std::pair<Index, Index>> reached; // face, curve by which it was reached
  for (const auto& [curve, faces] : sidesAt)
  {
    if (touches(curve, layout.sources))
    {
      reached.emplace_back(faces.front(), curve);
    }
  }
  std::map<Index, std::size_t> rowOf;
  while (!reached.empty())
  {
    const auto [row, curve] = reached.front();
    reached.pop_front();
    const ComplexFace& face = complex.faces[at(row)];
    const auto known = rowOf.find(row);
    if (known != rowOf.end())
    {
      if (!hasCurve(curvesAlong(layout.sides[known->second], 0), curve))
      {
        refuseFace(complex, face,
          "is reached by the layers of the sweep from two sides. Sweep the volume between other "
          "caps.");
      }
      continue;
    }
    SideFace side;
    side.face = row;
    if (face.loops.size() == 1)
    {
      layOutQuadrilateral(complex, face, curve, side);
    }
    else if (face.loops.size() == 2 && isTube(complex, face))
    {
      side.chains = tubeChains(face, curve);
    }
    else
    {
      layOutPolygon(complex, face, curve, side);
    }
    rowOf[row] = layout.sides.size();
    layout.sides.push_back(side);
    for (const DirectedUse& top : curvesAlong(side, 2))
    {
      if (touches(top.use.curve, layout.targets))
      {
        continue;
      }
      for (const Index next : sidesAt[top.use.curve])
      {
        if (next != row)
        {
          reached.emplace_back(next, top.use.curve);
        }
      }
    }
  }
  for (const Index face : sides)
  {
    if (rowOf.count(face) == 0)
    {
      refuseFace(complex, complex.faces[at(face)],
        "is not reached by layers that begin at the source cap. Sweep the volume between other "
        "caps.");
    }
  }
  checkDirections(complex, layout);
  return layout;
}
}

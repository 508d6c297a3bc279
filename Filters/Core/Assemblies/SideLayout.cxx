// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/SideLayout.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <cmath>
#include <deque>
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

Index firstPointOf(const AssemblyComplex& complex, const CurveUse& use)
{
  const std::vector<Index>& points = complex.curves[at(use.curve)].points;
  return use.reversed ? points.back() : points.front();
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

/// Cuts the loop of a face at its four corners; chain 0 is the one with a given curve.
std::array<std::vector<CurveUse>, 4> chainsOf(
  const AssemblyComplex& complex, const ComplexFace& face, Index curve)
{
  const std::vector<CurveUse>& loop = face.loops.front();
  std::set<Index> vertices;
  for (const CurveUse& use : loop)
  {
    vertices.insert(firstPointOf(complex, use));
  }
  std::vector<std::pair<double, Index>> byAngle;
  for (const auto& [point, angle] : anglesAt(complex, face, vertices))
  {
    byAngle.emplace_back(angle, point);
  }
  std::sort(byAngle.begin(), byAngle.end());
  if (byAngle.size() < 4 || byAngle[3].first > CornerAngle ||
    (byAngle.size() > 4 && byAngle[4].first < CornerAngle))
  {
    refuseFace(complex, face,
      "has not four corners: quads in rows and layers do not fit on it. Cut it into faces that "
      "have, or sweep the volume between other caps.");
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
  std::array<std::vector<CurveUse>, 4> chains;
  std::size_t chain = 0;
  for (std::size_t k = 0; k < n; ++k)
  {
    const CurveUse& use = loop[(start + k) % n];
    if (k > 0 && corners.count(firstPointOf(complex, use)) > 0)
    {
      ++chain;
    }
    chains[chain].push_back(use);
  }
  return chains;
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

bool hasCurve(const std::vector<CurveUse>& chain, Index curve)
{
  return std::any_of(
    chain.begin(), chain.end(), [curve](const CurveUse& use) { return use.curve == curve; });
}

/// Layers that run along a curve on one face must not end at it on the next.
void checkDirections(const AssemblyComplex& complex, const SweepLayout& layout)
{
  std::map<Index, std::size_t> kinds;
  for (const SideFace& side : layout.sides)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      for (const CurveUse& use : side.chains[c])
      {
        if (kinds.try_emplace(use.curve, c % 2).first->second != c % 2)
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
      if (!hasCurve(layout.sides[known->second].chains[0], curve))
      {
        refuseFace(complex, face,
          "is reached by the layers of the sweep from two sides. Sweep the volume between other "
          "caps.");
      }
      continue;
    }
    SideFace side;
    side.face = row;
    const bool isTube = face.loops.size() == 2;
    if (face.loops.size() > 2)
    {
      refuseFace(complex, face,
        "has a hole or another face within: quads in rows and layers do not fit round it. Make it "
        "a source or target cap, or cut the volume there.");
    }
    side.chains = isTube ? tubeChains(face, curve) : chainsOf(complex, face, curve);
    rowOf[row] = layout.sides.size();
    layout.sides.push_back(side);
    for (const CurveUse& use : side.chains[2])
    {
      if (touches(use.curve, layout.targets))
      {
        continue;
      }
      for (const Index next : sidesAt[use.curve])
      {
        if (next != row)
        {
          reached.emplace_back(next, use.curve);
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

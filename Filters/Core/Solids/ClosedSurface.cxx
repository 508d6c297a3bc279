// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/ClosedSurface.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/SolidAngle.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Surfaces/FaceSides.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hexsweep
{
namespace
{
/// Volume over surface area and size below which a closed surface encloses nothing but rounding.
constexpr double EmptyVolume = 1e-14;

Eigen::RowVector3d edgeMiddle(const SolidSurface& solid, const FaceSide& side)
{
  return 0.5 * (solid.points.row(side.low) + solid.points.row(side.high));
}

[[noreturn]] void failAtCrowdedEdge(const SolidSurface& solid, const std::vector<FaceSide>& sides,
  std::size_t first, std::size_t last)
{
  const auto corners = [&](Index t) {
    Eigen::Matrix<Index, 1, 3> row = solid.triangles.row(t);
    std::sort(row.data(), row.data() + 3);
    return row;
  };
  std::string cells;
  for (std::size_t s = first; s < last; ++s)
  {
    for (std::size_t r = first; r < s; ++r)
    {
      if (corners(sides[r].face) == corners(sides[s].face))
      {
        throw InvalidInput("the solid: " + describeCell(solid, sides[r].face) + " and " +
          describeCell(solid, sides[s].face) + " are the same triangle, at " +
          describe(triangleCenter(solid, sides[r].face)) + ". Remove duplicate cells.");
      }
    }
    cells += (s == first         ? ""
                 : s + 1 == last ? " and "
                                 : ", ") +
      describeCell(solid, sides[s].face);
  }
  throw InvalidInput("the solid is not a manifold: " + std::to_string(last - first) +
    " triangles meet at one edge, at " + describe(edgeMiddle(solid, sides[first])) + " (" + cells +
    "). Pass the outer surface of one body: no inner faces, no bodies that share an edge.");
}

[[noreturn]] void failAtOpenEdges(const SolidSurface& solid, const std::vector<FaceSide>& sides)
{
  std::vector<std::size_t> open;
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first == 1)
    {
      open.push_back(first);
    }
  });
  const FaceSide& side = sides[open.front()];
  const Eigen::RowVector3d middle = edgeMiddle(solid, side);
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < open.size(); ++i)
  {
    nearest = std::min(nearest, (edgeMiddle(solid, sides[open[i]]) - middle).norm());
  }
  const double length = (solid.points.row(side.low) - solid.points.row(side.high)).norm();
  throw InvalidInput("the solid is open: " + countOf(open.size(), "edge") +
    (open.size() == 1 ? " has" : " have") + " a triangle on one side only, the first one at " +
    describe(middle) + " (" + describeCell(solid, side.face) + "). " +
    (nearest < 0.25 * length
        ? "The next open edge is only " + describe(nearest) +
          " away: coincident points were not merged. Raise the match tolerance, or merge them "
          "first "
          "(in ParaView: Clean to Grid)."
        : "A face is missing there, or the mesh has a gap: pass the whole boundary of the solid."));
}

/// State of a triangle while neighbours are made to agree.
enum class Turn : char
{
  Unseen,
  Kept,
  Turned
};

/// Pieces that edges join, and how each triangle must be turned to agree with its piece's first.
struct Shells
{
  std::vector<Turn> turns;
  std::vector<Index> shellOfTriangle;
  std::size_t count = 0;
};

Shells findShells(const SolidSurface& solid, const std::vector<Index>& twins)
{
  const auto m = static_cast<std::size_t>(solid.triangles.rows());
  Shells shells{ std::vector<Turn>(m, Turn::Unseen), std::vector<Index>(m, -1), 0 };
  std::vector<Index> stack;
  for (std::size_t seed = 0; seed < m; ++seed)
  {
    if (shells.turns[seed] != Turn::Unseen)
    {
      continue;
    }
    shells.turns[seed] = Turn::Kept;
    stack.push_back(static_cast<Index>(seed));
    while (!stack.empty())
    {
      const Index t = stack.back();
      stack.pop_back();
      shells.shellOfTriangle[static_cast<std::size_t>(t)] = static_cast<Index>(shells.count);
      const Turn own = shells.turns[static_cast<std::size_t>(t)];
      for (Index c = 0; c < 3; ++c)
      {
        const Index twin = twins[static_cast<std::size_t>(3 * t + c)];
        const bool agrees = solid.triangles(t, c) != solid.triangles(twin / 3, twin % 3);
        const Turn wanted = agrees == (own == Turn::Kept) ? Turn::Kept : Turn::Turned;
        Turn& other = shells.turns[static_cast<std::size_t>(twin / 3)];
        if (other == Turn::Unseen)
        {
          other = wanted;
          stack.push_back(twin / 3);
        }
        else if (other != wanted)
        {
          throw InvalidInput("the solid has no inside: its surface cannot be oriented (it closes "
                             "like a Klein bottle), seen at " +
            describe(triangleCenter(solid, twin / 3)) + " (" + describeCell(solid, twin / 3) +
            "). Repair the faces that cross each other.");
        }
      }
    }
    ++shells.count;
  }
  return shells;
}

/// Six times the volume of the tetrahedron from a point to a triangle.
double sixfoldVolume(const SolidSurface& solid, Index t, const Eigen::RowVector3d& origin)
{
  const Eigen::RowVector3d a = solid.points.row(solid.triangles(t, 0)) - origin;
  const Eigen::RowVector3d b = solid.points.row(solid.triangles(t, 1)) - origin;
  const Eigen::RowVector3d c = solid.points.row(solid.triangles(t, 2)) - origin;
  return a.dot(b.cross(c));
}

double signOf(Turn turn)
{
  return turn == Turn::Turned ? -1.0 : 1.0;
}

[[noreturn]] void failOnShells(
  const SolidSurface& solid, const Shells& shells, const std::vector<double>& volumes)
{
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto outer =
    static_cast<Index>(std::max_element(volumes.begin(), volumes.end(), larger) - volumes.begin());
  const auto other = std::find_if(shells.shellOfTriangle.begin(), shells.shellOfTriangle.end(),
    [&](Index shell) { return shell != outer; });
  const Index seen = other - shells.shellOfTriangle.begin();
  const Eigen::RowVector3d eye = solid.points.row(solid.triangles(seen, 0));
  double angle = 0.0;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    if (shells.shellOfTriangle[static_cast<std::size_t>(t)] == outer)
    {
      angle += signOf(shells.turns[static_cast<std::size_t>(t)]) *
        solidAngle(solid.points.row(solid.triangles(t, 0)), solid.points.row(solid.triangles(t, 1)),
          solid.points.row(solid.triangles(t, 2)), eye);
    }
  }
  const std::string where =
    " (" + describeCell(solid, seen) + " at " + describe(triangleCenter(solid, seen)) + ")";
  const std::string number = std::to_string(shells.count) + " closed shells";
  if (std::abs(angle) > InsideAngle)
  {
    throw InvalidInput("the solid has " + number + ": an inner void" + where +
      ". A sweep fills the whole inside: remove the inner shell, or cut the solid so that the void "
      "becomes a hole from cap to cap.");
  }
  throw InvalidInput("the solid has " + number + " side by side, the second one with " +
    where.substr(2, where.size() - 3) + ". Give each body a VolumeId of its own.");
}
}

std::vector<Index> closedTwins(const SolidSurface& solid)
{
  const std::vector<FaceSide> sides = sortedSides(solid.triangles, solid.points.rows());
  std::vector<Index> twins(sides.size());
  bool isOpen = false;
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first > 2)
    {
      failAtCrowdedEdge(solid, sides, first, last);
    }
    isOpen = isOpen || last - first == 1;
    const FaceSide& s = sides[first];
    const FaceSide& t = sides[last - 1];
    twins[static_cast<std::size_t>(3 * s.face + s.corner)] = 3 * t.face + t.corner;
    twins[static_cast<std::size_t>(3 * t.face + t.corner)] = 3 * s.face + s.corner;
  });
  if (isOpen)
  {
    failAtOpenEdges(solid, sides);
  }
  return twins;
}

void checkPointFans(const SolidSurface& solid, const std::vector<Index>& twins)
{
  const auto n = static_cast<std::size_t>(solid.points.rows());
  std::vector<Index> corners(n, 0);
  std::vector<Index> firstTriangle(n, -1);
  for (Index i = solid.triangles.size() - 1; i >= 0; --i)
  {
    const auto p = static_cast<std::size_t>(solid.triangles.data()[i]);
    ++corners[p];
    firstTriangle[p] = i / 3;
  }
  for (std::size_t p = 0; p < n; ++p)
  {
    const Index point = static_cast<Index>(p);
    const auto cornerOf = [&](Index t) {
      return solid.triangles(t, 0) == point ? 0 : solid.triangles(t, 1) == point ? 1 : 2;
    };
    // Round the point, leaving each triangle by the one of its two sides that was not entered.
    const Index start = firstTriangle[p];
    Index side = 3 * start + cornerOf(start);
    Index walked = 0;
    do
    {
      const Index entered = twins[static_cast<std::size_t>(side)];
      const Index t = entered / 3;
      const Index own = 3 * t + cornerOf(t);
      const Index before = 3 * t + (cornerOf(t) + 2) % 3;
      side = entered == own ? before : own;
      ++walked;
    } while (side / 3 != start);
    if (walked != corners[p])
    {
      throw InvalidInput("the solid is not a manifold: parts of it touch in a point only, at " +
        describe(solid.points.row(point)) + " (" + describeCell(solid, start) +
        "). Pull them apart, or join them along an edge.");
    }
  }
}

Triangles outwardTriangles(const SolidSurface& solid, const std::vector<Index>& twins)
{
  const Shells shells = findShells(solid, twins);
  const Eigen::RowVector3d low = solid.points.colwise().minCoeff();
  const Eigen::RowVector3d high = solid.points.colwise().maxCoeff();
  const Eigen::RowVector3d center = 0.5 * (low + high);
  std::vector<double> volumes(shells.count, 0.0);
  double area = 0.0;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const auto shell =
      static_cast<std::size_t>(shells.shellOfTriangle[static_cast<std::size_t>(t)]);
    volumes[shell] +=
      signOf(shells.turns[static_cast<std::size_t>(t)]) * sixfoldVolume(solid, t, center) / 6.0;
    const Eigen::RowVector3d a = solid.points.row(solid.triangles(t, 0));
    const Eigen::RowVector3d u = solid.points.row(solid.triangles(t, 1)) - a;
    const Eigen::RowVector3d v = solid.points.row(solid.triangles(t, 2)) - a;
    area += 0.5 * u.cross(v).norm();
  }
  if (shells.count > 1)
  {
    failOnShells(solid, shells, volumes);
  }
  if (!(std::abs(volumes[0]) > EmptyVolume * area * (high - low).norm()))
  {
    throw InvalidInput("the solid encloses no volume: its surface, from " + describe(low) + " to " +
      describe(high) + ", lies upon itself. Pass the boundary of a solid with a thickness.");
  }
  const Turn wrong = volumes[0] > 0.0 ? Turn::Turned : Turn::Kept;
  Triangles triangles = solid.triangles;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    if (shells.turns[static_cast<std::size_t>(t)] == wrong)
    {
      std::swap(triangles(t, 1), triangles(t, 2));
    }
  }
  return triangles;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SolidBodies.h"

#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/SolidAngle.h"
#include "Core/Surfaces/FaceSides.h"
#include "Core/Surfaces/OpenEdgeWelding.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace hexsweep
{
namespace
{
/// Triangles that hang together, on points of their own: with those of all shells each of many
/// would cost as much as the whole.
struct Shell
{
  std::vector<Index> rows; ///< of the solid's triangles, rising
  Points points;
  Triangles triangles;
  Eigen::RowVector3d low;
  Eigen::RowVector3d high;
};

Triangles weldedTriangles(const SolidInput& solid, const SolidOptions& options)
{
  const std::vector<Index> welded =
    weldOpenEdges(solid.points, solid.triangles, options.matchTolerance);
  Triangles triangles = solid.triangles;
  for (Index i = 0; i < triangles.size(); ++i)
  {
    triangles.data()[i] = welded[static_cast<std::size_t>(triangles.data()[i])];
  }
  return triangles;
}

/// Numbers from 0 on for some ids of a large set, at the cost of those alone.
class LocalNumbers
{
public:
  explicit LocalNumbers(Index size)
    : Number(static_cast<std::size_t>(size), -1)
  {
  }
  Index of(Index id)
  {
    Index& number = this->Number[static_cast<std::size_t>(id)];
    if (number < 0)
    {
      number = static_cast<Index>(this->Ids.size());
      this->Ids.push_back(id);
    }
    return number;
  }
  /// The ids by number; the numbers begin anew.
  std::vector<Index> take()
  {
    for (const Index id : this->Ids)
    {
      this->Number[static_cast<std::size_t>(id)] = -1;
    }
    return std::exchange(this->Ids, {});
  }

private:
  std::vector<Index> Number;
  std::vector<Index> Ids;
};

/// By first triangles.
std::vector<Shell> findShells(const SolidInput& solid, const SolidOptions& options)
{
  const Triangles triangles = weldedTriangles(solid, options);
  const std::vector<FaceSide> sides = sortedSides(triangles, solid.points.rows());
  DisjointSets sets(triangles.rows());
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    for (std::size_t s = first + 1; s < last; ++s)
    {
      sets.join(sides[first].face, sides[s].face);
    }
  });
  std::map<Index, Shell> shells;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    shells[sets.find(t)].rows.push_back(t);
  }
  std::vector<Shell> result;
  LocalNumbers numbers(solid.points.rows());
  for (auto& [first, shell] : shells)
  {
    shell.triangles = triangles(shell.rows, Eigen::all);
    for (Index i = 0; i < shell.triangles.size(); ++i)
    {
      shell.triangles.data()[i] = numbers.of(shell.triangles.data()[i]);
    }
    shell.points = solid.points(numbers.take(), Eigen::all);
    shell.low = shell.points.colwise().minCoeff();
    shell.high = shell.points.colwise().maxCoeff();
    result.push_back(std::move(shell));
  }
  return result;
}

/// Whether neighbours can be turned to agree and every edge has two of them; turns them so.
bool orientIfClosed(Shell& shell)
{
  bool closed = true;
  forEachEdge(sortedSides(shell.triangles, shell.points.rows()),
    [&](std::size_t first, std::size_t last) { closed = closed && last - first == 2; });
  if (!closed)
  {
    return false;
  }
  try
  {
    shell.triangles = orientFaces(shell.triangles, "solid");
  }
  catch (const InvalidInput&)
  {
    return false; // is said, with its place, when the body's surface is made
  }
  return true;
}

using Corner = Eigen::RowVector3d;

Corner cornerOf(const Shell& shell, Index t, Index c)
{
  return shell.points.row(shell.triangles(t, c));
}

/// Where a line from `start` meets a triangle, in units of `direction`; nothing where it does not
/// \cite MoellerTrumbore1997.
std::optional<double> hitOf(
  const Shell& shell, Index t, const Corner& start, const Corner& direction)
{
  const Corner a = cornerOf(shell, t, 0);
  const Corner u = cornerOf(shell, t, 1) - a;
  const Corner v = cornerOf(shell, t, 2) - a;
  const Corner p = direction.cross(v);
  const double determinant = u.dot(p);
  const Corner q = (start - a).cross(u);
  const double first = (start - a).dot(p) / determinant;
  const double second = direction.dot(q) / determinant;
  if (determinant == 0.0 || !(first >= 0.0 && second >= 0.0 && first + second <= 1.0))
  {
    return std::nullopt;
  }
  return v.dot(q) / determinant;
}

/// A point well inside a closed shell, whichever way it is oriented: half-way through it behind its
/// largest triangle.
Corner pointInside(const Shell& shell)
{
  double volume = 0.0;
  double largest = 0.0;
  Index from = 0;
  for (Index t = 0; t < shell.triangles.rows(); ++t)
  {
    const Corner a = cornerOf(shell, t, 0) - shell.low;
    const Corner b = cornerOf(shell, t, 1) - shell.low;
    const Corner c = cornerOf(shell, t, 2) - shell.low;
    volume += a.dot(b.cross(c));
    const double area = (b - a).cross(c - a).norm();
    if (area > largest)
    {
      largest = area;
      from = t;
    }
  }
  const Corner a = cornerOf(shell, from, 0);
  const Corner b = cornerOf(shell, from, 1);
  const Corner c = cornerOf(shell, from, 2);
  const Corner start = (a + b + c) / 3.0;
  const Corner inward = (volume > 0.0 ? -1.0 : 1.0) * (b - a).cross(c - a);
  double nearest = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < shell.triangles.rows(); ++t)
  {
    const std::optional<double> hit = hitOf(shell, t, start, inward);
    if (t != from && hit && *hit > 0.0)
    {
      nearest = std::min(nearest, *hit);
    }
  }
  return std::isfinite(nearest) ? Corner(start + 0.5 * nearest * inward) : start;
}

/// A point of the inner shell's surface would not do: bodies may touch.
bool isAround(const Shell& outer, const Shell& inner)
{
  if ((inner.low.array() < outer.low.array()).any() ||
    (inner.high.array() > outer.high.array()).any())
  {
    return false;
  }
  const Corner eye = pointInside(inner);
  double angle = 0.0;
  for (Index t = 0; t < outer.triangles.rows(); ++t)
  {
    angle += solidAngle(cornerOf(outer, t, 0), cornerOf(outer, t, 1), cornerOf(outer, t, 2), eye);
  }
  return std::abs(angle) > InsideAngle;
}

/// Number of the body of each triangle, from 1 on.
std::vector<Index> bodiesOfShells(const SolidInput& solid, const SolidOptions& options)
{
  std::vector<Shell> shells = findShells(solid, options);
  DisjointSets sets(static_cast<Index>(shells.size()));
  if (shells.size() > 1)
  {
    std::vector<bool> isClosed;
    for (Shell& shell : shells)
    {
      isClosed.push_back(orientIfClosed(shell));
    }
    for (std::size_t i = 0; i < shells.size(); ++i)
    {
      for (std::size_t j = 0; j < shells.size(); ++j)
      {
        if (i != j && isClosed[i] && isClosed[j] && isAround(shells[i], shells[j]))
        {
          sets.join(static_cast<Index>(i), static_cast<Index>(j));
        }
      }
    }
  }
  std::vector<Index> bodies(static_cast<std::size_t>(solid.triangles.rows()), 0);
  std::map<Index, Index> numbers;
  for (std::size_t i = 0; i < shells.size(); ++i)
  {
    const Index number =
      numbers.emplace(sets.find(static_cast<Index>(i)), static_cast<Index>(numbers.size()) + 1)
        .first->second;
    for (const Index t : shells[i].rows)
    {
      bodies[static_cast<std::size_t>(t)] = number;
    }
  }
  return bodies;
}

/// Some triangles with the points and quads that are theirs.
SolidInput bodyOf(const SolidInput& solid, const std::vector<Index>& rows, LocalNumbers& points,
  LocalNumbers& quads)
{
  SolidInput body;
  body.triangles = solid.triangles(rows, Eigen::all);
  for (const Index row : rows)
  {
    const auto t = static_cast<std::size_t>(row);
    body.cellIds.push_back(solid.cellIds.empty() ? row : solid.cellIds[t]);
    if (!solid.faceIds.empty())
    {
      body.faceIds.push_back(solid.faceIds[t]);
    }
    if (!solid.quadOfTriangle.empty())
    {
      const Index quad = solid.quadOfTriangle[t];
      body.quadOfTriangle.push_back(quad < 0 ? quad : quads.of(quad));
    }
  }
  const std::vector<Index> quadRows = quads.take();
  body.quads = solid.quads(quadRows, Eigen::all);
  for (const Index quad : quadRows)
  {
    body.quadCellIds.push_back(solid.quadCellIds[static_cast<std::size_t>(quad)]);
  }
  for (Index i = 0; i < body.triangles.size(); ++i)
  {
    body.triangles.data()[i] = points.of(body.triangles.data()[i]);
  }
  for (Index i = 0; i < body.quads.size(); ++i)
  {
    body.quads.data()[i] = points.of(body.quads.data()[i]);
  }
  body.pointIds = points.take();
  body.points = solid.points(body.pointIds, Eigen::all);
  for (Index& id : body.pointIds)
  {
    id = solid.pointIds.empty() ? id : solid.pointIds[static_cast<std::size_t>(id)];
  }
  return body;
}
}

std::vector<SolidBody> solidBodies(
  const SolidInput& solid, const std::vector<Index>& volumeIds, const SolidOptions& options)
{
  checkSolidInput(solid);
  if (!volumeIds.empty() && static_cast<Index>(volumeIds.size()) != solid.triangles.rows())
  {
    throw InvalidInput("the solid has " + std::to_string(solid.triangles.rows()) +
      " triangles but " + std::to_string(volumeIds.size()) + " volume ids. Give one a triangle.");
  }
  const std::vector<Index> bodies = volumeIds.empty() ? bodiesOfShells(solid, options) : volumeIds;
  std::map<Index, std::vector<Index>> rowsOfBody;
  for (std::size_t t = 0; t < bodies.size(); ++t)
  {
    rowsOfBody[bodies[t]].push_back(static_cast<Index>(t));
  }
  std::vector<SolidBody> result;
  if (rowsOfBody.size() == 1)
  {
    result.push_back({ bodies.front(), solid });
    return result;
  }
  LocalNumbers points(solid.points.rows());
  LocalNumbers quads(solid.quads.rows());
  for (const auto& [id, rows] : rowsOfBody)
  {
    result.push_back({ id, bodyOf(solid, rows, points, quads) });
  }
  return result;
}
}

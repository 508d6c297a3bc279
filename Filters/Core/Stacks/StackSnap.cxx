// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/StackSnap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hexsweep
{
namespace
{
constexpr int MostProjections = 30;
constexpr double Reached = 1e-9;   // of the reach
constexpr double PartOfEdge = 0.3; // that a node may move
constexpr double Agree = 0.02;     // of the reach
/// A quad keeps this part of its least sine, or of the second figure where it has more.
constexpr double SnapLoss = 0.9;
constexpr double SnapEnough = 0.3;

/// Least sine of a quad's corners, over the edges' lengths.
double leastCorner(const StackPlane& plane, Index q)
{
  double least = 1.0;
  for (Index c = 0; c < 4; ++c)
  {
    const auto at = [&](Index k) -> Eigen::RowVector2d {
      return plane.mesh.points.row(plane.mesh.quads(q, k % 4)).head<2>();
    };
    const Eigen::RowVector2d ahead = at(c + 1) - at(c);
    const Eigen::RowVector2d back = at(c + 3) - at(c);
    const double sine =
      (ahead.x() * back.y() - ahead.y() * back.x()) / (ahead.norm() * back.norm());
    least = std::isfinite(sine) ? std::min(least, sine) : -1.0;
  }
  return least;
}

/// Of the edges of the quads at each node.
std::vector<double> shortestEdges(const StackPlane& plane)
{
  std::vector<double> shortest(
    static_cast<std::size_t>(plane.mesh.points.rows()), std::numeric_limits<double>::infinity());
  for (Index q = 0; q < plane.mesh.quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      const Index a = plane.mesh.quads(q, c);
      const Index b = plane.mesh.quads(q, (c + 1) % 4);
      const double length = (plane.mesh.points.row(a) - plane.mesh.points.row(b)).norm();
      for (const Index i : { a, b })
      {
        shortest[static_cast<std::size_t>(i)] =
          std::min(shortest[static_cast<std::size_t>(i)], length);
      }
    }
  }
  return shortest;
}

/// A place on all of some faces, near another one.
std::optional<Eigen::RowVector2d> placeOnSides(const ModelGeometry& geometry,
  const StackFrame& frame, const std::map<Index, double>& faces, const Eigen::RowVector2d& start,
  double reach)
{
  Eigen::RowVector2d place = start;
  for (int k = 0; k < MostProjections; ++k)
  {
    double change = 0.0;
    for (const auto& [faceId, height] : faces)
    {
      Points at(1, 3);
      at << place.x(), place.y(), height;
      const auto found = geometry.closestOnFace(faceId, frame.fromFrame(at).row(0));
      if (!found)
      {
        return std::nullopt;
      }
      const Eigen::RowVector2d next = frame.toFrame(Points(*found)).row(0).head<2>();
      change = std::max(change, (next - place).norm());
      place = next;
    }
    if ((place - start).norm() > reach)
    {
      return std::nullopt;
    }
    if (change <= Reached * reach || faces.size() == 1)
    {
      return place;
    }
    if (k + 1 == MostProjections && change <= Agree * reach)
    {
      return place;
    }
  }
  return std::nullopt;
}

/// The mean of the nearest places on some faces.
std::optional<Eigen::RowVector2d> placeBetweenSides(const ModelGeometry& geometry,
  const StackFrame& frame, const std::map<Index, double>& faces, const Eigen::RowVector2d& start,
  double reach)
{
  Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
  for (const auto& [faceId, height] : faces)
  {
    const auto place = placeOnSides(geometry, frame, { { faceId, height } }, start, reach);
    if (!place)
    {
      return std::nullopt;
    }
    sum += *place;
  }
  return sum / static_cast<double>(faces.size());
}
}

NodeSides nodeSides(const StackPlane& plane, const StackColumns& columns, const PointsRef& points,
  const std::vector<Index>& sideFaces)
{
  NodeSides result(static_cast<std::size_t>(plane.mesh.points.rows()));
  for (std::size_t b = 0; b < columns.boundary.size(); ++b)
  {
    const StackQuad& quad = columns.boundary[b];
    if (quad.cap >= 0 || sideFaces[b] < 0)
    {
      continue;
    }
    double height = 0.0;
    for (const Index p : quad.points)
    {
      height += 0.25 * points(p, 2);
    }
    for (const Index p : quad.points)
    {
      const Index node = columns.nodes[static_cast<std::size_t>(p)].node;
      result[static_cast<std::size_t>(node)].emplace(sideFaces[b], height);
    }
  }
  return result;
}

StackSnap snapToSides(const ModelGeometry& geometry, const StackFrame& frame,
  const NodeSides& sides, double reach, StackPlane& plane)
{
  StackSnap result;
  const Points before = plane.mesh.points;
  std::vector<bool> moved(sides.size(), false);
  std::vector<double> least;
  for (Index q = 0; q < plane.mesh.quads.rows(); ++q)
  {
    least.push_back(leastCorner(plane, q));
  }
  const std::vector<double> shortest = shortestEdges(plane);
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    if (sides[i].empty())
    {
      continue;
    }
    const Index row = static_cast<Index>(i);
    const Eigen::RowVector2d start = before.row(row).head<2>();
    const double most = std::min(reach, PartOfEdge * shortest[i]);
    auto place = placeOnSides(geometry, frame, sides[i], start, most);
    if (!place && sides[i].size() > 1)
    {
      // Curves that became one are not on both of theirs.
      place = placeBetweenSides(geometry, frame, sides[i], start, most);
    }
    if (place)
    {
      plane.mesh.points.row(row).head<2>() = *place;
      moved[i] = true;
    }
    else if (sides[i].size() == 1)
    {
      ++result.left;
    }
  }
  for (bool any = true; any;)
  {
    any = false;
    for (Index q = 0; q < plane.mesh.quads.rows(); ++q)
    {
      if (leastCorner(plane, q) >
        SnapLoss * std::min(least[static_cast<std::size_t>(q)], SnapEnough))
      {
        continue;
      }
      for (Index c = 0; c < 4; ++c)
      {
        const Index i = plane.mesh.quads(q, c);
        if (moved[static_cast<std::size_t>(i)])
        {
          plane.mesh.points.row(i) = before.row(i);
          moved[static_cast<std::size_t>(i)] = false;
          ++result.left;
          any = true;
        }
      }
    }
  }
  result.moved = std::count(moved.begin(), moved.end(), true);
  return result;
}
}

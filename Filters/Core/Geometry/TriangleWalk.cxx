// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/TriangleWalk.h"

#include "Core/Common/Errors.h"
#include "Core/Geometry/VisibilityWalk.h"

#include <algorithm>
#include <limits>

namespace hexsweep
{
namespace
{
using Vertex = PlaneTriangulation::Point;
using Triangle = PlaneTriangulation::Triangle;

constexpr std::size_t BlockSize = 4096;

double squaredLength(const Vertex& u)
{
  return u.x * u.x + u.y * u.y;
}

/// Triangles round a vertex that are looked at one by one; a search by boxes costs about as much.
constexpr int MostTurns = 128;

/// Barycentric coordinates of a point that lies in the triangle.
Eigen::RowVector3d coordinatesIn(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& q)
{
  const Vertex u = difference(a, q);
  const Vertex v = difference(b, q);
  const Vertex w = difference(c, q);
  // Rounding may make a small area negative that is not.
  const double atA = std::max(0.0, v.x * w.y - v.y * w.x);
  const double atB = std::max(0.0, w.x * u.y - w.y * u.x);
  const double atC = std::max(0.0, u.x * v.y - u.y * v.x);
  const double sum = atA + atB + atC;
  if (sum > 0.0)
  {
    return { atA / sum, atB / sum, atC / sum };
  }
  return nearestPointOn(a, b, c, q).coordinates;
}
}

TriangleWalk::TriangleWalk(const PlanePointsRef& points, const TrianglesRef& triangles)
  : Mesh(points, triangles)
{
  this->FlippedCorners.reserve(3 * this->flipped().size());
  for (const Index t : this->flipped())
  {
    for (Index c = 3; c-- > 0;)
    {
      const Index v = triangles(t, c);
      this->FlippedCorners.push_back({ points(v, 0), points(v, 1) });
    }
  }
  const Vertex* corners = this->FlippedCorners.data();
  this->FlippedBoxes = BoxTree(this->flipped().size(), [corners](std::size_t i) {
    return boxOf(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
  });
}

/// The triangle that a point on an edge or a vertex belongs to. `side` is one that it lies on.
std::uint32_t TriangleWalk::lowestAround(std::uint32_t side, const Vertex& q)
{
  // Round the vertex that the point lies on; across the edge and back if it lies on none.
  const auto at = [&](std::uint32_t corner) {
    const Vertex& p = this->Mesh.point(corner);
    return p.x == q.x && p.y == q.y;
  };
  const Triangle& first = this->Mesh.triangle(side >> 2);
  const std::uint32_t begin = side & 3;
  const bool atBegin = at(first.corners[begin]);
  const bool atEnd = at(first.corners[nextCorner(begin)]);
  std::uint32_t lowest = side >> 2;
  std::uint32_t current = side;
  int turns = 0;
  do
  {
    current = this->Mesh.triangle(current >> 2).across[current & 3];
    // Beyond a boundary there may be more triangles at this point. Many triangles round a vertex
    // are a search's matter as well.
    if (current == PlaneTriangulation::None || ++turns > MostTurns)
    {
      return this->search(q);
    }
    const std::uint32_t t = current >> 2;
    if (this->Mesh.triangle(t).id < this->Mesh.triangle(lowest).id)
    {
      lowest = t;
    }
    // The point is now at the other end of the side: go on over the side that shares it.
    if (atBegin)
    {
      current = (current & ~3u) | nextCorner(current & 3);
    }
    else if (atEnd)
    {
      current = (current & ~3u) | nextCorner(nextCorner(current & 3));
    }
  } while (current >> 2 != side >> 2);
  return lowest;
}

bool TriangleWalk::inFlipped(const Vertex& q) const
{
  bool found = false;
  this->FlippedBoxes.visitNear(q.x, q.y, 0.0, [&](std::size_t i) {
    const Vertex* corners = &this->FlippedCorners[3 * i];
    found = found || holdsPoint(corners[0], corners[1], corners[2], q);
    return 0.0;
  });
  return found;
}

std::uint32_t TriangleWalk::search(const Vertex& q)
{
  return lowestTriangleAt(this->Mesh, this->boxes(), q);
}

const BoxTree& TriangleWalk::boxes()
{
  if (!this->Boxes)
  {
    this->Boxes = triangleBoxes(this->Mesh);
  }
  return *this->Boxes;
}

TriangleWalk::Place TriangleWalk::locate(const Vertex& q, std::uint32_t start)
{
  std::uint32_t t = PlaneTriangulation::None;
  if (!this->flipped().empty() && this->inFlipped(q))
  {
    t = this->search(q);
  }
  else
  {
    const std::uint32_t arrived = visibilityWalk(this->Mesh, start, q);
    t = arrived == PlaneTriangulation::None ? this->search(q)
      : isInside(arrived)                   ? arrived >> 2
                                            : this->lowestAround(arrived, q);
  }
  const bool outside = t == PlaneTriangulation::None;
  if (outside)
  {
    t = nearestTriangle(this->Mesh, this->boxes(), q);
  }
  const Triangle& triangle = this->Mesh.triangle(t);
  const Vertex& a = this->Mesh.point(triangle.corners[0]);
  const Vertex& b = this->Mesh.point(triangle.corners[1]);
  const Vertex& c = this->Mesh.point(triangle.corners[2]);
  if (outside)
  {
    const TrianglePoint place = nearestPointOn(a, b, c, q);
    return { t, true, place.distance, place.coordinates };
  }
  return { t, false, 0.0, coordinatesIn(a, b, c, q) };
}

LocatedPoints TriangleWalk::locate(const PlanePointsRef& points, const Progress& progress)
{
  LocatedPoints result;
  const std::size_t n = static_cast<std::size_t>(points.rows());
  result.triangles.assign(n, -1);
  result.coordinates.resize(points.rows(), 3);
  if (this->empty())
  {
    result.coordinates.setZero();
    for (Index i = 0; i < points.rows(); ++i)
    {
      result.outside.push_back({ i, std::numeric_limits<double>::infinity() });
    }
    return result;
  }

  const std::vector<CurvePlace> order = hilbertOrder(this->Mesh.curve(), points);
  const std::vector<CurvePlace>& vertices = this->Mesh.order();
  std::size_t vertex = 0;
  // Points and results lie anywhere in memory: fetched and stored block by block, the misses of
  // the cache overlap.
  std::vector<Vertex> block(std::min(n, BlockSize));
  std::vector<Place> places(block.size());
  Vertex last{};
  std::uint32_t lastTriangle = PlaneTriangulation::None;
  for (std::size_t begin = 0; begin < n; begin += BlockSize)
  {
    reportProgress(progress, static_cast<double>(begin) / static_cast<double>(n));
    const std::size_t size = std::min(BlockSize, n - begin);
    for (std::size_t i = 0; i < size; ++i)
    {
      const Index row = static_cast<Index>(order[begin + i].id);
      block[i] = { points(row, 0), points(row, 1) };
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      while (vertex + 1 < vertices.size() && vertices[vertex].key < order[begin + i].key)
      {
        ++vertex;
      }
      const Vertex& q = block[i];
      const Vertex& onCurve = this->Mesh.point(static_cast<std::uint32_t>(vertex));
      const bool fromLast = lastTriangle != PlaneTriangulation::None &&
        squaredLength(difference(q, last)) < squaredLength(difference(q, onCurve));
      places[i] = this->locate(q, fromLast ? lastTriangle : this->Mesh.triangleNear(vertex));
      last = q;
      lastTriangle = places[i].triangle;
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::uint32_t row = order[begin + i].id;
      const Place& place = places[i];
      const Triangle& triangle = this->Mesh.triangle(place.triangle);
      result.triangles[row] = static_cast<Index>(triangle.id);
      for (std::uint32_t k = 0; k < 3; ++k)
      {
        result.coordinates(row, (triangle.first + k) % 3) = place.coordinates[k];
      }
      if (place.outside)
      {
        result.outside.push_back({ static_cast<Index>(row), place.distance });
      }
    }
  }
  std::sort(result.outside.begin(), result.outside.end(),
    [](const OutsidePoint& x, const OutsidePoint& y) { return x.point < y.point; });
  return result;
}
}

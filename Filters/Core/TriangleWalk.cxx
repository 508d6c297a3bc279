// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleWalk.h"

#include "Errors.h"
#include "Predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
using Vertex = PlaneTriangulation::Point;
using Triangle = PlaneTriangulation::Triangle;

constexpr std::uint32_t None = PlaneTriangulation::None;
constexpr std::size_t BlockSize = 4096;

/// A search by boxes costs about as much as this many steps.
constexpr int LongestWalk = 128;

/// Which of two edges is crossed where both part the triangle from the point: bits by chance, so
/// that a walk in a circle does not close.
constexpr std::uint32_t Choices = 0x9e3779b9u;

Eigen::RowVector2d rowOf(const Vertex& p)
{
  return { p.x, p.y };
}

Vertex difference(const Vertex& a, const Vertex& b)
{
  return { a.x - b.x, a.y - b.y };
}

/// Twice the area of the triangle a, b, q, given u = a - q and v = b - q as rounded; its sign is
/// exact: exactly(), asked in doubt, gives orientation(a, b, q).
template <typename Exactly>
double area(const Vertex& u, const Vertex& v, const Exactly& exactly)
{
  const double left = u.x * v.y;
  const double right = u.y * v.x;
  const double difference = left - right;
  return std::abs(difference) > OrientationErrorBound * (std::abs(left) + std::abs(right))
    ? difference
    : static_cast<double>(exactly());
}

double squaredLength(const Vertex& u)
{
  return u.x * u.x + u.y * u.y;
}

/// What walk() returns for a point inside of a triangle: not one of its sides 0, 1, 2.
constexpr std::uint32_t NoSide = 3;

bool isInside(std::uint32_t arrived)
{
  return (arrived & 3u) == NoSide;
}

std::uint32_t next(std::uint32_t corner)
{
  return corner == 2 ? 0 : corner + 1;
}

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

/// A side of the triangle that was found on which the point lies; where it lies on none see
/// isInside(); None where the walk was given up.
std::uint32_t TriangleWalk::walk(std::uint32_t start, const Vertex& q) const
{
  const auto seenFrom = [&](
                          std::uint32_t corner) { return difference(this->Mesh.point(corner), q); };
  const auto exactly = [&](const Triangle& triangle, std::uint32_t corner) {
    return exactOrientation(rowOf(this->Mesh.point(triangle.corners[corner])),
      rowOf(this->Mesh.point(triangle.corners[next(corner)])), rowOf(q));
  };
  const Triangle* triangle = &this->Mesh.triangle(start);
  std::uint32_t side = 4 * start;
  // The ends of `side` as seen from q, which lies left of it.
  Vertex ends[2] = { seenFrom(triangle->corners[0]), seenFrom(triangle->corners[1]) };
  double areaAB = area(ends[0], ends[1], [&] { return exactly(*triangle, 0); });
  if (areaAB < 0.0 && triangle->across[0] != None)
  {
    side = triangle->across[0];
    triangle = &this->Mesh.triangle(side >> 2);
    std::swap(ends[0], ends[1]);
    areaAB = 1.0;
  }
  std::uint32_t choices = Choices;
  for (int step = 0; step < LongestWalk; ++step)
  {
    const std::uint32_t cornerB = next(side & 3);
    const std::uint32_t cornerC = next(cornerB);
    const Vertex c = seenFrom(triangle->corners[cornerC]);
    const double areaBC = area(ends[1], c, [&] { return exactly(*triangle, cornerB); });
    const double areaCA = area(c, ends[0], [&] { return exactly(*triangle, cornerC); });
    const bool beyondBC = areaBC < 0.0;
    const bool beyondCA = areaCA < 0.0;
    // Operators of bits, and not of logic, here and below: which way a walk turns is nothing that
    // a processor could predict.
    if (!(beyondBC | beyondCA))
    {
      const std::uint32_t here = side & ~3u;
      if (areaAB > 0.0 && areaBC > 0.0 && areaCA > 0.0)
      {
        return here | NoSide;
      }
      // Only the first triangle can lie on the wrong side of its first edge.
      return areaAB < 0.0 ? None
                          : (areaAB == 0.0 ? side : here | (areaBC == 0.0 ? cornerB : cornerC));
    }
    choices = (choices >> 1) | (choices << 31);
    std::uint32_t overCA = static_cast<std::uint32_t>(beyondCA) &
      (static_cast<std::uint32_t>(!beyondBC) | (choices & 1u));
    side = triangle->across[overCA ? cornerC : cornerB];
    if (side == None)
    {
      overCA = 1 - overCA;
      if (beyondBC && beyondCA)
      {
        side = triangle->across[overCA ? cornerC : cornerB];
      }
      if (side == None)
      {
        return None;
      }
    }
    // The neighbour has the edge the other way round: C to B, or A to C.
    ends[overCA] = c;
    triangle = &this->Mesh.triangle(side >> 2);
    areaAB = 1.0;
  }
  return None;
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
  const bool atEnd = at(first.corners[next(begin)]);
  std::uint32_t lowest = side >> 2;
  std::uint32_t current = side;
  int turns = 0;
  do
  {
    current = this->Mesh.triangle(current >> 2).across[current & 3];
    // Beyond a boundary there may be more triangles at this point. Many triangles round a vertex
    // are a search's matter as well.
    if (current == None || ++turns > LongestWalk)
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
      current = (current & ~3u) | next(current & 3);
    }
    else if (atEnd)
    {
      current = (current & ~3u) | next(next(current & 3));
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
  std::uint32_t t = None;
  if (!this->flipped().empty() && this->inFlipped(q))
  {
    t = this->search(q);
  }
  else
  {
    const std::uint32_t arrived = this->walk(start, q);
    t = arrived == None   ? this->search(q)
      : isInside(arrived) ? arrived >> 2
                          : this->lowestAround(arrived, q);
  }
  const bool outside = t == None;
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
  std::uint32_t lastTriangle = None;
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
      const bool fromLast = lastTriangle != None &&
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

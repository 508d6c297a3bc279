// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/VisibilityWalk.h"

#include "Core/Common/Predicates.h"

#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
using Vertex = PlaneTriangulation::Point;
using Triangle = PlaneTriangulation::Triangle;

/// A search by boxes costs about as much as this many steps.
constexpr int LongestWalk = 128;

/// Which of two edges is crossed where both part the triangle from the point: bits by chance, so
/// that a walk in a circle does not close.
constexpr std::uint32_t Choices = 0x9e3779b9u;

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
}

std::uint32_t visibilityWalk(
  const PlaneTriangulation& mesh, std::uint32_t start, const PlaneTriangulation::Point& q)
{
  const auto seenFrom = [&](std::uint32_t corner) { return difference(mesh.point(corner), q); };
  const auto exactly = [&](const Triangle& triangle, std::uint32_t corner) {
    return exactOrientation(mesh.point(triangle.corners[corner]).row(),
      mesh.point(triangle.corners[nextCorner(corner)]).row(), q.row());
  };
  const Triangle* triangle = &mesh.triangle(start);
  std::uint32_t side = 4 * start;
  // The ends of `side` as seen from q, which lies left of it.
  Vertex ends[2] = { seenFrom(triangle->corners[0]), seenFrom(triangle->corners[1]) };
  double areaAB = area(ends[0], ends[1], [&] { return exactly(*triangle, 0); });
  if (areaAB < 0.0 && triangle->across[0] != PlaneTriangulation::None)
  {
    side = triangle->across[0];
    triangle = &mesh.triangle(side >> 2);
    std::swap(ends[0], ends[1]);
    areaAB = 1.0;
  }
  std::uint32_t choices = Choices;
  for (int step = 0; step < LongestWalk; ++step)
  {
    const std::uint32_t cornerB = nextCorner(side & 3);
    const std::uint32_t cornerC = nextCorner(cornerB);
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
      return areaAB < 0.0 ? PlaneTriangulation::None
                          : (areaAB == 0.0 ? side : here | (areaBC == 0.0 ? cornerB : cornerC));
    }
    choices = (choices >> 1) | (choices << 31);
    std::uint32_t overCA = static_cast<std::uint32_t>(beyondCA) &
      (static_cast<std::uint32_t>(!beyondBC) | (choices & 1u));
    side = triangle->across[overCA ? cornerC : cornerB];
    if (side == PlaneTriangulation::None)
    {
      overCA = 1 - overCA;
      if (beyondBC && beyondCA)
      {
        side = triangle->across[overCA ? cornerC : cornerB];
      }
      if (side == PlaneTriangulation::None)
      {
        return PlaneTriangulation::None;
      }
    }
    // The neighbour has the edge the other way round: C to B, or A to C.
    ends[overCA] = c;
    triangle = &mesh.triangle(side >> 2);
    areaAB = 1.0;
  }
  return PlaneTriangulation::None;
}
}

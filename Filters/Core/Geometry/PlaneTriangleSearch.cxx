// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/PlaneTriangleSearch.h"

#include "Core/Common/Predicates.h"

#include <limits>

namespace hexsweep
{
namespace
{
using Vertex = PlaneTriangulation::Point;
using Triangle = PlaneTriangulation::Triangle;

/// The distance to a box and that to a triangle in it are rounded differently: boxes that are
/// farther by no more than rounding may hold the triangle of lower id.
constexpr double PlaneTieSlack = 1.0 + 1e-9;
}

bool holdsPoint(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& q)
{
  const Eigen::RowVector2d p = q.row();
  return orientation(a.row(), b.row(), p) >= 0 && orientation(b.row(), c.row(), p) >= 0 &&
    orientation(c.row(), a.row(), p) >= 0;
}

PlaneBox boxOf(const Vertex& a, const Vertex& b, const Vertex& c)
{
  PlaneBox box;
  for (const Vertex* p : { &a, &b, &c })
  {
    box.extend(p->x, p->y);
  }
  return box;
}

TrianglePoint nearestPointOn(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& q)
{
  return closestPointOnTriangle(
    { q.x, q.y, 0.0 }, { a.x, a.y, 0.0 }, { b.x, b.y, 0.0 }, { c.x, c.y, 0.0 });
}

BoxTree triangleBoxes(const PlaneTriangulation& mesh)
{
  return BoxTree(mesh.numberOfTriangles(), [&mesh](std::size_t i) {
    const Triangle& triangle = mesh.triangle(static_cast<std::uint32_t>(i));
    return boxOf(mesh.point(triangle.corners[0]), mesh.point(triangle.corners[1]),
      mesh.point(triangle.corners[2]));
  });
}

std::uint32_t lowestTriangleAt(
  const PlaneTriangulation& mesh, const BoxTree& boxes, const Vertex& q)
{
  std::uint32_t found = PlaneTriangulation::None;
  boxes.visitNear(q.x, q.y, 0.0, [&](std::size_t i) {
    const std::uint32_t t = static_cast<std::uint32_t>(i);
    const Triangle& triangle = mesh.triangle(t);
    if ((found == PlaneTriangulation::None || triangle.id < mesh.triangle(found).id) &&
      holdsPoint(mesh.point(triangle.corners[0]), mesh.point(triangle.corners[1]),
        mesh.point(triangle.corners[2]), q))
    {
      found = t;
    }
    return 0.0;
  });
  return found;
}

std::uint32_t nearestTriangle(const PlaneTriangulation& mesh, const BoxTree& boxes, const Vertex& q)
{
  std::uint32_t found = PlaneTriangulation::None;
  double distance = std::numeric_limits<double>::infinity();
  boxes.visitNear(q.x, q.y, distance, [&](std::size_t i) {
    const std::uint32_t t = static_cast<std::uint32_t>(i);
    const Triangle& triangle = mesh.triangle(t);
    const double own = nearestPointOn(mesh.point(triangle.corners[0]),
      mesh.point(triangle.corners[1]), mesh.point(triangle.corners[2]), q)
                         .distance;
    // Some triangle is found even for a point that is not finite.
    if (found == PlaneTriangulation::None || own < distance ||
      (own == distance && triangle.id < mesh.triangle(found).id))
    {
      found = t;
      distance = own;
    }
    return PlaneTieSlack * distance * distance;
  });
  return found;
}
}

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Searches among the triangles of a plane triangulation, by boxes.
 */
#ifndef hexsweep_PlaneTriangleSearch_h
#define hexsweep_PlaneTriangleSearch_h

#include "Core/Geometry/BoxTree.h"
#include "Core/Geometry/PlaneTriangulation.h"
#include "Core/Geometry/TriangleSearch.h"

namespace hexsweep
{
/// Whether q lies in the positively oriented triangle a, b, c or on its boundary; exact.
bool holdsPoint(const PlaneTriangulation::Point& a, const PlaneTriangulation::Point& b,
  const PlaneTriangulation::Point& c, const PlaneTriangulation::Point& q);

PlaneBox boxOf(const PlaneTriangulation::Point& a, const PlaneTriangulation::Point& b,
  const PlaneTriangulation::Point& c);

/// See closestPointOnTriangle().
TrianglePoint nearestPointOn(const PlaneTriangulation::Point& a, const PlaneTriangulation::Point& b,
  const PlaneTriangulation::Point& c, const PlaneTriangulation::Point& q);

/// The tree that the searches take.
BoxTree triangleBoxes(const PlaneTriangulation& mesh);

/// The triangle of the lowest row of the input that the point lies in, or None.
std::uint32_t lowestTriangleAt(
  const PlaneTriangulation& mesh, const BoxTree& boxes, const PlaneTriangulation::Point& q);

/// The nearest triangle, of several the one of the lowest row; None only if there are none.
std::uint32_t nearestTriangle(
  const PlaneTriangulation& mesh, const BoxTree& boxes, const PlaneTriangulation::Point& q);
}

#endif

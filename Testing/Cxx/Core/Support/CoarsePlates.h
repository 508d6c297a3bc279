// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Caps as CAD tessellates them: plates with round holes and no nodes inside.
 */
#ifndef CoarsePlates_h
#define CoarsePlates_h

#include "Support/CapMeshes.h"

#include "Core/Surfaces/TriangulationImprovement.h"

namespace test
{
/// A hole with a regular polygon of nodes.
struct RoundHole
{
  double x;
  double y;
  double radius;
  Index nodes;
};

/// Twice the signed area of a triangle over the plane.
double turnOf(const Points& points, Index a, Index b, Index c);

/// One closed polygon from the outline and the holes: each hole, the rightmost first, is joined to
/// the node nearest to its rightmost one that it sees.
std::vector<Index> bridged(
  const Points& points, std::vector<Index> polygon, std::vector<std::vector<Index>> holes);

/// Ears cut off a counter-clockwise polygon, the best shaped first.
Triangles earsOf(const Points& points, std::vector<Index> polygon);

/// The Delaunay triangulation of [0, length] x [0, 1] with holes, of the nodes of its loops only;
/// each side of the rectangle is one edge.
TriangleMesh coarsePlate(double length, const std::vector<RoundHole>& holes);

/// A plate with one to three holes of few nodes side by side, at random sizes and places.
TriangleMesh randomCoarsePlate(std::mt19937& generator);
}

#endif

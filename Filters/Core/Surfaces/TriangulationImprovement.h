// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Better triangles for a cap whose own are stretched or have no nodes inside; the surface
 * and its boundary stay as they are (paper, end of section 3).
 *
 * The paper smooths the triangulation before the map. Moving nodes is not enough: even the exact
 * harmonic map, taken at the nodes of a needle, turns the needle over as soon as the needle is
 * thinner than the image of its long side is bent, wherever the other nodes are. So edges are
 * flipped and points added instead, which changes neither the surface nor a given node.
 */
#ifndef hexsweep_TriangulationImprovement_h
#define hexsweep_TriangulationImprovement_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// Whether a cap's triangulation may be changed for its map.
enum class TriangulationImprovement
{
  Off,       ///< never
  Automatic, ///< where the triangulation is bad (see planImprovement()) or the map flips
  On         ///< always
};

/// What is to be done to a triangulation.
struct ImprovementPlan
{
  bool flip = false;   ///< flip edges between coplanar triangles until they are Delaunay
  bool refine = false; ///< insert points until triangles are as small as the loops' edges ask for
};

/**
 * What a cap asks for. Automatic flips where an inner edge weighs less than -10 (equation (1): an
 * angle of 174 degrees across from a right one) and refines where triangles with all corners on
 * loops cover more than half of the cap; On always flips.
 */
ImprovementPlan planImprovement(const TriangleMesh& cap, TriangulationImprovement improvement);

struct ImprovedTriangulation
{
  TriangleMesh mesh; ///< the points given come first, unchanged
  /// Row of the given mesh that contains the middle of each triangle.
  std::vector<Index> triangleOrigin;
  Index flips = 0;
  Index addedPoints = 0;
};

/**
 * Carries out a plan. Edges of the boundary are neither flipped nor split.
 *
 * An edge is flipped only if its four corners lie in one plane up to the rounding of their
 * coordinates (1e-13 of the cap's size). Refinement inserts centroids where a triangle is larger
 * than the sizes at its corners \cite Liepa2003, flips, and halves long edges that are bent; the
 * size at a loop's node is the length of the edges beside it and grows inwards.
 *
 * Triangles beside a long edge of the boundary stay as large as that edge wants: no centroid is
 * inserted inside the circle over an edge of the boundary \cite Ruppert1995, nor closer than the
 * size / sqrt(2) to a point it would be joined to. No step makes a triangle whose height over its
 * longest edge is below both 0.1 and that of the thinnest triangle it replaces; a refinement that
 * ends below half of that is given up. At most 10 points are added for each point.
 *
 * @param mesh an oriented 2-manifold, see checkSurface().
 */
ImprovedTriangulation improveTriangulation(const TriangleMesh& mesh, const ImprovementPlan& plan);

/// Whether an inner edge weighs less than -10, so that weights ought to be intrinsic ones.
bool isStretched(const TriangleMesh& mesh);
}

#endif

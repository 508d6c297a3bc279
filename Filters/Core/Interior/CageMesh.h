// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cage of a swept volume: its closed boundary mesh, in the physical and in the
 * topological model.
 *
 * Section 4.2 of Cai and Tautges (\cite CaiTautges2013): the physical model is the volume to be
 * meshed, the topological model a prism of the same connectivity. Interior nodes are bound to the
 * cage of the second and follow the cage of the first.
 */
#ifndef hexsweep_CageMesh_h
#define hexsweep_CageMesh_h

#include "Core/Common/Mesh.h"
#include "Core/Interior/SweepBoundary.h"

namespace hexsweep
{
/// A closed triangle mesh on the boundary of a swept volume.
struct CageMesh
{
  /// Which of the (L + 1) n swept points are cage vertices, rising. Row k n + i of the swept
  /// points is point i on layer k.
  std::vector<Index> nodes;
  /// Places in `nodes`, counter-clockwise seen from outside the volume.
  Triangles triangles;
};

/**
 * The physical model as far as it is known: the boundary positions bit for bit (see
 * setGivenPoints()), and zero in the interior.
 *
 * @param sourcePoints, targetPoints n x 3, same order.
 * @param quads m x 4, the connectivity of both.
 * @return (L + 1) n x 3, row k n + i is source point i on layer k.
 */
Points physicalModel(const PointsRef& sourcePoints, const PointsRef& targetPoints,
  const QuadsRef& quads, const SweepBoundary& boundary);

/**
 * Boundary quads of a swept mesh, counter-clockwise seen from outside whichever way the quads of
 * the caps face: the sign of the volume that they enclose decides.
 *
 * @param quads    m x 4 ids in [0, n), consistently oriented.
 * @param physical (L + 1) n x 3, the physical model.
 * @param numberOfLayers L >= 1.
 * @return rows 0 to m - 1 the source cap, m to 2 m - 1 the target cap, in the order of `quads`;
 *         then the linking sides, L quads a loop edge. Ids are rows of `physical`.
 * @throw InvalidInput when the quads are no surface (see checkSurface()).
 */
Quads cageQuads(const QuadsRef& quads, const PointsRef& physical, Index numberOfLayers);

/// Volume inside closed quads, each the mean of its two triangulations; positive where they face
/// outwards. Unit of a volume.
double enclosedVolume(const QuadsRef& quads, const PointsRef& points);

/**
 * The shared triangulation of both cages, step 2 of section 4.2.
 *
 * Each boundary quad is cut along one diagonal, the same one in both models. It is the one whose
 * worse triangle, of four (two in each model), is better. A triangle is measured by its area as
 * seen along the normal of its quad over the sum of its squared edge lengths, so that a triangle
 * that is turned over, beside the re-entrant corner of a quad, counts as negative. Where both
 * diagonals are equally good to six digits it is the one from the quad's first corner, so that
 * rounding does not decide.
 *
 * @param cage     boundary quads (cageQuads()).
 * @param physical, model (L + 1) n x 3; only rows on the boundary are read.
 * @return triangles 2 q and 2 q + 1 are quad q.
 */
CageMesh triangulateCage(const QuadsRef& cage, const PointsRef& physical, const PointsRef& model);

/// Rows of the cage's vertices, in the order of `nodes`.
Points cageVertices(const CageMesh& cage, const PointsRef& sweptPoints);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Puts the nodes of divided curves into a cap's triangulation, and finds them again once it
 * has been remeshed.
 */
#ifndef hexsweep_CurveNodes_h
#define hexsweep_CurveNodes_h

#include "Core/CapQuads/CapCurves.h"
#include "Core/CapQuads/RemeshingMesh.h"

#include <utility>

namespace hexsweep
{
/// A cap that has a vertex at each node of its curves.
struct DividedCap
{
  RemeshingInput input;
  std::vector<ArcLengthChain> chains; ///< of the curves, as the cap was given
  /// Arc length of each entry of input.curves.
  std::vector<std::vector<double>> reached;
};

/**
 * Splits the triangles at the nodes of curves. A node that is within a thousandth of the edges
 * beside it from a vertex goes there.
 *
 * @param divided as divideCapCurves() gives it.
 * @param keep    further points that are to stay.
 */
DividedCap putNodesOnCurves(const TriangleMesh& cap, const std::vector<CapCurve>& curves,
  const std::vector<std::vector<double>>& divided, const std::vector<Index>& keep);

/// The vertices of the remeshed triangles along each curve, from its first point to its last.
std::vector<std::vector<Index>> curveVertices(
  const DividedCap& prepared, const std::vector<Index>& pointOf);

/// An edge of the remeshed triangles on a curve, and the place of the node that halves it.
struct CurveEdge
{
  std::pair<Index, Index> ends; ///< lower one first
  Eigen::RowVector3d middle;    ///< half-way by arc length
};

/**
 * The edges on all curves, by their ends.
 *
 * @param pointOf see RemeshedSurface.
 * @param kept    one a curve: whether it is divided at every second point of the cap, and halved at
 *                the others.
 */
std::vector<CurveEdge> curveEdges(
  const DividedCap& prepared, const std::vector<Index>& pointOf, const std::vector<bool>& kept);
}

#endif

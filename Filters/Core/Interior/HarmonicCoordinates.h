// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Interior nodes by harmonic coordinates, and single coordinates.
 *
 * Section 4.3 of Cai and Tautges \cite CaiTautges2013, after P. Joshi et al. (\cite Joshi2007): the
 * coordinate h_i of cage vertex i is the harmonic function on the topological model that is 1 at
 * this vertex, 0 at all others, and linear in between (equations (10) and (11)).
 *
 * Here the harmonic functions are the discrete ones of PrismSolver, with trilinear elements on the
 * prism, so that boundary values are bilinear on the quads of the cage. The paper's properties:
 * interpolation (1) holds bit for bit; linear reproduction on planar caps (5) and partition of
 * unity (6) to the accuracy of the solver (1e-12 a coordinate). So does (7): the linear functions
 * that are the barycentric coordinates of a simplex come back from their values at the cage
 * vertices. Non-negativity (3) and no interior extrema (4) are certain for layers as high as the
 * quads are wide, where every value is a mean of its neighbours' with weights that are not
 * negative; where hexahedra are flat or slender, one to three, a coordinate can fall to -0.23
 * beside its vertex. The functions are smooth (2) in the limit only.
 */
#ifndef hexsweep_HarmonicCoordinates_h
#define hexsweep_HarmonicCoordinates_h

#include "Core/Interior/SweepCage.h"

namespace hexsweep
{
/**
 * Places the nodes of a swept volume as the paper does: x' = sum_i h_i(x) v'_i (equation (9)) with
 * the cage vertices v'_i of the physical model.
 *
 * This sum is the harmonic function with the boundary values v', so three Dirichlet problems, one
 * a component, take the place of one for each cage vertex, and no weights are stored.
 *
 * Affine sweeps (one affine map of the whole prism) are reproduced to rounding for planar caps.
 * On curved caps the operator has the metric of the quads themselves, not that of the layers
 * that are translated, and linear functions are reproduced no more.
 *
 * Result and errors as InteriorMethod says.
 */
Points harmonicInterior(
  const SweepCage& cage, const Progress& progress = {}, const ParallelFor& parallelFor = {});

/**
 * Harmonic coordinates of some cage vertices, at all points of the model. Three of them cost as
 * much as harmonicInterior().
 *
 * @param targetPoints n x 3.
 * @param cageNodes    c rows k n + i of cage vertices: points on layer 0 or L, or loop nodes.
 * @return (L + 1) n x c, row k n + i is point i on layer k, column j the coordinate of
 *         cageNodes[j]. Rows of points that no quad uses are zero.
 * @throw InvalidInput when a node is not on the cage; SolverFailure, Aborted (progress).
 */
Eigen::MatrixXd harmonicCoordinates(const PointsRef& targetPoints, const QuadsRef& quads,
  const SweepBoundary& boundary, const std::vector<Index>& cageNodes, const Progress& progress = {},
  const ParallelFor& parallelFor = {});
}

#endif

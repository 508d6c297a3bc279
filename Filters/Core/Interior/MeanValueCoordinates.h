// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Mean value coordinates of closed triangle meshes, and interior nodes by them.
 */
#ifndef hexsweep_MeanValueCoordinates_h
#define hexsweep_MeanValueCoordinates_h

#include "Core/Interior/SweepCage.h"
#include "Core/Interior/TriangleEdges.h"

namespace hexsweep
{
/**
 * Mean value coordinates \cite JuSchaeferWarren2005, \cite FloaterKosReimers2005.
 *
 * Seen from x, a triangle covers the part T of the unit sphere, with the mean vector m = integral
 * of u over T = 1/2 sum theta_i n_i (theta_i the angle under which edge i is seen, n_i the unit
 * normal of the plane through x and that edge). With unit vectors u_i and distances d_i to the
 * corners, m = sum w_i d_i u_i, so w_i = (q_i . m) / (d_i det(u)) with q_i = u_i+1 x u_i+2. Over a
 * closed mesh the m sum to zero: sum w_i (v_i - x) = 0, and the weights over their sum reproduce
 * linear functions. On a tetrahedron they are the barycentric coordinates. In a cage that is not
 * convex they can be negative.
 *
 * This form with mean vectors keeps linear reproduction at rounding level when triangles are seen
 * from the side, where the weights themselves lose digits. vtkMeanValueCoordinatesInterpolator
 * evaluates the publication's second form (spherical angles); it has absolute tolerances, is
 * linear up to 1e-6 of the cage's size beside a face, and computes each edge twice.
 */
class MeanValueCoordinates
{
public:
  /// @param vertices v x 3; @param triangles m x 3, closed, consistently oriented.
  MeanValueCoordinates(Points vertices, Triangles triangles);

  /**
   * Coordinates of one point: v numbers that sum to 1.
   *
   * At a vertex they are 1 and 0, on a triangle the barycentric coordinates in it.
   */
  Eigen::VectorXd at(const Eigen::RowVector3d& point) const;

private:
  Points Vertices;
  Triangles Corners;
  TriangleEdges Edges;
};

/**
 * Places the nodes of a swept volume by mean value coordinates on the topological model (see
 * cageInterior()). Reproduces affine sweeps (one affine map of a prism), whatever the shape of the
 * caps. Nothing keeps the hexahedra valid, least of all beside re-entrant edges, where weights are
 * negative.
 *
 * Result and errors as InteriorMethod says.
 */
Points meanValueInterior(
  const SweepCage& cage, const Progress& progress = {}, const ParallelFor& parallelFor = {});
}

#endif

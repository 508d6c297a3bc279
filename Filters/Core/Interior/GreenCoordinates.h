// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Green coordinates of closed triangle meshes, and interior nodes by them.
 */
#ifndef hexsweep_GreenCoordinates_h
#define hexsweep_GreenCoordinates_h

#include "Core/Interior/SweepCage.h"
#include "Core/Interior/TriangleEdges.h"

namespace hexsweep
{
/// Green coordinates of one point.
struct GreenWeights
{
  /// phi_i, one a vertex, no unit; they sum to 1 inside.
  Eigen::VectorXd vertices;
  /// psi_j, one a triangle, a length; positive inside.
  Eigen::VectorXd faces;
};

/**
 * Green coordinates \cite LipmanLevinCohenOr2008 of triangle cages.
 *
 * Green's third identity for the coordinate functions, which are harmonic and linear on each
 * triangle, says x = sum_i phi_i v_i + sum_j psi_j n_j for x inside, with
 *
 *   phi_i = 1/(4 pi) integral of (y - x) . n / r^3 times the hat function of vertex i,
 *   psi_j = 1/(4 pi) integral of 1/r over triangle j,       r = |y - x|, n outward.
 *
 * The deformed point is sum_i phi_i v'_i + sum_j s_j psi_j n'_j (see stretchedNormals()).
 *
 * The integrals are the publication's, in the closed form of D. R. Wilton et al. \cite Wilton1984
 * with one logarithm an edge, one solid angle \cite VanOosteromStrackee1983 a triangle. Unlike the
 * publication's it divides by heights of the triangle only, so it is as accurate beside a triangle
 * and in its plane as anywhere else, at any length scale. Beside an edge of the cage the error
 * grows to machine precision over the relative distance.
 */
class GreenCoordinates
{
public:
  /// @param vertices v x 3; @param triangles m x 3, closed, facing outwards. Triangles without
  ///        area take no part.
  GreenCoordinates(Points vertices, Triangles triangles);

  /// @param point inside the cage. Outside, the identity above has 0 in place of x.
  GreenWeights at(const Eigen::RowVector3d& point) const;

private:
  /// A triangle's own frame.
  struct Face
  {
    Eigen::RowVector3d normal;
    /// Row c: unit vector in the triangle's plane, out of it, normal to the edge opposite corner c.
    Eigen::Matrix3d outward;
    /// Height over that edge.
    Eigen::RowVector3d height;
  };

  Points Vertices;
  Triangles Corners;
  TriangleEdges Edges;
  Eigen::VectorXd EdgeLengths;
  std::vector<Face> Faces;
};

/**
 * s_j n'_j, m x 3: unit normals of the deformed triangles times
 *
 *   s_j = sqrt(|u'|^2 |v|^2 - 2 (u' . v') (u . v) + |v'|^2 |u|^2) / (sqrt(8) area_j)
 *
 * with the edge vectors u, v of triangle j and its area at rest, u', v' deformed
 * (\cite LipmanLevinCohenOr2008): the root mean square of the principal stretches. Zero for
 * triangles that have no area at rest or deformed.
 *
 * @param rest, deformed v x 3; @param triangles m x 3.
 */
Points stretchedNormals(
  const PointsRef& rest, const PointsRef& deformed, const TrianglesRef& triangles);

/**
 * Places the nodes of a swept volume by Green coordinates on the topological model (see
 * cageInterior()).
 *
 * The map keeps shapes (it is conformal in the plane, nearly so in space) rather than positions:
 * a cage that is turned and scaled takes its interior along, one that is sheared or stretched does
 * not take it to the affine image. Straight sweeps are their own topological model, and so come out
 * exactly. Elsewhere interior nodes do not meet the cage, and hexahedra beside it can be inverted.
 *
 * Result and errors as InteriorMethod says.
 */
Points greenInterior(
  const SweepCage& cage, const Progress& progress = {}, const ParallelFor& parallelFor = {});
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Harmonic functions on a prism (quad mesh x layers) by separation of variables.
 */
#ifndef hexsweep_PrismSolver_h
#define hexsweep_PrismSolver_h

#include "Mesh.h"
#include "QuadLaplacian.h"

#include <vector>

namespace hexsweep
{
/**
 * Solves Laplace's equation on a prism: a quad mesh times L layers of equal height.
 *
 * The prism is the topological model of section 4.2 of Cai and Tautges (2013): the target quads
 * translated. On it, the trilinear finite element Laplacian is K2 x M1 + M2 x K1 with the bilinear
 * matrices K2, M2 of the quads (see quadLaplacian()) and the linear ones of the layers,
 * M1 = h/6 tridiag(1, 4, 1), K1 = 1/h tridiag(-1, 2, -1). Both have the eigenvectors
 * sin(pi j k / L), so a discrete sine transform along the layers leaves one sparse problem
 * (m_j K2 + k_j M2) u_j = f_j on the quads for each mode j = 1 ... L - 1, with
 * m_j = h/3 (2 + cos(pi j / L)) and k_j = 2/h (1 - cos(pi j / L)): the fast Poisson solvers of
 * Buzbee, Golub, Nielson ("On direct methods for solving Poisson's equations", 1970). The
 * result equals that of the assembled three-dimensional system, to rounding.
 */
class PrismSolver
{
public:
  /**
   * @param laplacian      matrices of the quad mesh with n points.
   * @param numberOfLayers L >= 1.
   * @param layerHeight    height of one layer, > 0, in the unit of the quad mesh.
   * @param fixedPoints    ids of the points whose values are given on all layers (the boundary of
   *        the quad mesh). Points that no quad uses count as fixed, too.
   * @throw InvalidInput for arguments out of range.
   */
  PrismSolver(QuadLaplacian laplacian, Index numberOfLayers, double layerHeight,
    const std::vector<Index>& fixedPoints);

  /**
   * The discrete harmonic function with the given boundary values, three components at once.
   *
   * @param values (L + 1) n x 3, row k n + i is point i on layer k. Read are the rows of layers 0
   *        and L, and of the fixed points on all layers.
   * @return the same rows, the others filled in; rows that were read are returned bit for bit.
   * @throw SolverFailure when a factorisation fails (coordinates that are not finite).
   * @throw Aborted when progress returns false.
   */
  Points extend(const PointsRef& values, const Progress& progress = {}) const;

private:
  QuadLaplacian Laplacian;
  Index NumberOfLayers;
  double LayerHeight;
  std::vector<Index> Free;
  std::vector<Index> Fixed;
};
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Harmonic functions on a prism (quad mesh x layers) by separation of variables.
 */
#ifndef hexsweep_PrismSolver_h
#define hexsweep_PrismSolver_h

#include "Core/Common/Mesh.h"
#include "Core/Common/ParallelFor.h"
#include "Core/Solvers/HelmholtzBatch.h"
#include "Core/Solvers/LayerModes.h"
#include "Core/Solvers/QuadLaplacian.h"

#include <vector>

namespace hexsweep
{
/**
 * Solves Laplace's equation on a prism: a quad mesh times L layers.
 *
 * The prism is the topological model of section 4.2 of Cai and Tautges (2013): the target quads
 * translated. On it, the trilinear finite element Laplacian is K2 x M1 + M2 x K1 with the bilinear
 * matrices K2, M2 of the quads (see quadLaplacian()) and the linear ones of the layers, M1 and K1.
 * The eigenfunctions of K1 f = lambda M1 f (sines where the layers are equal, see layerModes())
 * leave one sparse problem (K2 + lambda_j M2) u_j = f_j on the quads for each mode j = 1 ... L - 1:
 * the fast Poisson solvers of B. L. Buzbee et al. \cite BuzbeeGolubNielson1970. Eight modes with
 * their three components are solved side by side, see HelmholtzBatchSolver; those that converge too
 * slowly directly, see HelmholtzDirectSolver.
 *
 * The result equals that of the assembled three-dimensional system to 1e-10 of the greatest given
 * value; the modes are solved to about 1e-12 of it. It is the same, bit for bit, with any number of
 * threads, but the last bits depend on the instruction set of the processor (see prismKernels()).
 */
class PrismSolver
{
public:
  /**
   * @param laplacian    matrices of the quad mesh with n points.
   * @param layerHeights heights of the L >= 1 layers, each > 0, in the unit of the quad mesh.
   * @param fixedPoints  ids of the points whose values are given on all layers (the boundary of
   *        the quad mesh). Points that no quad uses count as fixed, too.
   * @throw InvalidInput for arguments out of range.
   * @throw SolverFailure for heights that differ by too many orders of magnitude.
   */
  PrismSolver(const QuadLaplacian& laplacian, const Eigen::VectorXd& layerHeights,
    const std::vector<Index>& fixedPoints);

  /// The same with equal layers.
  PrismSolver(const QuadLaplacian& laplacian, Index numberOfLayers, double layerHeight,
    const std::vector<Index>& fixedPoints);

  /**
   * The discrete harmonic function with the given boundary values, three components at once.
   *
   * @param values (L + 1) n x 3, row k n + i is point i on layer k. Read are the rows of layers 0
   *        and L, and of the fixed points on all layers. Move it in: no second array of this size
   *        is made.
   * @param progress asked from the calling thread only.
   * @param parallelFor the threads to use.
   * @return the same rows, the others filled in; rows that were read are returned bit for bit.
   * @throw SolverFailure when a mode cannot be solved (coordinates that are not finite).
   * @throw Aborted when progress returns false.
   */
  Points extend(
    Points values, const Progress& progress = {}, const ParallelFor& parallelFor = {}) const;

private:
  Index NumberOfPoints;
  LayerModes Modes;
  HelmholtzMesh Mesh;
  Eigen::SparseMatrix<double> Stiffness;
  std::vector<char> IsGiven;
  /// Row k - 1 is layer k: the functions; for equal layers the lower half of the layers only, the
  /// even functions first.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Synthesis;

  /// What the modes' right-hand sides are made of.
  struct Sources
  {
    double greatest = 0.0; ///< given value
    Eigen::MatrixXd sides; ///< coefficients of each mode at the given points
    Points first, last;    ///< what the caps' values add; no rows where all of them are zero
  };
  void addCaps(const Points& values, Sources& sources) const;
  Eigen::MatrixXd sideCoefficients(const Points& values) const;
  Eigen::RowVector3d loadOf(Index mode, Index node, const Sources& sources) const;
  double toleranceOf(Index mode, const Sources& sources) const;
  HelmholtzProblems problems(Index batch, const Sources& sources) const;
  std::vector<Index> solveBatches(const Sources& sources, const PrismKernels& kernels,
    const Progress& progress, const ParallelFor& parallelFor, Points& values) const;
  void solveDirectly(const std::vector<Index>& modes, const Sources& sources,
    const Progress& progress, const ParallelFor& parallelFor, Points& values) const;
  void storeModes(Index batch, const HelmholtzSolution& solution, Points& values) const;
  using Panel = Eigen::Matrix<double, Eigen::Dynamic, PanelWidth, Eigen::RowMajor>;
  double greatestGiven(const Points& values) const;
  void synthesizePanel(
    const PrismKernels& kernels, const double* coefficients, double* values) const;
  void synthesize(const PrismKernels& kernels, Index begin, Index end, bool hasCaps,
    Panel& coefficients, Panel& layers, Points& values) const;
};
}

#endif

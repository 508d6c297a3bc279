// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Newton's equations of the free nodes of a cap, two unknowns a node.
 */
#ifndef hexsweep_CapEquations_h
#define hexsweep_CapEquations_h

#include "Core/CapQuads/CapCorners.h"
#include "Core/Solvers/MultifrontalSolver.h"

#include <array>
#include <optional>

namespace hexsweep
{
/// How Newton's equations are solved.
enum class NewtonEquations
{
  Exactly, ///< by a factorisation
  /// By some steps of conjugate gradients: enough where nodes are to follow their neighbours, not
  /// where the whole mesh is to arrive somewhere.
  Roughly
};

/// The Hessian of a sum over the corners, and where each corner's blocks go in it.
class CapEquations
{
public:
  CapEquations(const CapCorners& cap, NewtonEquations kind);

  /// Numbers of a corner's nodes among the free ones, or -1.
  std::array<int, 3> variables(const QuadCorner& corner) const;

  /// The number of a quad's first corner; of all corners for the quad past the last.
  std::size_t firstCorner(Index quad) const
  {
    return this->FirstCorner[static_cast<std::size_t>(quad)];
  }

  /// All quads; those of one color share no node.
  const std::vector<std::vector<Index>>& colors() const { return this->Colors; }

  void setZero();

  /// Adds to the block of the free nodes i and j of a corner (0 to 2, i <= j), and its mirror
  /// image.
  void add(std::size_t corner, std::size_t i, std::size_t j, const Eigen::Matrix2d& block);

  /// Adds a part of the diagonal's mean to it.
  void damp(double part);

  /**
   * Newton's step; not a number where the matrix is not positive definite to working accuracy.
   *
   * @param places of the free nodes.
   */
  Eigen::VectorXd step(
    const Eigen::VectorXd& gradient, const PointsRef& places, const ParallelFor& parallelFor);

private:
  /// From a value of the first column of a free node to that of the second.
  int nextColumn(int j) const
  {
    const int* outer = this->Hessian.outerIndexPtr();
    return outer[2 * j + 1] - outer[2 * j];
  }

  void makeHessian(const std::vector<QuadCorner>& corners, std::size_t freeNodes);
  void color(const Quads& quads);

  NewtonEquations Kind;
  std::vector<int> Variable; // node -> free node or -1
  SparseMatrix Hessian;
  /// Nine a corner: value index in the first column of each of its blocks, and the way from there
  /// to the second; -1: none.
  std::vector<std::pair<int, int>> Slots;
  std::vector<int> Diagonal; // value indices
  std::optional<MultifrontalSolver> Solver;
  std::vector<std::size_t> FirstCorner;
  std::vector<std::vector<Index>> Colors;
};
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Direct solution of sparse linear systems on surfaces.
 */
#ifndef hexsweep_MultifrontalSolver_h
#define hexsweep_MultifrontalSolver_h

#include "Core/Common/ParallelFor.h"
#include "Core/Solvers/NestedDissection.h"
#include "Core/Solvers/PanelSubstitution.h"

namespace hexsweep
{
/**
 * Multifrontal factorisation \cite DuffReid1983 in a nested dissection order, see dissect().
 *
 * Symmetric positive definite matrices get a Cholesky factorisation; others an LU factorisation
 * that pivots within a part only, which is safe for the diagonally dominant matrices of positive
 * weights. Dense blocks are Eigen's.
 *
 * Measured on triangulated surfaces with two right-hand sides, ordering included, one thread: 100k
 * unknowns half of the CPU time of Eigen's SimplicialLDLT with its AMD ordering; time grows as
 * n^1.25, memory as n log n (1M unknowns: 83 M entries, 0.7 GB).
 */
class MultifrontalSolver
{
public:
  enum class Kind
  {
    Cholesky,
    LU
  };

  /**
   * Orders the pattern; no value is read.
   *
   * @param pattern n x n, compressed; entry (i, j) exists where (j, i) does.
   * @param places  where each block of rows lies in space, for a better order; or no rows at all.
   * @param width   rows a block: consecutive ones with the same pattern. Divides n.
   */
  MultifrontalSolver(
    const SparseMatrix& pattern, Kind kind, const PointsRef& places = Points(0, 3), int width = 1);

  /**
   * @param matrix with the pattern that the solver was made for, or a part of it. For Cholesky the
   *               lower triangle in the elimination order is read, so it must be symmetric.
   * @param parallelFor lends threads for the branches of the elimination tree; the bits do not
   *               depend on them.
   * @throw SolverFailure when the matrix is singular or, for Cholesky, not positive definite.
   */
  void factorize(const SparseMatrix& matrix, const ParallelFor& parallelFor = {});

  /// @param b n x k. @return n x k.
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& b) const;

  /// Some rows, and the parts of the factor that lead from them to each other.
  struct Selection
  {
    std::vector<Index> places; // of the rows, in the elimination order
    std::vector<Index> fronts; // rising
  };

  /// @param rows in [0, n).
  Selection select(const std::vector<Index>& rows) const;

  /**
   * The selected rows of the solution where the right-hand side is zero at all others: the rest of
   * the factor is not touched.
   *
   * @param b a row a selected row, k columns. @return the same shape.
   */
  Eigen::MatrixXd solve(
    const Selection& selection, const Eigen::Ref<const Eigen::MatrixXd>& b) const;

private:
  /// A part's pivots and the later rows that they touch (its border) form one dense matrix.
  struct Front
  {
    Index begin;      // first pivot
    Index pivots;     // how many
    Index parent;     // -1: none
    Index border;     // first entry in Borders
    Index borderSize; // how many
    Index lower;      // first entry in Values: (pivots + borderSize) x pivots, column-major
    Index upper;      // LU only: pivots x borderSize, column-major
  };
  using Update = Eigen::MatrixXd;

  struct Work;
  void factorizeFront(std::size_t f, std::vector<Index>& local, Work& work);
  void assemble(const Front& front, const SparseMatrix& matrix, const std::vector<Index>& local);
  void extendAdd(const Front& front, Update& update, const Front& child, const Update& childUpdate,
    const std::vector<Index>& local);
  bool eliminate(const Front& front, Update& update);
  void substitute(std::vector<RowPair>& x, const std::vector<Index>& fronts) const;

  Kind Factorization;
  std::vector<int> Order;
  std::vector<Index> Place; // inverse of Order
  std::vector<Front> Fronts;
  std::vector<Index> Borders; // places, rising within a front
  std::vector<double> Values; // none before the first factorisation
  Index ValuesNeeded = 0;
  Index UpdateValues = 0;      // of all fronts' borders together
  std::vector<Update> Updates; // of the borders; kept where they are few values, else empty
  std::vector<int> Pivoting;   // LU: rows of a front's pivots in the order they were taken
};
}

#endif

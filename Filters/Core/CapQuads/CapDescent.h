// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Newton descent of sums over the corners of a cap's quads.
 */
#ifndef hexsweep_CapDescent_h
#define hexsweep_CapDescent_h

#include "Core/CapQuads/CapEquations.h"

#include <memory>

namespace hexsweep
{
/// A corner's term as a function of its two edges in the plane across its normal, as columns.
struct CornerTerm
{
  double value;
  Eigen::Matrix2d gradient;
  /// Positive semidefinite; the columns of the edge matrix stacked.
  Eigen::Matrix4d curvature;
};

/// Two edges in space, as columns.
using CornerEdges = Eigen::Matrix<double, 3, 2>;

/// The term of a corner at a column as a function of its two edges in a frame whose third axis is
/// the column.
struct ColumnCornerTerm
{
  double value;
  CornerEdges gradient;
  /// Positive semidefinite; the columns of the edge matrix stacked.
  Eigen::Matrix<double, 6, 6> curvature;
};

/**
 * Moves the free nodes in their tangent planes, then puts them back on the surface.
 *
 * The sparsity is that of the mesh and analysed once. All work is done on the threads of the
 * corners, see CapCorners; the bits do not depend on them.
 */
class CapDescent
{
public:
  explicit CapDescent(const CapCorners& cap, NewtonEquations equations = NewtonEquations::Exactly);
  ~CapDescent();

  /// Called with the number of the corner (see CapCorners::corners()).
  using Term = std::function<CornerTerm(std::size_t corner, const Eigen::Matrix2d& edges)>;

  struct Result
  {
    Points points;
    double before;
    double after;
    Index steps = 0; ///< Newton steps taken
  };

  using ColumnTerm = std::function<ColumnCornerTerm(std::size_t corner, const CornerEdges& edges)>;

  /// The value of the term alone.
  using Value = std::function<double(std::size_t corner, const Eigen::Matrix2d& edges)>;

  /**
   * @param steps at the most; fewer once a step lowers the sum by less than relativeDecrease.
   * @param columnTerm of the corners at columns. Without it they have `term`, as a function of
   *        their edges seen along the column.
   */
  Result descend(const Points& points, const Term& term, int steps, double relativeDecrease,
    const ColumnTerm& columnTerm = {}) const;

  /// The same where a term's value is cheaper than all of it: along a step nothing else is asked.
  Result descend(const Points& points, const Term& term, const Value& value, int steps,
    double relativeDecrease, const ColumnTerm& columnTerm = {}) const;

private:
  struct Energy;
  struct Terms;
  Result descend(
    const Points& points, const Terms& terms, int steps, double relativeDecrease) const;

  const CapCorners& Cap;
  std::unique_ptr<CapEquations> Equations;
};
}

#endif

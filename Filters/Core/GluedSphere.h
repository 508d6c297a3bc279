// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Conformal map of a cap whose loops are closed by round disks.
 */
#ifndef hexsweep_GluedSphere_h
#define hexsweep_GluedSphere_h

#include "MultifrontalSolver.h"

#include <optional>

namespace hexsweep
{
/**
 * A cap, and one round disk glued to each of its loops by an angle for every node: a closed surface
 * of genus 0, with the metric of the cap and of the disks.
 *
 * Its conformal map to the plane, with the pole in the middle of the first loop's disk, is one
 * symmetric positive definite system with two right-hand sides (see diskFillEnergy()). It is solved
 * by a few steps of conjugate gradients; what is factorised for them is sparse, with a coarse mesh
 * in each disk (see fillMesh()). The image of a loop is a circle when the angles at which it is
 * glued are those of its image.
 */
class GluedSphere
{
public:
  /// @param laplacian cotangent weights. @param loops the outer one first.
  /// @param points n x 3.
  GluedSphere(const SparseMatrix& laplacian, std::vector<Loop> loops, const PointsRef& points);

  /**
   * Maps the surface that is glued at these angles, to about four digits; correct() adds to them.
   *
   * @param angles one list a loop, in radians, strictly monotone within a turn; rising on the
   * first.
   * @throw SolverFailure
   */
  void map(const std::vector<std::vector<double>>& angles);

  /// Approximates what map() would give from the present map with the factor of the last map().
  void correct(const std::vector<std::vector<double>>& angles);

  /// n x 2; the first loop's mean lies at the origin, its radius is near 1.
  const Eigen::MatrixXd& image() const { return this->Image; }

private:
  void glue(const std::vector<std::vector<double>>& angles);
  Eigen::MatrixXd apply(const Eigen::MatrixXd& image) const;
  void improve(int steps);
  SparseMatrix approximation(const std::vector<std::vector<double>>& angles) const;

  SparseMatrix Laplacian;
  std::vector<Loop> Loops;
  std::vector<Index> FirstFillNode; // rows of the approximation beyond those of the cap
  Points FillPlaces;                // about where all its rows lie in space
  std::optional<MultifrontalSolver> Solver;
  std::vector<Eigen::MatrixXd> Fills;
  Eigen::MatrixXd Source;
  Eigen::MatrixXd Image;
};
}

#endif

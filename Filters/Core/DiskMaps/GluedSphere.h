// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Conformal map of a cap whose loops are closed by round disks.
 */
#ifndef hexsweep_GluedSphere_h
#define hexsweep_GluedSphere_h

#include "Core/Solvers/MultifrontalSolver.h"

namespace hexsweep
{
/**
 * A cap, and one round disk glued to each of its loops by an angle for every node: a closed surface
 * of genus 0, with the metric of the cap and of the disks.
 *
 * Its conformal map to the plane, with the pole in the middle of the first loop's disk, is one
 * symmetric positive definite system with two right-hand sides (see diskFillEnergy()). Only the
 * disks' part of it depends on the angles, and only the loops' nodes know of the disks: the cap is
 * factorised once, and what remains is a system on the loops' nodes, solved by conjugate gradients.
 *
 * What preconditions them is the cap in place of the disks, as if a copy of it were glued to its
 * loops: waves along a loop that are short against the distance to the next one cost the same on
 * either side, whatever the angles, since the energy is conformally invariant. Five steps gain
 * about two digits.
 *
 * The image of a loop is a circle when the angles at which it is glued are those of its image.
 */
class GluedSphere
{
public:
  /// One list of angles a loop, in radians, strictly monotone within a turn; rising on the first.
  using Gluing = std::vector<std::vector<double>>;

  /**
   * @param laplacian n x n, cotangent weights. @param loops the outer one first.
   * @param points n x 3.
   * @throw SolverFailure
   */
  GluedSphere(
    const SparseMatrix& laplacian, const std::vector<Loop>& loops, const PointsRef& points);

  /**
   * Maps the surface that is glued at these angles, beginning with the map of the last ones: its
   * error falls to a hundredth of what their change makes.
   *
   * @throw SolverFailure
   */
  void map(const Gluing& angles);

  /// The nodes of a loop, one a row; the first loop's mean lies at the origin, its radius is
  /// near 1.
  PlanePoints image(std::size_t loop) const;

private:
  struct Anchored
  {
  };
  GluedSphere(const SparseMatrix& matrix, const std::vector<Loop>& loops, const PointsRef& points,
    Anchored tag);
  void glue(const Gluing& angles);
  Eigen::MatrixXd fillForces(const Eigen::MatrixXd& values) const;

  std::vector<Index> First; // of each loop's rows in what follows; and how many there are
  Eigen::VectorXd Anchor;   // what the factor has on the diagonal beyond the cap's matrix
  MultifrontalSolver Solver;
  MultifrontalSolver::Selection LoopNodes;
  std::vector<Eigen::MatrixXd> Fills;
  Eigen::MatrixXd Source;
  Eigen::MatrixXd Image;     // a row a node of the loops
  Eigen::MatrixXd CapForces; // on them, of the cap
};
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How well a piecewise linear correspondence carries one loop onto another.
 */
#ifndef hexsweep_LoopFit_h
#define hexsweep_LoopFit_h

#include "Core/Geometry/ClosedPolygon.h"

namespace hexsweep
{
/// A map of places by pairs of places, both ascending, the last no further than once round.
struct LoopAnchors
{
  std::vector<double> source;
  std::vector<double> target;

  /// @param place on the source loop, any real number; @return one of the target loop, unwrapped.
  double operator()(double place) const;
};

/// Costs closer than this are equal; they are dimensionless.
constexpr double SameLoopCost = 1e-9;

/**
 * Costs of correspondences of two loops: the mean over the source loop of the squared difference of
 * the unit tangents, and of the squared distance relative to the target's root-mean-square radius.
 * The source is moved first: centre on centre, turned by a linear map, scaled to the same length.
 */
class LoopFit
{
public:
  /// Keeps references to the loops. @param linear its scale does not matter.
  LoopFit(const ClosedPolygon& source, const ClosedPolygon& target, const Eigen::Matrix3d& linear);

  const ClosedPolygon& source() const { return this->Source; }
  const ClosedPolygon& target() const { return this->Target; }

  /// Arc length on arc length, source place 0 at this place of the target.
  double straightCost(double start) const;

  /// One linear piece, weighted by its part of the source loop: pieces of a whole add up.
  double pieceCost(double s, double sLength, double t, double tLength) const;

  /// What a corner costs on another one, from just before and just after both.
  double cornerCost(double s, double t) const;

  /// The cost after the affine map that fits this correspondence best, instead of the first move.
  double alignedCost(const LoopAnchors& anchors) const;

  /// Mean of target place minus source place, in [0, 1).
  double shiftOf(const LoopAnchors& anchors) const;

private:
  double sample(Index i) const;
  Eigen::RowVector3d movedPlace(double s) const;
  Eigen::RowVector3d movedDirection(double s) const;
  double costAt(
    const Eigen::RowVector3d& place, const Eigen::RowVector3d& direction, double t) const;

  const ClosedPolygon& Source;
  const ClosedPolygon& Target;
  Eigen::Matrix3d Linear; ///< applied to rows from the right
  Eigen::RowVector3d SourceCenter;
  Eigen::RowVector3d TargetCenter;
  Index Samples;
  double SquaredRadius = 0.0;
  std::vector<Eigen::RowVector3d> Places; ///< of the moved source, at the samples
  std::vector<Eigen::RowVector3d> Directions;
};
}

#endif

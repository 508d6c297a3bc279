// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Coordinates in which a sweep round an axis is straight.
 */
#ifndef hexsweep_RevolvedSpace_h
#define hexsweep_RevolvedSpace_h

#include "Core/Stacks/CapLikeFaces.h"

#include <optional>
#include <vector>

namespace hexsweep
{
/// A line.
struct RevolutionAxis
{
  Eigen::RowVector3d point;
  Eigen::RowVector3d direction; ///< of any length but 0
};

/**
 * Along the axis, away from it, and round it: (x, y, z) of the straight space. What is round it is
 * an arc of a middle radius, so that lengths are about the same in both. Keeps the orientation.
 */
class RevolvedSpace
{
public:
  /**
   * @param points of a solid that leaves out some angle round the axis and does not reach it.
   * @return nothing where it does.
   */
  static std::optional<RevolvedSpace> make(const RevolutionAxis& axis, const PointsRef& points);

  const RevolutionAxis& axis() const { return this->Axis; }
  /// @param points n x 3. @return n x 3.
  Points straight(const PointsRef& points) const;
  /// The inverse.
  Points revolved(const PointsRef& points) const;

private:
  RevolvedSpace(const RevolutionAxis& axis, const PointsRef& points);
  double angle(const Eigen::RowVector3d& point) const;

  RevolutionAxis Axis;
  Eigen::RowVector3d Outward; ///< across the axis, where angles begin
  Eigen::RowVector3d Around;
  double Radius = 1.0;
};

/// A solid that is a stack round an axis.
struct RevolvedStack
{
  RevolvedSpace space;
  SolidSurface straight; ///< the solid in that space
  CapLikeFaces faces;    ///< of `straight`, along its third axis
};

/// The solid as it is round an axis. @return nothing where RevolvedSpace::make() gives nothing.
std::optional<RevolvedStack> revolvedStack(
  const SolidSurface& solid, const RevolutionAxis& axis, double draft = 0.0);

/**
 * Looks for an axis round which all faces are sides and caps: among the lines in which the planes
 * of its twelve largest plane faces meet. The one with the fewest caps is taken.
 */
std::optional<RevolvedStack> findRevolvedStack(const SolidSurface& solid, double draft = 0.0);
}

#endif

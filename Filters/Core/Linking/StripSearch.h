// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From places of a side's strip to places on the side.
 */
#ifndef hexsweep_StripSearch_h
#define hexsweep_StripSearch_h

#include "Core/Geometry/BoxTree.h"
#include "Core/Geometry/PlaneTriangulation.h"
#include "Core/Linking/SideStrip.h"

namespace hexsweep
{
/// A place on the side.
struct StripPlace
{
  Index triangle = -1; ///< row of SideStrip::surface.triangles
  Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
};

/// Finds places of the strip on the side.
class StripSearch
{
public:
  /// @param strip must outlive the search.
  explicit StripSearch(const SideStrip& strip);

  /// @param v any number, period 1. @param u in [0, 1].
  StripPlace at(double v, double u) const;

private:
  StripPlace onTriangle(std::uint32_t t, const PlaneTriangulation::Point& q) const;

  const SideStrip& Strip;
  PlaneTriangulation Plane;
  BoxTree Boxes;
  int Least = 0; ///< range of v in whole turns
  int Most = 0;
};
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How high the caps of a stack are over the plane across its direction.
 */
#ifndef hexsweep_CapHeights_h
#define hexsweep_CapHeights_h

#include "Core/Geometry/ModelGeometry.h"
#include "Core/Geometry/PlaneTriangleSearch.h"
#include "Core/Stacks/CapLikeFaces.h"
#include "Core/Stacks/StackFrame.h"

#include <memory>
#include <optional>

namespace hexsweep
{
/// The caps of a solid as functions of the plane.
class CapHeights
{
public:
  /// @param framePoints the solid's points in the frame of the stack, n x 3.
  CapHeights(const SolidSurface& solid, const PointsRef& framePoints, const CapLikeFaces& faces);

  /// @param face place in CapLikeFaces::faces, a cap. @return nothing where the cap is not over or
  ///             under the place.
  std::optional<double> at(std::size_t face, const Eigen::RowVector2d& place) const;
  /// The same of the nearest place that the cap is over or under.
  double nearest(std::size_t face, const Eigen::RowVector2d& place) const;
  /// The same on the true surface of a cap that is not flat, where one is found near the facets.
  double exact(std::size_t face, const Eigen::RowVector2d& place) const;
  /// From now on exact() asks this. @param geometry must outlive the heights.
  void setGeometry(const ModelGeometry* geometry, const StackFrame& frame);
  /// Steepest slope of a cap: 0 for a flat one.
  double slope(std::size_t face) const { return this->Caps[face]->slope; }
  /// Lowest and highest place of a cap.
  std::pair<double, double> range(std::size_t face) const { return this->Caps[face]->range; }
  bool isFlat(std::size_t face) const;
  /// Places of the caps in CapLikeFaces::faces, rising.
  const std::vector<std::size_t>& caps() const { return this->Numbers; }

private:
  struct Cap
  {
    PlaneTriangulation mesh;
    BoxTree boxes;
    PlaneBox box;
    Triangles corners; // of the solid's points, by row of the mesh's input
    Index faceId = 0;
    double slope = 0.0;
    std::pair<double, double> range;
    double longest = 0.0; ///< edge of a triangle
  };
  double height(const Cap& cap, std::uint32_t t, const Eigen::RowVector2d& place) const;

  Points Places;
  std::vector<std::unique_ptr<const Cap>> Caps; // nullptr: no cap
  std::vector<std::size_t> Numbers;
  double Extent = 0.0;
  const ModelGeometry* Geometry = nullptr;
  std::optional<StackFrame> Frame;
};
}

#endif

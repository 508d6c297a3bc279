// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Newton descent of the distortion of quads in a plane, their boundary fixed.
 */
#ifndef hexsweep_SectionDescent_h
#define hexsweep_SectionDescent_h

#include "Core/Common/Mesh.h"

#include <memory>
#include <vector>

namespace hexsweep
{
/**
 * Moves the free nodes of a plane quad mesh towards the shapes that its quads have on the caps.
 *
 * The sum over the corners of the distortion of FoldoverFreeEnergy.h, which is finite for inverted
 * corners too. Corners whose three nodes are fixed do not count. The sparsity is that of the mesh
 * and analysed once.
 */
class SectionDescent
{
public:
  /**
   * @param quads  m x 4, counter-clockwise in the plane.
   * @param fixed  n entries: nodes that stay.
   * @param source, target n x 3: the quads on both caps, where the wanted shapes are read. A corner
   *        that is sharper or flatter there than 3 degrees is wanted to be a right angle.
   */
  SectionDescent(const QuadsRef& quads, const std::vector<bool>& fixed, const PointsRef& source,
    const PointsRef& target);
  ~SectionDescent();
  SectionDescent(SectionDescent&&) noexcept;

  /// From now on wants shapes between those on the source (0, as at first) and on the target (1).
  void wantShapes(double share);

  /// Movable corners that are <= 0.
  Index inverted(const PlanePoints& points) const;

  /**
   * Rounds with falling regularisation until no movable corner is inverted; the result is not
   * worse than the start.
   *
   * @param rounds at the most. @return corners that are still inverted.
   */
  Index untangle(PlanePoints& points, int rounds);

  /// A few steps downhill from a mesh without inverted corners; none is inverted after them.
  void relax(PlanePoints& points, int steps);

private:
  struct Implementation;
  std::unique_ptr<Implementation> Self;
};
}

#endif

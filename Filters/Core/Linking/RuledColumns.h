// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The columns of a linking side that is ruled by straight lines between affine images.
 */
#ifndef hexsweep_RuledColumns_h
#define hexsweep_RuledColumns_h

#include "Core/Geometry/AffineMap.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Linking/LinkingSideColumns.h"

namespace hexsweep
{
/**
 * Columns that run straight from each ring node to its image on the target loop. No strip is
 * needed, and no CAD edge: what crosses the side is none of their business.
 */
class RuledColumns
{
public:
  /**
   * @param side see SideTube; its patches are not looked at.
   * @param ring n x 3: nodes of the quads of the source cap along the source loop, in either
   *             direction.
   * @param map  of the source cap to the target cap, see findAffineSweep().
   * @throw InvalidInput when the side is no tube.
   */
  RuledColumns(const SideTube& side, const PointsRef& ring, const AffineMap& map);

  Index size() const { return this->Begin.rows(); }

  /// Mean length of the columns.
  double meanLength() const;

  /// Lays the rings on the straight lines: on the side itself, of which its triangles are a
  /// likeness.
  /// @param fractions of the columns' lengths, 0 ... 1, see layerFractions().
  SideTubeMesh mesh(const std::vector<double>& fractions) const;

private:
  TriangleSearch Search;
  Points Begin; ///< ring nodes, bit for bit
  Points End;   ///< on the target loop
};
}

#endif

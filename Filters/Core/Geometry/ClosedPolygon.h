// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A closed polygon that is asked for places and directions by arc length.
 */
#ifndef hexsweep_ClosedPolygon_h
#define hexsweep_ClosedPolygon_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// Places are fractions of the whole length from the first node, any real number: 1.25 is 0.25.
class ClosedPolygon
{
public:
  /// @throw InvalidInput when all nodes coincide. @param nodes n x 3.
  explicit ClosedPolygon(Points nodes);

  const Points& nodes() const { return this->Nodes; }
  double length() const { return this->Reached.back(); }
  /// Place of a node, in [0, 1).
  double fraction(Index node) const;
  /// Centre of the curve (not of its nodes, which may be dense in places).
  Eigen::RowVector3d center() const;
  /// A node itself where the place is one to rounding.
  Eigen::RowVector3d at(double fraction) const;
  /// Unit vector along the edge at a place.
  Eigen::RowVector3d direction(double fraction) const;

private:
  struct Place
  {
    Index edge;
    double along; ///< fraction of the edge
  };
  Place locate(double fraction) const;

  Points Nodes;
  std::vector<double> Reached; ///< length up to each node, and back to the first one
};

/**
 * The corners of a loop: nodes where it turns by more than 30 degrees, and the middle of narrow
 * fillets, where it does so within a hundredth of its length. A finely facetted circle has none, an
 * octagon has eight. Edges shorter than a millionth of the loop have no direction of their own.
 *
 * @return nodes in ascending order.
 */
std::vector<Index> loopCorners(const ClosedPolygon& loop);
}

#endif

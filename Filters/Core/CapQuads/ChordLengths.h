// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The longest edges that stay near a curved surface.
 */
#ifndef hexsweep_ChordLengths_h
#define hexsweep_ChordLengths_h

#include "Core/Geometry/TriangleSearch.h"

#include <vector>

namespace hexsweep
{
/// Of the wanted size of quads: the shortest edges that chords ask for.
constexpr double LeastOfChord = 0.02;

/**
 * The length of a chord whose arc rises above it by a share of the chord: 8 share / curvature, to
 * first order.
 *
 * @param share > 0. @param curvature >= 0, over the length unit.
 * @return infinite where nothing is curved.
 */
double chordLength(double share, double curvature);

/**
 * The same on a triangulated surface, with the greatest curvature along the edges of the nearest
 * triangle: the turn of the normals from one corner to the other over the edge's length. Borders
 * between faces are no curves.
 */
class ChordLengths
{
public:
  /// @param faceIds one a triangle, or empty. @param share see chordLength().
  ChordLengths(const TriangleMesh& surface, const std::vector<Index>& faceIds, double share);

  double at(const Eigen::RowVector3d& place) const;

private:
  TriangleSearch Search;
  std::vector<double> Lengths; ///< of each triangle
};
}

#endif

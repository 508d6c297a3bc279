// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The edges that leave a corner of a hexahedron.
 */
#ifndef hexsweep_HexCorner_h
#define hexsweep_HexCorner_h

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>

namespace hexsweep
{
/// The neighbours of each corner in VTK_HEXAHEDRON order, so that the determinant of the edges to
/// them is positive in a right-handed hexahedron.
constexpr int HexCornerNeighbors[8][3] = { { 1, 3, 4 }, { 2, 0, 5 }, { 3, 1, 6 }, { 0, 2, 7 },
  { 7, 5, 0 }, { 4, 6, 1 }, { 5, 7, 2 }, { 6, 4, 3 } };

/// Three edge vectors, in the order of HexCornerNeighbors.
struct HexFrame
{
  Eigen::RowVector3d u, v, w;

  double determinant() const { return u.dot(v.cross(w)); }

  /// The determinant over the product of the lengths, in [-1, 1]; 0 where an edge has no length.
  double scaledDeterminant() const
  {
    // Each vector is scaled by itself: the product of six factors would under- or overflow long
    // before the coordinates do.
    const double lengths[3] = { u.stableNorm(), v.stableNorm(), w.stableNorm() };
    if (!(lengths[0] > 0.0 && lengths[1] > 0.0 && lengths[2] > 0.0))
    {
      return 0.0;
    }
    const double scaled = (u / lengths[0]).dot((v / lengths[1]).cross(w / lengths[2]));
    return std::clamp(scaled, -1.0, 1.0);
  }

  bool hasZeroEdge() const { return u.isZero(0.0) || v.isZero(0.0) || w.isZero(0.0); }
};

/// @param place gives the coordinates of each of the eight corners.
template <typename Place>
HexFrame hexFrame(const Place& place, int corner)
{
  const int* to = HexCornerNeighbors[corner];
  return { place(to[0]) - place(corner), place(to[1]) - place(corner),
    place(to[2]) - place(corner) };
}
}

#endif

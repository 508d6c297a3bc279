// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which edges leave a corner of a hexahedron.
 */
#ifndef hexsweep_HexCorner_h
#define hexsweep_HexCorner_h

namespace hexsweep
{
/// The neighbours of each corner in VTK_HEXAHEDRON order, so that the determinant of the edges to
/// them is positive in a right-handed hexahedron.
constexpr int HexCornerNeighbors[8][3] = { { 1, 3, 4 }, { 2, 0, 5 }, { 3, 1, 6 }, { 0, 2, 7 },
  { 7, 5, 0 }, { 4, 6, 1 }, { 5, 7, 2 }, { 6, 4, 3 } };
}

#endif

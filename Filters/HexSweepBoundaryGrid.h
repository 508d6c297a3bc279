// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The boundary quads of a swept solid as a grid. Private to the module.
 */
#ifndef HexSweepBoundaryGrid_h
#define HexSweepBoundaryGrid_h

#include "Core/Solids/SolidCage.h"

class vtkUnstructuredGrid;

namespace hexsweep
{
/**
 * Writes the outer quads with `HexPointIds`, `BoundaryId`, `BoundaryPart`, `HexId` and `HexSide`
 * (see vtkOneToOneSweep).
 *
 * @param hexes the grid of hexahedra, whose points are taken.
 * @param sourceIsBottom see sweptHexes().
 */
void writeBoundary(const SolidCage& cage, const SolidSurface& solid, const SweepTopology& topology,
  bool sourceIsBottom, vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* output);
}

#endif

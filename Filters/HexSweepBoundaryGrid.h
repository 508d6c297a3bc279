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
 * @param sourceIsBottom see HexOutput.
 * @param turnsOver      whether the hexahedra are a mirror image of the cage.
 */
void writeBoundary(const SolidCage& cage, const SolidSurface& solid, const SweepTopology& topology,
  bool sourceIsBottom, bool turnsOver, vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* output);
}

#endif

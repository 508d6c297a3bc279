// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which volume a solid is. Private to the module.
 */
#ifndef HexSweepVolumeId_h
#define HexSweepVolumeId_h

#include "Core/Common/Mesh.h"

class vtkDataSet;
class vtkUnstructuredGrid;

namespace hexsweep
{
/**
 * Gives all hexahedra the cell array `VolumeId`, where the solid has one id for all its cells: in
 * `VolumeId`, or, for volume cells, in `CellEntityIds`.
 */
void carryVolumeId(vtkDataSet* solid, vtkUnstructuredGrid* hexes);

/// Gives all cells the cell array `VolumeId`.
void setVolumeId(Index id, vtkUnstructuredGrid* cells);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which cells of a data set are the boundary of its solid. Private to the module.
 */
#ifndef HexSweepSolidBoundary_h
#define HexSweepSolidBoundary_h

#include "Core/Common/Mesh.h"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace hexsweep
{
/// Surface cells on the points of a data set.
struct BoundaryCells
{
  vtkSmartPointer<vtkDataSet> cells;
  /// Cells of the data set that they are (or, of volume cells, are sides of).
  std::vector<Index> cellIds;
  bool fromVolume = false;   ///< whether they are sides of volume cells
  Index ignoredCells = 0;    ///< vertex and line cells
  Index ignoredSurfaces = 0; ///< surface cells that were not taken
};

/// Whether there are volume cells, ghosts left aside.
bool hasVolumes(vtkDataSet* data);

/**
 * The boundary of a mesh with volume cells: its surface cells on the boundary of the volume cells,
 * if they cover it, else all surface cells, if they form a closed surface, else the sides of volume
 * cells that no other one shares (of curved cells the corners only). Ghosts are left out.
 */
BoundaryCells volumeBoundary(vtkDataSet* data);
}

#endif

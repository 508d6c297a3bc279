// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Disk maps as unstructured grids: how vtkHarmonicDiskMap writes them and how
 * vtkSweepQuadProjector reads them back. Private to the module.
 */
#ifndef HexSweepCapDiskGrid_h
#define HexSweepCapDiskGrid_h

#include "Core/DiskMaps/CapDisk.h"

#include <string>
#include <vector>

class vtkDataSet;
class vtkUnstructuredGrid;

namespace hexsweep
{
/// Weights as reports name them.
const char* nameOf(Weights weights);

/// What a cap was read from.
struct CapOrigin
{
  vtkDataSet* data = nullptr;
  std::vector<Index> cellIds; ///< cell that each triangle came from
  Index ignoredCells = 0;     ///< see TriangleInput
};

/**
 * Fills the grid with the mapped triangles, the arrays of a disk map (HexSweepArrays.h), the
 * attributes of the input's cells and points (null values on added points), and the field data of
 * the map.
 *
 * @param outputDisk put the points into the disk, the surface's own into `SurfacePoints`.
 */
void writeCapDisk(const CapDisk& cap, const CapOrigin& origin, int precision, bool outputDisk,
  vtkUnstructuredGrid* output);

/// @throw InvalidInput when the data set carries no disk map.
CapDisk readCapDisk(vtkDataSet* data, const std::string& what);

/// What to tell the user about triangles that are flipped in the disk; empty if there are none.
std::string describeFlips(const CapDisk& cap, const std::string& what);
}

#endif

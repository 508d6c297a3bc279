// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The hexahedra of a stack, and their boundary, as grids. Private to the module.
 */
#ifndef HexSweepStackGrid_h
#define HexSweepStackGrid_h

#include "Core/Geometry/Reflection.h"
#include "Core/Stacks/StackSweep.h"

class vtkUnstructuredGrid;

namespace hexsweep
{
/// Writes points and hexahedra with `SourcePointIds`, `SourceCellIds` and `SweepLayer`.
/// @param reflection of the mesh, undone in the output. @param precision a
///                   vtkAlgorithm::DesiredOutputPrecision.
void writeStackGrid(
  const StackMesh& mesh, const Reflection& reflection, int precision, vtkUnstructuredGrid* output);

/// Writes the outer quads as writeBoundary() does. @param hexes the grid of hexahedra.
void writeStackBoundary(const StackMesh& mesh, const Reflection& reflection,
  vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* output);
}

#endif

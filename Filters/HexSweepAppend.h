// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Meshes of several bodies as one. Private to the module.
 */
#ifndef HexSweepAppend_h
#define HexSweepAppend_h

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <vector>

namespace hexsweep
{
/// The hexahedra of a body and their boundary.
struct BodyMesh
{
  vtkSmartPointer<vtkUnstructuredGrid> hexes = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkSmartPointer<vtkUnstructuredGrid> boundary = vtkSmartPointer<vtkUnstructuredGrid>::New();
};

/**
 * Puts bodies after each other; no points are merged. `HexPointIds` and `HexId` of the boundary
 * count on. Point and cell arrays are those that all bodies have; the reports have the tuples of
 * one body after those of the other, and other field data are the first body's.
 *
 * @param bodies one at least.
 */
void appendBodies(
  const std::vector<BodyMesh>& bodies, vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary);
}

#endif

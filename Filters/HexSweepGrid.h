// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From swept quads to vtkUnstructuredGrid, without temporaries.
 *
 * New memory costs more than what is written to it: every array is filled once, in place, by the
 * threads of vtkSMPTools. What takes long reports progress and throws Aborted when it is to stop.
 * Private to the module.
 */
#ifndef HexSweepGrid_h
#define HexSweepGrid_h

#include "Core/Common/Mesh.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkDataSet;
class vtkDataSetAttributes;
class vtkIdTypeArray;
class vtkPoints;
class vtkUnstructuredGrid;

namespace hexsweep
{
/// @param precision a vtkAlgorithm::DesiredOutputPrecision; default precision means double here.
vtkSmartPointer<vtkPoints> newSweptPoints(
  const PointsRef& points, int precision, const Progress& progress);

/**
 * The connectivity of sweptHexes() in the array that the grid will hold.
 *
 * @param quads m x 4.
 * @param sourceIsBottom see there.
 * @return 8 ids for each of L m hexahedra.
 */
vtkSmartPointer<vtkIdTypeArray> newSweptConnectivity(const QuadsRef& quads, Index pointsPerLayer,
  Index layers, bool sourceIsBottom, const Progress& progress);

/// Such an array as Core sees hexahedra; valid as long as the array.
Eigen::Map<const Hexes> hexView(vtkIdTypeArray* connectivity);

/// Gives the grid such hexahedra, and takes the array in as it is.
void setSweptCells(
  vtkUnstructuredGrid* grid, vtkIdTypeArray* connectivity, const Progress& progress);

/**
 * Carries attributes to each layer: tuple k n + i of the output is tuple ids[i] of the source.
 * Global ids and ghost flags stay behind: copies of a point are not one point.
 *
 * @param ids n numbers of tuples.
 */
void carryAttributes(vtkDataSetAttributes* source, const std::vector<Index>& ids, Index layers,
  vtkDataSetAttributes* output, const Progress& progress);

/// The ids of one layer, repeated on each of them.
vtkSmartPointer<vtkIdTypeArray> newRepeatedIds(
  const char* name, const std::vector<Index>& ids, Index layers, const Progress& progress);

/// `SweepLayer`: 0 on the first `perLayer` tuples, then 1, ...
vtkSmartPointer<vtkIdTypeArray> newLayerNumbers(
  Index perLayer, Index layers, const Progress& progress);
}

#endif

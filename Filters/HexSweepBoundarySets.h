// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Blocks and sets of a swept mesh, with the arrays that vtkExodusIIReader gives them.
 * Private to the module.
 */
#ifndef HexSweepBoundarySets_h
#define HexSweepBoundarySets_h

#include "HexSweepSetNames.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

class vtkDataObject;
class vtkUnstructuredGrid;

namespace hexsweep
{
/// Some quads of the boundary.
struct BoundarySet
{
  SetName name;
  std::vector<vtkIdType> quads;
};

/**
 * One set a face in the order of their ids, then source, target and sides (those there are), with
 * names as nameSets() gives them; the names of faces are the field data array `FaceNames` of the
 * boundary, else of the hexahedra.
 *
 * @param hexes, boundary nullptr counts as missing.
 * @param roleSets        whether source, target and sides are sets as well.
 * @param chosen          ids of sets by name.
 * @throw InvalidInput when one of the inputs is missing or empty, has other cells, lacks an array,
 *        when the boundary is that of another mesh, or an id was chosen that cannot be.
 */
std::vector<BoundarySet> boundarySets(vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary,
  bool roleSets, const ChosenIds& chosen);

/// Field data array `VolumeName`, else "Volume" with the `VolumeId` (1: there is none); "Volumes"
/// where there are several, whose blocks have the writer's one name for a grid.
std::string volumeName(vtkUnstructuredGrid* hexes);

/**
 * The hexahedra with `ObjectId`, `GlobalElementId` and `GlobalNodeId` (these from 1 on, in the
 * order of `hexes`). Those on the boundary come first: vtkExodusIIWriter searches the elements from
 * the first one on for each side.
 */
vtkSmartPointer<vtkUnstructuredGrid> newElementBlock(
  vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary);

/// Quads with `SourceElementId` (from 0 on) and `SourceElementSide` (in VTK's order), and with the
/// set's `SetName` and `SetId` as field data.
vtkSmartPointer<vtkUnstructuredGrid> newSideSet(
  vtkUnstructuredGrid* boundary, const BoundarySet& set);

/// Vertex cells on the points of the quads, with `GlobalNodeId`, in the order of these, and field
/// data as newSideSet().
vtkSmartPointer<vtkUnstructuredGrid> newNodeSet(
  vtkUnstructuredGrid* boundary, const BoundarySet& set);

/// Copies the field data that newElementBlock() leaves out.
void passTextsAndReports(vtkUnstructuredGrid* hexes, vtkDataObject* output);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Faces of a solid, chosen by cells that were selected in a view. Private to the module.
 */
#ifndef HexSweepSelection_h
#define HexSweepSelection_h

#include "Core/Common/Mesh.h"
#include "HexSweepBodies.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkInformation;
class vtkSelection;

namespace hexsweep
{
/// Declares that a port takes a selection, and need not have one.
void acceptSelection(vtkInformation* portInformation);

/**
 * Ids of the faces that selected cells are part of, rising. Cells that are part of several faces
 * (of a volume mesh, along its edges) count where no other cell is selected only to be refused.
 *
 * @param solid     what the selection is of: a data set, or a collection of them.
 * @param selection nullptr: none is connected, and no face chosen.
 * @param cap       "source" or "target", for messages.
 * @param bodies    of the solid.
 * @throw InvalidInput: a selection that is no list of cells, without cells of the solid's surface,
 * of points, or of faces of several bodies; cells of which each is part of several faces.
 */
std::vector<Index> selectedFaces(vtkDataObject* solid, vtkSelection* selection,
  const std::string& cap, const std::vector<ReadBody>& bodies);
}

#endif

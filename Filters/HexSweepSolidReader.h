// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The boundary of a solid, with its face ids, from any data set. Private to the module.
 */
#ifndef HexSweepSolidReader_h
#define HexSweepSolidReader_h

#include "Core/Solids/SolidInput.h"

#include <string>

class vtkDataSet;

namespace hexsweep
{
/// A solid as it stands in a data set. Points and cells go by their ids there.
struct SolidData
{
  SolidInput surface;
  /// Body that each triangle is part of, of the cell array `VolumeId`; empty: there is none, or
  /// the boundary was made from volume cells.
  std::vector<Index> volumeIds;
  std::string faceIdArray;   ///< name of the cell array that was read; empty: none
  bool fromVolume = false;   ///< whether the boundary was made from volume cells
  Index ignoredCells = 0;    ///< vertex and line cells
  Index ignoredSurfaces = 0; ///< surface cells beside volume cells that do not bound the solid
};

/**
 * Reads the boundary of a solid.
 *
 * Polygons, quads and strips are triangulated. Of a mesh with volume cells the surface cells are
 * taken, with their ids: those on the boundary of the volume cells, if they cover it, else all of
 * them, if they form a closed surface. Otherwise the boundary of the volume cells is taken, which
 * has no ids.
 *
 * @param data        nullptr counts as missing.
 * @param faceIdArray cell array with the face ids; empty: `FaceId`, else `CellEntityIds`, else
 * none.
 * @throw InvalidInput: missing or empty data; an array that does not exist, is a point
 *        array or does not hold one whole number a cell; coordinates that are not finite.
 */
SolidData readSolid(vtkDataSet* data, const std::string& faceIdArray = {});
}

#endif

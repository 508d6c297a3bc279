// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The boundary of a solid, with its face ids, from any data set. Private to the module.
 */
#ifndef HexSweepSolidReader_h
#define HexSweepSolidReader_h

#include "Core/Solids/SolidInput.h"

#include <optional>
#include <string>

class vtkDataSet;

namespace hexsweep
{
/// A solid as it stands in a data set. Points and cells go by their ids there.
struct SolidData : SolidInput
{
  /// Quad cells of the boundary, for use as source quads.
  Quads quads;
  /// Cell of the data set that each quad is (or, of a volume mesh, is a face of).
  std::vector<Index> quadCellIds;
  /// Row of `quads` that each triangle is half of; -1: none.
  std::vector<Index> quadOfTriangle;
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

/// Quads of a solid's faces.
struct FaceQuads
{
  QuadMesh mesh;               ///< on the solid's points (merged), normals outward
  std::vector<Index> pointIds; ///< of the data set, one a point of the mesh
  std::vector<Index> cellIds;  ///< of the data set, one a quad
};

/**
 * The quad cells on some faces.
 *
 * @param data  what `solid` was made from.
 * @return nothing where the faces have a cell that is no quad or has collapsed.
 */
std::optional<FaceQuads> quadsOfFaces(
  const SolidData& data, const SolidSurface& solid, const std::vector<Index>& faceIds);
}

#endif

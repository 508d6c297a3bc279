// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Quads that the faces of a solid are meshed with already.
 */
#ifndef hexsweep_FaceQuads_h
#define hexsweep_FaceQuads_h

#include "Core/Solids/SolidInput.h"
#include "Core/Solids/SweepTopology.h"

#include <optional>

namespace hexsweep
{
/// Quads of a solid's faces.
struct FaceQuads
{
  QuadMesh mesh;               ///< on the solid's points (merged), normals outward
  std::vector<Index> pointIds; ///< see SolidInput::pointIds, one a point of the mesh
  std::vector<Index> cellIds;  ///< of SolidInput::quadCellIds, one a quad
};

/**
 * The quads on some faces.
 *
 * @param input what `solid` was made from.
 * @return nothing where the faces have a cell that is no quad or has collapsed.
 */
std::optional<FaceQuads> quadsOfFaces(
  const SolidInput& input, const SolidSurface& solid, const std::vector<Index>& faceIds);

/// By side of the topology: its faces that are meshed with quads. @param input as quadsOfFaces().
std::vector<std::vector<QuadMesh>> sidePatches(
  const SolidInput& input, const SolidSurface& solid, const SweepTopology& topology);
}

#endif

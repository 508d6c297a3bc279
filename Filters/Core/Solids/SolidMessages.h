// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Faces, cells and places of a solid as text, for messages to the user.
 */
#ifndef hexsweep_SolidMessages_h
#define hexsweep_SolidMessages_h

#include "Core/Solids/SolidSurface.h"

#include <string>

namespace hexsweep
{
/// "3, 4 and 7"; of a long list the first ten: "1, 2, 3, ... (25 in all)".
std::string listIds(const std::vector<Index>& ids);

/// "face 3", "faces 3, 4 and 7". @param faceIds rising, each once, at least one.
std::string listFaces(const std::vector<Index>& faceIds);

/// The middle of a triangle's corners.
Eigen::RowVector3d triangleCenter(const SolidSurface& solid, Index triangle);

/// "cell 12 of face 3"; "cell 12" where the solid has no face ids (yet).
std::string describeCell(const SolidSurface& solid, Index triangle);

/// "2 loops", "1 loop".
std::string countOf(std::size_t count, const std::string& thing);
}

#endif

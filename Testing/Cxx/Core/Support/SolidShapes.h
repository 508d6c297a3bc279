// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tessellated solids made of cubes.
 */
#ifndef SolidShapes_h
#define SolidShapes_h

#include "Support/CapMeshes.h"

#include "Core/Solids/SolidInput.h"
#include "Core/Solids/SolidSurface.h"

#include <array>
#include <functional>
#include <map>
#include <vector>

namespace test
{
using hexsweep::SolidInput;
using Cell = std::array<int, 3>;

/// Face id of a cube's side that lies outside: its cell and direction (1, 2: -x, +x; 3, 4: -y, +y;
/// 5, 6: -z, +z).
using SideLabel = std::function<Index(const Cell& cell, int direction)>;

/// Ten times the level of the plane, plus the direction: the top of a solid three high is 36.
Index planeLabel(const Cell& cell, int direction);

/// The boundary of the cubes of edge 1 in [0, nx] x [0, ny] x [0, nz] that are `filled`: two
/// triangles a side, normals outward, points shared wherever cubes meet.
SolidInput cubes(const Cell& size, const std::function<bool(int, int, int)>& filled,
  const SideLabel& label = planeLabel);

SolidInput box(int x, int y, int z, const SideLabel& label = planeLabel);

/// Every triangle gets three points of its own, as in an STL file.
SolidInput soup(const SolidInput& solid);

/// Without the triangles that are not to be kept.
SolidInput withTriangles(const SolidInput& solid, const std::function<bool(Index triangle)>& keep);

/// With one triangle more.
SolidInput withTriangle(SolidInput solid, Index a, Index b, Index c, Index faceId);

/// What the triangles enclose, by the divergence theorem.
double volumeOf(const hexsweep::SolidSurface& solid);
}

#endif

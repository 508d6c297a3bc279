// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where a cap turns back over itself.
 */
#ifndef hexsweep_SurfaceFolds_h
#define hexsweep_SurfaceFolds_h

#include "Core/Common/Mesh.h"

#include <optional>

namespace hexsweep
{
/// Two triangles that share an edge, the one on its back, the other upright.
struct SurfaceFold
{
  Index upright;            ///< row of the triangles
  Index turnedOver;         ///< row of the triangles
  Eigen::RowVector3d place; ///< middle of their edge
};

/**
 * Looks for an edge over which a surface is folded onto itself: its triangles face with and against
 * the surface's vector area by more than 45 degrees, and make an angle of less than 20 with each
 * other. Grooves with steep walls are none, nor are triangles lower than a thousandth of their
 * edge, whose normals say little.
 *
 * @param surface oriented, see orientFaces().
 * @return the first fold by triangle and corner.
 */
std::optional<SurfaceFold> findFold(const TriangleMesh& surface);
}

#endif

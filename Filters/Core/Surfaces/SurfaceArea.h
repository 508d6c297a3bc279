// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The area of a triangulated surface.
 */
#ifndef hexsweep_SurfaceArea_h
#define hexsweep_SurfaceArea_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
double surfaceArea(const TriangleMesh& mesh);
}

#endif

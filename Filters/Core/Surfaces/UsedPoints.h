// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which points of a mesh belong to a face.
 */
#ifndef hexsweep_UsedPoints_h
#define hexsweep_UsedPoints_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * @param faces m x 3 or m x 4 point ids in [0, numberOfPoints).
 * @return one entry a point: whether a face uses it.
 */
std::vector<bool> usedPoints(const FacesRef& faces, Index numberOfPoints);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Size, place and flatness of each face of a solid, for a list to choose from.
 */
#ifndef hexsweep_FaceMeasures_h
#define hexsweep_FaceMeasures_h

#include "Core/Solids/SolidSurface.h"

#include <vector>

namespace hexsweep
{
struct FaceMeasure
{
  Index id = 0;
  Index triangles = 0;
  double area = 0.0;
  Eigen::RowVector3d center = Eigen::RowVector3d::Zero(); ///< centroid of the area
  /// Length of the sum of the area vectors over the area, in [0, 1]; 1: plane, all triangles facing
  /// the same way; 0: closed round.
  double flatness = 0.0;
};

/// One entry a face, rising ids.
std::vector<FaceMeasure> measureFaces(const SolidSurface& solid);
}

#endif

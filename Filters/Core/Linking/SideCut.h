// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cuts a tube open along paths that lead from one end to the other.
 */
#ifndef hexsweep_SideCut_h
#define hexsweep_SideCut_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// A tube cut open along paths: points of a path have one copy on either side of it.
struct CutTube
{
  TriangleMesh mesh;           ///< the triangles of the tube, same rows, same first corners
  std::vector<Index> original; ///< point of the tube, one a point of `mesh`
  std::vector<bool> onLeft;    ///< one a point of `mesh`: the copy that lies left of path 0
};

/**
 * @param tube  an oriented 2-manifold, see checkSurface(); no isolated points are carried over.
 * @param paths one or more, each its points along edges of the tube from a boundary to a boundary;
 *        no two share a point. Left is as seen from the side that normals point to.
 */
CutTube cutTube(const TriangleMesh& tube, const std::vector<std::vector<Index>>& paths);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What grids on faces of linking sides begin with: nodes on the face's border, and the way
 * back to the face.
 */
#ifndef hexsweep_FaceRims_h
#define hexsweep_FaceRims_h

#include "Core/Assemblies/AssemblyGeometry.h"
#include "Core/Assemblies/AssemblyMesh.h"
#include "Core/Geometry/SurfaceSearch.h"

#include <string>
#include <vector>

namespace hexsweep
{
/// Row k, column j: the node.
using NodeGrid = Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// As messages name it.
std::string nameOf(const ComplexFace& face);

/// The nodes of a face's side, from the chain that was meant to be first.
struct FaceRim
{
  std::vector<Index> nodes;
  Points places;                 ///< of the nodes
  std::vector<double> fractions; ///< of the rim's length that are passed at each node, from 0 to 1
};

/// @param chain curves one behind the other. @param backwards from its last node to its first.
FaceRim faceRim(const AssemblyMesh& mesh, const std::vector<CurveUse>& chain, bool backwards);

/// The face's point for a place, on the true surface where it is known.
class FaceProjection
{
public:
  FaceProjection(const AssemblyComplex& complex, const AssemblyGeometry& geometry, Index face);
  /// Of a place from the face's triangles.
  double distance(const Eigen::RowVector3d& place) const;

  /// @param reach no CAD point farther away counts.
  Eigen::RowVector3d operator()(const Eigen::RowVector3d& place, double reach) const;

private:
  const AssemblyGeometry& Geometry;
  Index Face;
  SurfaceSearch Surface;
};

/// Quads between the rows of a grid. @param closed whether the last column is followed by the
/// first.
Quads gridQuads(const NodeGrid& grid, bool closed);
}

#endif

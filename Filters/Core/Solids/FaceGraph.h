// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The faces of a solid, how each one lies, and how neighbours meet.
 */
#ifndef hexsweep_FaceGraph_h
#define hexsweep_FaceGraph_h

#include "Core/Solids/FacePatches.h"
#include "Core/Solids/SolidSurface.h"
#include "Core/Surfaces/HalfEdgeTriangles.h"

#include <vector>

namespace hexsweep
{
/// Of lines in Pluecker coordinates (direction, moment): mean of their dyads.
using NormalLines = Eigen::Matrix<double, 6, 6>;

/// How a face lies in space.
struct FaceShape
{
  double area = 0.0;
  Eigen::RowVector3d center = Eigen::RowVector3d::Zero(); ///< of the area
  /// Mean of the unit normals by area: its length is 1 for a plane face, 0 for a closed tube.
  Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d moment = Eigen::RowVector3d::Zero(); ///< mean of r x n by area, see `lines`
  /// Mean of l^T l by area, l = (n, r x n) the lines of the unit normals n at the places r from
  /// FaceGraph::center in units of FaceGraph::radius: v L v^T is the mean square of the velocity
  /// across the face in the rigid motion v.
  NormalLines lines = NormalLines::Zero();
  std::vector<Index> patches;      ///< see FacePatches; a cap's face has one
  std::vector<Index> borderPoints; ///< shared with other faces, rising
  Index innerPoints = 0;           ///< number of the others

  /// Mean of n^T n by area, n the unit normals: d M d^T is the mean of (n d)^2.
  Eigen::Matrix3d spread() const { return this->lines.topLeftCorner<3, 3>(); }
};

/// Two faces with a common border. Faces go by numbers: their place among FacePatches::ids.
struct FaceContact
{
  std::size_t first = 0; ///< the lower number
  std::size_t second = 0;
  std::vector<Index> halfEdges; ///< of the first face
  double length = 0.0;
  double sharpest = 0.0; ///< greatest angle between normals across the border, radians
};

struct FaceGraph
{
  const SolidSurface& solid;
  HalfEdgeTriangles halfEdges;
  FacePatches patches;
  std::vector<std::vector<Index>> patchNeighbors; ///< see patchNeighbors()
  std::vector<std::size_t> faceOfPatch;
  std::vector<double> triangleAreas;
  /// One a half-edge: by how much the normal turns across it, radians in (-pi, pi], positive where
  /// the solid is convex. A block has pi / 2 at its edges.
  std::vector<double> turns;
  std::vector<FaceShape> faces;
  std::vector<FaceContact> contacts; ///< by first face, then second
  std::vector<std::vector<std::size_t>> contactsOfFace;
  Index genus = 0; ///< number of handles (through holes) of the solid
  Eigen::RowVector3d center = Eigen::RowVector3d::Zero(); ///< of the points' box
  double radius = 1.0;                                    ///< of the points' box

  double edgeLength(Index half) const;
  std::size_t faceBeyond(Index half) const; ///< the face on the other side of a half-edge
};

/// Costs O(n log n). @param solid must outlive the graph.
FaceGraph makeFaceGraph(const SolidSurface& solid);

/// Numbers of the faces with these ids, rising; ids that no face has do not matter.
std::vector<std::size_t> facesWithIds(const FaceGraph& graph, const std::vector<Index>& ids);

/**
 * Steps from some faces to each face over common borders; the start has 0.
 *
 * @param start numbers of faces.
 */
std::vector<Index> stepsFrom(const FaceGraph& graph, const std::vector<std::size_t>& start);

/**
 * Connected sets of faces.
 *
 * @param isMember one a face: faces that are not are in no set.
 * @param joins    whether a contact of two members joins them.
 * @return each set rising, sets by their first face.
 */
std::vector<std::vector<std::size_t>> connectedFaces(const FaceGraph& graph,
  const std::vector<char>& isMember, const std::function<bool(const FaceContact&)>& joins);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The surface of all linking sides, made ready to be split and meshed, and its ends.
 */
#ifndef hexsweep_LinkingSurface_h
#define hexsweep_LinkingSurface_h

#include "Core/Common/Mesh.h"

#include <string>
#include <vector>

namespace hexsweep
{
/// The surface of all linking sides, as it is given.
struct LinkingSurface
{
  TriangleMesh mesh;          ///< any orientation
  std::vector<Index> faceIds; ///< one a triangle, or empty
  Quads quads{ 0, 4 };        ///< cells that were quads before they were cut into triangles
  /// Row of `quads` that each triangle is half of, -1: none; or empty.
  std::vector<Index> quadOfTriangle;
};

/**
 * Joins coincident points of open edges, orients each piece, and finds the faces where there are no
 * ids. Points keep their numbers; those that were joined to others are left unused.
 *
 * @param matchTolerance see weldOpenEdges().
 * @param featureAngle   radians, see facesByFeatureAngle(); looked at where `given` has no face
 * ids.
 * @throw InvalidInput for a surface that cannot be oriented or an angle out of range.
 */
LinkingSurface joinLinkingSurface(LinkingSurface given, double matchTolerance, double featureAngle);

/// Row of the loops that each quad of a LinkingMesh on them belongs to.
std::vector<Index> loopsOfQuads(const std::vector<Loop>& loops, Index layers);

/**
 * What to say where the last rings of linking sides miss the target cap.
 *
 * @param nodes  of a LinkingMesh on `loops`. @param target any orientation.
 * @param matchTolerance see boundaryMismatch().
 * @return empty where they do not.
 * @throw InvalidInput when the target is no cap.
 */
std::string describeMissedTarget(const PointsRef& nodes, const std::vector<Loop>& loops,
  Index layers, const TriangleMesh& target, double matchTolerance);
}

#endif

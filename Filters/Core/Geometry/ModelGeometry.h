// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The true surfaces and curves that a solid's facets stand for, whoever has them.
 */
#ifndef hexsweep_ModelGeometry_h
#define hexsweep_ModelGeometry_h

#include "Core/Common/Mesh.h"

#include <optional>
#include <string>
#include <vector>

namespace hexsweep
{
/// Triangles of the faces of a solid, whose points neighbouring faces share.
struct ModelFacets
{
  Points points;
  Triangles triangles;        ///< outward
  std::vector<Index> faceIds; ///< one a triangle
};

/**
 * A solid as a CAD kernel knows it; ids of faces are those of the solid's triangles.
 *
 * All functions may be called from any thread at any time, and give the same bits each time.
 */
class ModelGeometry
{
public:
  virtual ~ModelGeometry() = default;

  /**
   * The point of a face's surface nearest to a place near the face. The surface may go on beyond
   * the borders of the face, by as much as its parameters allow.
   *
   * @return nothing when there is no such face, or no point is found.
   */
  virtual std::optional<Eigen::RowVector3d> closestOnFace(
    Index faceId, const Eigen::RowVector3d& place) const = 0;

  /// Unit normal of a face at the point nearest to a place, outward. @return nothing as above, and
  /// where the surface has none (at the tip of a cone).
  virtual std::optional<Eigen::RowVector3d> normalOnFace(
    Index faceId, const Eigen::RowVector3d& place) const = 0;

  /// What kind of surface a face has, in a word: "plane", "cylinder", "cone", "sphere", "torus",
  /// "spline", "extrusion", "revolution", "offset", else "other"; empty when there is no such face.
  virtual std::string surfaceType(Index faceId) const = 0;

  /// Ids of the edges that two different faces share, rising.
  virtual std::vector<Index> edgesBetween(Index faceId, Index otherFaceId) const = 0;

  /// The point of an edge nearest to a place, between the edge's ends.
  virtual std::optional<Eigen::RowVector3d> closestOnEdge(
    Index edgeId, const Eigen::RowVector3d& place) const = 0;

  /// Where an edge ends: two points, or none for one that is closed and smooth there.
  virtual Points endsOfEdge(Index edgeId) const = 0;

  /**
   * Triangles that stay near the surfaces.
   *
   * @param deflection greatest distance, a length.
   * @param angle      greatest turn from facet to facet, radians.
   * @return nothing when the kernel finds none.
   */
  virtual std::optional<ModelFacets> facets(
    double deflection, double angle, const Progress& progress = {}) const = 0;
};
}

#endif

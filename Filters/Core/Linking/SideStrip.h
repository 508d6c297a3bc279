// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Maps a linking side, which is a tube, to a strip: v round the tube, u along the sweep.
 *
 * Step (3) of the introduction of Cai and Tautges (2013) asks for structured quads on the linking
 * sides. They are laid out in this strip, where u is 0 on the source loop and 1 on the target loop.
 */
#ifndef hexsweep_SideStrip_h
#define hexsweep_SideStrip_h

#include "Core/Linking/StripColumn.h"

#include <optional>

namespace hexsweep
{
/// A linking side as it is given.
struct SideTube
{
  TriangleMesh surface;       ///< a tube: one oriented piece with two boundary loops, no handle
  std::vector<Index> faceIds; ///< one a triangle: borders between faces are CAD edges; or empty
  Loop sourceLoop;            ///< its boundary on the source cap, in any direction
  /// Parts that are meshed already, with structured quads from the source to the target loop, in
  /// the same place as their triangles in `surface`.
  std::vector<QuadMesh> patches;
  /// What the metric of the strip has of the depth of steps, see ruledShape(); in (0, 1].
  double stepDepth = 1.0;
  /// The map of its columns is made of no fewer triangles than about four times this.
  double leastTriangles = 500.0;
};

/**
 * Harmonic map to the strip [0, 1) x [0, 1], periodic in v.
 *
 * u and v are harmonic; v is the fraction of the source loop's length there, CAD edges have a
 * constant v and u by their length in the same metric (or see EdgeHeights), and v on the target
 * loop goes by length between them. Without CAD edges the target loop is turned as the conjugate of
 * u has it. With boundary values like these a harmonic map to a flat strip is one-to-one where its
 * weights are positive \cite Floater2003OneToOne.
 */
struct SideStrip
{
  TriangleMesh surface;  ///< the side, long edges and chords halved; same shape
  Points shape;          ///< of the surface's points: in its metric the map is harmonic
  bool hasSteps = false; ///< whether the side is ruled but for some steps, see ruledShape()
  std::vector<Index> triangleOrigin; ///< row of the given triangles
  Loop source;                       ///< the way v rises
  Loop target;                       ///< the way v rises
  std::vector<double> sourceV;       ///< of the loop's points, rising within less than 1
  std::vector<double> targetV;
  std::vector<StripColumn> columns; ///< in the order of the source loop
  PlanePoints plane;                ///< (v, u) of the points of the tube cut open
  Triangles planeTriangles;         ///< rows of surface.triangles with points of `plane`
  Index flipped = 0;                ///< triangles that are not positively oriented in the strip
};

/// Heights u of the points of CAD edges.
enum class EdgeHeights
{
  ByLength,
  OfNeighborhood ///< as in a strip that knows no CAD edge, see risingHeights()
};

/**
 * @param longestEdge edges of the side that are longer are halved first, so that the map is as
 *        smooth as the mesh that is to come; > 0.
 * @throw InvalidInput when the side is no tube or its source loop is none of its boundaries;
 *        SolverFailure.
 */
SideStrip mapSideToStrip(
  const SideTube& side, double longestEdge, EdgeHeights heights = EdgeHeights::ByLength);

/// @return the place of the target loop at v, any number, period 1.
Eigen::RowVector3d pointOnTarget(const SideStrip& strip, double v);
}

#endif

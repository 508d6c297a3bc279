// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief All linking sides of a sweep, meshed with structured quads (see SideTubeMesh.h).
 */
#ifndef hexsweep_LinkingSides_h
#define hexsweep_LinkingSides_h

#include "Core/Common/ParallelFor.h"
#include "Core/Geometry/AffineMap.h"
#include "Core/Linking/LinkingSideColumns.h"
#include "Core/Linking/LinkingSurface.h"
#include "Core/Linking/RingStack.h"

namespace hexsweep
{
/// How many layers there are to be, and how thick.
struct LayerRequest
{
  Index layers = 10;
  double size = 0.0;             ///< wanted mean thickness; not 0: counts instead of `layers`
  Index mostLayers = 0;          ///< of layers by `size`; 0: any number
  double growth = 1.0;           ///< see layerFractions()
  bool bothEnds = false;         ///< see layerFractions()
  std::vector<double> positions; ///< not empty: counts instead of all of these
};

struct LinkingMesh
{
  /// Side after side (loop after loop of the quads), see stackRings().
  RingStack rings;
  /// Side after side, quad k n + j is that between columns j and j + 1, rings k and k + 1.
  Quads quads{ 0, 4 };
  std::vector<Index> quadSide;     ///< row of the given sides
  std::vector<Index> quadTriangle; ///< row of that side's triangles below the quad's middle
  std::vector<Index> quadLayer;
  std::vector<Index> nodeRing; ///< 0 ... layers
  /// Of each node: the point of the quads that its column begins at.
  std::vector<Index> sourcePoint;
  std::vector<Points> edges; ///< one a column, loop after loop, see SideTubeMesh
  double meanColumnLength = 0.0;
  Index keptEdges = 0;                         ///< columns that are CAD edges
  std::vector<Eigen::RowVector3d> lostEdges;   ///< see LinkingSideColumns
  std::vector<Eigen::RowVector3d> lostCorners; ///< see LinkingSideColumns
  std::vector<std::string> refusedPatches;     ///< see LinkingSideColumns
  std::vector<bool> hasSteps;                  ///< one a given side, see LinkingSideColumns
  Index flipped = 0;                           ///< see LinkingSideColumns
};

/**
 * Splits a surface into its pieces, each of which is a linking side. Faces that consist of quads
 * alone become patches (see SideTube).
 *
 * @param quadPoints, quadLoops of the source quads: the boundary of a piece that is nearest to one
 *        of them is its source loop.
 * @throw InvalidInput naming the piece that is no tube, or when pieces and loops do not pair up.
 */
std::vector<SideTube> splitLinkingSides(
  const LinkingSurface& surface, const PointsRef& quadPoints, const std::vector<Loop>& quadLoops);

/**
 * @param quadPoints, quadLoops boundary of the source quads, see checkSurface().
 * @param sides one a loop, in any order.
 * @param matchTolerance see LinkingSideColumns.
 * @throw InvalidInput when sides and loops do not pair up, the layers asked for are none (see
 *        LayerSpacing.h), or a side cannot be meshed; SolverFailure; Aborted.
 */
LinkingMesh meshLinkingSides(const PointsRef& quadPoints, const std::vector<Loop>& quadLoops,
  const std::vector<SideTube>& sides, const LayerRequest& request, double matchTolerance = 1e-6,
  const Progress& progress = {}, const ParallelFor& parallelFor = {});

/**
 * The same with columns that run straight to their images, see RuledColumns; patches of the sides
 * are not looked at.
 *
 * @param map of the source cap to the target cap, see findAffineSweep().
 */
LinkingMesh meshRuledSides(const PointsRef& quadPoints, const std::vector<Loop>& quadLoops,
  const std::vector<SideTube>& sides, const LayerRequest& request, const AffineMap& map,
  const Progress& progress = {}, const ParallelFor& parallelFor = {});
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Hexahedra for a solid with several caps at both ends of one direction.
 */
#ifndef hexsweep_StackSweep_h
#define hexsweep_StackSweep_h

#include "Core/Common/ParallelFor.h"
#include "Core/Common/Stopwatch.h"
#include "Core/Geometry/ModelGeometry.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Stacks/CapLikeFaces.h"
#include "Core/Stacks/StackColumns.h"

#include <functional>
#include <string>
#include <vector>

namespace hexsweep
{
struct StackOptions
{
  double size = 0.0;      ///< edge length of the hexahedra; 0: chosen
  double layerSize = 0.0; ///< thickness of layers; 0: as `size`
  Index layers = 0;       ///< from the lowest to the highest cap; 0: by thickness
  /// Over the size: curves of caps that are nearer to each other than this become one.
  double imprintTolerance = 0.05;
  double chordTolerance = 0.0;             ///< see CapQuadOptions
  bool ensureValid = true;                 ///< untangle what is not certified
  bool improveQuality = true;              ///< raise low scaled Jacobians
  const ModelGeometry* geometry = nullptr; ///< true surfaces, on which nodes are put; may be none
  /// Takes points of the solid's coordinates, n x 3, to the space in which hexahedra are judged and
  /// returned, see RevolvedSpace; empty: they are there.
  std::function<Points(const PointsRef&)> toSpace;
  ParallelFor parallelFor;
};

/// An outer quad, as StackQuad, with the face of the solid behind it.
struct StackBoundaryQuad
{
  std::array<Index, 4> points; ///< outward
  Index hex;
  int side; ///< see StackQuad
  Index faceId;
  StackFaceKind kind; ///< Bottom, Top or Side
};

struct StackMesh
{
  Points points;                 ///< n x 3, in the solid's coordinates
  Hexes hexes;                   ///< m x 8, right-handed
  std::vector<Index> planeNodes; ///< one a point: number of its column of nodes
  std::vector<Index> quadOf;     ///< one a hexahedron: number of its column
  std::vector<Index> layerOf;    ///< one a hexahedron: from the bottom of its column
  std::vector<StackBoundaryQuad> boundary;
  std::vector<HexQuality> qualities; ///< certified
  std::string method;                ///< what was done, in words
  double size = 0.0;                 ///< asked for or chosen
  double refusedSize = 0.0;          ///< that would have given too many hexahedra; 0: none
  Index regions = 0;
  Index levels = 0;
  Index invertedQuads = 0;
  double greatestGap = 0.0; ///< between curves that became one, see PlaneGraph
  Index snapped = 0;        ///< columns that were put on true surfaces
  Index unsnapped = 0;      ///< that could not be
  double volume = 0.0;      ///< of the hexahedra
  std::vector<std::string> warnings;
  std::vector<Stage> stages;
};

/// The size that StackOptions::size = 0 stands for.
double chosenStackSize(const SolidSurface& solid, const CapLikeFaces& faces);

/**
 * Meshes a solid whose faces are all sides or caps of one direction: the plane across it is parted
 * by the borders of all caps and meshed once, and each part has columns of hexahedra between the
 * caps over it.
 *
 * Bits do not depend on the number of threads.
 *
 * @param faces along the direction, CapLikeFaces::isStack().
 * @throw InvalidInput where the solid cannot be meshed in this way, with faces or places; Aborted.
 */
StackMesh sweepStack(const SolidSurface& solid, const CapLikeFaces& faces,
  const StackOptions& options, const Progress& progress = {});
}

#endif

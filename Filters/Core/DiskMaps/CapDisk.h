// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One cap and its image in the disk.
 */
#ifndef hexsweep_CapDisk_h
#define hexsweep_CapDisk_h

#include "Core/Common/Errors.h"
#include "Core/DiskMaps/DiskDomain.h"
#include "Core/DiskMaps/FilledDiskMap.h"
#include "Core/DiskMaps/KoebeMap.h"
#include "Core/Surfaces/TriangulationImprovement.h"

#include <optional>
#include <string>
#include <utility>

namespace hexsweep
{
/// One cap in the disk.
struct CapDisk
{
  TriangleMesh mesh; ///< original points first; positively oriented with its partner
  Index numberOfOriginalPoints = 0;
  /// Row of the cap as it was given in which each triangle lies (its middle, after edge flips).
  std::vector<Index> triangleOrigin;
  PlanePoints disk; ///< one row a point of mesh
  DiskDomain domain = DiskDomain::Disk;
  std::vector<Loop> loops; ///< outer first
  std::vector<Circle> holes;
  Weights weights = Weights::Cotangent; ///< what was used in the end
  /// Triangles that are flipped in the disk (rows of mesh.triangles).
  std::vector<Index> flipped;
  /// How many were flipped with the weights that were wanted, before any fallback.
  Index flipsBefore = 0;
  /// Greatest distance between a ring node and the cap's own boundary polygon.
  double maximumBoundaryDistance = 0.0;
  /// The record of Koebe's iteration; empty where it did not run.
  std::vector<KoebeRound> rounds;
  /// See KoebeMap; one number a loop, or empty.
  std::vector<double> circularity;
  bool converged = true; ///< whether the iteration came to its tolerance
  /// Why Koebe's iteration could not be used and circles by arc length stand in; empty where not.
  std::string koebeFailure;
  TriangulationImprovement improvement = TriangulationImprovement::Off; ///< what is allowed
  Index edgeFlips = 0;   ///< of the surface's own edges
  Index addedPoints = 0; ///< that the improvement took
};

/**
 * Harmonic map with the boundary vertices at the given places of the plane.
 *
 * @param places places[p] belongs to loops[p], a row a node.
 * @return a row a point of the mesh.
 * @throw SolverFailure.
 */
PlanePoints mapToPlane(const TriangleMesh& mesh, const std::vector<Loop>& loops,
  const std::vector<PlanePoints>& places, Weights weights);

/// Shrinks circles until they keep clear of each other and of the unit circle.
/// @throw InvalidInput when two centres coincide or one lies on the unit circle.
void separateCircles(std::vector<Circle>& circles);

/**
 * Angles of a hole's nodes about its centre: clockwise by arc length, turned as a whole so that
 * they fit where a map has the nodes.
 *
 * @param lengths arc lengths along the loop, scaled to [0, 2 pi).
 * @param disk    the map, a row a point; those of the loop's nodes are read.
 * @return radians, one a node, falling.
 */
std::vector<double> holeAngles(const std::vector<double>& lengths, const PlanePoints& disk,
  const Loop& loop, const Circle& hole);

/**
 * Carries out planImprovement(`asked`) on a cap's mesh and lets mapWithFallback() do the rest; with
 * Off nothing changes.
 *
 * @param asked the cap as it was given, before points were put on its loops and chords.
 * @return the weights to map with: `weights`, or intrinsic instead of cotangent ones where edges
 *         that cannot be flipped leave the triangulation stretched, and always with On.
 */
Weights improveCap(
  CapDisk& cap, const TriangleMesh& asked, Weights weights, TriangulationImprovement improvement);

/**
 * Calls map(weights) and keeps what has the fewest flips. Fills disk, weights, flipped and
 * flipsBefore.
 *
 * The wanted weights come first. Where they fold: those of the intrinsic Delaunay triangulation
 * (unless improvement is Off), then mean value weights, then intrinsic ones with the triangles cut
 * (see cutAlongIntrinsicEdges()), which changes mesh and triangleOrigin. With On mean value
 * weights are the last to be tried.
 *
 * @param map a map of cap.mesh as it is before the call; one row a point.
 */
void mapWithFallback(CapDisk& cap, Weights weights, const std::function<PlanePoints(Weights)>& map);

/**
 * The same for mapToPlane() of cap.mesh. Where the domain is not convex a harmonic map can flip
 * triangles beside a hole whatever its weights: their edges are then halved (not with Off) and the
 * map made again.
 */
void mapWithFallback(CapDisk& cap, Weights weights, const std::vector<PlanePoints>& places);

/**
 * The map with an improvement of the triangulation, or the one without it where that one flips
 * fewer triangles or the improvement fails: what is meant to help must never stand in the way.
 *
 * @param map   called with the improvement, then, if need be, with Off.
 * @param flips of one of its results: how many triangles are flipped.
 */
template <typename Map, typename Flips>
auto improvedOrPlain(TriangulationImprovement improvement, const Map& map, const Flips& flips)
{
  const auto plain = [&] { return map(TriangulationImprovement::Off); };
  if (improvement == TriangulationImprovement::Off)
  {
    return plain();
  }
  std::optional<decltype(plain())> improved;
  try
  {
    improved = map(improvement);
  }
  catch (const InvalidInput&)
  {
    return plain();
  }
  catch (const SolverFailure&)
  {
    return plain();
  }
  if (flips(*improved) > 0)
  {
    auto other = plain();
    if (flips(other) < flips(*improved))
    {
      return other;
    }
  }
  return *std::move(improved);
}
}

#endif

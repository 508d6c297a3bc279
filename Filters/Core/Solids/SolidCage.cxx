// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SolidCage.h"

#include "Core/CapQuads/ImageProjection.h"
#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Interior/RingCollapse.h"
#include "Core/Solids/AffineSweep.h"
#include "Core/Solids/CapCrossings.h"
#include "Core/Solids/SolidSides.h"
#include "Core/Surfaces/SurfacePart.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "Core/Surfaces/UsedPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
/// Source quads this far from the source cap (of the cap's diameter) are another cap's.
constexpr double FarFromCap = 0.05;
/// Of the edges beside it: a column's end does not go further to the end of a border.
constexpr double MostPinned = 0.25;
/// Of a turn between edges: columns that end at corners of the target's loop stay there.
constexpr double CornerCosine = 0.86;
/// Of the quads: more that the projection inverts are not untangled between fixed borders.
constexpr double MostInverted = 0.01;
/// Scaled Jacobian of the quads beside borders that is good enough not to be compared with those
/// that left them.
constexpr double LeastHeld = 0.1;

SurfacePart partOf(const SolidSurface& solid, const std::vector<Index>& rows)
{
  return surfacePart(solid.points, solid.triangles, rows);
}

/// The target quads' boundary nodes are those of the last rings, bit for bit.
void snapTarget(Points& target, const RingStack& rings)
{
  for (std::size_t l = 0; l < rings.loops.size(); ++l)
  {
    const Points last = ringPoints(rings, l, rings.numberOfLayers());
    for (std::size_t j = 0; j < rings.loops[l].size(); ++j)
    {
      target.row(rings.loops[l][j]) = last.row(static_cast<Index>(j));
    }
  }
}

double distanceFromCap(
  const QuadMesh& quads, const TriangleMesh& cap, const ParallelFor& parallelFor)
{
  constexpr Index PointsAtOnce = 1024;
  const TriangleSearch search(cap.points, cap.triangles);
  const std::vector<bool> used = usedPoints(quads.quads, quads.points.rows());
  Eigen::VectorXd distances = Eigen::VectorXd::Zero(quads.points.rows());
  forPieces(parallelFor, distances.size(), PointsAtOnce, [&](Index begin, Index end) {
    Index near = -1;
    for (Index point = begin; point < end; ++point)
    {
      if (used[at(point)])
      {
        const TrianglePoint found = search.closest(quads.points.row(point), near);
        near = found.triangle;
        distances[point] = found.distance;
      }
    }
  });
  Index place = 0;
  const double greatest = distances.maxCoeff(&place);
  const double diameter =
    (cap.points.colwise().maxCoeff() - cap.points.colwise().minCoeff()).norm();
  if (greatest > FarFromCap * diameter)
  {
    throw InvalidInput("the source quads do not lie on the source cap: point " +
      std::to_string(place) + " at " + describe(quads.points.row(place)) + " is " +
      describe(greatest) + " away from it, and the cap measures " + describe(diameter) +
      ". Name the faces under these quads as source faces, or give quads that mesh the source "
      "cap.");
  }
  return greatest;
}

/// Whether structured quads of one layer, as walls of an extrusion are given, are all there is:
/// every node lies on a loop.
bool isOneLayer(const QuadMesh& patch, const SolidSurface& solid, const SweepSide& side)
{
  std::set<std::array<double, 3>> nodes;
  for (const Loop* loop : { &side.sourceLoop, &side.targetLoop })
  {
    for (const Index point : *loop)
    {
      nodes.insert({ solid.points(point, 0), solid.points(point, 1), solid.points(point, 2) });
    }
  }
  for (Index i = 0; i < patch.points.rows(); ++i)
  {
    if (nodes.count({ patch.points(i, 0), patch.points(i, 1), patch.points(i, 2) }) == 0)
    {
      return false;
    }
  }
  return true;
}

/// Where sides are meshed already, their nodes come before straight columns, and so does a method
/// that was asked for by name.
std::optional<AffineSweep> affineSweepOf(const SolidCageInput& input)
{
  if (input.method != ProjectionMethod::Harmonic)
  {
    return std::nullopt;
  }
  for (std::size_t s = 0; s < input.patches.size(); ++s)
  {
    for (const QuadMesh& patch : input.patches[s])
    {
      if (!isOneLayer(patch, input.solid, input.topology.sides[s]))
      {
        return std::nullopt;
      }
    }
  }
  return input.affine ? *input.affine : findAffineSweep(input.solid, input.topology);
}

/**
 * Columns end where the borders of the target's faces do.
 *
 * @return the nodes that lie on no loop.
 */
std::vector<FixedNode> pinColumns(const std::vector<FixedNode>& imprinted, RingStack& rings)
{
  std::map<Index, std::pair<std::size_t, Index>> columnOf;
  for (std::size_t l = 0; l < rings.loops.size(); ++l)
  {
    for (std::size_t j = 0; j < rings.loops[l].size(); ++j)
    {
      columnOf[rings.loops[l][j]] = { l, static_cast<Index>(j) };
    }
  }
  std::vector<FixedNode> inner;
  for (const FixedNode& node : imprinted)
  {
    const auto column = columnOf.find(node.point);
    if (column == columnOf.end())
    {
      inner.push_back(node);
      continue;
    }
    const auto& [l, j] = column->second;
    const Index n = static_cast<Index>(rings.loops[l].size());
    const auto last = rings.tables[l].row(rings.numberOfLayers());
    const Eigen::RowVector3d here = rings.points.row(last[j]);
    const Eigen::RowVector3d in = here - rings.points.row(last[(j + n - 1) % n]);
    const Eigen::RowVector3d out = rings.points.row(last[(j + 1) % n]) - here;
    const bool isCorner = in.dot(out) < CornerCosine * in.norm() * out.norm();
    if (!isCorner && (node.position - here).norm() < MostPinned * std::min(in.norm(), out.norm()))
    {
      rings.points.row(last[j]) = node.position;
    }
  }
  return inner;
}

/// Target quads as image of the source quads, straight columns. @return whether all quads are
/// valid.
bool sweepToImage(const SolidCageInput& input, const AffineSweep& image, const TriangleMesh& target,
  const Progress& progress, StageClock& stages, SolidCage& cage)
{
  cage.linking = meshRuledSides(input.source.points, cage.loops,
    solidSides(input.solid, input.topology, input.patches), input.layers, image.map,
    progressPart(progress, 0.0, 0.4), input.parallelFor);
  stages.finish("Linking sides");
  const std::vector<FixedNode> borders = pinColumns(input.imprinted, cage.linking.rings);
  const RingStack& rings = cage.linking.rings;
  std::vector<FixedNode> boundary;
  for (std::size_t l = 0; l < cage.loops.size(); ++l)
  {
    const Points last = ringPoints(rings, l, rings.numberOfLayers());
    for (std::size_t j = 0; j < cage.loops[l].size(); ++j)
    {
      boundary.push_back({ cage.loops[l][j], last.row(static_cast<Index>(j)) });
    }
  }
  cage.projection = projectToImage(
    input.source, image.map, boundary, borders, target, input.singlePrecision, input.parallelFor);
  stages.finish("Target quads");
  return cage.projection.quality.inverted == 0;
}

/// @param quadLoops of the source quads.
BoundaryMismatch sourceMismatch(
  const SolidCageInput& input, const SurfacePart& source, const std::vector<Loop>& quadLoops)
{
  std::vector<Loop> loops;
  for (const SweepSide& side : input.topology.sides)
  {
    loops.emplace_back();
    for (const Index point : side.sourceLoop)
    {
      loops.back().push_back(source.idOf(point));
    }
  }
  std::vector<Points> rings;
  for (const Loop& loop : quadLoops)
  {
    rings.push_back(loopPoints(input.source.points, loop));
  }
  return boundaryMismatch(source.mesh.points, loops, rings, input.matchTolerance);
}

/// Nodes stay on the target's borders unless quads would be inverted for it.
SweepProjection projectWithBorders(
  SweepProjectionInput input, const Progress& progress, bool& leftBorders)
{
  const bool ensureValid = std::exchange(input.ensureValid, false);
  const bool improveQuality = std::exchange(input.improveQuality, false);
  const SweepProjection first = projectSweep(input, progressPart(progress, 0.0, 0.5));
  const double inverted = static_cast<double>(first.quality.inverted);
  if (input.method == ProjectionMethod::Harmonic && !first.carried)
  {
    input.sourceDisk = first.source;
    input.targetDisk = first.target;
  }
  input.ensureValid = ensureValid;
  input.improveQuality = improveQuality;
  const auto again = [&](const Progress& part) {
    SweepProjection result = projectSweep(input, part);
    result.sourceMismatch = first.sourceMismatch;
    result.targetMismatch = first.targetMismatch;
    return result;
  };
  std::optional<SweepProjection> held;
  if (inverted <= MostInverted * static_cast<double>(input.source.quads.rows()))
  {
    held = again(progressPart(progress, 0.5, 0.75));
    if (held->quality.inverted == 0 && held->quality.minimum >= LeastHeld)
    {
      return *std::move(held);
    }
  }
  input.borders.clear();
  SweepProjection free = again(progressPart(progress, 0.75, 1.0));
  leftBorders = !held || free.quality.inverted < held->quality.inverted ||
    (held->quality.inverted == 0 && free.quality.inverted == 0 &&
      free.quality.minimum > 2.0 * held->quality.minimum);
  return leftBorders ? std::move(free) : *std::move(held);
}

void sweepThroughDisks(const SolidCageInput& input, const TriangleMesh& source,
  const TriangleMesh& target, const Progress& progress, StageClock& stages, SolidCage& cage)
{
  std::vector<SideTube> sides =
    solidSides(input.solid, input.topology, input.patches, input.freeSides);
  for (SideTube& side : sides)
  {
    // Nodes that there are stay where they are.
    side.stepDepth = side.patches.empty() ? input.stepDepth : 1.0;
    side.leastTriangles = input.leastTriangles;
  }
  cage.linking = meshLinkingSides(input.source.points, cage.loops, sides, input.layers,
    input.matchTolerance, progressPart(progress, 0.0, 0.4), input.parallelFor);
  stages.finish("Linking sides");
  SweepProjectionInput projection;
  projection.source = input.source;
  projection.target = target;
  projection.sourceSurface = source;
  projection.matchTolerance = input.matchTolerance;
  projection.singlePrecision = input.singlePrecision;
  projection.ensureValid = input.ensureValid;
  projection.improveQuality = input.improveQuality;
  projection.method = input.method;
  projection.weights = input.weights;
  projection.improvement = input.improvement;
  projection.parallelFor = input.parallelFor;
  projection.borders = pinColumns(input.imprinted, cage.linking.rings);
  projection.linking = cage.linking.rings;
  cage.projection = projection.borders.empty()
    ? projectSweep(projection, progressPart(progress, 0.4, 1.0))
    : projectWithBorders(std::move(projection), progressPart(progress, 0.4, 1.0), cage.leftBorders);
  stages.finish("Target quads");
}
}

SolidCage makeSolidCage(const SolidCageInput& input, const Progress& progress)
{
  const SurfaceTopology topology =
    checkSurface(input.source.quads, input.source.points.rows(), "source quads");
  checkCap(topology, "source quads");
  if (topology.loops.size() != input.topology.sides.size())
  {
    throw InvalidInput("the source quads have " + std::to_string(topology.loops.size() - 1) +
      " holes and the source cap of the solid has " +
      std::to_string(input.topology.sides.size() - 1) +
      ". Mesh the whole source cap with quads, and leave out each of its holes.");
  }
  SolidCage cage;
  StageClock stages;
  cage.loops = topology.loops;
  checkCapCrossings(input.solid, input.topology.sourceTriangles, "source cap");
  checkCapCrossings(input.solid, input.topology.targetTriangles, "target cap");
  const SurfacePart source = partOf(input.solid, input.topology.sourceTriangles);
  const SurfacePart target = partOf(input.solid, input.topology.targetTriangles);
  cage.greatestDistance = distanceFromCap(input.source, source.mesh, input.parallelFor);
  stages.finish("Check");

  const std::optional<AffineSweep> image = affineSweepOf(input);
  cage.isRuled = image && sweepToImage(input, *image, target.mesh, progress, stages, cage);
  if (cage.isRuled)
  {
    cage.projection.sourceMismatch = sourceMismatch(input, source, cage.loops);
  }
  else
  {
    sweepThroughDisks(input, source.mesh, target.mesh, progress, stages, cage);
  }

  cage.source = input.source.points;
  cage.target = cage.projection.quads.points;
  cage.quads = input.source.quads;
  snapTarget(cage.target, cage.linking.rings);
  cage.boundary = gatherSweepBoundary(cage.source, cage.target, cage.linking.rings);
  checkRings(cage.boundary, cage.loops);
  stages.finish("Cage");
  cage.stages = stages.stages();
  return cage;
}

std::vector<Index> sidesOfLoops(const SolidCage& cage)
{
  std::vector<Index> sides;
  Index quad = 0;
  for (const Loop& loop : cage.loops)
  {
    sides.push_back(cage.linking.quadSide[at(quad)]);
    quad += static_cast<Index>(loop.size()) * cage.linking.rings.numberOfLayers();
  }
  return sides;
}
}

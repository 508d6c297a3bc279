// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/SweepProjection.h"

#include "Core/Common/Errors.h"
#include "Core/Geometry/AffineMap.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Geometry/SurfaceSearch.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Linking/LoopMatching.h"
#include "Core/Surfaces/Cap.h"
#include "Core/Surfaces/QuadHalving.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "Core/Surfaces/UsedPoints.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace hexsweep
{
namespace
{
/// Disk coordinates of common boundary nodes agree to rounding; the disk's size is 1.
constexpr double SameDiskPoint = 1e-9;

/// Turns of loops below which quads are not carried along the sides to get rid of folds: they come
/// from elsewhere.
constexpr double LeastWinding = 0.5;

/// The pairs with LoopPair::first on the first cap.
std::vector<LoopPair> sourceFirst(LinkedLoops linked)
{
  for (LoopPair& pair : linked.pairs)
  {
    if (linked.swapped)
    {
      std::swap(pair.first, pair.second);
    }
  }
  return std::move(linked.pairs);
}

/// Where the boundary nodes of the quads belong on the target cap.
struct Boundary
{
  std::vector<FixedNode> nodes;
  std::vector<ColumnDirection> columns; // with linking sides only
  std::vector<Points> lastRings;        // with linking sides only
  std::vector<LoopPair> shapePairs;     // without linking sides only
  std::vector<double> startFractions;
  std::vector<std::string> doubts;
};

Boundary placeBoundary(
  const SweepProjectionInput& input, const Cap& target, const std::vector<Loop>& loops)
{
  Boundary boundary;
  if (input.linking)
  {
    const RingStack& rings = *input.linking;
    if (rings.loops != loops)
    {
      throw InvalidInput("the rings of the linking sides belong to other source quads. Trace them "
                         "from the loops of these.");
    }
    for (std::size_t l = 0; l < loops.size(); ++l)
    {
      const Index layers = rings.numberOfLayers();
      const Points last = ringPoints(rings, l, layers);
      const Points above = ringPoints(rings, l, layers - 1);
      for (std::size_t j = 0; j < loops[l].size(); ++j)
      {
        const Index row = static_cast<Index>(j);
        boundary.nodes.push_back({ loops[l][j], last.row(row) });
        boundary.columns.push_back({ loops[l][j], above.row(row) - last.row(row) });
      }
      boundary.lastRings.push_back(last);
    }
    return boundary;
  }
  MatchedLoops matched = matchLoopsByShape(
    input.source.points, loops, target.points(), target.loops(), "source quads", "target surface");
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    for (std::size_t j = 0; j < loops[l].size(); ++j)
    {
      boundary.nodes.push_back({ loops[l][j], matched.pairs[l].second.row(static_cast<Index>(j)) });
    }
  }
  boundary.shapePairs = outerFirst(std::move(matched.pairs));
  boundary.startFractions = std::move(matched.startFractions);
  boundary.doubts = std::move(matched.doubts);
  return boundary;
}

/// All nodes that are not the projection's to place.
std::vector<FixedNode> placedNodes(const SweepProjectionInput& input, const Boundary& boundary)
{
  std::vector<FixedNode> nodes = input.borders;
  nodes.insert(nodes.end(), boundary.nodes.begin(), boundary.nodes.end());
  return nodes;
}

/// Every boundary node of one disk must be one of the other, in the same place.
void checkSameBoundary(const CapDisk& source, const CapDisk& target)
{
  const auto boundaryPoints = [](const CapDisk& cap) {
    std::vector<Index> ids;
    for (const Loop& loop : cap.loops)
    {
      ids.insert(ids.end(), loop.begin(), loop.end());
    }
    Points corners(static_cast<Index>(ids.size()) * 3, 3);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const Eigen::RowVector2d p = cap.disk.row(ids[i]);
      corners.middleRows<3>(static_cast<Index>(i) * 3).rowwise() =
        Eigen::RowVector3d(p.x(), p.y(), 0.0);
    }
    return corners;
  };
  const Points a = boundaryPoints(source);
  const Points b = boundaryPoints(target);
  bool same = source.domain == target.domain && a.rows() == b.rows();
  const TriangleSearch inB(b);
  for (Index i = 0; same && i < a.rows(); i += 3)
  {
    same = inB.closest(a.row(i)).distance <= SameDiskPoint;
  }
  if (!same)
  {
    throw InvalidInput("the disk maps of the two surfaces do not share their loops. Map each cap "
                       "with the other as Partner and the same linking sides, or let the projector "
                       "make the maps (DiskMaps = Automatic).");
  }
}

/// The source cap, of its own triangulation or that of the quads.
Cap sourceCap(const SweepProjectionInput& input)
{
  return input.sourceSurface
    ? makeCap(*input.sourceSurface, "source surface")
    : makeCap({ input.source.points, halveQuads(input.source.points, input.source.quads) },
        "source quads");
}

BoundaryMismatch sourceMismatch(
  const SweepProjectionInput& input, const std::vector<Loop>& loops, const Cap& source)
{
  std::vector<Points> firstRings;
  for (const Loop& loop : loops)
  {
    firstRings.push_back(loopPoints(input.source.points, loop));
  }
  return mismatchOf(source, firstRings, input.matchTolerance);
}

/// Fills the disk maps of the result, and what there is to say of them. @param loops of the quads.
void mapCaps(const SweepProjectionInput& input, const std::vector<Loop>& loops, const Cap& target,
  const Boundary& boundary, const Progress& progress, SweepProjection& result)
{
  const Cap source = sourceCap(input);
  result.sourceMismatch = sourceMismatch(input, loops, source);
  const CapNames names{ input.sourceSurface ? "source surface" : "source quads", "target surface",
    input.linking ? "linking sides" : "source quads" };
  LinkedLoops linked;
  linked.pairs = boundary.shapePairs;
  if (input.linking)
  {
    linked = linkLoops(*input.linking);
  }
  CommonDisks disks;
  if (input.method == ProjectionMethod::PaperHarmonic)
  {
    PaperDisks pinned = paperDiskMap(source, target, sourceFirst(std::move(linked)), input.weights,
      input.matchTolerance, progress, names);
    disks = std::move(pinned.disks);
    result.nitsche = pinned.nitsche;
  }
  else
  {
    disks = mapPairs(source, target, linked, input.weights, input.matchTolerance, progress, names,
      input.improvement);
  }
  result.source = std::move(disks.first);
  result.target = std::move(disks.second);
}

/**
 * Whether the target is an affine image of the source, up to a small part of an edge, and so near
 * that what its nodes drift sideways would tilt the columns of hexahedra.
 *
 * @param outer the outer loop of the quads.
 */
bool isThinAffineSweep(
  const SweepProjectionInput& input, const Boundary& boundary, const Loop& outer)
{
  constexpr double AffineSlack = 0.1; // of an edge
  constexpr double ThinSweep = 5.0;   // edges
  const Index n = static_cast<Index>(boundary.nodes.size());
  Points from(n, 3);
  Points to(n, 3);
  Points outerTo(static_cast<Index>(outer.size()), 3);
  std::vector<Index> rowOf(static_cast<std::size_t>(input.source.points.rows()), -1);
  for (Index i = 0; i < n; ++i)
  {
    const FixedNode& node = boundary.nodes[static_cast<std::size_t>(i)];
    from.row(i) = input.source.points.row(node.point);
    to.row(i) = node.position;
    rowOf[static_cast<std::size_t>(node.point)] = i;
  }
  for (std::size_t j = 0; j < outer.size(); ++j)
  {
    outerTo.row(static_cast<Index>(j)) = to.row(rowOf[static_cast<std::size_t>(outer[j])]);
  }
  const AffineMap map =
    fitAffineMap(from, to, areaVector(loopPoints(input.source.points, outer)), areaVector(outerTo));
  const double residual = (map.apply(from) - to).rowwise().norm().maxCoeff();
  const double edge = closedLength(outerTo) / static_cast<double>(outer.size());
  return residual < AffineSlack * edge && (to - from).rowwise().norm().mean() < ThinSweep * edge;
}

/// Untangles and polishes as asked, and judges the result.
void improve(SweepProjection& result, const SweepProjectionInput& input, const Boundary& boundary,
  const Loop& outer, const TriangleMesh& target, const Progress& progress)
{
  const auto search = std::make_shared<const SurfaceSearch>(target);
  // Points that no quad uses are nobody's to move; they count as fixed.
  std::vector<bool> fixed = usedPoints(input.source.quads, input.source.points.rows());
  fixed.flip();
  for (const FixedNode& node : boundary.nodes)
  {
    fixed[static_cast<std::size_t>(node.point)] = true;
  }
  std::vector<bool> still = fixed;
  for (const FixedNode& node : input.borders)
  {
    still[static_cast<std::size_t>(node.point)] = true;
  }
  const auto judge = [&] {
    if (input.singlePrecision)
    {
      result.quads.points = result.quads.points.cast<float>().cast<double>().eval();
    }
    const Points normals = search->normals(result.quads.points, input.parallelFor);
    result.quality = quadQuality(result.quads.points, input.source.quads, normals);
    result.fixedCorners = fixedQuadCorners(result.quads.points, input.source.quads, normals, fixed);
  };
  judge();
  result.invertedBefore = result.quality.inverted;
  if (!input.ensureValid && !input.improveQuality)
  {
    return;
  }
  // Loops that wind once round are an affine image of themselves as well.
  if (input.improveQuality && input.method == ProjectionMethod::Harmonic && input.linking &&
    !result.carried && result.winding < FarWinding && isThinAffineSweep(input, boundary, outer))
  {
    Points harmonic = std::move(result.quads.points);
    result.quads.points = projectAffinely(input.source.points,
      usedPoints(input.source.quads, input.source.points.rows()), placedNodes(input, boundary),
      outer, target)
                            .points;
    judge();
    if (result.quality.inverted == 0)
    {
      return;
    }
    result.quads.points = std::move(harmonic);
  }
  if (input.ensureValid)
  {
    const CapCorners corners(input.source.quads, still, search, boundary.columns,
      result.quads.points, LeaningColumns::PassedOver, input.parallelFor);
    ImprovedQuads untangled = untangleQuads(
      corners, result.quads.points, input.source.points, progressPart(progress, 0.0, 0.5));
    result.quads.points = std::move(untangled.points);
    result.rounds += untangled.rounds;
  }
  if (input.improveQuality)
  {
    const CapCorners corners(input.source.quads, still, search, boundary.columns,
      result.quads.points, LeaningColumns::WhereUpright, input.parallelFor);
    ImprovedQuads polished = polishQuads(
      corners, result.quads.points, input.source.points, progressPart(progress, 0.5, 1.0));
    result.quads.points = std::move(polished.points);
    result.rounds += polished.rounds;
  }
  judge();
}

/// One projection's input, and what is known of it before any map.
struct Projection
{
  const SweepProjectionInput& input;
  const std::vector<Loop>& loops; ///< of the source quads
  const Cap& target;
  const Boundary& boundary;
  double winding;

  std::vector<bool> used() const
  {
    return usedPoints(this->input.source.quads, this->input.source.points.rows());
  }
  const Loop& outer() const
  {
    return this->loops[longestLoop(this->input.source.points, this->loops)];
  }
};

SweepProjection emptyResult(const Projection& given)
{
  SweepProjection result;
  result.startFractions = given.boundary.startFractions;
  result.doubts = given.boundary.doubts;
  result.winding = given.winding;
  return result;
}

/// From cap to cap, as the method says.
SweepProjection projectDirectly(const Projection& given, const Progress& progress)
{
  const SweepProjectionInput& input = given.input;
  SweepProjection result = emptyResult(given);
  if (!input.targetDisk)
  {
    result.targetMismatch =
      mismatchOf(given.target, given.boundary.lastRings, input.matchTolerance);
  }
  const std::vector<FixedNode> placed = placedNodes(input, given.boundary);
  if (input.method == ProjectionMethod::AffineLeastSquares)
  {
    result.quads = projectAffinely(input.source.points, given.used(), placed, given.outer(),
      given.target.mesh(), progressPart(progress, 0.0, 0.7));
  }
  else
  {
    if (input.targetDisk)
    {
      checkSameBoundary(*input.sourceDisk, *input.targetDisk);
      result.source = input.sourceDisk;
      result.target = input.targetDisk;
    }
    else
    {
      mapCaps(
        input, given.loops, given.target, given.boundary, progressPart(progress, 0.0, 0.6), result);
    }
    result.quads = projectThroughDisks(input.source.points, given.used(), placed, *result.source,
      *result.target, progressPart(progress, 0.6, 0.7), input.parallelFor);
  }
  // The triangulation of the map, also where it was made here: given maps must give the same bits.
  improve(result, input, given.boundary, given.outer(),
    result.target ? result.target->mesh : given.target.mesh(), progressPart(progress, 0.7, 1.0));
  return result;
}

Index turnsOf(const SweepProjection& projection)
{
  Index turns = 0;
  for (const MissedHole& hole : projection.missedHoles)
  {
    turns += hole.turns;
  }
  return turns;
}

/**
 * Along the sides to the plane of the last ring, and through disk maps from there.
 *
 * @return nothing where that way is blocked.
 */
std::optional<SweepProjection> projectAlongSides(
  const Projection& given, const SweepSections& sections, const Progress& progress)
{
  const std::optional<CarriedSource> carried = carrySource(
    given.input.source, *given.input.linking, sections, progressPart(progress, 0.0, 0.5));
  if (!carried)
  {
    return std::nullopt;
  }
  SweepProjectionInput section = given.input;
  section.source = carried->quads;
  section.sourceSurface.reset();
  section.linking = carried->linking;
  SweepProjection result = emptyResult(given);
  try
  {
    if (std::optional<PlaneDisks> plane = planeDisks(*carried, given.target.mesh()))
    {
      result.source = std::move(plane->source);
      result.target = std::move(plane->target);
    }
    else
    {
      mapCaps(section, given.loops, given.target, given.boundary, progressPart(progress, 0.5, 0.7),
        result);
    }
    result.quads = projectThroughDisks(section.source.points, given.used(),
      placedNodes(given.input, given.boundary), *result.source, *result.target,
      progressPart(progress, 0.7, 0.75), given.input.parallelFor);
  }
  catch (const SolverFailure&)
  {
    return std::nullopt;
  }
  catch (const InvalidInput&) // of a section that crosses itself in its plane
  {
    return std::nullopt;
  }
  result.carried = true;
  result.quads.maximumSourceDistance = 0.0;
  result.sourceMismatch = sourceMismatch(given.input, given.loops, sourceCap(given.input));
  result.targetMismatch =
    mismatchOf(given.target, given.boundary.lastRings, given.input.matchTolerance);
  const TriangleMesh surface = std::move(result.target->mesh);
  result.source.reset();
  result.target.reset();
  improve(
    result, given.input, given.boundary, given.outer(), surface, progressPart(progress, 0.75, 1.0));
  result.missedHoles = missedHoles(given.input.source, result.quads.points, sections);
  return result;
}

/// Whether quads are folded that need not be, or wind otherwise than the sides.
bool isWanting(const SweepProjection& result)
{
  return !result.missedHoles.empty() ||
    result.quality.inverted > static_cast<Index>(result.fixedCorners.inverted.size());
}

bool betterThan(const SweepProjection& a, const SweepProjection& b)
{
  if (turnsOf(a) != turnsOf(b))
  {
    return turnsOf(a) < turnsOf(b);
  }
  return a.quality.inverted != b.quality.inverted ? a.quality.inverted < b.quality.inverted
                                                  : a.quality.minimum > b.quality.minimum;
}

/// Along the sides where they wind far, otherwise where the way from cap to cap leaves anything to
/// be desired.
SweepProjection projectWindingSides(
  const Projection& given, const SweepSections& sections, const Progress& progress)
{
  const bool far = given.winding > FarWinding;
  std::optional<SweepProjection> carried;
  if (far)
  {
    carried = projectAlongSides(given, sections, progressPart(progress, 0.0, 0.5));
    if (carried && !isWanting(*carried))
    {
      return *std::move(carried);
    }
  }
  SweepProjection direct = projectDirectly(given, progressPart(progress, far ? 0.5 : 0.0, 0.95));
  direct.missedHoles = missedHoles(given.input.source, direct.quads.points, sections);
  if (!far && given.input.ensureValid && isWanting(direct))
  {
    carried = projectAlongSides(given, sections, progressPart(progress, 0.95, 1.0));
  }
  return carried && betterThan(*carried, direct) ? *std::move(carried) : std::move(direct);
}
}

SweepProjection projectSweep(const SweepProjectionInput& input, const Progress& progress)
{
  const SurfaceTopology topology =
    checkSurface(input.source.quads, input.source.points.rows(), "source quads");
  checkCap(topology, "source quads");
  const bool given = input.sourceDisk && input.targetDisk;
  if (given && input.method == ProjectionMethod::PaperHarmonic)
  {
    throw InvalidInput("the method PaperHarmonic makes disk maps of its own and cannot use given "
                       "ones. Set DiskMaps to Automatic, or Method to Harmonic.");
  }
  const Cap target = makeCap(given ? input.targetDisk->mesh : input.target, "target surface");
  const Boundary boundary = placeBoundary(input, target, topology.loops);
  reportProgress(progress, 0.05);

  std::optional<SweepSections> sections;
  if (input.linking && input.method == ProjectionMethod::Harmonic && !given)
  {
    sections = sweepSections(*input.linking);
  }
  const Projection projection{ input, topology.loops, target, boundary,
    sections ? loopWinding(*sections).greatest() : 0.0 };
  SweepProjection result = projection.winding > LeastWinding
    ? projectWindingSides(projection, *sections, progressPart(progress, 0.05, 1.0))
    : projectDirectly(projection, progressPart(progress, 0.05, 1.0));
  reportProgress(progress, 1.0);
  return result;
}
}

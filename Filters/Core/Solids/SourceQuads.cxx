// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SourceQuads.h"

#include "Core/CapQuads/CapCurves.h"
#include "Core/CapQuads/CapMeshing.h"
#include "Core/CapQuads/CurveDivision.h"
#include "Core/Common/Constants.h"
#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Solids/OpeningCorners.h"
#include "Core/Solids/SolidCage.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Solids/SolidSides.h"
#include "Core/Solids/TargetImprint.h"
#include "Core/Surfaces/FaceSides.h"
#include "Core/Surfaces/SurfacePart.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace hexsweep
{
namespace
{
/// Quads that are much smaller than the facets of a curve are bent at the facets' corners: the
/// shortest default edge, in facets.
constexpr double QuadsOnFacet = 0.5;
/// Of the quads' edges: borders of the source and the target that are nearer to each other are one.
constexpr double ImprintSnap = 0.02;
/// The same where harmonic maps carry the borders, which take no curve quite to its like.
constexpr double HarmonicSnap = 0.15;
/// Of the edges that are wanted on curves: more are too many.
constexpr double MostCrowded = 4.0;
/// Quads with the target's borders over those without (which may be very few), and their least
/// scaled Jacobians: with more, or less, the borders are not worth it.
constexpr double MostQuads = 3.0;
constexpr double FewQuads = 300.0;
constexpr double LeastQuality = 0.05;
/// Of the quads: where the projection inverts more, borders are no help.
constexpr double MostInvertedQuads = 0.01;
/// Pieces of the target's borders are mapped by their ends where the map bends them.
constexpr double PieceOfQuad = 0.5;
/// Layers on which corners are looked at before the quads are made for good.
constexpr Index LayersLookedAt = 8;

/// Facets that stand for curves of the source cap.
struct CurveFacets
{
  double length = 0.0; ///< median over the edges beside points that turn by more than 10 degrees
  double turn = 0.0;   ///< the greatest, radians
};

/// @param borders points where faces of the sides meet, which are corners of their own right.
CurveFacets curveFacets(
  const SolidSurface& solid, const SweepTopology& topology, std::vector<Index> borders)
{
  constexpr double LeastTurn = Pi / 18.0;
  std::sort(borders.begin(), borders.end());
  CurveFacets facets;
  std::vector<double> lengths;
  for (const SweepSide& side : topology.sides)
  {
    const std::size_t n = side.sourceLoop.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const Index here = side.sourceLoop[i];
      const Eigen::RowVector3d in =
        solid.points.row(here) - solid.points.row(side.sourceLoop[(i + n - 1) % n]);
      const Eigen::RowVector3d out =
        solid.points.row(side.sourceLoop[(i + 1) % n]) - solid.points.row(here);
      const double turn = std::atan2(in.cross(out).norm(), in.dot(out));
      if (turn > LeastTurn && !std::binary_search(borders.begin(), borders.end(), here))
      {
        facets.turn = std::max(facets.turn, turn);
        lengths.push_back(in.norm());
        lengths.push_back(out.norm());
      }
    }
  }
  if (!lengths.empty())
  {
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    facets.length = *middle;
  }
  return facets;
}
}

std::vector<Index> edgeStarts(const SolidSurface& solid, const SweepTopology& topology)
{
  std::vector<Index> starts;
  const Index points = solid.points.rows();
  std::vector<Loop> loops;
  for (const SweepSide& side : topology.sides)
  {
    loops.push_back(side.sourceLoop);
  }
  const std::vector<Index> next = nextOnLoops(loops, points);
  std::vector<Index> faceOf(static_cast<std::size_t>(points), -1);
  for (const SweepSide& side : topology.sides)
  {
    // The side's face behind each edge of the loop, which runs the cap's way.
    for (const Index row : side.triangles)
    {
      for (Index c = 0; c < 3; ++c)
      {
        const Index here = solid.triangles(row, (c + 1) % 3);
        if (next[static_cast<std::size_t>(here)] == solid.triangles(row, c))
        {
          faceOf[static_cast<std::size_t>(here)] = solid.faceIds[static_cast<std::size_t>(row)];
        }
      }
    }
    Index before = faceOf[static_cast<std::size_t>(side.sourceLoop.back())];
    for (const Index here : side.sourceLoop)
    {
      const Index after = faceOf[static_cast<std::size_t>(here)];
      if (before != after)
      {
        starts.push_back(here);
      }
      before = after;
    }
  }
  return starts;
}

std::vector<std::pair<Index, Index>> meshedEdges(
  const SolidInput& input, const SolidSurface& solid, const SweepTopology& topology)
{
  std::vector<std::pair<Index, Index>> edges;
  if (input.quadOfTriangle.empty())
  {
    return edges;
  }
  for (const SweepSide& side : topology.sides)
  {
    std::map<std::pair<Index, Index>, bool> meshed;
    for (const Index row : side.triangles)
    {
      const Index given = solid.triangleRows[static_cast<std::size_t>(row)];
      const bool ofQuad = input.quadOfTriangle[static_cast<std::size_t>(given)] >= 0;
      for (Index c = 0; c < 3; ++c)
      {
        meshed[{ solid.triangles(row, (c + 1) % 3), solid.triangles(row, c) }] = ofQuad;
      }
    }
    const std::size_t n = side.sourceLoop.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::pair<Index, Index> edge(side.sourceLoop[i], side.sourceLoop[(i + 1) % n]);
      if (meshed.at(edge))
      {
        edges.push_back(edge);
      }
    }
  }
  return edges;
}

namespace
{
/// What is to be meshed.
struct CapToMesh
{
  TriangleMesh cap;
  std::vector<Index> faceIds;
  CapQuadOptions options;
};

CapToMesh capToMesh(
  const SolidInput& input, const SolidSurface& solid, const SweepTopology& topology, double size)
{
  SurfacePart part = surfacePart(solid.points, solid.triangles, topology.sourceTriangles);
  CapToMesh result;
  for (const Index row : topology.sourceTriangles)
  {
    result.faceIds.push_back(solid.faceIds[static_cast<std::size_t>(row)]);
  }
  CapQuadOptions& options = result.options;
  const std::vector<Index> starts = edgeStarts(solid, topology);
  for (const Index point : starts)
  {
    options.keep.push_back(part.idOf(point));
  }
  double keptLength = 0.0;
  for (const auto& [from, to] : meshedEdges(input, solid, topology))
  {
    options.keepEdges.emplace_back(part.idOf(from), part.idOf(to));
    keptLength += (solid.points.row(from) - solid.points.row(to)).norm();
  }
  result.cap = std::move(part.mesh);
  options.size = size > 0.0     ? size
    : options.keepEdges.empty() ? std::max(defaultQuadSize(result.cap),
                                    QuadsOnFacet * curveFacets(solid, topology, starts).length)
                                : keptLength / static_cast<double>(options.keepEdges.size());
  return result;
}

/// How many of the edges to keep are edges of the quads.
std::size_t keptEdges(const CapToMesh& cap, const QuadMesh& quads)
{
  using Place = std::array<double, 3>;
  const auto edgeOf = [](const Points& points, Index a, Index b) {
    const Place p{ points(a, 0), points(a, 1), points(a, 2) };
    const Place q{ points(b, 0), points(b, 1), points(b, 2) };
    return std::make_pair(std::min(p, q), std::max(p, q));
  };
  std::set<std::pair<Place, Place>> outer;
  const std::vector<FaceSide> sides = sortedSides(quads.quads, quads.points.rows());
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first == 1)
    {
      outer.insert(edgeOf(quads.points, sides[first].low, sides[first].high));
    }
  });
  std::size_t count = 0;
  for (const auto& [from, to] : cap.options.keepEdges)
  {
    count += outer.count(edgeOf(cap.cap.points, from, to));
  }
  return count;
}

SourceQuads sourceQuadsOf(CapQuads made, double size)
{
  SourceQuads result;
  result.mesh = std::move(made.mesh);
  result.inverted = made.inverted;
  result.least = made.minimumScaledJacobian;
  result.size = size;
  return result;
}

FacedCap targetCap(const SolidSurface& solid, const SweepTopology& topology)
{
  FacedCap target;
  target.surface = surfacePart(solid.points, solid.triangles, topology.targetTriangles).mesh;
  for (const Index row : topology.targetTriangles)
  {
    target.faceIds.push_back(solid.faceIds[static_cast<std::size_t>(row)]);
  }
  return target;
}

/// Corners that open on the way to the target want more quads than their own angle does.
std::vector<CornerFan> fansFor(const SolidSurface& solid, const SweepTopology& topology,
  const QuadMesh& quads, const Progress& progress)
{
  const std::vector<Loop> loops =
    checkSurface(quads.quads, quads.points.rows(), "source quads").loops;
  return openingCorners(quads, loops, solidSides(solid, topology), LayersLookedAt, progress);
}

std::string notKept(const SweepTopology& topology, const std::string& why)
{
  return "the borders between the target's " + listFaces(topology.targetFaceIds) +
    " are no edges of the quads, some of which lie on two of these faces: " + why;
}

/// How many edges the mesher puts on the curves of a cap.
double edgesOnCurves(
  const TriangleMesh& cap, const std::vector<Index>& faceIds, const CapQuadOptions& options)
{
  const std::vector<Loop> loops = checkSurface(cap.triangles, cap.points.rows(), "cap").loops;
  const std::vector<CapCurve> curves =
    traceCapCurves(cap, loops, faceIds, options.keep, options.size);
  double edges = 0.0;
  for (const std::vector<double>& curve :
    divideCapCurves(cap, curves, 2.0 * options.size, options.chordTolerance))
  {
    edges += static_cast<double>(curve.size() - 1);
  }
  return edges;
}

/// Whether the borders run so near to others that edges along them would have to be much shorter
/// than they are wanted.
bool isCrowded(const CapToMesh& cap, const TargetImprint& imprint, const CapQuadOptions& options)
{
  double wanted = edgesOnCurves(cap.cap, cap.faceIds, cap.options);
  for (const ImprintedEdge& edge : imprint.cap.edges)
  {
    const Points& points = imprint.cap.mesh.points;
    wanted += (points.row(edge.ends.first) - points.row(edge.ends.second)).norm() / options.size;
  }
  // Corners take edges of their own.
  wanted += 2.0 * static_cast<double>(imprint.ends.size());
  return edgesOnCurves(imprint.cap.mesh, imprint.labels, options) > MostCrowded * wanted;
}

/// Quads that keep the borders of the target too, or a warning that says why there are none.
SourceQuads imprintedQuads(const CapToMesh& cap, const SweepTopology& topology,
  const FacedCap& target, const CapMaps& maps, double longest, const Progress& progress)
{
  const double size = cap.options.size;
  SourceQuads none;
  const std::optional<TargetImprint> imprint =
    imprintTarget({ cap.cap, cap.faceIds, cap.options.keep, cap.options.keepEdges,
                    (longest > 0.0 ? HarmonicSnap : ImprintSnap) * size },
      target, maps, size, longest);
  if (!imprint)
  {
    none.imprintWarning = notKept(topology, "they find no way over the source cap.");
    return none;
  }
  CapQuadOptions options = cap.options;
  const std::vector<Index> ends = imprint->keep();
  options.keep.insert(options.keep.end(), ends.begin(), ends.end());
  try
  {
    if (isCrowded(cap, *imprint, options))
    {
      none.imprintWarning = notKept(topology,
        "they run so near to each other or to other curves that edges along them would be much "
        "shorter than " +
          describe(size) + ". Set QuadSize to a smaller length.");
      return none;
    }
    CapQuads made = meshCapWithQuads(imprint->cap.mesh, imprint->labels, options, progress);
    const auto first = static_cast<std::ptrdiff_t>(cap.options.keep.size());
    const std::vector<Index> endNodes(made.keptNodes.begin() + first, made.keptNodes.end());
    std::vector<FixedNode> nodes = nodesOnBorders(*imprint, made, endNodes, maps);
    SourceQuads result = sourceQuadsOf(std::move(made), size);
    result.imprinted = std::move(nodes);
    if (!imprint->hiddenFaces.empty())
    {
      result.imprintWarning = "no quads of their own are on " + listFaces(imprint->hiddenFaces) +
        " of the target: quads of size " + describe(size) +
        " are too large there. Set QuadSize to a smaller length.";
    }
    return result;
  }
  catch (const InvalidInput& error)
  {
    none.imprintWarning = notKept(topology, error.what());
    return none;
  }
}

/// The quads with the target's borders, unless those without are better.
SourceQuads betterOf(
  const CapToMesh& cap, const SweepTopology& topology, SourceQuads imprinted, SourceQuads plain)
{
  if (imprinted.mesh.quads.rows() == 0)
  {
    plain.imprintWarning = imprinted.imprintWarning;
    return plain;
  }
  if (imprinted.inverted > plain.inverted)
  {
    plain.imprintWarning = notKept(topology,
      std::to_string(imprinted.inverted) +
        " quads along them would be inverted. Set QuadSize to a smaller length.");
    return plain;
  }
  const auto count = static_cast<double>(imprinted.mesh.quads.rows());
  if (count > MostQuads * std::max(FewQuads, static_cast<double>(plain.mesh.quads.rows())) ||
    imprinted.least < LeastQuality * plain.least)
  {
    plain.imprintWarning = notKept(topology,
      "quads along them would be much smaller or flatter than the others (" + describe(count) +
        " quads in place of " + std::to_string(plain.mesh.quads.rows()) +
        ", least scaled Jacobian " + describe(imprinted.least) + " in place of " +
        describe(plain.least) + "). Set QuadSize to a smaller length.");
    return plain;
  }
  if (keptEdges(cap, imprinted.mesh) < keptEdges(cap, plain.mesh))
  {
    plain.imprintWarning =
      notKept(topology, "they would take away edges at which quads of the sides begin.");
    return plain;
  }
  return imprinted;
}

/// The caps' disk maps, tied by one layer of columns that begin at these quads; nothing where that
/// fails, which the sweep itself will tell.
std::optional<SweepProjection> firstProjection(
  const SolidSurface& solid, const SweepTopology& topology, const QuadMesh& quads)
{
  SolidCageInput input{ solid, topology, quads, {}, {} };
  input.layers.layers = 1;
  input.ensureValid = false;
  input.improveQuality = false;
  try
  {
    SolidCage cage = makeSolidCage(input);
    return cage.projection.source && cage.projection.target
      ? std::optional<SweepProjection>(std::move(cage.projection))
      : std::nullopt;
  }
  catch (const InvalidInput&)
  {
    return std::nullopt;
  }
  catch (const SolverFailure&)
  {
    return std::nullopt;
  }
}
}

SourceQuads makeSourceQuads(const SolidInput& input, const SolidSurface& solid,
  const SweepTopology& topology, double size, const Progress& progress, bool withBorders,
  const ParallelFor& parallelFor, double chordTolerance, const std::optional<AffineSweep>* known)
{
  if (!(size >= 0.0) || !std::isfinite(size))
  {
    throw InvalidInput("the quad size is not a length. Set QuadSize to a positive length, or to 0 "
                       "for a size that fits the source cap.");
  }
  CapToMesh cap = capToMesh(input, solid, topology, size);
  cap.options.chordTolerance = chordTolerance;
  cap.options.parallelFor = parallelFor;
  const auto plainQuads = [&](const Progress& part) {
    return sourceQuadsOf(
      meshCapWithQuads(cap.cap, cap.faceIds, cap.options, part), cap.options.size);
  };
  const bool imprints = topology.targetFaceIds.size() > 1 && withBorders;
  const Progress first = imprints ? progressPart(progress, 0.0, 0.5) : progress;
  const Progress second = progressPart(progress, 0.5, 1.0);
  if (const std::optional<AffineSweep> affine = known ? *known : findAffineSweep(solid, topology))
  {
    if (!imprints)
    {
      return plainQuads(progress);
    }
    const AffineMap back = inverse(affine->map);
    const CapMaps maps{ [&](const PointsRef& points) { return affine->map.apply(points); },
      [&](const PointsRef& points) { return back.apply(points); } };
    SourceQuads imprinted =
      imprintedQuads(cap, topology, targetCap(solid, topology), maps, 0.0, first);
    return betterOf(cap, topology, std::move(imprinted), plainQuads(second));
  }
  SourceQuads plain = plainQuads(progressPart(first, 0.0, 0.5));
  cap.options.fans = fansFor(solid, topology, plain.mesh, progressPart(first, 0.5, 0.6));
  if (!cap.options.fans.empty())
  {
    plain = plainQuads(progressPart(first, 0.6, 1.0));
  }
  if (!imprints)
  {
    return plain;
  }
  const std::optional<SweepProjection> disks = firstProjection(solid, topology, plain.mesh);
  if (!disks)
  {
    return plain;
  }
  if (static_cast<double>(disks->quality.inverted) >
    MostInvertedQuads * static_cast<double>(plain.mesh.quads.rows()))
  {
    plain.imprintWarning = notKept(topology,
      "the caps differ so much that " + std::to_string(disks->quality.inverted) +
        " quads are inverted on the way to the target, and with fixed borders they could not be "
        "mended.");
    return plain;
  }
  const CapMaps maps = mapsThroughDisks(*disks->source, *disks->target);
  SourceQuads imprinted = imprintedQuads(
    cap, topology, targetCap(solid, topology), maps, PieceOfQuad * cap.options.size, second);
  return betterOf(cap, topology, std::move(imprinted), std::move(plain));
}

double greatestFacetTurn(const SolidSurface& solid, const SweepTopology& topology)
{
  return curveFacets(solid, topology, edgeStarts(solid, topology)).turn * 180.0 / Pi;
}
}

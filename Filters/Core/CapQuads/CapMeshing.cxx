// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CapMeshing.h"

#include "Core/CapQuads/ChordLengths.h"
#include "Core/CapQuads/CurveDivision.h"
#include "Core/CapQuads/CurveNodes.h"
#include "Core/CapQuads/MidpointSubdivision.h"
#include "Core/CapQuads/QuadPolishing.h"
#include "Core/CapQuads/QuadQuality.h"
#include "Core/CapQuads/SurfaceRemeshing.h"
#include "Core/CapQuads/TrianglePairing.h"
#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Surfaces/SurfaceArea.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "Core/Surfaces/UsedPoints.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace hexsweep
{
namespace
{
constexpr double MaximumQuads = 50e6;
/// Edges of the triangles over those of the quads: pairs of equilateral triangles, cut in four,
/// are as large as squares of the wanted size.
constexpr double TriangleSize = 2.32;
constexpr double Growth = 0.4;
/// The same where chords limit them: the longest edges of the triangles, 4/3 of this, are twice
/// those of the quads, which are not to be longer.
constexpr double ChordTriangle = 1.5;
constexpr double DefaultQuads = 1000.0;
constexpr double MostDefaultQuads = 16000.0;
constexpr double DefaultLoopEdges = 12.0;
constexpr Index OriginsAtOnce = 1024;

void checkOptions(const TriangleMesh& cap, const std::vector<Loop>& loops,
  const std::vector<Index>& faceIds, const CapQuadOptions& options)
{
  if (!faceIds.empty() && static_cast<Index>(faceIds.size()) != cap.triangles.rows())
  {
    throw InvalidInput("the cap has " + std::to_string(cap.triangles.rows()) + " triangles, but " +
      std::to_string(faceIds.size()) + " face ids were given. Give one a triangle, or none.");
  }
  if (!(options.chordTolerance >= 0.0 && options.chordTolerance <= 0.5))
  {
    throw InvalidInput("the chord tolerance is " + describe(options.chordTolerance) +
      ". Set ChordTolerance to a share of the edges' length, from 0 (off) to 0.5.");
  }
  if (!(options.size > 0.0) || !std::isfinite(options.size))
  {
    throw InvalidInput("the wanted size of the quads is " + describe(options.size) +
      "; it is an edge length. Give a positive one.");
  }
  double perimeter = 0.0;
  for (const Loop& loop : loops)
  {
    perimeter += closedLength(loopPoints(cap.points, loop));
  }
  const double area = surfaceArea(cap);
  const double quads = std::max(area / options.size, perimeter) / options.size;
  if (!(quads <= MaximumQuads))
  {
    throw InvalidInput("quads of size " + describe(options.size) + " would be about " +
      describe(quads) + " on this cap (area " + describe(area) +
      "), more than 50 million. Give a larger size, at least " +
      describe(std::max(std::sqrt(area / MaximumQuads), perimeter / MaximumQuads)) + ".");
  }
  const std::vector<bool> used = usedPoints(cap.triangles, cap.points.rows());
  for (const Index point : options.keep)
  {
    if (point < 0 || point >= cap.points.rows() || !used[static_cast<std::size_t>(point)])
    {
      throw InvalidInput("point " + std::to_string(point) +
        " is to become a node of the quads, but no triangle of the cap uses it. Name points of the "
        "cap only.");
    }
  }
}

/// Of the triangles, where curvature limits them.
LengthLimit longestEdges(
  const TriangleMesh& cap, const std::vector<Index>& faceIds, const CapQuadOptions& options)
{
  if (!(options.chordTolerance > 0.0))
  {
    return {};
  }
  const auto chords = std::make_shared<ChordLengths>(cap, faceIds, options.chordTolerance);
  const double least = LeastOfChord * options.size;
  return [chords, least](const Eigen::RowVector3d& place) {
    return ChordTriangle * std::max(least, chords->at(place));
  };
}

/// Whether each curve consists of edges to keep, and these can be edges of the quads.
std::vector<bool> keptCurves(
  const std::vector<CapCurve>& curves, std::vector<std::pair<Index, Index>> edges)
{
  for (auto& edge : edges)
  {
    edge = std::minmax({ edge.first, edge.second });
  }
  std::sort(edges.begin(), edges.end());
  std::vector<bool> kept;
  for (const CapCurve& curve : curves)
  {
    // Two triangles' edges on a curve, four on a loop: fewer are no mesh.
    const std::size_t count = curve.points.size() - 1;
    bool all = curve.loop >= 0 && count % 2 == 0 && count >= (curve.closed() ? 8 : 4);
    for (std::size_t k = 0; k < count && all; ++k)
    {
      const std::pair<Index, Index> edge = std::minmax({ curve.points[k], curve.points[k + 1] });
      all = std::binary_search(edges.begin(), edges.end(), edge);
    }
    kept.push_back(all);
  }
  return kept;
}

/// The curves that are given, every second node of theirs a node of the triangles.
void takeGivenCurves(const TriangleMesh& cap, const std::vector<GivenCurve>& given,
  std::vector<CapCurve>& curves, std::vector<std::vector<double>>& divided)
{
  for (const GivenCurve& curve : given)
  {
    if (curve.fractions.size() % 2 == 0 || curve.fractions.size() < 3 ||
      static_cast<Index>(curve.fractions.size()) != curve.places.rows())
    {
      throw InvalidInput("a curve of the cap has " + std::to_string(curve.fractions.size()) +
        " given nodes and " + std::to_string(curve.places.rows()) +
        " places of them. Give an odd number, three at least, and as many places.");
    }
    curves.push_back({ curve.points, 0 });
    const double length = chainOf(cap.points, curves.back()).length();
    divided.emplace_back();
    for (std::size_t k = 0; k < curve.fractions.size(); k += 2)
    {
      divided.back().push_back(curve.fractions[k] * length);
    }
  }
}

/// Puts the vertices that are left on given curves where these have nodes.
/// @return the edges between them, each with its given middle; as curveEdges().
std::vector<CurveEdge> givenEdges(const std::vector<GivenCurve>& given,
  const std::vector<std::vector<Index>>& vertices, Points& points)
{
  std::vector<CurveEdge> edges;
  for (std::size_t c = 0; c < given.size(); ++c)
  {
    const std::size_t nodes = given[c].fractions.size();
    if (vertices[c].size() != nodes / 2 + 1)
    {
      throw InvalidInput("the cap cannot be meshed with " + std::to_string(nodes - 1) +
        " edges along the curve that begins at " + describe(given[c].places.row(0)) +
        ": the cap is too narrow there for its size. Set Size to a smaller length.");
    }
    for (std::size_t k = 0; k < vertices[c].size(); ++k)
    {
      points.row(vertices[c][k]) = given[c].places.row(static_cast<Index>(2 * k));
      if (k > 0)
      {
        edges.push_back({ std::minmax(vertices[c][k - 1], vertices[c][k]),
          given[c].places.row(static_cast<Index>(2 * k - 1)) });
      }
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const CurveEdge& a, const CurveEdge& b) { return a.ends < b.ends; });
  return edges;
}

/// Every second point of the curves to keep is a node of the triangles.
void divideAtEverySecondPoint(const PointsRef& points, const std::vector<CapCurve>& curves,
  const std::vector<bool>& kept, std::vector<std::vector<double>>& divided)
{
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (kept[c])
    {
      const ArcLengthChain chain = chainOf(points, curves[c]);
      divided[c].clear();
      for (std::size_t k = 0; k < curves[c].points.size(); k += 2)
      {
        divided[c].push_back(chain.reached(static_cast<Index>(k)));
      }
    }
  }
}

/// Curves of a cap, and where they are divided.
struct DividedCurves
{
  std::vector<CapCurve> curves;
  std::vector<bool> kept; ///< see keptCurves(); empty where curves are given
  std::vector<std::vector<double>> divided;
};

DividedCurves dividedCurves(const TriangleMesh& cap, const std::vector<Loop>& loops,
  const std::vector<Index>& faceIds, const CapQuadOptions& options)
{
  DividedCurves result;
  if (!options.given.empty())
  {
    takeGivenCurves(cap, options.given, result.curves, result.divided);
    return result;
  }
  result.curves = traceCapCurves(cap, loops, faceIds, options.keep, options.size);
  result.kept = keptCurves(result.curves, options.keepEdges);
  result.divided = divideCapCurves(cap, result.curves, 2.0 * options.size, options.chordTolerance);
  divideAtEverySecondPoint(cap.points, result.curves, result.kept, result.divided);
  return result;
}

/// Nodes along given curves: the vertices, and between them the nodes that halve their edges.
/// @param halved edges that are halved by the nodes from `firstHalf` on, rising.
std::vector<std::vector<Index>> nodesAlongGiven(const std::vector<std::vector<Index>>& vertices,
  const std::vector<std::pair<Index, Index>>& halved, Index firstHalf)
{
  std::vector<std::vector<Index>> nodes;
  for (const std::vector<Index>& curve : vertices)
  {
    nodes.push_back({ curve.front() });
    for (std::size_t k = 1; k < curve.size(); ++k)
    {
      const std::pair<Index, Index> ends = std::minmax(curve[k - 1], curve[k]);
      const auto found = std::lower_bound(halved.begin(), halved.end(), ends);
      nodes.back().push_back(firstHalf + (found - halved.begin()));
      nodes.back().push_back(curve[k]);
    }
  }
  return nodes;
}
}

CapQuads meshCapWithQuads(const TriangleMesh& cap, const std::vector<Index>& faceIds,
  const CapQuadOptions& options, const Progress& progress)
{
  const std::string what = "cap";
  const SurfaceTopology topology = checkSurface(cap.triangles, cap.points.rows(), what);
  checkCap(topology, what);
  checkOptions(cap, topology.loops, faceIds, options);

  const DividedCurves along = dividedCurves(cap, topology.loops, faceIds, options);
  const DividedCap prepared = putNodesOnCurves(cap, along.curves, along.divided, options.keep);
  const ParallelFor& threads = options.parallelFor;
  const auto search = std::make_shared<const SurfaceSearch>(cap);
  const SurfaceSearch& surface = *search;
  RemeshedSurface remeshed = remeshSurface(prepared.input, surface, TriangleSize * options.size,
    Growth, progressPart(progress, 0.0, 0.5), threads, longestEdges(cap, faceIds, options));

  const std::vector<std::vector<Index>> vertices = curveVertices(prepared, remeshed.pointOf);
  const std::vector<CurveEdge> onCurves = options.given.empty()
    ? curveEdges(prepared, remeshed.pointOf, along.kept)
    : givenEdges(options.given, vertices, remeshed.mesh.points);
  std::vector<std::pair<Index, Index>> keptEdges;
  for (const CurveEdge& edge : onCurves)
  {
    keptEdges.push_back(edge.ends);
  }
  const std::vector<std::pair<Index, Index>> parted =
    openCornerFans(remeshed.mesh, options.fans, keptEdges, surface);
  keptEdges.insert(keptEdges.end(), parted.begin(), parted.end());
  const PairedTriangles paired =
    pairTriangles(remeshed.mesh, surface.normals(remeshed.mesh.points, threads), keptEdges);
  SubdividedFaces subdivided =
    subdivideAtMidpoints(remeshed.mesh.points, paired.quads, paired.triangles);

  CapQuads result;
  result.mesh.quads = std::move(subdivided.mesh.quads);
  result.loops = static_cast<Index>(topology.loops.size());
  result.splitTriangles = paired.triangles.rows();
  for (const Index point : options.keep)
  {
    result.keptNodes.push_back(remeshed.pointOf[static_cast<std::size_t>(point)]);
  }
  const Index coarse = remeshed.mesh.points.rows();
  Points points = surface.project(subdivided.mesh.points, threads).points;
  points.topRows(coarse) = remeshed.mesh.points;
  result.onCurve.assign(static_cast<std::size_t>(points.rows()), false);
  for (const CurveEdge& edge : onCurves)
  {
    const auto found =
      std::lower_bound(subdivided.edges.begin(), subdivided.edges.end(), edge.ends);
    const Index node = coarse + (found - subdivided.edges.begin());
    points.row(node) = edge.middle;
    for (const Index i : { edge.ends.first, edge.ends.second, node })
    {
      result.onCurve[static_cast<std::size_t>(i)] = true;
    }
  }
  if (!options.given.empty())
  {
    result.givenNodes = nodesAlongGiven(vertices, subdivided.edges, coarse);
  }
  std::vector<bool> fixed = result.onCurve;
  for (const Index node : result.keptNodes)
  {
    fixed[static_cast<std::size_t>(node)] = true;
  }
  result.mesh.points = std::move(points);
  const CapCorners corners(
    result.mesh.quads, fixed, search, {}, result.mesh.points, LeaningColumns::PassedOver, threads);
  result.mesh.points = untangleQuads(
    corners, result.mesh.points, result.mesh.points, progressPart(progress, 0.5, 0.75))
                         .points;
  result.mesh.points =
    polishQuads(corners, result.mesh.points, result.mesh.points, progressPart(progress, 0.75, 1.0))
      .points;

  result.quadOrigin.resize(static_cast<std::size_t>(result.mesh.quads.rows()));
  forPieces(threads, result.mesh.quads.rows(), OriginsAtOnce, [&](Index begin, Index end) {
    Index last = -1;
    for (Index q = begin; q < end; ++q)
    {
      Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
      for (Index c = 0; c < 4; ++c)
      {
        middle += 0.25 * result.mesh.points.row(result.mesh.quads(q, c));
      }
      last = surface.project(middle, last).triangle;
      result.quadOrigin[static_cast<std::size_t>(q)] = last;
    }
  });
  const QuadQuality quality = quadQuality(
    result.mesh.points, result.mesh.quads, surface.normals(result.mesh.points, threads));
  result.inverted = quality.inverted;
  result.minimumScaledJacobian = quality.minimum;
  result.meanScaledJacobian = quality.mean;
  return result;
}

double defaultQuadSize(const TriangleMesh& cap)
{
  const double area = surfaceArea(cap);
  if (!(area > 0.0) || !std::isfinite(area))
  {
    throw InvalidInput(
      "the cap has no area: its points coincide or lie on a line. Check the triangles.");
  }
  double shortest = std::numeric_limits<double>::infinity();
  for (const Loop& loop : checkSurface(cap.triangles, cap.points.rows(), "cap").loops)
  {
    shortest = std::min(shortest, closedLength(loopPoints(cap.points, loop)));
  }
  return std::max(std::sqrt(area / MostDefaultQuads),
    std::min(std::sqrt(area / DefaultQuads), shortest / DefaultLoopEdges));
}
}

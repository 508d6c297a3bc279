// SPDX-License-Identifier: BSD-3-Clause
#include "CapQuads.h"

#include "CurveDivision.h"
#include "Describe.h"
#include "Errors.h"
#include "LoopGeometry.h"
#include "MidpointSubdivision.h"
#include "QuadPolishing.h"
#include "QuadQuality.h"
#include "SurfaceRefinement.h"
#include "SurfaceRemeshing.h"
#include "SurfaceTopology.h"
#include "TrianglePairing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
constexpr double MaximumQuads = 50e6;
/// Edges of the triangles over those of the quads: pairs of equilateral triangles, cut in four,
/// are as large as squares of the wanted size.
constexpr double TriangleSize = 2.32;
constexpr double Growth = 0.4;
/// Nodes go to a point of a curve this near, relative to the edges beside them.
constexpr double SnapDistance = 1e-3;
constexpr double DefaultQuads = 1000.0;
constexpr double MostDefaultQuads = 16000.0;
constexpr double DefaultLoopEdges = 12.0;

double areaOf(const TriangleMesh& cap)
{
  double area = 0.0;
  for (Index t = 0; t < cap.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = cap.points.row(cap.triangles(t, 0));
    const Eigen::RowVector3d b = cap.points.row(cap.triangles(t, 1));
    const Eigen::RowVector3d c = cap.points.row(cap.triangles(t, 2));
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area;
}

void checkOptions(const TriangleMesh& cap, const std::vector<Loop>& loops,
  const std::vector<Index>& faceIds, const CapQuadOptions& options)
{
  if (!faceIds.empty() && static_cast<Index>(faceIds.size()) != cap.triangles.rows())
  {
    throw InvalidInput("the cap has " + std::to_string(cap.triangles.rows()) + " triangles, but " +
      std::to_string(faceIds.size()) + " face ids were given. Give one a triangle, or none.");
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
  const double area = areaOf(cap);
  const double quads = std::max(area / options.size, perimeter) / options.size;
  if (!(quads <= MaximumQuads))
  {
    throw InvalidInput("quads of size " + describe(options.size) + " would be about " +
      describe(quads) + " on this cap (area " + describe(area) +
      "), more than 50 million. Give a larger size, at least " +
      describe(std::max(std::sqrt(area / MaximumQuads), perimeter / MaximumQuads)) + ".");
  }
  std::vector<bool> used(static_cast<std::size_t>(cap.points.rows()), false);
  for (Index i = 0; i < cap.triangles.size(); ++i)
  {
    used[static_cast<std::size_t>(cap.triangles.data()[i])] = true;
  }
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

/// The curves of a cap with points for their nodes.
struct PreparedCap
{
  RemeshingInput input;
  std::vector<ArcLengthChain> chains;
  /// Arc length of each entry of input.curves.
  std::vector<std::vector<double>> reached;
};

PreparedCap putNodesOnCurves(const TriangleMesh& cap, const std::vector<CapCurve>& curves,
  const std::vector<std::vector<double>>& divided, const std::vector<Index>& keep)
{
  struct Insertion
  {
    std::size_t curve;
    Index edge;
  };
  PreparedCap prepared;
  std::vector<EdgeSubdivision> subdivisions;
  std::vector<Insertion> insertions;
  std::vector<Index> nodes = keep;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    prepared.chains.push_back(chainOf(cap.points, curves[c]));
    const ArcLengthChain& chain = prepared.chains.back();
    nodes.push_back(curves[c].points.front());
    nodes.push_back(curves[c].points.back());
    for (std::size_t k = 1; k + 1 < divided[c].size(); ++k)
    {
      const double place = divided[c][k];
      const ArcLengthChain::Place at = chain.locate(place);
      const double near =
        SnapDistance * std::min(place - divided[c][k - 1], divided[c][k + 1] - place);
      if (place - chain.reached(at.edge) <= near)
      {
        nodes.push_back(curves[c].points[static_cast<std::size_t>(at.edge)]);
      }
      else if (chain.reached(at.edge + 1) - place <= near)
      {
        nodes.push_back(curves[c].points[static_cast<std::size_t>(at.edge) + 1]);
      }
      else
      {
        if (insertions.empty() || insertions.back().curve != c || insertions.back().edge != at.edge)
        {
          insertions.push_back({ c, at.edge });
          subdivisions.push_back({ curves[c].points[static_cast<std::size_t>(at.edge)],
            curves[c].points[static_cast<std::size_t>(at.edge) + 1], {} });
        }
        subdivisions.back().fractions.push_back(at.along);
      }
    }
  }
  RefinedSurface refined = refineSurface(cap, subdivisions, false);
  prepared.input.mesh = std::move(refined.mesh);
  prepared.input.stays.assign(static_cast<std::size_t>(prepared.input.mesh.points.rows()), false);
  for (const Index node : nodes)
  {
    prepared.input.stays[static_cast<std::size_t>(node)] = true;
  }
  std::size_t insertion = 0;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    std::vector<Index> points;
    std::vector<double> reached;
    for (std::size_t k = 0; k < curves[c].points.size(); ++k)
    {
      points.push_back(curves[c].points[k]);
      reached.push_back(prepared.chains[c].reached(static_cast<Index>(k)));
      if (insertion < insertions.size() && insertions[insertion].curve == c &&
        insertions[insertion].edge == static_cast<Index>(k))
      {
        const double next = prepared.chains[c].reached(static_cast<Index>(k) + 1);
        for (std::size_t i = 0; i < refined.inserted[insertion].size(); ++i)
        {
          const double fraction = subdivisions[insertion].fractions[i];
          const Index node = refined.inserted[insertion][i];
          points.push_back(node);
          reached.push_back(
            (1.0 - fraction) * prepared.chains[c].reached(static_cast<Index>(k)) + fraction * next);
          prepared.input.stays[static_cast<std::size_t>(node)] = true;
        }
        ++insertion;
      }
    }
    prepared.input.curves.push_back(std::move(points));
    prepared.reached.push_back(std::move(reached));
  }
  return prepared;
}

/// An edge of the triangles on a curve, and the place of the node that halves it.
struct CurveEdge
{
  std::pair<Index, Index> ends; ///< lower one first
  Eigen::RowVector3d middle;
};

std::vector<CurveEdge> curveEdges(const PreparedCap& prepared, const std::vector<Index>& pointOf)
{
  std::vector<CurveEdge> edges;
  for (std::size_t c = 0; c < prepared.chains.size(); ++c)
  {
    Index last = -1;
    double lastReached = 0.0;
    for (std::size_t k = 0; k < prepared.input.curves[c].size(); ++k)
    {
      const Index point = pointOf[static_cast<std::size_t>(prepared.input.curves[c][k])];
      const double reached = prepared.reached[c][k];
      if (point < 0)
      {
        continue;
      }
      if (last >= 0)
      {
        edges.push_back(
          { std::minmax(last, point), prepared.chains[c].at(0.5 * (lastReached + reached)) });
      }
      last = point;
      lastReached = reached;
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const CurveEdge& a, const CurveEdge& b) { return a.ends < b.ends; });
  return edges;
}
}

CapQuads meshCapWithQuads(const TriangleMesh& cap, const std::vector<Index>& faceIds,
  const CapQuadOptions& options, const Progress& progress)
{
  const std::string what = "cap";
  const SurfaceTopology topology = checkSurface(cap.triangles, cap.points.rows(), what);
  checkCap(topology, what);
  checkOptions(cap, topology.loops, faceIds, options);

  const std::vector<CapCurve> curves =
    traceCapCurves(cap, topology.loops, faceIds, options.keep, options.size);
  const PreparedCap prepared =
    putNodesOnCurves(cap, curves, divideCapCurves(cap, curves, 2.0 * options.size), options.keep);
  const SurfaceProjection surface(cap);
  const TriangleRemesher::Result remeshed = remeshSurface(
    prepared.input, surface, TriangleSize * options.size, Growth, progressPart(progress, 0.0, 0.5));

  const std::vector<CurveEdge> onCurves = curveEdges(prepared, remeshed.pointOf);
  std::vector<std::pair<Index, Index>> keptEdges;
  for (const CurveEdge& edge : onCurves)
  {
    keptEdges.push_back(edge.ends);
  }
  const PairedTriangles paired =
    pairTriangles(remeshed.mesh, surface.project(remeshed.mesh.points).normals, keptEdges);
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
  Points points = surface.project(subdivided.mesh.points).points;
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
  std::vector<bool> fixed = result.onCurve;
  for (const Index node : result.keptNodes)
  {
    fixed[static_cast<std::size_t>(node)] = true;
  }
  const CapCorners corners(result.mesh.quads, fixed, cap, {}, points);
  const ImprovedQuads untangled =
    untangleQuads(corners, points, points, progressPart(progress, 0.5, 0.75));
  result.mesh.points =
    polishQuads(corners, untangled.points, untangled.points, progressPart(progress, 0.75, 1.0))
      .points;

  const TriangleSearch search(cap.points, cap.triangles);
  Index last = -1;
  for (Index q = 0; q < result.mesh.quads.rows(); ++q)
  {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (Index c = 0; c < 4; ++c)
    {
      middle += 0.25 * result.mesh.points.row(result.mesh.quads(q, c));
    }
    last = search.closest(middle, last).triangle;
    result.quadOrigin.push_back(last);
  }
  const QuadQuality quality =
    quadQuality(result.mesh.points, result.mesh.quads, surface.project(result.mesh.points).normals);
  result.inverted = quality.inverted;
  result.minimumScaledJacobian = quality.minimum;
  result.meanScaledJacobian = quality.mean;
  return result;
}

double defaultQuadSize(const TriangleMesh& cap)
{
  const double area = areaOf(cap);
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

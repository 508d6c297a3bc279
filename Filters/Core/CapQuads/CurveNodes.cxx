// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CurveNodes.h"

#include "Core/Surfaces/FlatFlips.h"
#include "Core/Surfaces/SurfaceRefinement.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
/// Nodes go to a point of a curve this near, relative to the edges beside them.
constexpr double SnapDistance = 1e-3;
/// More nodes on an edge make a fan that takes too many flips (their square) to become good
/// triangles.
constexpr std::size_t FewNodes = 32;

/// As refineSurface(); edges are halved over and over, with flips in between, so that no point ever
/// has many neighbours.
RefinedSurface halvedSurface(const TriangleMesh& cap, const std::vector<CapCurve>& curves,
  const std::vector<EdgeSubdivision>& subdivisions)
{
  struct Piece
  {
    std::size_t subdivision;
    std::size_t begin; // of its fractions
    std::size_t end;
    Index from;
    Index to;
  };
  FlatFlips flips(cap);
  for (const CapCurve& curve : curves)
  {
    for (std::size_t k = 1; k < curve.points.size(); ++k)
    {
      flips.keep(curve.points[k - 1], curve.points[k]);
    }
  }
  RefinedSurface refined;
  std::vector<Piece> pieces;
  for (std::size_t s = 0; s < subdivisions.size(); ++s)
  {
    refined.inserted.emplace_back(subdivisions[s].fractions.size(), -1);
    pieces.push_back(
      { s, 0, subdivisions[s].fractions.size(), subdivisions[s].from, subdivisions[s].to });
  }
  for (std::size_t p = 0; p < pieces.size(); ++p)
  {
    const Piece piece = pieces[p];
    if (piece.begin == piece.end)
    {
      continue;
    }
    const EdgeSubdivision& whole = subdivisions[piece.subdivision];
    const std::size_t middle = (piece.begin + piece.end) / 2;
    const double fraction = whole.fractions[middle];
    const Index node = flips.insertOn(piece.from, piece.to,
      (1.0 - fraction) * cap.points.row(whole.from) + fraction * cap.points.row(whole.to));
    refined.inserted[piece.subdivision][middle] = node;
    pieces.push_back({ piece.subdivision, piece.begin, middle, piece.from, node });
    pieces.push_back({ piece.subdivision, middle + 1, piece.end, node, piece.to });
  }
  refined.mesh = flips.mesh();
  return refined;
}

RefinedSurface refinedSurface(const TriangleMesh& cap, const std::vector<CapCurve>& curves,
  const std::vector<EdgeSubdivision>& subdivisions)
{
  const bool few = std::all_of(subdivisions.begin(), subdivisions.end(),
    [](const EdgeSubdivision& one) { return one.fractions.size() <= FewNodes; });
  return few ? refineSurface(cap, subdivisions, false) : halvedSurface(cap, curves, subdivisions);
}
}

DividedCap putNodesOnCurves(const TriangleMesh& cap, const std::vector<CapCurve>& curves,
  const std::vector<std::vector<double>>& divided, const std::vector<Index>& keep)
{
  struct Insertion
  {
    std::size_t curve;
    Index edge;
  };
  DividedCap prepared;
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
  RefinedSurface refined = refinedSurface(cap, curves, subdivisions);
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

std::vector<std::vector<Index>> curveVertices(
  const DividedCap& prepared, const std::vector<Index>& pointOf)
{
  std::vector<std::vector<Index>> vertices;
  for (const std::vector<Index>& curve : prepared.input.curves)
  {
    vertices.emplace_back();
    for (const Index point : curve)
    {
      if (pointOf[static_cast<std::size_t>(point)] >= 0)
      {
        vertices.back().push_back(pointOf[static_cast<std::size_t>(point)]);
      }
    }
  }
  return vertices;
}

std::vector<CurveEdge> curveEdges(
  const DividedCap& prepared, const std::vector<Index>& pointOf, const std::vector<bool>& kept)
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
        const Eigen::RowVector3d middle = kept[c]
          ? prepared.chains[c].nodes().row(static_cast<Index>(k) - 1)
          : prepared.chains[c].at(0.5 * (lastReached + reached));
        edges.push_back({ std::minmax(last, point), middle });
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

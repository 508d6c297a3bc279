// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/StackPlaneMesh.h"

#include "Core/CapQuads/CapMeshing.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Surfaces/SurfaceArea.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hexsweep
{
namespace
{
constexpr double LoopEdges = 12.0;
constexpr double MostPlaneQuads = 16000.0;

/// Corners that lie on a border, and where more than two borders meet.
std::vector<bool> borderCorners(const StackArrangement& arrangement)
{
  std::vector<Index> ends(static_cast<std::size_t>(arrangement.mesh.points.rows()), 0);
  for (const RegionEdge& edge : arrangement.edges)
  {
    ++ends[static_cast<std::size_t>(edge.a)];
    ++ends[static_cast<std::size_t>(edge.b)];
  }
  std::vector<bool> corner;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    corner.push_back(ends[i] > 2 || (ends[i] > 0 && arrangement.corner[i]));
  }
  return corner;
}

/// Regions of the quads: those that hang together without a border have one.
std::vector<Index> quadRegions(const StackArrangement& arrangement, const CapQuads& quads)
{
  const Quads& cells = quads.mesh.quads;
  const auto isBorder = [&](Index a, Index b) {
    return quads.onCurve[static_cast<std::size_t>(a)] && quads.onCurve[static_cast<std::size_t>(b)];
  };
  std::map<std::pair<Index, Index>, Index> first;
  DisjointSets sets(cells.rows());
  for (Index q = 0; q < cells.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      const Index a = cells(q, c);
      const Index b = cells(q, (c + 1) % 4);
      const auto known = first.emplace(std::minmax(a, b), q);
      if (!known.second && !isBorder(a, b))
      {
        sets.join(q, known.first->second);
      }
    }
  }
  // A quad beside a bent border may have its middle beyond it: the most decide.
  std::map<Index, std::map<Index, Index>> votes;
  for (Index q = 0; q < cells.rows(); ++q)
  {
    const Index triangle = quads.quadOrigin[static_cast<std::size_t>(q)];
    ++votes[sets.find(q)][arrangement.regionOf[static_cast<std::size_t>(triangle)]];
  }
  std::vector<Index> result;
  for (Index q = 0; q < cells.rows(); ++q)
  {
    const auto& own = votes[sets.find(q)];
    result.push_back(std::max_element(own.begin(), own.end(), [](const auto& a, const auto& b) {
      return a.second < b.second;
    })->first);
  }
  return result;
}
}

double defaultStackSize(const StackArrangement& arrangement)
{
  DisjointSets sets(arrangement.mesh.points.rows());
  for (const RegionEdge& edge : arrangement.edges)
  {
    sets.join(edge.a, edge.b);
  }
  std::map<Index, double> lengths;
  for (const RegionEdge& edge : arrangement.edges)
  {
    lengths[sets.find(edge.a)] +=
      (arrangement.mesh.points.row(edge.b) - arrangement.mesh.points.row(edge.a)).norm();
  }
  double size = defaultQuadSize(arrangement.mesh);
  for (const auto& [set, length] : lengths)
  {
    size = std::min(size, length / LoopEdges);
  }
  return std::max(size, std::sqrt(surfaceArea(arrangement.mesh) / MostPlaneQuads));
}

StackPlaneMesh meshStackPlane(const StackArrangement& arrangement, double size,
  double chordTolerance, const ParallelFor& parallelFor, const Progress& progress)
{
  const std::vector<bool> corners = borderCorners(arrangement);
  CapQuadOptions options;
  options.size = size;
  options.chordTolerance = chordTolerance;
  options.parallelFor = parallelFor;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (corners[i])
    {
      options.keep.push_back(static_cast<Index>(i));
    }
  }
  const std::vector<Index>& regions = arrangement.regionOf;
  CapQuads quads = meshCapWithQuads(arrangement.mesh, regions, options, progress);
  StackPlaneMesh result;
  result.plane.regionOf = quadRegions(arrangement, quads);
  result.onBorder = quads.onCurve;
  result.corner.assign(quads.onCurve.size(), false);
  for (const Index node : quads.keptNodes)
  {
    result.corner[static_cast<std::size_t>(node)] = true;
  }
  result.inverted = quads.inverted;
  result.least = quads.minimumScaledJacobian;
  result.plane.mesh = std::move(quads.mesh);
  return result;
}
}

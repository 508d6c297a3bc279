// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SweepForecast.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Describe.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Solids/SweepMeasure.h"

#include <cmath>
#include <optional>

namespace hexsweep
{
namespace
{
/// Radians: caps and sides that meet at less go on into each other.
constexpr double TangentTurn = Pi / 12.0;
/// Of the rim of a cap: less of it does not matter.
constexpr double NotableShare = 0.02;

std::string shoulderText(
  const FaceGraph& graph, const CapCandidate& source, const CapCandidate& target)
{
  const RimDistances ways(graph);
  const SweepMeasure measure =
    measureSweep(graph, source, target, ways.from(source), ways.from(target));
  if (!measure.hasWideShoulder())
  {
    return {};
  }
  const bool one = measure.shoulders.size() == 1;
  return listFaces(measure.shoulders) + (one ? " of the sides runs" : " of the sides run") +
    " across the sweep all round (a shoulder, " +
    describe(std::round(100.0 * measure.shoulderShare)) +
    " % of the cap): hexahedra will be flat or inverted there. Cut the solid at " +
    (one ? "this face" : "these faces") +
    " into parts that can be swept, or sweep it between other caps.";
}

std::string tangentText(const FaceGraph& graph, const CapCandidate& cap)
{
  // By face of the sides: length of tangent rim, and the cap's face there.
  std::vector<double> lengths(graph.faces.size(), 0.0);
  std::vector<std::size_t> capFaces(graph.faces.size(), 0);
  for (const std::vector<Index>& loop : cap.loops)
  {
    for (const Index half : loop)
    {
      const double turn = graph.turns[static_cast<std::size_t>(half)];
      if (std::abs(turn) < TangentTurn)
      {
        const std::size_t side = graph.faceBeyond(half);
        lengths[side] += graph.edgeLength(half);
        capFaces[side] = graph.patches.faceOfTriangle[static_cast<std::size_t>(half / 3)];
      }
    }
  }
  std::string pairs;
  for (std::size_t side = 0; side < lengths.size(); ++side)
  {
    if (lengths[side] > NotableShare * cap.perimeter)
    {
      pairs += (pairs.empty() ? "" : ", ") + std::to_string(graph.patches.ids[capFaces[side]]) +
        " into " + std::to_string(graph.patches.ids[side]);
    }
  }
  if (pairs.empty())
  {
    return {};
  }
  return "faces of the cap of " + listFaces(cap.faceIds) +
    " go on smoothly into faces of the sides (" + pairs +
    "): hexahedra will be flat along these edges. Take the side's face into the cap, or the cap's "
    "into the sides, if a sharp edge lies beyond it.";
}
}

SweepForecast forecastSweep(const SolidSurface& solid, const SweepTopology& topology)
{
  SweepForecast forecast;
  const FaceGraph graph = makeFaceGraph(solid);
  const std::optional<CapCandidate> source =
    makeCapCandidate(graph, facesWithIds(graph, topology.sourceFaceIds));
  const std::optional<CapCandidate> target =
    makeCapCandidate(graph, facesWithIds(graph, topology.targetFaceIds));
  if (!source || !target)
  {
    return forecast;
  }
  forecast.shoulder = shoulderText(graph, *source, *target);
  forecast.tangentRims = tangentText(graph, *source);
  const std::string beyond = tangentText(graph, *target);
  forecast.tangentRims += (forecast.tangentRims.empty() || beyond.empty() ? "" : " ") + beyond;
  return forecast;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/IntrinsicEdgeMiddles.h"

#include "Core/Surfaces/MeshEdgeTracing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace hexsweep
{
std::vector<EdgeSubdivision> middlesOfIntrinsicEdges(
  const IntrinsicTriangulation& intrinsic, const std::vector<Index>& triangles)
{
  const auto twin = [&](Index half) { return intrinsic.twins(half / 3, half % 3); };
  // The longest edges, by the lower of their half-edges.
  std::set<Index> wanted;
  for (const Index t : triangles)
  {
    Index longest = -1;
    for (Index half = 3 * t; half < 3 * t + 3; ++half)
    {
      if (twin(half) >= 0 &&
        (longest < 0 || intrinsic.edgeLengths(t, half % 3) > intrinsic.edgeLengths(t, longest % 3)))
      {
        longest = half;
      }
    }
    if (longest >= 0)
    {
      wanted.insert(std::min(longest, twin(longest)));
    }
  }
  struct Place
  {
    Index from;
    Index to;
    double fraction;
    double fromMiddle;
  };
  std::map<Index, Place> places;
  for (const TracedEdge& edge : traceMeshEdges(intrinsic))
  {
    for (const Crossing& crossing : edge.crossings)
    {
      const Index half = std::min(crossing.half, twin(crossing.half));
      const double fromMiddle = std::abs(crossing.alongHalf - 0.5);
      if (wanted.count(half) > 0)
      {
        const Place place{ edge.from, edge.to, crossing.along, fromMiddle };
        const auto known = places.emplace(half, place);
        if (!known.second && fromMiddle < known.first->second.fromMiddle)
        {
          known.first->second = place;
        }
      }
    }
  }
  std::map<std::pair<Index, Index>, std::set<double>> fractions;
  for (const Index half : wanted)
  {
    const auto known = places.find(half);
    const Index a = intrinsic.triangles(half / 3, half % 3);
    const Index b = intrinsic.triangles(half / 3, (half % 3 + 1) % 3);
    const Place place =
      known != places.end() ? known->second : Place{ std::min(a, b), std::max(a, b), 0.5, 0.0 };
    fractions[{ place.from, place.to }].insert(place.fraction);
  }
  std::vector<EdgeSubdivision> result;
  for (const auto& [edge, values] : fractions)
  {
    result.push_back({ edge.first, edge.second, { values.begin(), values.end() } });
  }
  return result;
}
}

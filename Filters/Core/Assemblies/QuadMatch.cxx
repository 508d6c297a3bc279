// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/QuadMatch.h"

#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <deque>
#include <map>
#include <utility>

namespace hexsweep
{
namespace
{
using Ends = std::pair<Index, Index>; // lower one first

std::map<Ends, std::vector<Index>> quadsAtEdges(const Quads& quads)
{
  std::map<Ends, std::vector<Index>> result;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      result[std::minmax({ quads(q, c), quads(q, (c + 1) % 4) })].push_back(q);
    }
  }
  return result;
}

/// The corners of a quad from `a` to `b` on; empty where these are no edge of it.
std::vector<Index> cornersFrom(const Quads& quads, Index q, Index a, Index b)
{
  for (Index c = 0; c < 4; ++c)
  {
    for (const Index step : { Index(1), Index(3) })
    {
      if (quads(q, c) == a && quads(q, (c + step) % 4) == b)
      {
        return { a, b, quads(q, (c + 2 * step) % 4), quads(q, (c + 3 * step) % 4) };
      }
    }
  }
  return {};
}
}

std::optional<std::vector<Index>> matchQuads(
  const Quads& source, const Quads& target, std::vector<Index> known)
{
  if (source.rows() != target.rows())
  {
    return std::nullopt;
  }
  const auto atSource = quadsAtEdges(source);
  const auto atTarget = quadsAtEdges(target);
  std::vector<Index> quadOf(at(source.rows()), -1);
  std::vector<bool> isTaken(at(target.rows()), false);
  struct Pair
  {
    Index quad;
    Ends edge; // of the source quad
    Index image;
  };
  std::deque<Pair> pairs;
  for (const auto& [edge, quads] : atSource)
  {
    const Index a = known[at(edge.first)];
    const Index b = known[at(edge.second)];
    const auto image = a >= 0 && b >= 0 ? atTarget.find(std::minmax({ a, b })) : atTarget.end();
    if (quads.size() == 1 && image != atTarget.end() && image->second.size() == 1)
    {
      pairs.push_back({ quads.front(), edge, image->second.front() });
    }
  }
  while (!pairs.empty())
  {
    const Pair pair = pairs.front();
    pairs.pop_front();
    Index& image = quadOf[at(pair.quad)];
    if (image == pair.image)
    {
      continue;
    }
    if (image >= 0 || isTaken[at(pair.image)])
    {
      return std::nullopt;
    }
    image = pair.image;
    isTaken[at(pair.image)] = true;
    const auto [a, b] = pair.edge;
    const std::vector<Index> here = cornersFrom(source, pair.quad, a, b);
    const std::vector<Index> there = cornersFrom(target, pair.image, known[at(a)], known[at(b)]);
    if (there.empty())
    {
      return std::nullopt;
    }
    for (std::size_t c = 0; c < 4; ++c)
    {
      Index& point = known[at(here[c])];
      if (point >= 0 && point != there[c])
      {
        return std::nullopt;
      }
      point = there[c];
    }
    for (std::size_t c = 0; c < 4; ++c)
    {
      const Ends edge = std::minmax({ here[c], here[(c + 1) % 4] });
      const Ends imageEdge = std::minmax({ there[c], there[(c + 1) % 4] });
      const std::vector<Index>& mine = atSource.at(edge);
      const std::vector<Index>& theirs = atTarget.at(imageEdge);
      if (mine.size() != theirs.size())
      {
        return std::nullopt;
      }
      if (mine.size() == 2)
      {
        pairs.push_back({ mine[0] == pair.quad ? mine[1] : mine[0], edge,
          theirs[0] == pair.image ? theirs[1] : theirs[0] });
      }
    }
  }
  const bool all =
    std::all_of(quadOf.begin(), quadOf.end(), [](Index image) { return image >= 0; });
  return all ? std::optional<std::vector<Index>>(std::move(known)) : std::nullopt;
}
}

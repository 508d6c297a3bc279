// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SweepFit.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
constexpr Index Free = -1;
constexpr Index Cap = -2;

Index patchBeyond(const FaceGraph& graph, const std::vector<Index>& loop)
{
  return graph.patches
    .patchOfTriangle[static_cast<std::size_t>(graph.halfEdges.twin(loop.front()) / 3)];
}

/// Marks what can be reached from a patch over free ones.
void spread(const FaceGraph& graph, Index from, Index mark, std::vector<Index>& marks)
{
  std::vector<Index> queue = { from };
  marks[static_cast<std::size_t>(from)] = mark;
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    for (const Index next : graph.patchNeighbors[static_cast<std::size_t>(queue[i])])
    {
      if (marks[static_cast<std::size_t>(next)] == Free)
      {
        marks[static_cast<std::size_t>(next)] = mark;
        queue.push_back(next);
      }
    }
  }
}

/// Walks from each source loop over the patches between the caps: the walk must come upon one
/// target loop, and no other source loop.
bool joinsLoopWithLoop(
  const FaceGraph& graph, const CapCandidate& source, const CapCandidate& target)
{
  if (target.loops.size() == 1)
  {
    return true; // a disk taken off a connected surface leaves it connected
  }
  std::vector<Index> marks(static_cast<std::size_t>(graph.patches.numberOfPatches), Free);
  for (const CapCandidate* cap : { &source, &target })
  {
    for (const std::size_t face : cap->faces)
    {
      for (const Index patch : graph.faces[face].patches)
      {
        marks[static_cast<std::size_t>(patch)] = Cap;
      }
    }
  }
  for (std::size_t l = 0; l < source.loops.size(); ++l)
  {
    const Index start = patchBeyond(graph, source.loops[l]);
    if (marks[static_cast<std::size_t>(start)] != Free)
    {
      return false;
    }
    spread(graph, start, static_cast<Index>(l), marks);
  }
  std::vector<Index> joined;
  for (const std::vector<Index>& loop : target.loops)
  {
    joined.push_back(marks[static_cast<std::size_t>(patchBeyond(graph, loop))]);
  }
  std::sort(joined.begin(), joined.end());
  return joined.front() >= 0 && std::adjacent_find(joined.begin(), joined.end()) == joined.end();
}
}

bool areApart(const CapCandidate& first, const CapCandidate& second)
{
  auto a = first.rimPoints.begin();
  auto b = second.rimPoints.begin();
  while (a != first.rimPoints.end() && b != second.rimPoints.end())
  {
    if (*a == *b)
    {
      return false;
    }
    ++(*a < *b ? a : b);
  }
  std::vector<std::size_t> both;
  std::set_intersection(first.faces.begin(), first.faces.end(), second.faces.begin(),
    second.faces.end(), std::back_inserter(both));
  return both.empty();
}

bool hasLoopsOfSweep(const FaceGraph& graph, const CapCandidate& cap)
{
  // With caps of b loops, b linking sides have 2 - 2 g - 2 (2 - b) = 2 (b - 1 - g) for the sum of
  // their Euler characteristics, g being the genus of the solid's surface: annuli have none.
  return graph.genus == static_cast<Index>(cap.loops.size()) - 1;
}

bool capsFit(const FaceGraph& graph, const CapCandidate& source, const CapCandidate& target)
{
  return hasLoopsOfSweep(graph, source) && hasLoopsOfSweep(graph, target) &&
    areApart(source, target) && joinsLoopWithLoop(graph, source, target);
}
}

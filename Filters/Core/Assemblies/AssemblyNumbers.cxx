// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblyNumbers.h"

#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <limits>

namespace hexsweep
{
namespace
{
/// The nodes inside a volume, which have numbers of their own one after the other.
NodeBlock insideOf(const AssemblySweep& sweep, std::size_t volume)
{
  const Index outer = sweep.boundary.nodes.size();
  NodeBlock block{ static_cast<Index>(sweep.boundary.faces.size() + sweep.volumes.size() + volume),
    std::numeric_limits<Index>::max(), 0 };
  for (const Index node : sweep.volumes[volume].nodes)
  {
    if (node >= outer)
    {
      block.begin = std::min(block.begin, node);
      ++block.count;
    }
  }
  return block;
}

/// All blocks of nodes behind those of the curves.
std::vector<NodeBlock> blocksOf(const AssemblySweep& sweep)
{
  std::vector<NodeBlock> blocks = sweep.boundary.blocks;
  for (std::size_t v = 0; v < sweep.volumes.size(); ++v)
  {
    blocks.push_back(insideOf(sweep, v));
  }
  return blocks;
}
}

std::vector<Index> assemblyCounts(const AssemblySweep& sweep)
{
  const std::size_t faces = sweep.boundary.faces.size();
  const std::size_t volumes = sweep.volumes.size();
  std::vector<Index> counts(faces + 3 * volumes, 0);
  for (const NodeBlock& block : blocksOf(sweep))
  {
    counts[at(block.entity)] = block.count;
  }
  for (std::size_t v = 0; v < volumes; ++v)
  {
    counts[faces + 2 * volumes + v] = sweep.volumes[v].hexes.hexes.rows();
  }
  return counts;
}

AssemblyNumbers numberAssembly(const AssemblySweep& sweep, const std::vector<Index>& counts)
{
  const std::size_t volumes = sweep.volumes.size();
  const std::size_t entities = sweep.boundary.faces.size() + 2 * volumes;
  std::vector<Index> begins(entities);
  Index next = sweep.boundary.curveNodes;
  for (std::size_t e = 0; e < entities; ++e)
  {
    begins[e] = next;
    next += counts[e];
  }
  AssemblyNumbers numbers;
  numbers.nodes.resize(at(sweep.nodes.rows()));
  for (Index i = 0; i < sweep.boundary.curveNodes; ++i)
  {
    numbers.nodes[at(i)] = i;
  }
  for (const NodeBlock& block : blocksOf(sweep))
  {
    for (Index i = 0; i < block.count; ++i)
    {
      numbers.nodes[at(block.begin + i)] = begins[at(block.entity)] + i;
    }
  }
  next = 0;
  for (std::size_t v = 0; v < volumes; ++v)
  {
    numbers.firstHexes.push_back(next);
    next += counts[entities + v];
  }
  return numbers;
}
}

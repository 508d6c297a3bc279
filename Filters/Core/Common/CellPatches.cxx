// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/CellPatches.h"

#include "Core/Common/Errors.h"

#include <algorithm>
#include <limits>
#include <string>
#include <unordered_map>
#include <unordered_set>

namespace hexsweep
{
CellsAtNodes::CellsAtNodes(const FacesRef& mesh, Index numberOfPoints)
  : Begin(static_cast<std::size_t>(numberOfPoints) + 1, 0)
{
  if (mesh.rows() > std::numeric_limits<std::uint32_t>::max())
  {
    throw InvalidInput(std::to_string(mesh.rows()) +
      " cells are more than can be untangled or polished. Use a coarser mesh, or several.");
  }
  this->Cells.resize(static_cast<std::size_t>(mesh.size()));
  for (Index h = 0; h < mesh.rows(); ++h)
  {
    for (Index i = 0; i < mesh.cols(); ++i)
    {
      ++this->Begin[static_cast<std::size_t>(mesh(h, i)) + 1];
    }
  }
  for (std::size_t i = 1; i < this->Begin.size(); ++i)
  {
    this->Begin[i] += this->Begin[i - 1];
  }
  std::vector<Index> next(this->Begin.begin(), this->Begin.end() - 1);
  for (Index h = 0; h < mesh.rows(); ++h)
  {
    for (Index i = 0; i < mesh.cols(); ++i)
    {
      this->Cells[static_cast<std::size_t>(next[static_cast<std::size_t>(mesh(h, i))]++)] =
        static_cast<std::uint32_t>(h);
    }
  }
}

namespace
{
using CellSet = std::unordered_set<Index>;

CellSet withRings(
  const FacesRef& mesh, const CellsAtNodes& atNodes, const std::vector<Index>& cells, int rings)
{
  CellSet all(cells.begin(), cells.end());
  std::vector<Index> front = cells;
  for (int ring = 0; ring < rings; ++ring)
  {
    std::vector<Index> next;
    for (const Index h : front)
    {
      for (Index i = 0; i < mesh.cols(); ++i)
      {
        for (const Index other : atNodes[mesh(h, i)])
        {
          if (all.insert(other).second)
          {
            next.push_back(other);
          }
        }
      }
    }
    front = std::move(next);
  }
  return all;
}

CellPatch patchOf(std::vector<Index> cells, const FacesRef& mesh, const CellsAtNodes& atNodes,
  const std::vector<bool>& fixed)
{
  CellPatch patch;
  std::sort(cells.begin(), cells.end());
  patch.cells = std::move(cells);
  for (const Index h : patch.cells)
  {
    for (Index i = 0; i < mesh.cols(); ++i)
    {
      patch.nodes.push_back(mesh(h, i));
    }
  }
  std::sort(patch.nodes.begin(), patch.nodes.end());
  patch.nodes.erase(std::unique(patch.nodes.begin(), patch.nodes.end()), patch.nodes.end());
  std::unordered_map<Index, Index> number;
  for (std::size_t i = 0; i < patch.nodes.size(); ++i)
  {
    number[patch.nodes[i]] = static_cast<Index>(i);
  }
  patch.corners.resize(static_cast<Index>(patch.cells.size()), mesh.cols());
  for (std::size_t c = 0; c < patch.cells.size(); ++c)
  {
    for (Index i = 0; i < mesh.cols(); ++i)
    {
      patch.corners(static_cast<Index>(c), i) = number[mesh(patch.cells[c], i)];
    }
  }
  for (const Index node : patch.nodes)
  {
    const auto around = atNodes[node];
    patch.free.push_back(!fixed[static_cast<std::size_t>(node)] &&
      std::all_of(around.begin(), around.end(),
        [&](Index h) { return std::binary_search(patch.cells.begin(), patch.cells.end(), h); }));
  }
  return patch;
}
}

std::vector<CellPatch> cellPatches(const FacesRef& mesh, const CellsAtNodes& atNodes,
  const std::vector<Index>& cells, int rings, const std::vector<bool>& fixed)
{
  CellSet left = withRings(mesh, atNodes, cells, rings);
  std::vector<CellPatch> patches;
  // In the order of the cells: what comes out does not depend on how a set is stored.
  for (const Index start : cells)
  {
    if (left.erase(start) == 0)
    {
      continue;
    }
    std::vector<Index> piece{ start };
    for (std::size_t next = 0; next < piece.size(); ++next)
    {
      for (Index i = 0; i < mesh.cols(); ++i)
      {
        for (const Index other : atNodes[mesh(piece[next], i)])
        {
          if (left.erase(other) > 0)
          {
            piece.push_back(other);
          }
        }
      }
    }
    patches.push_back(patchOf(std::move(piece), mesh, atNodes, fixed));
  }
  return patches;
}
}

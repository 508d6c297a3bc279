// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/QuadPatchWork.h"

#include "Core/Common/StoppablePieces.h"

#include <numeric>

namespace hexsweep
{
namespace
{
double sizeOf(const std::vector<CellPatch>& patches)
{
  std::size_t cells = 0;
  for (const CellPatch& patch : patches)
  {
    cells += patch.cells.size();
  }
  return static_cast<double>(cells);
}
}

QuadPatchWork::QuadPatchWork(const CapCorners& cap, const PointsRef& source)
  : Cap(cap)
  , Source(source)
  , AtNodes(cap.quads(), source.rows())
  , Fixed(static_cast<std::size_t>(source.rows()), true)
{
  for (const Index i : cap.freeNodes())
  {
    this->Fixed[static_cast<std::size_t>(i)] = false;
  }
}

bool QuadPatchWork::run(ImprovedQuads& quads, double floor, int rings, double most,
  const Work& work, const Progress& progress) const
{
  const std::vector<CellPatch> patches = cellPatches(this->Cap.quads(), this->AtNodes,
    this->Cap.quadsBelow(floor, quads.points), rings, this->Fixed);
  if (sizeOf(patches) > most * static_cast<double>(this->Cap.quads().rows()))
  {
    return false;
  }
  // A single one has all threads to itself.
  const ParallelFor within = patches.size() == 1 ? this->Cap.parallelFor() : ParallelFor();
  std::vector<int> rounds(patches.size(), 0);
  forStoppablePieces(
    this->Cap.parallelFor(), progress, static_cast<Index>(patches.size()), 1, [&](Index p, Index) {
      // No other patch has these nodes.
      const CellPatch& patch = patches[static_cast<std::size_t>(p)];
      const Points source = this->Source(patch.nodes, Eigen::all);
      const ImprovedQuads mended =
        work(CapCorners(this->Cap, patch, within), quads.points(patch.nodes, Eigen::all), source);
      rounds[static_cast<std::size_t>(p)] = mended.rounds;
      for (std::size_t i = 0; i < patch.nodes.size(); ++i)
      {
        quads.points.row(patch.nodes[i]) = mended.points.row(static_cast<Index>(i));
      }
    });
  quads.rounds = std::accumulate(rounds.begin(), rounds.end(), quads.rounds);
  quads.quality = this->Cap.measure(quads.points);
  return true;
}
}

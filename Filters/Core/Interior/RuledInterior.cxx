// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/RuledInterior.h"

#include "Core/Common/StoppablePieces.h"

namespace hexsweep
{
Points ruledInterior(
  const SweepCage& cage, const Progress& progress, const ParallelFor& parallelFor)
{
  const Index n = cage.source.rows();
  const Index layers = cage.boundary.numberOfLayers();
  Points swept((layers + 1) * n, 3);
  const Points way = cage.target - cage.source;
  forStoppablePieces(parallelFor, progress, layers + 1, 1, [&](Index k, Index) {
    swept.middleRows(k * n, n) =
      cage.source + cage.boundary.fractions[static_cast<std::size_t>(k)] * way;
  });
  setGivenPoints(cage.source, cage.target, cage.quads, cage.boundary, swept);
  reportProgress(progress, 1.0);
  return swept;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexPolishing.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexNodeMoves.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr double GoodEnough = 0.95;
/// Above this a scaled Jacobian may fall for the good of its neighbours.
constexpr double FreelyTraded = 0.3;
/// A node whose sum falls by less of it stays where it is from then on.
constexpr double LeastSumGain = 0.02;
constexpr Index NodesAtOnce = 256;
constexpr Index NodesPerReport = 64 * NodesAtOnce;
/// Nodes between the one that moves and the one whose memory is asked for.
constexpr Index Ahead = 6;

class Polisher
{
public:
  Polisher(const PointsRef& points, const HexesRef& hexes, const std::vector<bool>& fixed,
    std::vector<HexQuality> verdicts, const Progress& progress)
    : Moves(points, hexes, fixed, std::move(verdicts), GoodEnough, progress)
    , Settled(fixed.size(), 0)
  {
    for (const HexQuality& quality : this->Moves.qualities())
    {
      this->Minimum = std::min(this->Minimum, quality.scaledJacobian);
    }
  }

  const std::vector<std::vector<Index>>& groups() const { return this->Moves.groups(); }

  Index moveGroup(
    const std::vector<Index>& nodes, const ParallelFor& parallelFor, const Progress& progress)
  {
    std::atomic<Index> moved{ 0 };
    const Index count = static_cast<Index>(nodes.size());
    for (Index first = 0; first < count; first += NodesPerReport)
    {
      reportProgress(progress, static_cast<double>(first) / static_cast<double>(count));
      forPieces(parallelFor, std::min(NodesPerReport, count - first), NodesAtOnce,
        [&](Index begin, Index end) {
          Index here = 0;
          for (Index k = first + begin; k < first + end; ++k)
          {
            this->prefetch(nodes, std::min(k + Ahead, first + end - 1));
            here += this->move(nodes[static_cast<std::size_t>(k)]);
          }
          moved += here;
        });
    }
    return moved;
  }

  Points take() { return this->Moves.take(); }

private:
  void prefetch(const std::vector<Index>& nodes, Index k) const
  {
    const Index node = nodes[static_cast<std::size_t>(k)];
    if (!this->Settled[static_cast<std::size_t>(node)])
    {
      this->Moves.prefetch(node);
    }
  }

  bool move(Index node)
  {
    char& settled = this->Settled[static_cast<std::size_t>(node)];
    if (settled)
    {
      return false;
    }
    const double least = this->Moves.leastAt(node);
    if (least >= GoodEnough)
    {
      return false;
    }
    const HexNodeMoves::Step step =
      this->Moves.move(node, {}, std::min(least, std::max(FreelyTraded, this->Minimum)));
    settled = step.gain < LeastSumGain;
    return step.moved;
  }

  HexNodeMoves Moves;
  std::vector<char> Settled;
  double Minimum = 1.0;
};

/// Whether a hexahedron that is not good enough has a node that may move.
bool canGain(
  const std::vector<HexQuality>& verdicts, const HexesRef& hexes, const std::vector<bool>& fixed)
{
  for (Index h = 0; h < hexes.rows(); ++h)
  {
    for (int i = 0; i < 8 && !(verdicts[static_cast<std::size_t>(h)].scaledJacobian >= GoodEnough);
         ++i)
    {
      if (!fixed[static_cast<std::size_t>(hexes(h, i))])
      {
        return true;
      }
    }
  }
  return false;
}
}

PolishedHexes polishHexes(const PointsRef& points, const HexesRef& hexes,
  const std::vector<bool>& fixed, int rounds, const ParallelFor& parallelFor,
  const Progress& progress)
{
  PolishedHexes result;
  constexpr double Preparation = 0.1;
  std::vector<HexQuality> verdicts =
    hexVerdicts(points, hexes, parallelFor, progressPart(progress, 0.0, 0.3 * Preparation));
  if (!canGain(verdicts, hexes, fixed))
  {
    result.points = points;
    return result;
  }
  Polisher polisher(points, hexes, fixed, std::move(verdicts),
    progressPart(progress, 0.3 * Preparation, Preparation));
  const std::vector<std::vector<Index>>& groups = polisher.groups();
  const double width = (1.0 - Preparation) / static_cast<double>(rounds * groups.size());
  double done = Preparation;
  Index moved = 1;
  for (int round = 0; round < rounds && moved > 0; ++round)
  {
    moved = 0;
    for (const std::vector<Index>& group : groups)
    {
      moved += polisher.moveGroup(group, parallelFor, progressPart(progress, done, done + width));
      done += width;
    }
    result.movedNodes += moved;
  }
  result.points = polisher.take();
  return result;
}
}

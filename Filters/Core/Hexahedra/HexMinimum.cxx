// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexMinimum.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexNodeMoves.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
/// Times what is wanted: up to there nodes are moved, so that their neighbours have room.
constexpr double Room = 1.2;
/// Of the smooth minimum: this over what is wanted, and not less than the least. A softer one
/// trades what is worst for what is merely low.
constexpr double Sharpness = 6.0;
constexpr double LeastSharpness = 30.0;
/// Rounds in a row without progress that end the search.
constexpr int RoundsWithoutGain = 10;
constexpr double LeastMinimumGain = 0.01; // of the minimum, to count as progress
constexpr double VisitsForAny = 20000.0;  // that any mesh may cost
constexpr double VisitsPerNode = 0.1;     // and each free node besides
constexpr Index LowNodesAtOnce = 64;
/// Between the one that moves and the one whose memory is asked for.
constexpr Index LowNodesAhead = 6;

struct Shortfall
{
  Index hexes = 0;
  double minimum = 1.0;

  bool isProgress(const Shortfall& reached) const
  {
    return hexes < reached.hexes || minimum > (1.0 + LeastMinimumGain) * reached.minimum;
  }
};

Shortfall shortfall(const std::vector<HexQuality>& qualities, double wanted)
{
  Shortfall result;
  for (const HexQuality& quality : qualities)
  {
    result.hexes += quality.scaledJacobian < wanted;
    result.minimum = std::min(result.minimum, quality.scaledJacobian);
  }
  return result;
}

/// Finds the nodes at low hexahedra without a look at all others, which nearly all are.
class LowNodes
{
public:
  /// @param enough scaled Jacobian from which on a hexahedron is not low.
  LowNodes(const HexNodeMoves& moves, std::size_t nodes, double enough)
    : Moves(moves)
    , Enough(enough)
    , Marked(nodes, 0)
  {
    for (Index h = 0; h < moves.hexes().rows(); ++h)
    {
      this->markIfLow(h);
    }
  }

  std::vector<Index> of(const std::vector<Index>& group) const
  {
    std::vector<Index> low;
    for (const Index node : group)
    {
      if (this->Marked[static_cast<std::size_t>(node)] && this->Moves.leastAt(node) < this->Enough)
      {
        low.push_back(node);
      }
    }
    return low;
  }

  void update(const std::vector<Index>& moved)
  {
    for (const Index node : moved)
    {
      for (const Index h : this->Moves.atNodes()[node])
      {
        this->markIfLow(h);
      }
    }
  }

private:
  void markIfLow(Index h)
  {
    if (this->Moves.qualities()[static_cast<std::size_t>(h)].scaledJacobian < this->Enough)
    {
      for (int i = 0; i < 8; ++i)
      {
        this->Marked[static_cast<std::size_t>(this->Moves.hexes()(h, i))] = 1;
      }
    }
  }

  const HexNodeMoves& Moves;
  double Enough;
  std::vector<char> Marked; ///< nodes of hexahedra that are low or were
};

Index moveGroup(HexNodeMoves& moves, LowNodes& lowNodes, const std::vector<Index>& nodes,
  double wanted, Certificates certificates, const ParallelFor& parallelFor)
{
  const std::vector<Index> low = lowNodes.of(nodes);
  forPieces(
    parallelFor, static_cast<Index>(low.size()), LowNodesAtOnce, [&](Index begin, Index end) {
      for (Index i = begin; i < end; ++i)
      {
        const Index node = low[static_cast<std::size_t>(i)];
        moves.prefetch(low[static_cast<std::size_t>(std::min(i + LowNodesAhead, end - 1))]);
        const double least = moves.leastAt(node);
        moves.move(node, { std::max(Sharpness / wanted, LeastSharpness), least },
          std::min(least, wanted), certificates);
      }
    });
  lowNodes.update(low);
  return static_cast<Index>(low.size());
}
}

RaisedMinimum raiseMinimum(const PointsRef& points, const HexesRef& hexes,
  const std::vector<bool>& fixed, double wanted, Certificates certificates,
  const ParallelFor& parallelFor, const Progress& progress)
{
  constexpr double Preparation = 0.1;
  HexNodeMoves moves(points, hexes, fixed, parallelFor, progressPart(progress, 0.0, Preparation));
  double most = VisitsForAny;
  for (const std::vector<Index>& group : moves.groups())
  {
    most += VisitsPerNode * static_cast<double>(group.size());
  }
  Shortfall reached = shortfall(moves.qualities(), wanted);
  RaisedMinimum result;
  result.before = reached.hexes;
  Shortfall now = reached;
  LowNodes lowNodes(moves, fixed.size(), Room * wanted);
  int stagnant = 0;
  double visits = 0.0;
  while (now.hexes > 0 && visits < most && stagnant < RoundsWithoutGain && wanted > 0.0)
  {
    reportProgress(progress, Preparation + (1.0 - Preparation) * visits / most);
    const double before = visits;
    for (const std::vector<Index>& group : moves.groups())
    {
      visits +=
        static_cast<double>(moveGroup(moves, lowNodes, group, wanted, certificates, parallelFor));
    }
    ++result.rounds;
    now = shortfall(moves.qualities(), wanted);
    const bool progressed = now.isProgress(reached);
    stagnant = progressed ? 0 : stagnant + 1;
    if (progressed)
    {
      reached = now;
    }
    if (visits == before) // no free node is at what is low
    {
      break;
    }
  }
  result.after = now.hexes;
  result.points = moves.take();
  return result;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/CornerMatching.h"

#include "Core/Common/Constants.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace hexsweep
{
namespace
{
/// Target corners that are looked at for one source corner, and corners left over in a row.
constexpr std::size_t CornersToTry = 8;
constexpr Index CornersToSkip = 5;
constexpr Index FewCorners = 12;

/// The distance between corners a and b going ahead, in (0, 1]: once round from one to itself.
double ahead(double a, double b)
{
  const double d = b - a - std::floor(b - a);
  return d > 0.0 ? d : 1.0;
}

/// Corners by number, any number: they repeat.
class Matcher
{
public:
  explicit Matcher(const LoopFit& fit)
    : Fit(fit)
    , SourceCorners(loopCorners(fit.source()))
    , TargetCorners(loopCorners(fit.target()))
  {
  }

  std::vector<CornerMatch> allCorners() const
  {
    const Index n = static_cast<Index>(this->SourceCorners.size());
    std::vector<CornerMatch> matches;
    if (n != static_cast<Index>(this->TargetCorners.size()))
    {
      return matches;
    }
    for (Index offset = 0; offset < n; ++offset)
    {
      double cost = 0.0;
      std::vector<std::pair<Index, Index>> corners;
      for (Index i = 0; i < n; ++i)
      {
        corners.emplace_back(i, i + offset);
        cost += this->cornerPiece(i, i + 1, i + offset, i + offset + 1);
      }
      matches.push_back({ this->anchorsOf(corners), cost });
    }
    return matches;
  }

  /// The best cyclic sequence of pairs of corners, over all first pairs.
  CornerMatch someCorners()
  {
    const Index m = static_cast<Index>(this->SourceCorners.size());
    CornerMatch best;
    if (m == 0 || this->TargetCorners.empty())
    {
      return best;
    }
    std::vector<std::vector<Index>> partners;
    for (Index i = 0; i < m; ++i)
    {
      partners.push_back(this->partnersOf(i));
    }
    const Index skip = m <= FewCorners ? m : CornersToSkip;
    for (Index i = 0; i < std::min(m, skip + 1); ++i)
    {
      for (const Index j : partners[static_cast<std::size_t>(i)])
      {
        const auto [corners, cost] = this->bestSequence(i, j, partners, skip);
        if (cost < best.cost - SameLoopCost)
        {
          best = { this->anchorsOf(corners), cost };
        }
      }
    }
    return best;
  }

private:
  double sourceCorner(Index i) const
  {
    const Index n = static_cast<Index>(this->SourceCorners.size());
    return this->Fit.source().fraction(this->SourceCorners[static_cast<std::size_t>(i % n)]);
  }
  double targetCorner(Index j) const
  {
    const Index n = static_cast<Index>(this->TargetCorners.size());
    return this->Fit.target().fraction(this->TargetCorners[static_cast<std::size_t>(j % n)]);
  }

  LoopAnchors anchorsOf(const std::vector<std::pair<Index, Index>>& corners) const
  {
    LoopAnchors anchors;
    for (const auto& [i, j] : corners)
    {
      const double s = this->sourceCorner(i);
      const double t = this->targetCorner(j);
      anchors.source.push_back(
        anchors.source.empty() ? s : anchors.source.back() + ahead(anchors.source.back(), s));
      anchors.target.push_back(
        anchors.target.empty() ? t : anchors.target.back() + ahead(anchors.target.back(), t));
    }
    return anchors;
  }

  double cornerPiece(Index i, Index iNext, Index j, Index jNext) const
  {
    const double s = this->sourceCorner(i);
    const double t = this->targetCorner(j);
    return this->Fit.pieceCost(
      s, ahead(s, this->sourceCorner(iNext)), t, ahead(t, this->targetCorner(jNext)));
  }

  /// cornerPiece(), computed once.
  double knownPiece(Index i, Index iNext, Index j, Index jNext)
  {
    const Index m = static_cast<Index>(this->SourceCorners.size());
    const Index n = static_cast<Index>(this->TargetCorners.size());
    const Index key = (((i % m) * m + iNext % m) * n + j % n) * n + jNext % n;
    const auto known = this->Pieces.find(key);
    if (known != this->Pieces.end())
    {
      return known->second;
    }
    const double cost = this->cornerPiece(i, iNext, j, jNext);
    this->Pieces.emplace(key, cost);
    return cost;
  }

  /// The target corners that one source corner may belong to, ascending.
  std::vector<Index> partnersOf(Index i) const
  {
    std::vector<std::pair<double, Index>> order;
    for (Index j = 0; j < static_cast<Index>(this->TargetCorners.size()); ++j)
    {
      order.emplace_back(this->Fit.cornerCost(this->sourceCorner(i), this->targetCorner(j)), j);
    }
    std::sort(order.begin(), order.end());
    order.resize(std::min(order.size(), CornersToTry));
    std::vector<Index> partners;
    for (const auto& [cost, j] : order)
    {
      partners.push_back(j);
    }
    std::sort(partners.begin(), partners.end());
    return partners;
  }

  /// The best sequence that holds the pair of source corner `first` and target corner `partner`.
  std::pair<std::vector<std::pair<Index, Index>>, double> bestSequence(
    Index first, Index partner, const std::vector<std::vector<Index>>& partners, Index skip)
  {
    const Index m = static_cast<Index>(this->SourceCorners.size());
    const Index n = static_cast<Index>(this->TargetCorners.size());
    struct State
    {
      Index i; // from the first corner, 0 to m
      Index j; // from its partner, 0 to n
      double cost;
      std::size_t previous;
    };
    std::vector<State> states{ { 0, 0, 0.0, 0 } };
    std::vector<std::size_t> begin{ 0 }; // the first state of each source corner
    const auto relax = [&](Index i, Index j) {
      State best{ i, j, Infinity, 0 };
      const Index oldest = std::max<Index>(0, i - skip - 1);
      for (std::size_t k = begin[static_cast<std::size_t>(oldest)]; k < states.size(); ++k)
      {
        const State& from = states[k];
        if (from.i < i && from.j < j && (from.j > 0 || j < n || i - from.i == m))
        {
          const double cost =
            from.cost + this->knownPiece(first + from.i, first + i, partner + from.j, partner + j);
          if (cost < best.cost)
          {
            best.cost = cost;
            best.previous = k;
          }
        }
      }
      return best;
    };
    for (Index i = 1; i < m; ++i)
    {
      std::vector<State> reached;
      for (const Index j : partners[static_cast<std::size_t>((first + i) % m)])
      {
        const Index steps = ((j - partner) % n + n) % n;
        const State state = steps > 0 ? relax(i, steps) : State{ i, 0, Infinity, 0 };
        if (state.cost < Infinity)
        {
          reached.push_back(state);
        }
      }
      begin.push_back(states.size());
      states.insert(states.end(), reached.begin(), reached.end());
    }
    const State end = relax(m, n);
    std::vector<std::pair<Index, Index>> corners;
    if (end.cost < Infinity)
    {
      for (std::size_t k = end.previous;; k = states[k].previous)
      {
        corners.emplace_back(first + states[k].i, partner + states[k].j);
        if (k == 0)
        {
          break;
        }
      }
      std::reverse(corners.begin(), corners.end());
    }
    return { corners, end.cost };
  }

  const LoopFit& Fit;
  std::vector<Index> SourceCorners;
  std::vector<Index> TargetCorners;
  std::unordered_map<Index, double> Pieces;
};
}

std::vector<CornerMatch> matchAllCorners(const LoopFit& fit)
{
  return Matcher(fit).allCorners();
}

CornerMatch matchSomeCorners(const LoopFit& fit)
{
  return Matcher(fit).someCorners();
}
}

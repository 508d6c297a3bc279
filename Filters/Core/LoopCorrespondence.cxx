// SPDX-License-Identifier: BSD-3-Clause
#include "LoopCorrespondence.h"

#include "AffineMap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace hexsweep
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
/// Costs are dimensionless; those that differ by less are equal.
constexpr double SameCost = 1e-9;
/// Leaving corners over must pay: cost relative to arc length alone.
constexpr double ClearlyBetter = 0.8;
/// Corners may cost this many times as much as arc length before the best fit takes the motion out.
constexpr double StillNear = 2.5;
/// A runner-up that costs less than this many times the best one makes the choice a guess.
constexpr double NearlyAsGood = 1.5;
/// Target corners that are looked at for one source corner, and corners left over in a row.
constexpr std::size_t CornersToTry = 8;
constexpr Index CornersToSkip = 5;
constexpr Index FewCorners = 12;

/// A map of places by pairs of places, both ascending, the last no further than once round.
struct Anchors
{
  std::vector<double> source;
  std::vector<double> target;

  double operator()(double place) const
  {
    const std::size_t n = this->source.size();
    const double from = this->source.front();
    const double s = from + (place - from - std::floor(place - from));
    const auto above = std::upper_bound(this->source.begin(), this->source.end(), s);
    const std::size_t k = static_cast<std::size_t>(above - this->source.begin()) - 1;
    const bool last = k + 1 == n;
    const double sEnd = last ? from + 1.0 : this->source[k + 1];
    const double tEnd = last ? this->target.front() + 1.0 : this->target[k + 1];
    const double t = (s - this->source[k]) / (sEnd - this->source[k]);
    return (1.0 - t) * this->target[k] + t * tEnd;
  }
};

/// A correspondence that was looked at: its mean shift of places and its cost.
struct Candidate
{
  double shift;
  double cost;
};

/// The best correspondence of a kind.
struct Choice
{
  Anchors anchors;
  double cost = Infinity;
  Index corners = 0;
};

/// The distance between corners a and b going ahead, in (0, 1]: once round from one to itself.
double ahead(double a, double b)
{
  const double d = b - a - std::floor(b - a);
  return d > 0.0 ? d : 1.0;
}

class Matcher
{
public:
  Matcher(const ClosedPolygon& source, const ClosedPolygon& target, const Eigen::Matrix3d& linear)
    : Source(source)
    , Target(target)
    , Linear(linear.transpose())
    , SourceCenter(source.center())
    , TargetCenter(target.center())
    , SourceCorners(loopCorners(source))
    , TargetCorners(loopCorners(target))
    , Samples(std::clamp<Index>(2 * source.nodes().rows(), 128, 512))
  {
    const ClosedPolygon moved(source.nodes() * this->Linear);
    this->Linear *= target.length() / moved.length();
    double squared = 0.0;
    for (Index i = 0; i < this->Samples; ++i)
    {
      squared += (target.at(this->sample(i)) - this->TargetCenter).squaredNorm();
      this->Places.push_back(this->movedPlace(this->sample(i)));
      this->Directions.push_back(this->movedDirection(this->sample(i)));
    }
    this->SquaredRadius = squared / static_cast<double>(this->Samples);
  }

  LoopCorrespondence match()
  {
    // Starts and offsets are chosen as the loops lie; whether corners fit better than arc length
    // is judged by shape alone, after the affine map that fits each correspondence best.
    Choice best = this->alongLength();
    std::vector<Candidate> others = this->Starts;
    double shapeCost = this->alignedCost(best.anchors);
    const Choice all = this->allCorners();
    if (all.cost <= StillNear * best.cost + SameCost &&
      this->alignedCost(all.anchors) <= shapeCost + SameCost)
    {
      best = all;
      others = this->Offsets;
      shapeCost = this->alignedCost(best.anchors);
    }
    const Choice some = this->someCorners();
    if (some.cost < best.cost - SameCost &&
      this->alignedCost(some.anchors) < ClearlyBetter * shapeCost - SameCost)
    {
      best = some;
      others = this->Starts;
    }

    LoopCorrespondence result;
    for (Index i = 0; i < this->Source.nodes().rows(); ++i)
    {
      result.places.push_back(best.anchors(this->Source.fraction(i)));
    }
    result.matchedCorners = best.corners;
    result.cost = best.cost;
    this->findRunnerUp(this->shiftOf(best.anchors), std::move(others), result);
    return result;
  }

private:
  double sample(Index i) const
  {
    return (static_cast<double>(i) + 0.5) / static_cast<double>(this->Samples);
  }
  Eigen::RowVector3d movedPlace(double s) const
  {
    return this->TargetCenter + (this->Source.at(s) - this->SourceCenter) * this->Linear;
  }
  Eigen::RowVector3d movedDirection(double s) const
  {
    return (this->Source.direction(s) * this->Linear).normalized();
  }
  double costAt(
    const Eigen::RowVector3d& place, const Eigen::RowVector3d& direction, double t) const
  {
    return (this->Target.direction(t) - direction).squaredNorm() +
      (this->Target.at(t) - place).squaredNorm() / this->SquaredRadius;
  }

  double straightCost(double start) const
  {
    double sum = 0.0;
    for (Index i = 0; i < this->Samples; ++i)
    {
      const std::size_t k = static_cast<std::size_t>(i);
      sum += this->costAt(this->Places[k], this->Directions[k], start + this->sample(i));
    }
    return sum / static_cast<double>(this->Samples);
  }

  /// Cost of one linear piece, weighted by its part of the source loop.
  double pieceCost(double s, double sLength, double t, double tLength) const
  {
    const Index count = std::max<Index>(
      3, static_cast<Index>(std::ceil(sLength * static_cast<double>(this->Samples))));
    double sum = 0.0;
    for (Index i = 0; i < count; ++i)
    {
      const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      const double place = s + u * sLength;
      sum += this->costAt(this->movedPlace(place), this->movedDirection(place), t + u * tLength);
    }
    return sLength * sum / static_cast<double>(count);
  }

  /// The cost after the affine map that fits this correspondence best.
  double alignedCost(const Anchors& anchors) const
  {
    if (anchors.source.empty())
    {
      return Infinity;
    }
    Points from(this->Samples, 3);
    Points to(this->Samples, 3);
    for (Index i = 0; i < this->Samples; ++i)
    {
      from.row(i) = this->Source.at(this->sample(i));
      to.row(i) = this->Target.at(anchors(this->sample(i)));
    }
    const AffineMap map =
      fitAffineMap(from, to, areaVector(this->Source.nodes()), areaVector(this->Target.nodes()));
    const Points fitted = map.apply(from);
    double sum = 0.0;
    for (Index i = 0; i < this->Samples; ++i)
    {
      const Eigen::RowVector3d direction =
        this->Source.direction(this->sample(i)) * map.linear.transpose();
      sum += this->costAt(fitted.row(i), direction.normalized(), anchors(this->sample(i)));
    }
    return sum / static_cast<double>(this->Samples);
  }

  double shiftOf(const Anchors& anchors) const
  {
    // Unwrapped: the places rise from that of the first anchor, once round.
    double sum = 0.0;
    const double from = anchors.source.front();
    for (Index i = 0; i < this->Samples; ++i)
    {
      const double s = from + this->sample(i);
      sum += anchors(s) - s;
    }
    const double shift = sum / static_cast<double>(this->Samples);
    return shift - std::floor(shift);
  }

  /// Starts that put the first source node on a target node, and source nodes on target corners.
  std::vector<double> starts() const
  {
    constexpr Index MostOfOneKind = 1024;
    std::vector<double> result;
    for (Index v = 0; v < this->Target.nodes().rows(); ++v)
    {
      result.push_back(this->Target.fraction(v));
    }
    const Index nodes = this->Source.nodes().rows();
    std::vector<Index> corners = this->TargetCorners;
    if (corners.empty() || static_cast<Index>(corners.size()) * nodes > MostOfOneKind)
    {
      corners = { 0 };
    }
    for (const Index corner : corners)
    {
      for (Index j = 0; j < nodes; ++j)
      {
        const double start = this->Target.fraction(corner) - this->Source.fraction(j);
        result.push_back(start - std::floor(start));
      }
    }
    return result;
  }

  Choice alongLength()
  {
    Choice best;
    for (const double start : this->starts())
    {
      const double cost = this->straightCost(start);
      this->Starts.push_back({ start, cost });
      if (cost < best.cost - SameCost)
      {
        best = { Anchors{ { 0.0 }, { start } }, cost, 0 };
      }
    }
    return best;
  }

  double sourceCorner(Index i) const
  {
    const Index n = static_cast<Index>(this->SourceCorners.size());
    return this->Source.fraction(this->SourceCorners[static_cast<std::size_t>(i % n)]);
  }
  double targetCorner(Index j) const
  {
    const Index n = static_cast<Index>(this->TargetCorners.size());
    return this->Target.fraction(this->TargetCorners[static_cast<std::size_t>(j % n)]);
  }

  Anchors anchorsOf(const std::vector<std::pair<Index, Index>>& corners) const
  {
    Anchors anchors;
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

  Choice allCorners()
  {
    const Index n = static_cast<Index>(this->SourceCorners.size());
    Choice best;
    if (n == 0 || n != static_cast<Index>(this->TargetCorners.size()))
    {
      return best;
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
      const Anchors anchors = this->anchorsOf(corners);
      this->Offsets.push_back({ this->shiftOf(anchors), cost });
      if (cost < best.cost - SameCost)
      {
        best = { anchors, cost, n };
      }
    }
    return best;
  }

  double cornerPiece(Index i, Index iNext, Index j, Index jNext) const
  {
    const double s = this->sourceCorner(i);
    const double t = this->targetCorner(j);
    return this->pieceCost(
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
    constexpr double Beside = 1e-3; // of the loop: on the edges that meet in the corner
    const double s = this->sourceCorner(i);
    std::vector<std::pair<double, Index>> order;
    for (Index j = 0; j < static_cast<Index>(this->TargetCorners.size()); ++j)
    {
      const double t = this->targetCorner(j);
      double cost = 0.0;
      for (const double side : { -Beside, Beside })
      {
        cost += this->costAt(this->movedPlace(s + side), this->movedDirection(s + side), t + side);
      }
      order.emplace_back(cost, j);
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

  /// The best cyclic sequence of pairs of corners, over all first pairs.
  Choice someCorners()
  {
    const Index m = static_cast<Index>(this->SourceCorners.size());
    Choice best;
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
        if (cost < best.cost - SameCost)
        {
          best = { this->anchorsOf(corners), cost, static_cast<Index>(corners.size()) };
        }
      }
    }
    return best;
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

  /// The best of the others that is lower than its neighbours and no neighbour of the chosen one.
  void findRunnerUp(double chosen, std::vector<Candidate> others, LoopCorrespondence& result) const
  {
    // A shift by less than an edge or so of a smooth loop is the same correspondence.
    const double edges = result.matchedCorners > 0 ? 0.9 : 1.5;
    const double near = edges / static_cast<double>(this->Source.nodes().rows());
    const auto turn = [](double from, double to) { return std::remainder(to - from, 1.0); };
    std::sort(others.begin(), others.end(), [](const Candidate& a, const Candidate& b) {
      return a.cost != b.cost ? a.cost < b.cost : a.shift < b.shift;
    });
    result.runnerUpCost = Infinity;
    for (auto candidate = others.begin(); candidate != others.end(); ++candidate)
    {
      const auto isBetterNeighbor = [&](const Candidate& other) {
        return std::abs(turn(other.shift, candidate->shift)) <= near &&
          other.cost < candidate->cost - SameCost;
      };
      if (std::abs(turn(chosen, candidate->shift)) > near &&
        std::none_of(others.begin(), candidate, isBetterNeighbor))
      {
        result.runnerUpCost = candidate->cost;
        result.runnerUpTurn = turn(chosen, candidate->shift);
        return;
      }
    }
  }

  const ClosedPolygon& Source;
  const ClosedPolygon& Target;
  Eigen::Matrix3d Linear; ///< applied to rows from the right
  Eigen::RowVector3d SourceCenter;
  Eigen::RowVector3d TargetCenter;
  std::vector<Index> SourceCorners;
  std::vector<Index> TargetCorners;
  Index Samples;
  double SquaredRadius = 0.0;
  std::vector<Eigen::RowVector3d> Places; ///< of the moved source, at the samples
  std::vector<Eigen::RowVector3d> Directions;
  std::vector<Candidate> Starts;
  std::vector<Candidate> Offsets;
  std::unordered_map<Index, double> Pieces;
};
}

bool LoopCorrespondence::isGuess() const
{
  return this->runnerUpCost <= NearlyAsGood * this->cost;
}

LoopCorrespondence correspondLoops(
  const ClosedPolygon& source, const ClosedPolygon& target, const Eigen::Matrix3d& linear)
{
  return Matcher(source, target, linear).match();
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CurveDivision.h"

#include "Core/CapQuads/ChordLengths.h"
#include "Core/Common/Constants.h"
#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/PointGrid.h"
#include "Core/Geometry/SurfaceSearch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

namespace hexsweep
{
namespace
{
constexpr double CurveGrowth = 0.4;
constexpr double SamplesPerEdge = 4.0;
constexpr double LeastSamples = 16.0; // of a curve
constexpr double FacingCosine = 0.8;  // between conormals and the way across a wall
/// A wall that two curves form beside their common end is a wedge, not a wall, up to this many
/// times its width from there.
constexpr double WedgeReach = 4.0;
constexpr double LeastOfCurve = 0.02; // of the size: shorter curves ask for nothing shorter
constexpr double TurnOfEdge = 0.5 * Pi;
constexpr double LeastOfTurn = 0.5; // of the size: bends ask for nothing shorter
constexpr Index LeastLoopEdges = 4;
constexpr double MaximumEdges = 10e6;

struct Sample
{
  Index curve;
  double reached; ///< arc length
  double wanted;  ///< edge length
};

/// A way along which the wanted length may grow.
struct Link
{
  Index to;
  double length;
};

class EdgeLengths
{
public:
  EdgeLengths(const TriangleMesh& cap, const std::vector<CapCurve>& curves, double size,
    double chordTolerance)
    : Curves(curves)
    , Size(size)
    , ChordTolerance(chordTolerance)
  {
    for (const CapCurve& curve : curves)
    {
      this->Chains.push_back(chainOf(cap.points, curve));
    }
    this->takeSamples();
    this->Links.resize(this->Samples.size());
    this->linkNeighbors();
    this->limitByWalls(cap);
    this->grow();
  }

  const std::vector<ArcLengthChain>& chains() const { return this->Chains; }

  /// How many edges there are up to each sample of a curve, as a real number.
  std::vector<double> edgesUpTo(std::size_t curve) const
  {
    std::vector<double> count(1, 0.0);
    for (std::size_t s = this->First[curve] + 1; s < this->First[curve + 1]; ++s)
    {
      const Sample& a = this->Samples[s - 1];
      const Sample& b = this->Samples[s];
      count.push_back(
        count.back() + (b.reached - a.reached) * 0.5 * (1.0 / a.wanted + 1.0 / b.wanted));
    }
    return count;
  }

  double reached(std::size_t curve, std::size_t sample) const
  {
    return this->Samples[this->First[curve] + sample].reached;
  }

private:
  void takeSamples()
  {
    for (std::size_t c = 0; c < this->Curves.size(); ++c)
    {
      this->First.push_back(this->Samples.size());
      const ArcLengthChain& chain = this->Chains[c];
      const double length = chain.length();
      const double part =
        std::max(this->Curves[c].closed() ? 0.25 * length : length, LeastOfCurve * this->Size);
      const Index n =
        static_cast<Index>(std::ceil(std::max(LeastSamples, SamplesPerEdge * length / this->Size)));
      std::vector<double> turn(static_cast<std::size_t>(n) + 1, 0.0);
      for (Index i = 1; i + 1 < chain.nodes().rows(); ++i)
      {
        const Eigen::RowVector3d back = chain.nodes().row(i) - chain.nodes().row(i - 1);
        const Eigen::RowVector3d ahead = chain.nodes().row(i + 1) - chain.nodes().row(i);
        const double place = chain.reached(i) / length * static_cast<double>(n);
        turn[static_cast<std::size_t>(std::lround(place))] +=
          std::atan2(back.cross(ahead).norm(), back.dot(ahead));
      }
      for (Index j = 0; j <= n; ++j)
      {
        // The turns are spread over an edge's length.
        const Index reach = static_cast<Index>(SamplesPerEdge / 2.0);
        double bend = 0.0;
        for (Index k = std::max<Index>(0, j - reach); k <= std::min(n, j + reach); ++k)
        {
          bend += turn[static_cast<std::size_t>(k)];
        }
        bend /= static_cast<double>(2 * reach + 1) * length / static_cast<double>(n);
        double bent =
          bend > 0.0 ? std::max(LeastOfTurn * this->Size, TurnOfEdge / bend) : this->Size;
        if (this->ChordTolerance > 0.0)
        {
          bent = std::min(bent,
            std::max(LeastOfChord * this->Size, 2.0 * chordLength(this->ChordTolerance, bend)));
        }
        this->Samples.push_back(
          { static_cast<Index>(c), length * static_cast<double>(j) / static_cast<double>(n),
            std::min({ this->Size, part, bent }) });
      }
    }
    this->First.push_back(this->Samples.size());
    this->Places.resize(static_cast<Index>(this->Samples.size()), 3);
    for (std::size_t s = 0; s < this->Samples.size(); ++s)
    {
      this->Places.row(static_cast<Index>(s)) =
        this->Chains[static_cast<std::size_t>(this->Samples[s].curve)].at(this->Samples[s].reached);
    }
  }

  void link(std::size_t a, std::size_t b, double length)
  {
    this->Links[a].push_back({ static_cast<Index>(b), length });
    this->Links[b].push_back({ static_cast<Index>(a), length });
  }

  void linkNeighbors()
  {
    std::map<Index, std::size_t> firstAt;
    for (std::size_t c = 0; c < this->Curves.size(); ++c)
    {
      for (std::size_t s = this->First[c] + 1; s < this->First[c + 1]; ++s)
      {
        this->link(s - 1, s, this->Samples[s].reached - this->Samples[s - 1].reached);
      }
      const std::pair<Index, std::size_t> ends[] = { { this->Curves[c].points.front(),
                                                       this->First[c] },
        { this->Curves[c].points.back(), this->First[c + 1] - 1 } };
      for (const auto& [point, sample] : ends)
      {
        const auto known = firstAt.emplace(point, sample);
        if (!known.second)
        {
          this->link(known.first->second, sample, 0.0);
        }
      }
    }
  }

  Eigen::RowVector3d tangent(std::size_t s) const
  {
    const std::size_t c = static_cast<std::size_t>(this->Samples[s].curve);
    const std::size_t before = std::max(s, this->First[c] + 1) - 1;
    const std::size_t after = std::min(s + 1, this->First[c + 1] - 1);
    return (
      this->Places.row(static_cast<Index>(after)) - this->Places.row(static_cast<Index>(before)))
      .normalized();
  }

  /// Whether the curves of two samples meet so near that what lies between them is a wedge.
  bool isWedge(std::size_t a, std::size_t b, double width) const
  {
    const Sample& s = this->Samples[a];
    const Sample& t = this->Samples[b];
    if (s.curve == t.curve)
    {
      return std::abs(s.reached - t.reached) < width * 1.01;
    }
    const std::vector<Index>& p = this->Curves[static_cast<std::size_t>(s.curve)].points;
    const std::vector<Index>& q = this->Curves[static_cast<std::size_t>(t.curve)].points;
    const double pLength = this->Chains[static_cast<std::size_t>(s.curve)].length();
    const double qLength = this->Chains[static_cast<std::size_t>(t.curve)].length();
    for (const bool pBack : { false, true })
    {
      for (const bool qBack : { false, true })
      {
        const double along = std::max(
          pBack ? pLength - s.reached : s.reached, qBack ? qLength - t.reached : t.reached);
        if ((pBack ? p.back() : p.front()) == (qBack ? q.back() : q.front()) &&
          along < WedgeReach * width)
        {
          return true;
        }
      }
    }
    return false;
  }

  void limitByWalls(const TriangleMesh& cap)
  {
    const Points normals = SurfaceSearch(cap).project(this->Places).normals;
    std::vector<Index> all(this->Samples.size());
    Points conormals(this->Places.rows(), 3);
    for (std::size_t s = 0; s < all.size(); ++s)
    {
      all[s] = static_cast<Index>(s);
      const Eigen::RowVector3d normal = normals.row(all[s]);
      conormals.row(all[s]) = normal.cross(this->tangent(s)).normalized();
    }
    // Towards the cap: loops run with it on their left; a border has it on both sides.
    const auto faces = [&](std::size_t s, const Eigen::RowVector3d& way) {
      const double cosine = conormals.row(static_cast<Index>(s)).dot(way);
      const bool inside = this->Curves[static_cast<std::size_t>(this->Samples[s].curve)].loop < 0;
      return (inside ? std::abs(cosine) : cosine) > FacingCosine;
    };
    const PointGrid grid(this->Places, all, this->Size);
    for (std::size_t s = 0; s < all.size(); ++s)
    {
      double width = this->Size;
      Index across = -1;
      grid.forEachNear(this->Places.row(all[s]), this->Size, [&](Index id, double distance) {
        const std::size_t t = static_cast<std::size_t>(id);
        if (!(distance > 0.0) || distance > width || (distance == width && across >= 0))
        {
          return;
        }
        const Eigen::RowVector3d way = (this->Places.row(id) - this->Places.row(all[s])) / distance;
        if (faces(s, way) && faces(t, -way) && !this->isWedge(s, t, distance))
        {
          width = distance;
          across = id;
        }
      });
      if (across >= 0)
      {
        this->Samples[s].wanted = std::min(this->Samples[s].wanted, width);
        this->link(s, static_cast<std::size_t>(across), width);
      }
    }
  }

  /// wanted(a) <= wanted(b) + CurveGrowth * way from b to a.
  void grow()
  {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (std::size_t s = 0; s < this->Samples.size(); ++s)
    {
      open.emplace(this->Samples[s].wanted, static_cast<Index>(s));
    }
    while (!open.empty())
    {
      const auto [wanted, id] = open.top();
      open.pop();
      if (wanted > this->Samples[static_cast<std::size_t>(id)].wanted)
      {
        continue;
      }
      for (const Link& link : this->Links[static_cast<std::size_t>(id)])
      {
        double& other = this->Samples[static_cast<std::size_t>(link.to)].wanted;
        if (wanted + CurveGrowth * link.length < other)
        {
          other = wanted + CurveGrowth * link.length;
          open.emplace(other, link.to);
        }
      }
    }
  }

  const std::vector<CapCurve>& Curves;
  double Size;
  double ChordTolerance;
  std::vector<ArcLengthChain> Chains;
  std::vector<Sample> Samples;
  std::vector<std::size_t> First; // sample of each curve, and one past the last
  Points Places;                  // of the samples
  std::vector<std::vector<Link>> Links;
};

/// Numbers of edges that keep to the real ones as far as loops and neighbours allow.
std::vector<Index> edgeCounts(
  const std::vector<CapCurve>& curves, const std::vector<std::vector<double>>& wanted)
{
  std::vector<Index> counts;
  std::map<Index, std::vector<std::size_t>> loops;
  std::map<std::pair<Index, Index>, std::vector<std::size_t>> single;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const Index least = curves[c].closed() ? LeastLoopEdges : 1;
    counts.push_back(std::max(least, static_cast<Index>(std::llround(wanted[c].back()))));
    if (curves[c].loop >= 0)
    {
      loops[curves[c].loop].push_back(c);
    }
  }
  for (const auto& [loop, members] : loops)
  {
    for (;;)
    {
      Index sum = 0;
      std::size_t longest = members.front();
      const auto load = [&](std::size_t c) {
        return wanted[c].back() / static_cast<double>(counts[c]);
      };
      for (const std::size_t c : members)
      {
        sum += counts[c];
        longest = load(c) > load(longest) ? c : longest;
      }
      if (sum >= LeastLoopEdges)
      {
        break;
      }
      ++counts[longest];
    }
  }
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (counts[c] == 1)
    {
      single[std::minmax(curves[c].points.front(), curves[c].points.back())].push_back(c);
    }
  }
  for (const auto& [ends, members] : single)
  {
    for (std::size_t m = 0; m < members.size() && members.size() > 1; ++m)
    {
      counts[members[m]] = 2;
    }
  }
  return counts;
}
}

std::vector<std::vector<double>> divideCapCurves(
  const TriangleMesh& cap, const std::vector<CapCurve>& curves, double size, double chordTolerance)
{
  const EdgeLengths lengths(cap, curves, size, chordTolerance);
  std::vector<std::vector<double>> wanted;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    wanted.push_back(lengths.edgesUpTo(c));
  }
  double edges = 0.0;
  for (const std::vector<double>& curve : wanted)
  {
    edges += curve.back();
  }
  if (!(edges <= MaximumEdges))
  {
    throw InvalidInput("the cap is so narrow in places that its boundary would take " +
      describe(edges) + " edges. Give a larger size, or mend the cap where curves all but touch.");
  }
  const std::vector<Index> counts = edgeCounts(curves, wanted);
  std::vector<std::vector<double>> divided(curves.size());
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const double length = lengths.chains()[c].length();
    divided[c].push_back(0.0);
    std::size_t sample = 1;
    for (Index k = 1; k < counts[c]; ++k)
    {
      const double goal =
        wanted[c].back() * static_cast<double>(k) / static_cast<double>(counts[c]);
      while (wanted[c][sample] < goal)
      {
        ++sample;
      }
      const double t = (goal - wanted[c][sample - 1]) / (wanted[c][sample] - wanted[c][sample - 1]);
      const double before = lengths.reached(c, sample - 1);
      divided[c].push_back(before + t * (lengths.reached(c, sample) - before));
    }
    divided[c].push_back(length);
  }
  return divided;
}
}

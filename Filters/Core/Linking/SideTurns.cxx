// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/SideTurns.h"

#include "Core/Geometry/AffineMap.h"
#include "Core/Geometry/LoopGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
constexpr Index Levels = 12;      // held sides may twist by 90 degrees between two of them
constexpr Index MostColumns = 48; // columns of a side that are looked at, at most
constexpr int Rounds = 2;         // of the Gauss-Newton iteration at each level

/// Every few columns of a side.
class SampledSide
{
public:
  explicit SampledSide(const LinkingSideColumns& side)
    : Side(side)
  {
    const Index count = std::min(side.size(), MostColumns);
    for (Index i = 0; i < count; ++i)
    {
      this->Columns.push_back(i * side.size() / count);
    }
    this->Begins = this->at(0.0, 0.0);
    const Points offsets = this->Begins.rowwise() - this->Begins.colwise().mean();
    this->Radius = std::sqrt(offsets.rowwise().squaredNorm().mean());
  }

  Points at(double u, double turn) const { return this->Side.nodesAt(this->Columns, u, turn); }
  const Points& begins() const { return this->Begins; }
  double radius() const { return this->Radius; }
  double height() const { return this->Side.meanLength(); }

  /// The turn near a first guess that brings the columns nearest to the wanted places.
  double fit(double u, double turn, const Points& wanted) const
  {
    const Index n = wanted.rows();
    for (int round = 0; round < Rounds; ++round)
    {
      const Points here = this->at(u, turn);
      double product = 0.0;
      double squares = 0.0;
      for (Index i = 0; i < n; ++i)
      {
        const Index before = (i + n - 1) % n;
        const Index after = (i + 1) % n;
        double step =
          this->Side.beginOf(this->column(after)) - this->Side.beginOf(this->column(before));
        step += step <= 0.0 ? 1.0 : 0.0;
        const Eigen::RowVector3d tangent = (here.row(after) - here.row(before)) / step;
        product += tangent.dot(wanted.row(i) - here.row(i));
        squares += tangent.squaredNorm();
      }
      constexpr double Longest = 0.125; // of a whole turn
      const double change = squares > 0.0 ? product / squares : 0.0;
      turn += std::max(-Longest, std::min(Longest, change));
    }
    return turn;
  }

private:
  Index column(Index i) const { return this->Columns[static_cast<std::size_t>(i)]; }

  const LinkingSideColumns& Side;
  std::vector<Index> Columns;
  Points Begins;
  double Radius = 0.0;
};

std::vector<bool> heldSides(const std::deque<LinkingSideColumns>& sides)
{
  std::vector<bool> held;
  std::size_t longest = 0;
  double most = 0.0;
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    held.push_back(!sides[s].isFree());
    const double length = closedLength(sides[s].ring());
    longest = length > most ? s : longest;
    most = std::max(most, length);
  }
  if (std::find(held.begin(), held.end(), true) == held.end())
  {
    held[longest] = true;
  }
  return held;
}

/// The affine maps of the held rings at the source to those at each level, from the first level on.
std::vector<AffineMap> mapsToLevels(
  const std::vector<SampledSide>& sampled, const std::vector<bool>& held)
{
  Index nodes = 0;
  std::size_t main = sampled.size();
  for (std::size_t s = 0; s < sampled.size(); ++s)
  {
    if (held[s])
    {
      nodes += sampled[s].begins().rows();
      main = main == sampled.size() || sampled[s].radius() > sampled[main].radius() ? s : main;
    }
  }
  const auto all = [&](double u) {
    Points points(nodes, 3);
    Index row = 0;
    for (std::size_t s = 0; s < sampled.size(); ++s)
    {
      if (held[s])
      {
        const Points own = sampled[s].at(u, 0.0);
        points.middleRows(row, own.rows()) = own;
        row += own.rows();
      }
    }
    return points;
  };
  const Points begins = all(0.0);
  const Eigen::RowVector3d area = areaVector(sampled[main].begins());
  std::vector<AffineMap> maps;
  for (Index k = 1; k <= Levels; ++k)
  {
    const double u = static_cast<double>(k) / static_cast<double>(Levels);
    maps.push_back(fitAffineMap(begins, all(u), area, areaVector(sampled[main].at(u, 0.0))));
  }
  return maps;
}

/// How much of the turn that suits the cap a side should take.
double shareOf(const std::vector<SampledSide>& sampled, const std::deque<LinkingSideColumns>& sides,
  std::size_t s)
{
  double gap = std::numeric_limits<double>::infinity();
  double radius = sampled[s].radius();
  for (std::size_t other = 0; other < sides.size(); ++other)
  {
    if (other == s)
    {
      continue;
    }
    for (Index i = 0; i < sampled[s].begins().rows(); ++i)
    {
      const double distance =
        (sides[other].ring().rowwise() - sampled[s].begins().row(i)).rowwise().norm().minCoeff();
      if (distance < gap)
      {
        gap = distance;
        radius = std::min(sampled[s].radius(), sampled[other].radius());
      }
    }
  }
  const double inCap = radius / gap;
  const double inSide = sampled[s].radius() / sampled[s].height();
  return inCap * inCap / (inCap * inCap + inSide * inSide);
}
}

std::vector<double> sideTurns(const std::deque<LinkingSideColumns>& sides)
{
  std::vector<double> turns(sides.size(), 0.0);
  const std::vector<bool> held = heldSides(sides);
  if (std::find(held.begin(), held.end(), false) == held.end())
  {
    return turns;
  }
  const std::vector<SampledSide> sampled(sides.begin(), sides.end());
  const std::vector<AffineMap> maps = mapsToLevels(sampled, held);
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    if (held[s])
    {
      continue;
    }
    for (Index k = 1; k <= Levels; ++k)
    {
      const double u = static_cast<double>(k) / static_cast<double>(Levels);
      turns[s] = sampled[s].fit(
        u, turns[s], maps[static_cast<std::size_t>(k - 1)].apply(sampled[s].begins()));
    }
    turns[s] *= shareOf(sampled, sides, s);
  }
  return turns;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexPolishing.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexCorner.h"
#include "Core/Hexahedra/HexPatches.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

namespace hexsweep
{
namespace
{
constexpr double GoodEnough = 0.95;
/// Above this a scaled Jacobian may fall for the good of its neighbours.
constexpr double FreelyTraded = 0.5;
/// Added to the diagonal, relative to its mean.
constexpr double Damping = 1e-3;
constexpr int Backtracks = 4;
/// A node whose sum falls by less of it stays where it is from then on.
constexpr double LeastGain = 0.02;
constexpr Index NodesAtOnce = 256;
constexpr Index NodesPerReport = 64 * NodesAtOnce;

HexCorners cornersOf(const Points& points, const HexesRef& hexes, Index h)
{
  HexCorners corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.row(i) = points.row(hexes(h, i));
  }
  return corners;
}

/// Sum, gradient and Gauss-Newton matrix of (1 - scaled Jacobian)^2 with respect to one node.
struct LocalSum
{
  double value = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();

  /// @param moving index of the node among the hexahedron's corners.
  void add(const HexCorners& x, int moving)
  {
    for (int c = 0; c < 8; ++c)
    {
      const int* to = HexCornerNeighbors[c];
      int edge = c == moving ? 3 : -1;
      for (int e = 0; e < 3; ++e)
      {
        edge = to[e] == moving ? e : edge;
      }
      if (edge < 0)
      {
        continue;
      }
      Eigen::Vector3d arm[3];
      for (int e = 0; e < 3; ++e)
      {
        const Eigen::Vector3d a = (x.row(to[e]) - x.row(c)).transpose();
        arm[e] = a;
      }
      const double squares[3] = { arm[0].squaredNorm(), arm[1].squaredNorm(),
        arm[2].squaredNorm() };
      const double lengths = std::sqrt(squares[0]) * std::sqrt(squares[1]) * std::sqrt(squares[2]);
      if (!(lengths > 0.0))
      {
        continue;
      }
      Eigen::Vector3d slope = Eigen::Vector3d::Zero();
      double jacobian = 0.0;
      for (int e = 0; e < 3; ++e)
      {
        const Eigen::Vector3d cross = arm[(e + 1) % 3].cross(arm[(e + 2) % 3]) / lengths;
        jacobian = arm[e].dot(cross);
        if (edge == e || edge == 3)
        {
          const Eigen::Vector3d part = cross - jacobian / squares[e] * arm[e];
          slope += edge == 3 ? Eigen::Vector3d(-part) : part;
        }
      }
      const double loss = 1.0 - jacobian;
      this->value += loss * loss;
      this->gradient -= 2.0 * loss * slope;
      this->curvature += 2.0 * slope * slope.transpose();
      // The scaled Jacobian falls about quadratically as an arm turns away from its best place.
      double stiffness = 0.0;
      for (int e = 0; e < 3; ++e)
      {
        stiffness += edge == e || edge == 3 ? 1.0 / squares[e] : 0.0;
      }
      this->curvature.diagonal().array() += 2.0 * loss * std::max(jacobian, 0.0) * stiffness;
    }
  }
};

class Polisher
{
public:
  Polisher(const PointsRef& points, const HexesRef& hexes, const std::vector<bool>& fixed,
    const ParallelFor& parallelFor, const Progress& progress)
    : Places(points)
    , Cells(hexes)
    , AtNodes(hexes, points.rows())
    , Settled(fixed.size(), 0)
  {
    this->color(fixed, progressPart(progress, 0.0, 0.7));
    this->Qualities =
      hexQualities(points, hexes, true, parallelFor, progressPart(progress, 0.7, 1.0));
    this->Minimum = 1.0;
    for (const HexQuality& quality : this->Qualities)
    {
      this->Minimum = std::min(this->Minimum, quality.scaledJacobian);
    }
  }

  const std::vector<std::vector<Index>>& groups() const { return this->Groups; }

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
            here += this->move(nodes[static_cast<std::size_t>(k)]);
          }
          moved += here;
        });
    }
    return moved;
  }

  Points take() { return std::move(this->Places); }

private:
  /// Groups of nodes that share no hexahedron, greedily.
  void color(const std::vector<bool>& fixed, const Progress& progress)
  {
    std::vector<int> colors(fixed.size(), -1);
    std::vector<bool> taken;
    for (std::size_t i = 0; i < fixed.size(); ++i)
    {
      if (i % static_cast<std::size_t>(NodesPerReport) == 0)
      {
        reportProgress(progress, static_cast<double>(i) / static_cast<double>(fixed.size()));
      }
      const auto around = this->AtNodes[static_cast<Index>(i)];
      if (fixed[i] || around.begin() == around.end())
      {
        continue;
      }
      taken.assign(this->Groups.size() + 1, false);
      for (const Index h : around)
      {
        for (int c = 0; c < 8; ++c)
        {
          const int other = colors[static_cast<std::size_t>(this->Cells(h, c))];
          if (other >= 0)
          {
            taken[static_cast<std::size_t>(other)] = true;
          }
        }
      }
      const auto first = std::find(taken.begin(), taken.end(), false) - taken.begin();
      colors[i] = static_cast<int>(first);
      if (static_cast<std::size_t>(first) == this->Groups.size())
      {
        this->Groups.emplace_back();
      }
      this->Groups[static_cast<std::size_t>(first)].push_back(static_cast<Index>(i));
    }
  }

  bool move(Index node)
  {
    char& settled = this->Settled[static_cast<std::size_t>(node)];
    if (settled)
    {
      return false;
    }
    const auto around = this->AtNodes[node];
    double least = 1.0;
    for (const Index h : around)
    {
      least = std::min(least, this->Qualities[static_cast<std::size_t>(h)].scaledJacobian);
    }
    if (least >= GoodEnough)
    {
      return false;
    }
    const LocalSum sum = this->sum(node);
    Eigen::Matrix3d matrix = sum.curvature;
    matrix.diagonal().array() += Damping * matrix.diagonal().mean();
    const Eigen::Vector3d step = matrix.ldlt().solve(-sum.gradient);
    const double slope = step.dot(sum.gradient);
    if (!step.allFinite() || !(slope < 0.0))
    {
      return false;
    }
    const double floor = std::min(least, std::max(FreelyTraded, this->Minimum));
    const Eigen::RowVector3d before = this->Places.row(node);
    double length = 1.0;
    for (int backtrack = 0; backtrack < Backtracks; ++backtrack, length *= 0.5)
    {
      this->Places.row(node) = before + length * step.transpose();
      if (const std::optional<double> after =
            this->accept(node, floor, sum.value + 1e-4 * length * slope))
      {
        settled = sum.value - *after < LeastGain * sum.value;
        return true;
      }
    }
    this->Places.row(node) = before;
    settled = 1;
    return false;
  }

  LocalSum sum(Index node) const
  {
    LocalSum sum;
    for (const Index h : this->AtNodes[node])
    {
      int corner = 0;
      while (this->Cells(h, corner) != node)
      {
        ++corner;
      }
      sum.add(cornersOf(this->Places, this->Cells, h), corner);
    }
    return sum;
  }

  /// The sum at the node's new place, where that is to be kept.
  std::optional<double> accept(Index node, double floor, double greatestSum)
  {
    const double value = this->sum(node).value;
    if (!(value <= greatestSum))
    {
      return std::nullopt;
    }
    const auto around = this->AtNodes[node];
    Points corners(8 * (around.end() - around.begin()), 3);
    Index row = 0;
    for (const Index h : around)
    {
      corners.middleRows<8>(row) = cornersOf(this->Places, this->Cells, h);
      row += 8;
    }
    const std::vector<HexQuality> qualities = hexQualities(corners);
    std::size_t next = 0;
    for (const Index h : around)
    {
      const HexQuality& old = this->Qualities[static_cast<std::size_t>(h)];
      const HexQuality& now = qualities[next++];
      if (!(now.scaledJacobian >= floor) ||
        (old.validity == Validity::Certified && now.validity != Validity::Certified))
      {
        return std::nullopt;
      }
    }
    next = 0;
    for (const Index h : around)
    {
      this->Qualities[static_cast<std::size_t>(h)] = qualities[next++];
    }
    return value;
  }

  Points Places;
  HexesRef Cells;
  HexesAtNodes AtNodes;
  std::vector<HexQuality> Qualities;
  std::vector<std::vector<Index>> Groups;
  std::vector<char> Settled;
  double Minimum;
};
}

PolishedHexes polishHexes(const PointsRef& points, const HexesRef& hexes,
  const std::vector<bool>& fixed, int rounds, const ParallelFor& parallelFor,
  const Progress& progress)
{
  PolishedHexes result;
  constexpr double Preparation = 0.1;
  Polisher polisher(points, hexes, fixed, parallelFor, progressPart(progress, 0.0, Preparation));
  const std::vector<std::vector<Index>>& groups = polisher.groups();
  const double width = (1.0 - Preparation) / static_cast<double>(rounds * groups.size());
  double done = Preparation;
  for (int round = 0; round < rounds; ++round)
  {
    for (const std::vector<Index>& group : groups)
    {
      result.movedNodes +=
        polisher.moveGroup(group, parallelFor, progressPart(progress, done, done + width));
      done += width;
    }
  }
  result.points = polisher.take();
  return result;
}
}

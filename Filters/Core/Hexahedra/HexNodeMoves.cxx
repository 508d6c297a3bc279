// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexNodeMoves.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexCorner.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
/// Added to the diagonal, relative to its mean.
constexpr double Damping = 1e-3;
constexpr int Backtracks = 4;
constexpr double SufficientDecrease = 1e-4;
constexpr std::size_t NodesPerReport = 16384;

HexCorners cornersOf(const Points& points, const HexesRef& hexes, Index h)
{
  HexCorners corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.row(i) = points.row(hexes(h, i));
  }
  return corners;
}

/// Index of a node among the corners of a hexahedron at it.
int cornerOf(const HexesRef& hexes, Index h, Index node)
{
  int corner = 0;
  while (hexes(h, corner) != node)
  {
    ++corner;
  }
  return corner;
}

struct Corner
{
  Eigen::Vector3d arm[3];
  double squares[3];
  double lengths; ///< their product
  double jacobian;

  Corner(const HexCorners& x, int c)
  {
    for (int e = 0; e < 3; ++e)
    {
      this->arm[e] = (x.row(HexCornerNeighbors[c][e]) - x.row(c)).transpose();
      this->squares[e] = this->arm[e].squaredNorm();
    }
    this->lengths =
      std::sqrt(this->squares[0]) * std::sqrt(this->squares[1]) * std::sqrt(this->squares[2]);
    this->jacobian = this->arm[0].dot(this->arm[1].cross(this->arm[2])) / this->lengths;
  }

  /// The scaled Jacobian's derivative by an arm, but for the arm's length.
  Eigen::Vector3d cross(int e) const
  {
    return this->arm[(e + 1) % 3].cross(this->arm[(e + 2) % 3]) / this->lengths;
  }
};
}

HexLoss::Place HexLoss::at(double x) const
{
  const double k = this->sharpness;
  if (k == 0.0)
  {
    return { (1.0 - x) * (1.0 - x), -2.0 * (1.0 - x), 2.0 };
  }
  const double t = k * (this->middle - x);
  if (t > 0.0)
  {
    return { 1.0 + t + 0.5 * t * t, -k * (1.0 + t), k * k };
  }
  const double value = std::exp(t);
  return { value, -k * value, k * k * value };
}

void HexNodeSum::add(const HexCorners& x, int moving, const HexLoss& loss)
{
  for (int i = 0; i < 4; ++i)
  {
    const int c = i < 3 ? HexCornerNeighbors[moving][i] : moving;
    const Corner corner(x, c);
    if (!(corner.lengths > 0.0))
    {
      continue;
    }
    Eigen::Vector3d slope = Eigen::Vector3d::Zero();
    // The scaled Jacobian falls about quadratically as an arm turns away from its best place.
    double stiffness = 0.0;
    for (int e = 0; e < 3; ++e)
    {
      if (c == moving || HexCornerNeighbors[c][e] == moving)
      {
        const double inverse = 1.0 / corner.squares[e];
        slope += corner.cross(e) - corner.jacobian * inverse * corner.arm[e];
        stiffness += inverse;
      }
    }
    if (c == moving)
    {
      slope = -slope;
    }
    const HexLoss::Place place = loss.at(corner.jacobian);
    this->value += place.value;
    this->gradient += place.slope * slope;
    this->curvature.noalias() += place.curvature * slope * slope.transpose();
    this->curvature.diagonal().array() -= place.slope * std::max(corner.jacobian, 0.0) * stiffness;
  }
}

double HexNodeSum::valueOf(const HexCorners& x, int moving, const HexLoss& loss)
{
  double value = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const Corner corner(x, i < 3 ? HexCornerNeighbors[moving][i] : moving);
    value += corner.lengths > 0.0 ? loss.at(corner.jacobian).value : 0.0;
  }
  return value;
}

HexNodeMoves::HexNodeMoves(const PointsRef& points, const HexesRef& hexes,
  const std::vector<bool>& fixed, const ParallelFor& parallelFor, const Progress& progress)
  : Places(points)
  , Cells(hexes)
  , AtNodes(hexes, points.rows())
{
  this->color(fixed, progressPart(progress, 0.0, 0.7));
  this->Qualities =
    hexQualities(points, hexes, true, parallelFor, progressPart(progress, 0.7, 1.0));
}

/// Greedily.
void HexNodeMoves::color(const std::vector<bool>& fixed, const Progress& progress)
{
  std::vector<int> colors(fixed.size(), -1);
  std::vector<bool> taken;
  for (std::size_t i = 0; i < fixed.size(); ++i)
  {
    if (i % NodesPerReport == 0)
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

double HexNodeMoves::leastAt(Index node) const
{
  double least = 1.0;
  for (const Index h : this->AtNodes[node])
  {
    least = std::min(least, this->Qualities[static_cast<std::size_t>(h)].scaledJacobian);
  }
  return least;
}

HexNodeMoves::Step HexNodeMoves::move(
  Index node, const HexLoss& loss, double floor, Certificates certificates)
{
  const HexNodeSum sum = this->sum(node, loss);
  Eigen::Matrix3d matrix = sum.curvature;
  matrix.diagonal().array() += Damping * matrix.diagonal().mean();
  const Eigen::Vector3d step = matrix.ldlt().solve(-sum.gradient);
  const double slope = step.dot(sum.gradient);
  if (!step.allFinite() || !(slope < 0.0))
  {
    return {};
  }
  const Eigen::RowVector3d before = this->Places.row(node);
  double length = 1.0;
  for (int backtrack = 0; backtrack < Backtracks; ++backtrack, length *= 0.5)
  {
    this->Places.row(node) = before + length * step.transpose();
    if (const std::optional<double> after = this->accept(
          node, loss, floor, sum.value + SufficientDecrease * length * slope, certificates))
    {
      return { true, (sum.value - *after) / sum.value };
    }
  }
  this->Places.row(node) = before;
  return {};
}

HexNodeSum HexNodeMoves::sum(Index node, const HexLoss& loss) const
{
  HexNodeSum sum;
  for (const Index h : this->AtNodes[node])
  {
    sum.add(cornersOf(this->Places, this->Cells, h), cornerOf(this->Cells, h, node), loss);
  }
  return sum;
}

/// The sum at the node's new place, where that is to be kept.
std::optional<double> HexNodeMoves::accept(
  Index node, const HexLoss& loss, double floor, double greatestSum, Certificates certificates)
{
  const auto around = this->AtNodes[node];
  Points corners(8 * (around.end() - around.begin()), 3);
  Index row = 0;
  double value = 0.0;
  for (const Index h : around)
  {
    const HexCorners places = cornersOf(this->Places, this->Cells, h);
    value += HexNodeSum::valueOf(places, cornerOf(this->Cells, h, node), loss);
    corners.middleRows<8>(row) = places;
    row += 8;
  }
  if (!(value <= greatestSum))
  {
    return std::nullopt;
  }
  const std::vector<HexQuality> qualities = hexQualities(corners);
  std::size_t next = 0;
  for (const Index h : around)
  {
    const HexQuality& old = this->Qualities[static_cast<std::size_t>(h)];
    const HexQuality& now = qualities[next++];
    if (!(now.scaledJacobian >= floor) ||
      (certificates == Certificates::Stay && old.validity == Validity::Certified &&
        now.validity != Validity::Certified))
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
}

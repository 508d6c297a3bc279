// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexNodeMoves.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexCorner.h"
#include "Core/Hexahedra/HexKernels.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace hexsweep
{
namespace
{
/// Added to the diagonal, relative to its mean.
constexpr double NodeDamping = 1e-3;
constexpr double LeastEdge = 0.1; // of what it was at first
constexpr int Backtracks = 4;
constexpr double SufficientNodeDecrease = 1e-4;
constexpr std::size_t NodesPerProgress = 16384;

/// Numbers of one visit: in place up to `Size`, which nearly all nodes need.
template <typename Value, std::size_t Size>
class Scratch
{
public:
  explicit Scratch(std::size_t size)
  {
    if (size > Size)
    {
      this->Many.resize(size);
      this->First = this->Many.data();
    }
  }
  Value* data() { return this->First; }
  const Value* data() const { return this->First; }

private:
  std::array<Value, Size> Few;
  std::vector<Value> Many;
  Value* First = this->Few.data();
};

/// Downhill by the sum's parabola; not finite where that has no lowest place.
Eigen::Vector3d newtonStep(const HexNodeSum& sum)
{
  const double* c = sum.curvature;
  Eigen::Matrix3d matrix;
  matrix << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
  matrix.diagonal().array() += NodeDamping * matrix.diagonal().mean();
  return matrix.llt().solve(-Eigen::Map<const Eigen::Vector3d>(sum.gradient));
}
}

HexNodeMoves::HexNodeMoves(const PointsRef& points, const HexesRef& hexes,
  const std::vector<bool>& fixed, const ParallelFor& parallelFor, const Progress& progress)
  : HexNodeMoves(points, hexes, fixed,
      hexVerdicts(points, hexes, parallelFor, progressPart(progress, 0.0, 0.3)),
      std::numeric_limits<double>::infinity(), progressPart(progress, 0.3, 1.0))
{
}

HexNodeMoves::HexNodeMoves(const PointsRef& points, const HexesRef& hexes,
  const std::vector<bool>& fixed, std::vector<HexQuality> verdicts, double enough,
  const Progress& progress)
  : Start(points)
  , Places(points)
  , Cells(hexes)
  , AtNodes(hexes, points.rows())
  , Qualities(std::move(verdicts))
{
  this->color(fixed, enough, progress);
}

/// Greedily.
void HexNodeMoves::color(const std::vector<bool>& fixed, double enough, const Progress& progress)
{
  std::vector<int> colors(fixed.size(), -1);
  std::vector<std::size_t> sizes;
  std::vector<bool> taken;
  for (std::size_t i = 0; i < fixed.size(); ++i)
  {
    if (i % NodesPerProgress == 0)
    {
      reportProgress(progress, static_cast<double>(i) / static_cast<double>(fixed.size()));
    }
    const auto around = this->AtNodes[static_cast<Index>(i)];
    if (fixed[i] || around.begin() == around.end() ||
      this->leastAt(static_cast<Index>(i)) >= enough)
    {
      continue;
    }
    taken.assign(sizes.size() + 1, false);
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
    sizes.resize(std::max(sizes.size(), static_cast<std::size_t>(first) + 1), 0);
    ++sizes[static_cast<std::size_t>(first)];
  }
  this->Groups.resize(sizes.size());
  for (std::size_t group = 0; group < sizes.size(); ++group)
  {
    this->Groups[group].reserve(sizes[group]);
  }
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    if (colors[i] >= 0)
    {
      this->Groups[static_cast<std::size_t>(colors[i])].push_back(static_cast<Index>(i));
    }
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

void HexNodeMoves::prefetch(Index node) const
{
#if defined(__GNUC__)
  for (const Index h : this->AtNodes[node])
  {
    const Index* ids = this->Cells.data() + this->Cells.outerStride() * h;
    __builtin_prefetch(ids);
    __builtin_prefetch(ids + 7);
    __builtin_prefetch(this->Qualities.data() + h);
  }
#else
  static_cast<void>(node);
#endif
}

/// A node and the hexahedra at it.
class HexNodeMoves::Visit
{
public:
  Visit(HexNodeMoves& moves, Index node)
    : Moves(moves)
    , Around(moves.AtNodes[node])
    , Count(Around.end() - Around.begin())
    , Batches(static_cast<int>((Count + HexLanesSize - 1) / HexLanesSize))
    , Corners(static_cast<std::size_t>(8 * HexLanesSize * Batches))
  {
    const double* places = moves.Places.data();
    const double** to = this->Corners.data();
    for (const Index h : this->Around)
    {
      const Index* ids = moves.Cells.data() + moves.Cells.outerStride() * h;
      int corner = 0;
      while (ids[corner] != node)
      {
        ++corner;
      }
      for (const int i : HexCornersFrom[corner])
      {
        *to++ = places + 3 * ids[i];
      }
    }
    // Hexahedra without edges fill the last batch: they add nothing.
    std::fill(to, this->Corners.data() + 8 * HexLanesSize * this->Batches, places + 3 * node);
  }

  HexNodeSum sum(const HexLoss& loss) const
  {
    return Kernels.sum(this->Corners.data(), this->Batches, loss);
  }

  double value(const HexLoss& loss) const
  {
    return Kernels.value(this->Corners.data(), this->Batches, loss);
  }

  /// Whether no edge at the node is much shorter than at first.
  bool keepsLengths() const
  {
    const double* places = this->Moves.Places.data();
    const auto startOf = [&](const double* place) {
      return this->Moves.Start.row((place - places) / 3);
    };
    for (Index h = 0; h < this->Count; ++h)
    {
      const double* const* corners = this->Corners.data() + 8 * h;
      const Eigen::Map<const Eigen::RowVector3d> here(corners[0]);
      for (const int i : HexCornerNeighbors[0])
      {
        const Eigen::Map<const Eigen::RowVector3d> there(corners[i]);
        if ((there - here).squaredNorm() <
          LeastEdge * LeastEdge * (startOf(corners[i]) - startOf(corners[0])).squaredNorm())
        {
          return false;
        }
      }
    }
    return true;
  }

  /// Whether the hexahedra are to be had as they are now; keeps their qualities then.
  bool accept(double floor, Certificates certificates)
  {
    // In the order of their own corners: the last bits are those that others find.
    Scratch<const double*, 8 * UsualHexes> corners(static_cast<std::size_t>(8 * this->Count));
    const double** to = corners.data();
    for (const Index h : this->Around)
    {
      const Index* ids = this->Moves.Cells.data() + this->Moves.Cells.outerStride() * h;
      for (int i = 0; i < 8; ++i)
      {
        *to++ = this->Moves.Places.data() + 3 * ids[i];
      }
    }
    Scratch<HexQuality, UsualHexes> qualities(static_cast<std::size_t>(this->Count));
    hexVerdicts(corners.data(), this->Count, qualities.data());
    const HexQuality* now = qualities.data();
    for (const Index h : this->Around)
    {
      const HexQuality& old = this->Moves.Qualities[static_cast<std::size_t>(h)];
      if (!(now->scaledJacobian >= floor) ||
        (certificates == Certificates::Stay && old.validity == Validity::Certified &&
          now->validity != Validity::Certified))
      {
        return false;
      }
      ++now;
    }
    now = qualities.data();
    for (const Index h : this->Around)
    {
      this->Moves.Qualities[static_cast<std::size_t>(h)] = *now++;
    }
    return true;
  }

private:
  static constexpr std::size_t UsualHexes = 16;

  HexNodeMoves& Moves;
  const HexKernels& Kernels = hexKernels();
  const CellsAtNodes::Range Around;
  const Index Count;
  const int Batches;
  Scratch<const double*, 8 * UsualHexes> Corners; ///< of each hexahedron, from the node on
};

HexNodeMoves::Step HexNodeMoves::move(
  Index node, const HexLoss& loss, double floor, Certificates certificates)
{
  Visit visit(*this, node);
  const HexNodeSum sum = visit.sum(loss);
  const Eigen::Vector3d step = newtonStep(sum);
  const double slope = step.dot(Eigen::Map<const Eigen::Vector3d>(sum.gradient));
  if (!step.allFinite() || !(slope < 0.0))
  {
    return {};
  }
  const Eigen::RowVector3d before = this->Places.row(node);
  double length = 1.0;
  for (int backtrack = 0; backtrack < Backtracks; ++backtrack, length *= 0.5)
  {
    this->Places.row(node) = before + length * step.transpose();
    const double value = visit.value(loss);
    if (value <= sum.value + SufficientNodeDecrease * length * slope && visit.keepsLengths() &&
      visit.accept(floor, certificates))
    {
      return { true, (sum.value - value) / sum.value };
    }
  }
  this->Places.row(node) = before;
  return {};
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/SideSlides.h"

#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Interior/SweptHexes.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr int SlideRounds = 24;
constexpr int Patience = 4; // rounds in which the least scaled Jacobian has to grow
constexpr double LeastGrowth = 0.005;
/// More poor hexahedra are no matter of single nodes.
constexpr Index MostPoor = 200;
constexpr double FirstStride = 0.25; // of the edge that a node is moved along
constexpr double LastStride = 0.01;
constexpr double SlideSharpness = 12.0;
constexpr double LeastGain = 1e-3; // of the sum at a node, for a move to count

/// Neighbours of each corner of a hexahedron, VTK_HEXAHEDRON order.
constexpr Index HexNeighbors[8][3] = { { 1, 3, 4 }, { 0, 2, 5 }, { 1, 3, 6 }, { 2, 0, 7 },
  { 0, 5, 7 }, { 1, 4, 6 }, { 2, 5, 7 }, { 3, 4, 6 } };

double scaledJacobianOf(const Points& points, const HexesRef& hexes, Index hex)
{
  HexCorners corners;
  for (Index c = 0; c < 8; ++c)
  {
    corners.row(c) = points.row(hexes(hex, c));
  }
  const double value = hexQuality(corners).scaledJacobian;
  return std::isfinite(value) ? value : -1.0;
}

/// A node that may move.
struct SlidingNode
{
  Index id = -1;
  Index row = -1; ///< of SweepBoundary::nodes, -1 inside
  std::vector<Index> hexes;
  std::vector<Index> neighbors; ///< along edges; of a node on a side those on the side
  double stride = FirstStride;
};

/// The mesh, and what is known of its nodes.
class SideSlide
{
public:
  SideSlide(const SweepCage& cage, const PointsRef& filled, const std::vector<bool>& stays,
    const NearestOnSide& nearest, const ParallelFor& parallelFor)
    : Nearest(nearest)
    , Places(filled)
    , Cells(sweptHexes(cage.quads, filled, cage.boundary.numberOfLayers(), parallelFor))
    , OfLayer(cage.source.rows())
    , Layers(cage.boundary.numberOfLayers())
    , Rows(at(cage.source.rows()), -1)
    , Stays(stays)
  {
    for (std::size_t row = 0; row < cage.boundary.nodes.size(); ++row)
    {
      this->Rows[at(cage.boundary.nodes[row])] = static_cast<Index>(row);
    }
  }

  /// @return whether there are poor hexahedra at a side, not too many.
  bool gather(double enough, const ParallelFor& parallelFor, const Progress& progress)
  {
    const std::vector<HexQuality> qualities =
      hexVerdicts(this->Places, this->Cells, parallelFor, progress);
    std::vector<bool> isNear(at(this->Places.rows()), false);
    Index poor = 0;
    for (Index hex = 0; hex < this->Cells.rows(); ++hex)
    {
      const auto nodes = this->Cells.row(hex);
      if (!(qualities[at(hex)].scaledJacobian >= enough) &&
        std::any_of(nodes.begin(), nodes.end(), [&](Index id) { return this->rowOf(id) >= 0; }))
      {
        ++poor;
        for (const Index id : nodes)
        {
          isNear[at(id)] = true;
        }
      }
    }
    const bool isFew = poor > 0 && poor <= MostPoor;
    if (isFew)
    {
      this->gatherAround(isNear);
    }
    return isFew;
  }

  void round(double enough)
  {
    for (SlidingNode& node : this->Nodes)
    {
      if (node.stride > LastStride && this->leastAt(node) < enough)
      {
        this->move(node);
      }
    }
  }

  bool isDone() const
  {
    return std::none_of(this->Nodes.begin(), this->Nodes.end(),
      [](const SlidingNode& node) { return node.stride > LastStride; });
  }

  double least() const
  {
    double least = 1.0;
    for (const Index hex : this->Around)
    {
      least = std::min(least, scaledJacobianOf(this->Places, this->Cells, hex));
    }
    return least;
  }

  Points take() { return std::move(this->Places); }

private:
  Index rowOf(Index id) const { return this->Rows[at(id % this->OfLayer)]; }

  bool mayMove(Index id) const
  {
    const Index layer = id / this->OfLayer;
    const Index row = this->rowOf(id);
    return layer > 0 && layer < this->Layers && (row < 0 || !this->Stays[at(row)]);
  }

  /// All nodes of the hexahedra at nodes of poor ones, and the hexahedra at these.
  void gatherAround(const std::vector<bool>& isNear)
  {
    const auto touches = [&](Index hex, const std::vector<bool>& marked) {
      const auto nodes = this->Cells.row(hex);
      return std::any_of(nodes.begin(), nodes.end(), [&](Index id) { return marked[at(id)]; });
    };
    std::vector<bool> isAround(isNear.size(), false);
    for (Index hex = 0; hex < this->Cells.rows(); ++hex)
    {
      if (touches(hex, isNear))
      {
        for (const Index id : this->Cells.row(hex))
        {
          isAround[at(id)] = true;
        }
      }
    }
    std::vector<Index> numberOf(isNear.size(), -1);
    for (std::size_t id = 0; id < isAround.size(); ++id)
    {
      if (isAround[id] && this->mayMove(static_cast<Index>(id)))
      {
        numberOf[id] = static_cast<Index>(this->Nodes.size());
        SlidingNode& node = this->Nodes.emplace_back();
        node.id = static_cast<Index>(id);
        node.row = this->rowOf(node.id);
      }
    }
    for (Index hex = 0; hex < this->Cells.rows(); ++hex)
    {
      if (touches(hex, isAround))
      {
        this->Around.push_back(hex);
        this->addHex(hex, numberOf);
      }
    }
  }

  void addHex(Index hex, const std::vector<Index>& numberOf)
  {
    for (Index c = 0; c < 8; ++c)
    {
      const Index number = numberOf[at(this->Cells(hex, c))];
      if (number < 0)
      {
        continue;
      }
      SlidingNode& node = this->Nodes[at(number)];
      node.hexes.push_back(hex);
      for (const Index other : HexNeighbors[c])
      {
        const Index id = this->Cells(hex, other);
        const bool isAlong = node.row < 0 || this->rowOf(id) >= 0;
        if (isAlong &&
          std::find(node.neighbors.begin(), node.neighbors.end(), id) == node.neighbors.end())
        {
          node.neighbors.push_back(id);
        }
      }
    }
  }

  double leastAt(const SlidingNode& node) const
  {
    double least = 1.0;
    for (const Index hex : node.hexes)
    {
      least = std::min(least, scaledJacobianOf(this->Places, this->Cells, hex));
    }
    return least;
  }

  double sumAt(const SlidingNode& node) const
  {
    double sum = 0.0;
    for (const Index hex : node.hexes)
    {
      sum += std::exp(-SlideSharpness * scaledJacobianOf(this->Places, this->Cells, hex));
    }
    return sum;
  }

  void move(SlidingNode& node)
  {
    const Eigen::RowVector3d start = this->Places.row(node.id);
    Eigen::RowVector3d best = start;
    double least = (1.0 - LeastGain) * this->sumAt(node);
    bool hasMoved = false;
    const auto attempt = [&](const Eigen::RowVector3d& step) {
      const Eigen::RowVector3d place =
        node.row < 0 ? Eigen::RowVector3d(start + step) : this->Nearest(node.row, start + step);
      this->Places.row(node.id) = place;
      const double sum = this->sumAt(node);
      if (sum < least)
      {
        least = sum;
        best = place;
        hasMoved = true;
      }
    };
    for (std::size_t i = 0; i < node.neighbors.size(); ++i)
    {
      const Eigen::RowVector3d step = node.stride * (this->Places.row(node.neighbors[i]) - start);
      attempt(step);
      attempt(-step);
      for (std::size_t j = i + 1; j < node.neighbors.size(); ++j)
      {
        attempt(step + node.stride * (this->Places.row(node.neighbors[j]) - start));
      }
    }
    this->Places.row(node.id) = best;
    node.stride *= hasMoved ? 1.0 : 0.5;
  }

  const NearestOnSide& Nearest;
  Points Places;
  Hexes Cells;
  Index OfLayer;
  Index Layers;
  std::vector<Index> Rows; // of SweepBoundary::nodes, by source point, or -1
  const std::vector<bool>& Stays;
  std::vector<SlidingNode> Nodes;
  std::vector<Index> Around;
};
}

SlidSides slideSides(const SweepCage& cage, const PointsRef& filled, const std::vector<bool>& stays,
  const NearestOnSide& nearest, double enough, const ParallelFor& parallelFor,
  const Progress& progress)
{
  SideSlide slide(cage, filled, stays, nearest, parallelFor);
  SlidSides result;
  if (slide.gather(enough, parallelFor, progressPart(progress, 0.0, 0.2)))
  {
    result.least = slide.least();
    double awaited = result.least;
    int waited = 0;
    for (int round = 0; round < SlideRounds && waited < Patience && !slide.isDone(); ++round)
    {
      slide.round(enough);
      result.least = slide.least();
      waited = result.least < awaited + LeastGrowth ? waited + 1 : 0;
      awaited = std::max(awaited, result.least);
      reportProgress(progress, 0.2 + 0.8 * static_cast<double>(round + 1) / SlideRounds);
    }
  }
  result.points = slide.take();
  return result;
}
}

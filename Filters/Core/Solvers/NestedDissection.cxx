// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/NestedDissection.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace hexsweep
{
namespace
{
/// Rows that are eliminated as one dense block rather than cut once more; measured, flat about it.
constexpr int LeafSize = 20;

/// Breadth-first distance of each row from one of them; rows of other components keep -1.
std::vector<int> distancesFrom(const SparseMatrix& matrix, int start)
{
  std::vector<int> distance(static_cast<std::size_t>(matrix.rows()), -1);
  std::vector<int> queue{ start };
  queue.reserve(distance.size());
  distance[static_cast<std::size_t>(start)] = 0;
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    const int row = queue[next];
    for (SparseMatrix::InnerIterator it(matrix, row); it; ++it)
    {
      int& found = distance[static_cast<std::size_t>(it.row())];
      if (found < 0)
      {
        found = distance[static_cast<std::size_t>(row)] + 1;
        queue.push_back(static_cast<int>(it.row()));
      }
    }
  }
  return distance;
}

int farthest(const std::vector<int>& distance)
{
  return static_cast<int>(std::max_element(distance.begin(), distance.end()) - distance.begin());
}

/// Differences of distances: from two far-apart rows, and from two that are far from both.
Points graphCoordinates(const SparseMatrix& matrix)
{
  const int west = farthest(distancesFrom(matrix, 0));
  const std::vector<int> fromWest = distancesFrom(matrix, west);
  const std::vector<int> fromEast = distancesFrom(matrix, farthest(fromWest));
  std::vector<int> least(fromWest.size());
  std::transform(fromWest.begin(), fromWest.end(), fromEast.begin(), least.begin(),
    [](int a, int b) { return std::min(a, b); });
  const std::vector<int> fromSouth = distancesFrom(matrix, farthest(least));
  const std::vector<int> fromNorth = distancesFrom(matrix, farthest(fromSouth));
  Points coordinates = Points::Zero(matrix.rows(), 3);
  for (std::size_t i = 0; i < fromWest.size(); ++i)
  {
    coordinates(static_cast<Index>(i), 0) = fromWest[i] - fromEast[i];
    coordinates(static_cast<Index>(i), 1) = fromSouth[i] - fromNorth[i];
  }
  return coordinates;
}

class Dissector
{
public:
  Dissector(const SparseMatrix& matrix, const PointsRef& places)
    : Matrix(matrix)
    , Places(places)
    , Side(static_cast<std::size_t>(matrix.rows()), None)
  {
    this->Result.order.resize(Side.size());
    std::iota(this->Result.order.begin(), this->Result.order.end(), 0);
    this->split(0, static_cast<int>(Side.size()));
  }

  Dissection result() && { return std::move(this->Result); }

private:
  enum : unsigned char
  {
    None,
    Low,
    High,
    Separator
  };

  bool touches(int row, unsigned char side) const
  {
    for (SparseMatrix::InnerIterator it(this->Matrix, row); it; ++it)
    {
      if (this->Side[static_cast<std::size_t>(it.row())] == side)
      {
        return true;
      }
    }
    return false;
  }

  Index longestAxis(int begin, int end) const
  {
    Eigen::RowVector3d low = this->Places.row(this->row(begin));
    Eigen::RowVector3d high = low;
    for (int k = begin; k < end; ++k)
    {
      low = low.cwiseMin(this->Places.row(this->row(k)));
      high = high.cwiseMax(this->Places.row(this->row(k)));
    }
    Index axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
  }

  /// Orders the rows at places begin ... end - 1 and adds their parts; returns the last one.
  int split(int begin, int end)
  {
    std::array<int, 2> children{ -1, -1 };
    int separator = begin;
    if (end - begin > LeafSize)
    {
      const std::array<int, 2> bounds = this->halve(begin, end);
      if (bounds[0] > begin)
      {
        children[0] = this->split(begin, bounds[0]);
      }
      if (bounds[1] > bounds[0])
      {
        children[1] = this->split(bounds[0], bounds[1]);
      }
      separator = bounds[1];
    }
    const int part = static_cast<int>(this->Result.parts.size());
    this->Result.parts.push_back({ separator, end, -1 });
    for (const int child : children)
    {
      if (child >= 0)
      {
        this->Result.parts[static_cast<std::size_t>(child)].parent = part;
      }
    }
    return part;
  }

  /// Reorders into low half, high half, separator; returns where the latter two begin.
  std::array<int, 2> halve(int begin, int end)
  {
    const Index axis = this->longestAxis(begin, end);
    const auto at = [this](int place) { return this->Result.order.begin() + place; };
    const int middle = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(middle), at(end), [&](int a, int b) {
      const double x = this->Places(a, axis);
      const double y = this->Places(b, axis);
      return x != y ? x < y : a < b;
    });
    for (int k = begin; k < end; ++k)
    {
      this->side(k) = k < middle ? Low : High;
    }
    // Either side's rows at the cut separate; the fewer ones are taken.
    std::vector<int> low;
    std::vector<int> high;
    for (int k = begin; k < end; ++k)
    {
      if (this->touches(this->row(k), k < middle ? High : Low))
      {
        (k < middle ? low : high).push_back(this->row(k));
      }
    }
    for (const int row : low.size() <= high.size() ? low : high)
    {
      this->Side[static_cast<std::size_t>(row)] = Separator;
    }
    const auto sideOf = [this](int row) { return this->Side[static_cast<std::size_t>(row)]; };
    const auto highBegin =
      std::stable_partition(at(begin), at(end), [&](int row) { return sideOf(row) == Low; });
    const auto separatorBegin =
      std::stable_partition(highBegin, at(end), [&](int row) { return sideOf(row) == High; });
    for (int k = begin; k < end; ++k)
    {
      this->side(k) = None;
    }
    return { static_cast<int>(highBegin - at(0)), static_cast<int>(separatorBegin - at(0)) };
  }

  int row(int place) const { return this->Result.order[static_cast<std::size_t>(place)]; }
  unsigned char& side(int place) { return this->Side[static_cast<std::size_t>(this->row(place))]; }

  const SparseMatrix& Matrix;
  const PointsRef Places;
  std::vector<unsigned char> Side;
  Dissection Result;
};
}

Dissection dissect(const SparseMatrix& matrix, const PointsRef& places)
{
  if (matrix.rows() == 0)
  {
    return {};
  }
  return places.rows() > 0 ? Dissector(matrix, places).result()
                           : Dissector(matrix, graphCoordinates(matrix)).result();
}
}

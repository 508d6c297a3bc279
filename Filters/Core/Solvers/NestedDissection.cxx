// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/NestedDissection.h"

#include <algorithm>
#include <array>

namespace hexsweep
{
namespace
{
/// Rows that are eliminated as one dense block rather than cut once more; measured, flat about it.
constexpr int LeafSize = 20;

/// Breadth-first distances of the rows of a component from one of them, in the order of the rows.
/// @param distance scratch: -1 for each row of the matrix, before and after.
std::vector<int> distancesFrom(
  const SparseMatrix& matrix, int start, const std::vector<int>& rows, std::vector<int>& distance)
{
  std::vector<int> queue{ start };
  queue.reserve(rows.size());
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
  std::vector<int> result;
  result.reserve(rows.size());
  for (const int row : rows)
  {
    result.push_back(distance[static_cast<std::size_t>(row)]);
    distance[static_cast<std::size_t>(row)] = -1;
  }
  return result;
}

/// The rows of each connected component, rising; the components by their first rows.
std::vector<std::vector<int>> components(const SparseMatrix& matrix)
{
  std::vector<std::vector<int>> result;
  std::vector<bool> isFound(static_cast<std::size_t>(matrix.rows()), false);
  for (int first = 0; first < static_cast<int>(matrix.rows()); ++first)
  {
    if (isFound[static_cast<std::size_t>(first)])
    {
      continue;
    }
    std::vector<int> rows{ first };
    isFound[static_cast<std::size_t>(first)] = true;
    for (std::size_t next = 0; next < rows.size(); ++next)
    {
      for (SparseMatrix::InnerIterator it(matrix, rows[next]); it; ++it)
      {
        if (!isFound[static_cast<std::size_t>(it.row())])
        {
          isFound[static_cast<std::size_t>(it.row())] = true;
          rows.push_back(static_cast<int>(it.row()));
        }
      }
    }
    std::sort(rows.begin(), rows.end());
    result.push_back(std::move(rows));
  }
  return result;
}

/// Differences of distances: from two far-apart rows, and from two that are far from both.
/// @param distance scratch of distancesFrom().
void setGraphCoordinates(const SparseMatrix& matrix, const std::vector<int>& rows,
  std::vector<int>& distance, Points& coordinates)
{
  const auto from = [&](int start) { return distancesFrom(matrix, start, rows, distance); };
  const auto farthestOf = [&](const std::vector<int>& distances) {
    return rows[static_cast<std::size_t>(
      std::max_element(distances.begin(), distances.end()) - distances.begin())];
  };
  const std::vector<int> fromWest = from(farthestOf(from(rows.front())));
  const std::vector<int> fromEast = from(farthestOf(fromWest));
  std::vector<int> least(fromWest.size());
  std::transform(fromWest.begin(), fromWest.end(), fromEast.begin(), least.begin(),
    [](int a, int b) { return std::min(a, b); });
  const std::vector<int> fromSouth = from(farthestOf(least));
  const std::vector<int> fromNorth = from(farthestOf(fromSouth));
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    coordinates.row(rows[k]) << fromWest[k] - fromEast[k], fromSouth[k] - fromNorth[k], 0.0;
  }
}

class Dissector
{
public:
  Dissector(const SparseMatrix& matrix, const PointsRef& places,
    const std::vector<std::vector<int>>& components)
    : Matrix(matrix)
    , Places(places)
    , Side(static_cast<std::size_t>(matrix.rows()), None)
  {
    for (const std::vector<int>& rows : components)
    {
      const int begin = static_cast<int>(this->Result.order.size());
      this->Result.order.insert(this->Result.order.end(), rows.begin(), rows.end());
      this->split(begin, begin + static_cast<int>(rows.size()));
    }
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
  const std::vector<std::vector<int>> parts = components(matrix);
  if (places.rows() > 0)
  {
    return Dissector(matrix, places, parts).result();
  }
  Points coordinates(matrix.rows(), 3);
  std::vector<int> distance(static_cast<std::size_t>(matrix.rows()), -1);
  for (const std::vector<int>& rows : parts)
  {
    setGraphCoordinates(matrix, rows, distance, coordinates);
  }
  return Dissector(matrix, coordinates, parts).result();
}

Dissection dissectBlocks(const SparseMatrix& matrix, int width, const PointsRef& places)
{
  if (width == 1)
  {
    return dissect(matrix, places);
  }
  const Index blocks = matrix.rows() / width;
  SparseMatrix quotient(blocks, blocks);
  quotient.reserve(matrix.nonZeros() / (Index{ width } * width));
  for (Index b = 0; b < blocks; ++b)
  {
    quotient.startVec(b);
    for (SparseMatrix::InnerIterator it(matrix, b * width); it; ++it)
    {
      if (it.row() % width == 0)
      {
        quotient.insertBack(it.row() / width, b) = 1.0;
      }
    }
  }
  quotient.finalize();
  const Dissection ofBlocks = dissect(quotient, places);
  Dissection result;
  result.order.reserve(static_cast<std::size_t>(matrix.rows()));
  for (const int block : ofBlocks.order)
  {
    for (int i = 0; i < width; ++i)
    {
      result.order.push_back(width * block + i);
    }
  }
  for (const Dissection::Part& part : ofBlocks.parts)
  {
    result.parts.push_back({ width * part.begin, width * part.end, part.parent });
  }
  return result;
}
}

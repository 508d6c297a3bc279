// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/SegmentGrid.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
SegmentPlace nearestOnSegment(
  const Eigen::RowVector2d& place, const Eigen::RowVector2d& a, const Eigen::RowVector2d& b)
{
  const Eigen::RowVector2d way = b - a;
  const double squared = way.squaredNorm();
  SegmentPlace result;
  result.along = squared > 0.0 ? std::clamp((place - a).dot(way) / squared, 0.0, 1.0) : 0.0;
  result.distance = (a + result.along * way - place).norm();
  return result;
}

SegmentGrid::SegmentGrid(const PlanePointsRef& points, const Segments& segments, double reach)
{
  const Index count = static_cast<Index>(segments.size());
  if (count == 0)
  {
    this->First.assign(2, 0);
    return;
  }
  Eigen::RowVector2d high = points.row(segments[0].first);
  this->Low = high;
  for (const auto& [a, b] : segments)
  {
    for (const Index i : { a, b })
    {
      this->Low = this->Low.cwiseMin(points.row(i));
      high = high.cwiseMax(points.row(i));
    }
  }
  const Eigen::RowVector2d extent = high - this->Low;
  const double side = std::max(extent.maxCoeff(), 1e-300);
  this->Cell = std::max(side / std::ceil(std::sqrt(static_cast<double>(count))), 1e-6 * side);
  this->Columns = 1 + static_cast<Index>(extent.x() / this->Cell);
  this->Rows = 1 + static_cast<Index>(extent.y() / this->Cell);
  const auto cells = [&](Index s, const auto& visit) {
    const Eigen::RowVector2d a = points.row(segments[static_cast<std::size_t>(s)].first);
    const Eigen::RowVector2d b = points.row(segments[static_cast<std::size_t>(s)].second);
    const Eigen::RowVector2d low = a.cwiseMin(b).array() - reach;
    const Eigen::RowVector2d top = a.cwiseMax(b).array() + reach;
    for (Index r = this->row(low.y()); r <= this->row(top.y()); ++r)
    {
      for (Index c = this->column(low.x()); c <= this->column(top.x()); ++c)
      {
        visit(static_cast<std::size_t>(r * this->Columns + c));
      }
    }
  };
  this->First.assign(static_cast<std::size_t>(this->Columns * this->Rows) + 1, 0);
  for (Index s = 0; s < count; ++s)
  {
    cells(s, [&](std::size_t cell) { ++this->First[cell + 1]; });
  }
  for (std::size_t c = 1; c < this->First.size(); ++c)
  {
    this->First[c] += this->First[c - 1];
  }
  this->Members.resize(static_cast<std::size_t>(this->First.back()));
  std::vector<Index> next(this->First.begin(), this->First.end() - 1);
  for (Index s = 0; s < count; ++s)
  {
    cells(s, [&](std::size_t cell) { this->Members[static_cast<std::size_t>(next[cell]++)] = s; });
  }
}

Index SegmentGrid::column(double x) const
{
  const double cell = std::floor((x - this->Low.x()) / this->Cell);
  return static_cast<Index>(std::clamp(cell, 0.0, static_cast<double>(this->Columns - 1)));
}

Index SegmentGrid::row(double y) const
{
  const double cell = std::floor((y - this->Low.y()) / this->Cell);
  return static_cast<Index>(std::clamp(cell, 0.0, static_cast<double>(this->Rows - 1)));
}

std::vector<Index> SegmentGrid::near(
  const Eigen::RowVector2d& low, const Eigen::RowVector2d& high) const
{
  std::vector<Index> result;
  for (Index r = this->row(low.y()); r <= this->row(high.y()); ++r)
  {
    for (Index c = this->column(low.x()); c <= this->column(high.x()); ++c)
    {
      const auto cell = static_cast<std::size_t>(r * this->Columns + c);
      result.insert(result.end(), this->Members.begin() + this->First[cell],
        this->Members.begin() + this->First[cell + 1]);
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}
}

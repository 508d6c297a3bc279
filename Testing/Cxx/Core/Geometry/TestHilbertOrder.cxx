// SPDX-License-Identifier: BSD-3-Clause
// The curve visits every cell once and steps from neighbour to neighbour.
#include "Core/Geometry/HilbertOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>

namespace TestHilbertOrder
{
using hexsweep::CurvePlace;
using hexsweep::HilbertCurve;
using hexsweep::Index;
using hexsweep::PlanePoints;

/// Cells are the unit squares of [0, 2^16]^2.
HilbertCurve unitCells()
{
  PlanePoints box(2, 2);
  box << 0, 0, 65536, 65536;
  return HilbertCurve(box);
}

PlanePoints randomPoints(Index n)
{
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  PlanePoints points(n, 2);
  for (Index i = 0; i < points.size(); ++i)
  {
    points.data()[i] = normal(generator);
  }
  return points;
}

TEST(HilbertOrder, StepsFromCellToCell)
{
  const HilbertCurve curve = unitCells();
  const int size = 256;
  for (const int corner : { 0, 256, 32768, 65536 - size })
  {
    // An aligned square of cells is one piece of the curve.
    std::map<std::uint32_t, std::pair<int, int>> cells;
    for (int j = corner; j < corner + size; ++j)
    {
      for (int i = corner; i < corner + size; ++i)
      {
        cells[curve.key(i + 0.5, j + 0.25)] = { i, j };
      }
    }
    ASSERT_EQ(cells.size(), static_cast<std::size_t>(size * size));
    EXPECT_EQ(cells.rbegin()->first - cells.begin()->first, cells.size() - 1);
    for (auto cell = cells.begin(), next = std::next(cell); next != cells.end(); ++cell, ++next)
    {
      ASSERT_EQ(std::abs(cell->second.first - next->second.first) +
          std::abs(cell->second.second - next->second.second),
        1);
    }
  }
  EXPECT_EQ(curve.key(0.5, 0.5), 0u);
  EXPECT_EQ(curve.key(65535.5, 0.5), std::numeric_limits<std::uint32_t>::max());
}

TEST(HilbertOrder, IsTheStableOrderOfTheKeys)
{
  const PlanePoints points = randomPoints(20000);
  const HilbertCurve curve(points);
  const std::vector<CurvePlace> order = hexsweep::hilbertOrder(curve, points);
  std::vector<std::uint32_t> expected(static_cast<std::size_t>(points.rows()));
  std::iota(expected.begin(), expected.end(), 0u);
  const auto key = [&](std::uint32_t i) { return curve.key(points(i, 0), points(i, 1)); };
  std::stable_sort(expected.begin(), expected.end(),
    [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  ASSERT_EQ(order.size(), expected.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    ASSERT_EQ(order[i].id, expected[i]);
    ASSERT_EQ(order[i].key, key(expected[i]));
  }
}

TEST(HilbertOrder, PointsOfOneCellKeepTheirOrder)
{
  const PlanePoints points = PlanePoints::Constant(1000, 2, 4.5);
  const std::vector<CurvePlace> order = hexsweep::hilbertOrder(HilbertCurve(points), points);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    EXPECT_EQ(order[i].id, i);
  }
  EXPECT_TRUE(hexsweep::hilbertOrder(HilbertCurve(PlanePoints(0, 2)), PlanePoints(0, 2)).empty());
}

TEST(HilbertOrder, WhatIsNotFiniteOrOutsideCountsToSomeCell)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PlanePoints points(4, 2);
  points << 0, 0, nan, 5, infinity, -infinity, 65536, 65536;
  const HilbertCurve curve(points); // as unitCells(): what is not finite does not count
  EXPECT_EQ(curve.key(1.5, 0.5), unitCells().key(1.5, 0.5));
  EXPECT_EQ(curve.key(-1e300, 7.5), curve.key(0.5, 7.5));
  EXPECT_EQ(curve.key(1e300, infinity), curve.key(65535.5, 65535.5));
  EXPECT_EQ(curve.key(nan, 7.5), curve.key(0.5, 7.5));
}

TEST(HilbertOrder, DoesNotDependOnSizeAndPlace)
{
  const PlanePoints points = randomPoints(1000);
  const auto plain = hexsweep::hilbertOrder(HilbertCurve(points), points);
  for (const double scale : { std::ldexp(1.0, -20), std::ldexp(1.0, 20) })
  {
    const PlanePoints scaled = scale * points;
    const auto order = hexsweep::hilbertOrder(HilbertCurve(scaled), scaled);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      ASSERT_EQ(order[i].id, plain[i].id);
    }
  }
}
}

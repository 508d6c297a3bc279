// SPDX-License-Identifier: BSD-3-Clause
// Ends of evenly spaced columns whose corners are known.
#include "Core/Linking/ColumnEnds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace TestColumnEnds
{
using hexsweep::ColumnAnchor;
using hexsweep::ColumnEnds;
using hexsweep::columnEnds;
using hexsweep::Index;

std::vector<double> evenly(std::size_t n)
{
  std::vector<double> begins;
  for (std::size_t j = 0; j < n; ++j)
  {
    begins.push_back(static_cast<double>(j) / static_cast<double>(n));
  }
  return begins;
}

/// The column that ends there; -1: none does.
Index columnAt(const ColumnEnds& found, double v)
{
  for (std::size_t j = 0; j < found.ends.size(); ++j)
  {
    if (std::abs(std::remainder(found.ends[j] - v, 1.0)) < 1e-12)
    {
      return static_cast<Index>(j);
    }
  }
  return -1;
}

void expectInOrder(const std::vector<double>& ends)
{
  for (std::size_t j = 0; j < ends.size(); ++j)
  {
    const double next = j + 1 < ends.size() ? ends[j + 1] : ends[0] + 1.0;
    EXPECT_GT(next, ends[j]) << "column " << j;
  }
}

TEST(ColumnEnds, WithoutCornersColumnsTurnAlike)
{
  const ColumnEnds found = columnEnds(evenly(12), { 0, 3 }, {}, 0.3, {});
  for (std::size_t j = 0; j < 12; ++j)
  {
    EXPECT_DOUBLE_EQ(found.ends[j], static_cast<double>(j) / 12.0 + 0.3);
  }
}

TEST(ColumnEnds, CornersAreReachedByColumnsThatBeginAtCorners)
{
  // A square of 40 columns whose corners are ahead by 0.06 (more than two columns) at the target,
  // wherever the first column is, and whichever corner comes first.
  for (const double drift : { 0.06, -0.06, 0.01 })
  {
    std::vector<double> corners{ 0.0, 0.25, 0.5, 0.75 };
    for (double& corner : corners)
    {
      corner = hexsweep::wrappedV(corner + drift);
    }
    for (int order = 0; order < 4; ++order)
    {
      const ColumnEnds found = columnEnds(evenly(40), { 0, 10, 20, 30 }, {}, 0.0, corners);
      EXPECT_TRUE(found.lostCorners.empty());
      expectInOrder(found.ends);
      for (Index corner = 0; corner < 4; ++corner)
      {
        EXPECT_EQ(columnAt(found, 0.25 * static_cast<double>(corner) + drift), 10 * corner);
      }
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
  }
}

TEST(ColumnEnds, CornersThatNoCornerIsNearGetTheNearestColumn)
{
  const ColumnEnds found = columnEnds(evenly(20), { 0, 10 }, {}, 0.0, { 0.02, 0.26, 0.49 });
  EXPECT_EQ(columnAt(found, 0.02), 0);
  EXPECT_EQ(columnAt(found, 0.26), 5);
  EXPECT_EQ(columnAt(found, 0.49), 10);
  expectInOrder(found.ends);
}

TEST(ColumnEnds, AnchorsAreKeptExactly)
{
  const std::vector<ColumnAnchor> anchors{ { 2, 0.3 }, { 15, 0.7 } };
  const ColumnEnds found = columnEnds(evenly(20), { 3 }, anchors, 0.0, { 0.3, 0.31, 0.1 });
  EXPECT_EQ(found.ends[2], 0.3);
  EXPECT_EQ(found.ends[15], 0.7);
  EXPECT_EQ(columnAt(found, 0.31), 6);
  expectInOrder(found.ends);
}

TEST(ColumnEnds, MoreCornersThanColumnsAreNamed)
{
  const ColumnEnds found = columnEnds(evenly(4), { 0 }, {}, 0.0, { 0.0, 0.2, 0.4, 0.5, 0.6, 0.8 });
  EXPECT_EQ(found.lostCorners.size(), 2u);
  expectInOrder(found.ends);
}
}

// SPDX-License-Identifier: BSD-3-Clause
// The tree against all boxes one by one.
#include "Core/Geometry/BoxTree.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <set>

namespace TestBoxTree
{
using hexsweep::BoxTree;
using hexsweep::PlaneBox;

TEST(BoxTree, FindsTheNearestAndAllThatHoldAPoint)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const std::size_t count : { 0u, 1u, 7u, 8u, 9u, 64u, 65u, 1000u })
  {
    std::vector<PlaneBox> boxes(count);
    for (PlaneBox& box : boxes)
    {
      const double x = uniform(generator);
      const double y = uniform(generator);
      box.extend(x, y);
      box.extend(x + 0.2 * uniform(generator), y + 0.2 * uniform(generator));
    }
    // In some order of the plane, as the tree wants it.
    std::sort(boxes.begin(), boxes.end(),
      [](const PlaneBox& a, const PlaneBox& b) { return a.low[0] < b.low[0]; });
    const BoxTree tree(count, [&](std::size_t i) { return boxes[i]; });
    constexpr std::size_t Points = 200;
    std::size_t visited = 0;
    for (std::size_t k = 0; k < Points; ++k)
    {
      const double x = 1.4 * uniform(generator) - 0.2;
      const double y = 1.4 * uniform(generator) - 0.2;
      std::set<std::size_t> expected;
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < count; ++i)
      {
        nearest = std::min(nearest, boxes[i].squaredDistance(x, y));
        if (boxes[i].squaredDistance(x, y) == 0.0)
        {
          expected.insert(i);
        }
      }
      std::set<std::size_t> found;
      tree.visitNear(x, y, 0.0, [&](std::size_t i) {
        if (boxes[i].squaredDistance(x, y) == 0.0)
        {
          EXPECT_TRUE(found.insert(i).second) << "visited twice";
        }
        return 0.0;
      });
      EXPECT_EQ(found, expected);

      double best = std::numeric_limits<double>::infinity();
      tree.visitNear(x, y, best, [&](std::size_t i) {
        ++visited;
        best = std::min(best, boxes[i].squaredDistance(x, y));
        return best;
      });
      EXPECT_EQ(best, nearest);
    }
    EXPECT_LE(visited, Points * (count < 1000 ? count : count / 4));
  }
}

TEST(BoxTree, VisitsEverythingForWhatIsNotFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  PlaneBox box;
  box.extend(0.0, 0.0);
  box.extend(1.0, 1.0);
  std::size_t visited = 0;
  BoxTree(100, [&](std::size_t) { return box; }).visitNear(nan, nan, 1.0, [&](std::size_t) {
    ++visited;
    return 1.0;
  });
  EXPECT_EQ(visited, 100u);
}
}

// SPDX-License-Identifier: BSD-3-Clause
// The least of all permutations, one by one.
#include "Core/Linking/Assignment.h"

#include "Core/Common/Mesh.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace TestAssignment
{
using hexsweep::Index;

TEST(Assignment, LeastOfAllPermutations)
{
  std::mt19937 generator(5);
  for (Index n = 1; n <= 6; ++n)
  {
    for (int round = 0; round < 20; ++round)
    {
      Eigen::MatrixXd cost(n, n);
      for (Index i = 0; i < cost.size(); ++i)
      {
        cost.data()[i] = static_cast<double>(generator() % 50) - 10.0;
      }
      std::vector<Index> order(static_cast<std::size_t>(n));
      std::iota(order.begin(), order.end(), Index{ 0 });
      const auto total = [&](const std::vector<Index>& columns) {
        double sum = 0.0;
        for (Index i = 0; i < n; ++i)
        {
          sum += cost(i, columns[static_cast<std::size_t>(i)]);
        }
        return sum;
      };
      std::vector<Index> found = hexsweep::leastCostAssignment(cost);
      double least = total(order);
      do
      {
        least = std::min(least, total(order));
      } while (std::next_permutation(order.begin(), order.end()));
      EXPECT_EQ(total(found), least);
      std::sort(found.begin(), found.end());
      std::iota(order.begin(), order.end(), Index{ 0 });
      EXPECT_EQ(found, order);
    }
  }
}
}

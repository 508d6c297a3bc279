// SPDX-License-Identifier: BSD-3-Clause
// Exact sums and products against identities that hold for exact numbers only.
#include "Core/Common/Expansion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace TestExpansion
{
using hexsweep::Expansion;

TEST(Expansion, KeepsWhatADoubleLoses)
{
  const Expansion tiny(std::ldexp(1.0, -200));
  const Expansion sum = Expansion(1.0) + tiny;
  EXPECT_EQ(toDouble(sum), 1.0);
  EXPECT_EQ(toDouble(sum - Expansion(1.0)), std::ldexp(1.0, -200));
  EXPECT_LT(toDouble(Expansion(1.0) - sum), 0.0);
  EXPECT_EQ(toDouble(sum - sum), 0.0);
  EXPECT_EQ(toDouble(Expansion()), 0.0);
  EXPECT_EQ(toDouble(Expansion(0.0) * sum), 0.0);
}

TEST(Expansion, SquareOfASumIsExact)
{
  std::mt19937 generator(6);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n = 0; n < 1000; ++n)
  {
    const Expansion a(std::ldexp(uniform(generator), n % 90));
    const Expansion b(uniform(generator));
    const Expansion c(std::ldexp(uniform(generator), -(n % 70)));
    const Expansion sum = a + b + c;
    const Expansion products = 2.0 * (a * b + b * c + c * a);
    EXPECT_EQ(toDouble(sum * sum - (a * a + b * b + c * c) - products), 0.0);
    // One unit in the last place of the smallest term, cubed, is not lost either.
    const Expansion off = sum * sum * sum + Expansion(std::ldexp(1.0, -400));
    EXPECT_EQ(toDouble(off - sum * sum * sum), std::ldexp(1.0, -400));
  }
}

TEST(Expansion, EqualsIntegerArithmetic)
{
  std::mt19937_64 generator(7);
  std::uniform_int_distribution<std::int64_t> uniform(-(1 << 20), 1 << 20);
  for (int n = 0; n < 1000; ++n)
  {
    const std::int64_t a = uniform(generator);
    const std::int64_t b = uniform(generator);
    const std::int64_t c = uniform(generator);
    const std::int64_t d = uniform(generator);
    const auto exact = [](std::int64_t value) { return Expansion(static_cast<double>(value)); };
    const Expansion difference = exact(a) * exact(b) * exact(c) - exact(d) * exact(d) * exact(a);
    const std::int64_t truth = a * b * c - d * d * a;
    const std::int64_t high = truth / (1 << 30);
    const std::int64_t low = truth % (1 << 30);
    EXPECT_EQ(toDouble(difference - (exact(high) * exact(1 << 30) + exact(low))), 0.0);
    EXPECT_EQ(toDouble(difference), static_cast<double>(truth));
  }
}
}

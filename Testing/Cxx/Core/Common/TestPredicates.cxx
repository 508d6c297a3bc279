// SPDX-License-Identifier: BSD-3-Clause
// The exact orientation against 128-bit integers.
#include "Core/Common/Predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace TestPredicates
{
using Point = Eigen::RowVector2d;
__extension__ using Wide = __int128;

struct IntegerPoint
{
  std::int64_t x;
  std::int64_t y;
};

int exactSign(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c)
{
  const Wide left = Wide(a.x - c.x) * Wide(b.y - c.y);
  const Wide right = Wide(a.y - c.y) * Wide(b.x - c.x);
  return left > right ? 1 : (left < right ? -1 : 0);
}

int naiveSign(const Point& a, const Point& b, const Point& c)
{
  const double area = (a.x() - c.x()) * (b.y() - c.y()) - (a.y() - c.y()) * (b.x() - c.x());
  return area > 0.0 ? 1 : (area < 0.0 ? -1 : 0);
}

Point scaled(const IntegerPoint& p, int exponent)
{
  return { std::ldexp(static_cast<double>(p.x), exponent),
    std::ldexp(static_cast<double>(p.y), exponent) };
}

/// Compares all orders of three points; the integers must fit a double's 53 bits.
/// @return how often plain arithmetic is wrong.
int compare(const IntegerPoint& p, const IntegerPoint& q, const IntegerPoint& r, int exponent)
{
  const int expected = exactSign(p, q, r);
  const Point a = scaled(p, exponent);
  const Point b = scaled(q, exponent);
  const Point c = scaled(r, exponent);
  EXPECT_EQ(hexsweep::orientation(a, b, c), expected);
  EXPECT_EQ(hexsweep::orientation(b, c, a), expected);
  EXPECT_EQ(hexsweep::orientation(c, a, b), expected);
  EXPECT_EQ(hexsweep::orientation(b, a, c), -expected);
  EXPECT_EQ(hexsweep::orientation(a, c, b), -expected);
  EXPECT_EQ(hexsweep::orientation(c, b, a), -expected);
  return naiveSign(a, b, c) == expected ? 0 : 1;
}

TEST(Predicates, PlainTriangles)
{
  EXPECT_EQ(hexsweep::orientation({ 0, 0 }, { 1, 0 }, { 0, 1 }), 1);
  EXPECT_EQ(hexsweep::orientation({ 0, 0 }, { 0, 1 }, { 1, 0 }), -1);
  EXPECT_EQ(hexsweep::orientation({ 0, 0 }, { 1, 1 }, { 3, 3 }), 0);
  EXPECT_EQ(hexsweep::orientation({ 5, 5 }, { 5, 5 }, { 5, 5 }), 0);
  EXPECT_EQ(hexsweep::orientation({ 5, 5 }, { 5, 5 }, { 1, 2 }), 0);
  EXPECT_EQ(hexsweep::orientation({ 0.1, 0.1 }, { 0.2, 0.2 }, { 0.3, 0.3 }), 0);
}

TEST(Predicates, SmallIntegersIncludingManyCollinear)
{
  for (std::int64_t i = 0; i < 7 * 7; ++i)
  {
    for (std::int64_t j = 0; j < 7 * 7; ++j)
    {
      compare({ i % 7, i / 7 }, { j % 7, j / 7 }, { 3, 4 }, 0);
    }
  }
}

TEST(Predicates, GridOfPointsOneUlpApart)
{
  // Near the line through (12, 12) and (24, 24): coordinates 0.5 + i ulp. L. Kettner et al.,
  // "Classroom examples of robustness problems in geometric computations", 2008.
  int wrong = 0;
  const std::int64_t one = std::int64_t(1) << 53;
  for (std::int64_t i = 0; i < 128; ++i)
  {
    for (std::int64_t j = 0; j < 128; ++j)
    {
      wrong +=
        compare({ one / 2 + i, one / 2 + j }, { 12 * one, 12 * one }, { 24 * one, 24 * one }, -53);
    }
  }
  EXPECT_GT(wrong, 1000) << "the grid is not hard enough to test anything";
}

TEST(Predicates, NearlyCollinearFullWidthIntegers)
{
  std::mt19937_64 generator(1);
  std::uniform_int_distribution<std::int64_t> base(-(std::int64_t(1) << 40), std::int64_t(1) << 40);
  std::uniform_int_distribution<std::int64_t> step(-(std::int64_t(1) << 30), std::int64_t(1) << 30);
  std::uniform_int_distribution<std::int64_t> multiple(-1000, 1000);
  std::uniform_int_distribution<std::int64_t> off(-1, 1);
  std::uniform_int_distribution<int> exponent(-200, 200);
  int wrong = 0;
  int collinear = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const IntegerPoint a{ base(generator), base(generator) };
    const std::int64_t dx = step(generator);
    const std::int64_t dy = step(generator);
    const std::int64_t m = multiple(generator);
    const IntegerPoint b{ a.x + dx, a.y + dy };
    const IntegerPoint c{ a.x + m * dx + off(generator), a.y + m * dy + off(generator) };
    collinear += exactSign(a, b, c) == 0 ? 1 : 0;
    wrong += compare(a, b, c, exponent(generator));
  }
  EXPECT_GT(collinear, 100);
  (void)wrong; // differences of these are exact, so that plain arithmetic may well be right
}

TEST(Predicates, CoordinatesOfDifferentMagnitude)
{
  // c far away: the differences a - c and b - c are rounded, the exact answer is not.
  std::mt19937_64 generator(2);
  std::uniform_int_distribution<std::int64_t> near(-1000, 1000);
  std::uniform_int_distribution<std::int64_t> far(
    std::int64_t(1) << 50, (std::int64_t(1) << 51) - 1);
  int wrong = 0;
  for (int i = 0; i < 20000; ++i)
  {
    // Full 53-bit numbers at two scales: units 2^-2 near, whole numbers far.
    const std::int64_t fx = far(generator) * 4;
    const IntegerPoint c{ fx, fx + near(generator) * 4 };
    const IntegerPoint a{ near(generator), near(generator) };
    const IntegerPoint b{ a.x + 1 + near(generator) % 3, a.y + 1 + near(generator) % 3 };
    wrong += compare(a, b, c, -2);
  }
  EXPECT_GT(wrong, 0) << "the points are not hard enough to test anything";
}
}

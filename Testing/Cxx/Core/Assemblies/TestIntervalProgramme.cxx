// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/IntervalProgramme.h"
#include "Core/Common/Errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace TestIntervalProgramme
{
using hexsweep::Index;
using hexsweep::IntervalEquation;
using hexsweep::IntervalProgramme;
using hexsweep::IntervalWish;

IntervalWish wish(double number, Index least = 1, bool even = false)
{
  IntervalWish result;
  result.number = number;
  result.least = least;
  result.even = even;
  return result;
}

double costOf(const IntervalProgramme& programme, const std::vector<Index>& numbers)
{
  double cost = 0.0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const double number = programme.wishes[i].number;
    cost += std::abs(static_cast<double>(numbers[i]) - number) / number;
  }
  return cost;
}

bool holds(const IntervalProgramme& programme, const std::vector<Index>& numbers)
{
  for (const IntervalEquation& equation : programme.equations)
  {
    Index difference = 0;
    for (const Index i : equation.left)
    {
      difference += numbers[static_cast<std::size_t>(i)];
    }
    for (const Index i : equation.right)
    {
      difference -= numbers[static_cast<std::size_t>(i)];
    }
    if (difference != 0)
    {
      return false;
    }
  }
  return true;
}

/// All numbers up to 12, tried one after the other.
double leastCost(const IntervalProgramme& programme)
{
  constexpr Index Most = 12;
  double least = HUGE_VAL;
  std::vector<Index> numbers(programme.wishes.size(), 1);
  while (true)
  {
    bool allowed = holds(programme, numbers);
    for (std::size_t i = 0; i < numbers.size() && allowed; ++i)
    {
      const IntervalWish& own = programme.wishes[i];
      allowed = numbers[i] >= own.least && (!own.even || numbers[i] % 2 == 0);
    }
    least = allowed ? std::min(least, costOf(programme, numbers)) : least;
    std::size_t place = 0;
    while (place < numbers.size() && ++numbers[place] > Most)
    {
      numbers[place++] = 1;
    }
    if (place == numbers.size())
    {
      return least;
    }
  }
}

TEST(IntervalProgramme, FreeNumbersAreTheNearestWholeOnes)
{
  const IntervalProgramme programme{
    { wish(3.4), wish(3.6), wish(3.4, 1, true), wish(0.2), wish(2.0, 8) }, {}
  };
  EXPECT_EQ(hexsweep::solveIntervals(programme), (std::vector<Index>{ 3, 4, 4, 1, 8 }));
}

TEST(IntervalProgramme, EqualNumbersTakeTheWeightedMedian)
{
  // Costs are relative: 2 counts five times as much as 10.
  const IntervalProgramme programme{ { wish(2.0), wish(10.0) }, { { { 0 }, { 1 }, "" } } };
  EXPECT_EQ(hexsweep::solveIntervals(programme), (std::vector<Index>{ 2, 2 }));
}

TEST(IntervalProgramme, SumsAreAsGoodAsAllNumbersTriedOneByOne)
{
  std::mt19937 random(7); // NOLINT: the same numbers each time
  std::uniform_real_distribution<double> number(1.0, 6.0);
  for (int trial = 0; trial < 12; ++trial)
  {
    IntervalProgramme programme;
    for (int i = 0; i < 5; ++i)
    {
      programme.wishes.push_back(wish(number(random), 1, i == 2));
    }
    programme.equations = { { { 0 }, { 1, 2 }, "first" }, { { 3, 0 }, { 4 }, "second" } };
    const std::vector<Index> numbers = hexsweep::solveIntervals(programme);
    EXPECT_TRUE(holds(programme, numbers));
    EXPECT_NEAR(costOf(programme, numbers), leastCost(programme), 1e-9) << trial;
  }
}

TEST(IntervalProgramme, ContradictionsAreNamedAndNothingElse)
{
  IntervalProgramme programme{ { wish(2.0), wish(3.0), wish(4.0), wish(5.0) }, {} };
  programme.equations = { { { 0 }, { 1, 2 }, "one" }, { { 1 }, { 0, 2 }, "two" },
    { { 3 }, { 0, 1 }, "unconcerned" } };
  try
  {
    hexsweep::solveIntervals(programme);
    FAIL();
  }
  catch (const hexsweep::InvalidInput& error)
  {
    const std::string words = error.what();
    EXPECT_NE(words.find("one; two"), std::string::npos) << words;
    EXPECT_EQ(words.find("unconcerned"), std::string::npos) << words;
  }
}

TEST(IntervalProgramme, NumbersThatAreAskedForAreKept)
{
  IntervalWish asked = wish(4.0, 7);
  asked.most = 7;
  const IntervalProgramme programme{ { asked, wish(3.0) }, { { { 0 }, { 1 }, "both" } } };
  EXPECT_EQ(hexsweep::solveIntervals(programme), (std::vector<Index>{ 7, 7 }));
  IntervalWish other = wish(4.0, 5);
  other.most = 5;
  EXPECT_THROW(hexsweep::solveIntervals({ { asked, other }, { { { 0 }, { 1 }, "both" } } }),
    hexsweep::InvalidInput);
}

TEST(IntervalProgramme, WishesWithoutMeasureAreBoundedOrRefused)
{
  const auto sum = [](double number) {
    return IntervalProgramme{ { wish(number), wish(1.0), wish(2.0) },
      { { { 0 }, { 1, 2 }, "sum" } } };
  };
  EXPECT_EQ(hexsweep::solveIntervals(sum(1e-40)), (std::vector<Index>{ 2, 1, 1 }));
  EXPECT_EQ(hexsweep::solveIntervals(sum(std::numeric_limits<double>::min())),
    (std::vector<Index>{ 2, 1, 1 }));
  EXPECT_THROW(hexsweep::solveIntervals(sum(1e30)), hexsweep::InvalidInput);
  EXPECT_THROW(hexsweep::solveIntervals(sum(HUGE_VAL)), hexsweep::InvalidInput);
}
}

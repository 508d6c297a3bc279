// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HalfSpace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace TestHalfSpace
{
using hexsweep::Index;
using hexsweep::Points;
using Vector = Eigen::RowVector3d;

Index count(const std::vector<bool>& flags)
{
  return std::count(flags.begin(), flags.end(), true);
}

std::vector<bool> largest(const Points& vectors)
{
  return hexsweep::largestHalfSpace(vectors, Vector::Zero());
}

Points randomUnits(Index n, std::mt19937& generator)
{
  std::normal_distribution<double> coordinate;
  Points vectors(n, 3);
  for (Index i = 0; i < n; ++i)
  {
    vectors.row(i) =
      Vector(coordinate(generator), coordinate(generator), coordinate(generator)).normalized();
  }
  return vectors;
}

/// The perceptron ends if the chosen vectors have an open half space in common.
bool isHalfSpaceFound(const Points& units, const std::vector<bool>& chosen)
{
  Vector normal = Vector::Zero();
  for (int round = 0; round < 1000000; ++round)
  {
    bool changed = false;
    for (Index i = 0; i < units.rows(); ++i)
    {
      if (chosen[static_cast<std::size_t>(i)] && !(normal.dot(units.row(i)) > 0.0))
      {
        normal += units.row(i);
        changed = true;
      }
    }
    if (!changed)
    {
      return true;
    }
  }
  return false;
}

/// The most vectors on one side of some of many planes spread over the sphere.
Index mostOfManyPlanes(const Points& units)
{
  constexpr int planes = 20000;
  const double golden = std::acos(-1.0) * (3.0 - std::sqrt(5.0));
  Index most = 0;
  for (int k = 0; k < planes; ++k)
  {
    const double z = 1.0 - (2.0 * k + 1.0) / planes;
    const double radius = std::sqrt(1.0 - z * z);
    const Vector normal(radius * std::cos(golden * k), radius * std::sin(golden * k), z);
    most = std::max<Index>(most, ((units * normal.transpose()).array() > 0.0).count());
  }
  return most;
}

TEST(HalfSpace, IsTheLargestOfRandomVectors)
{
  std::mt19937 generator(3);
  Index partial = 0;
  for (int sample = 0; sample < 60; ++sample)
  {
    const Points units = randomUnits(1 + sample % 9, generator);
    const std::vector<bool> chosen = largest(units);
    EXPECT_GE(count(chosen), mostOfManyPlanes(units));
    EXPECT_TRUE(isHalfSpaceFound(units, chosen));
    partial += count(chosen) < units.rows();
  }
  EXPECT_GT(partial, 10);
}

TEST(HalfSpace, LengthsDoNotMatter)
{
  std::mt19937 generator(4);
  for (int sample = 0; sample < 20; ++sample)
  {
    const Points units = randomUnits(6, generator);
    Points scaled = units;
    for (Index i = 0; i < 6; ++i)
    {
      scaled.row(i) *= std::pow(10.0, 4.0 * static_cast<double>(i) - 12.0);
    }
    EXPECT_EQ(largest(scaled), largest(units));
  }
}

TEST(HalfSpace, OppositeAndLostVectors)
{
  Points vectors(4, 3);
  vectors << 0, 0, 1, 0, 0, -2, 0, 0, 3, 0, 0, 0;
  EXPECT_EQ(largest(vectors), (std::vector<bool>{ true, false, true, false }));
  // As many on either side: the preferred one.
  vectors << 0, 0, 1, 0, 0, -2, 0, 0, 3, 0, 0, -1;
  EXPECT_EQ(hexsweep::largestHalfSpace(vectors, Vector(0, 0, -1)),
    (std::vector<bool>{ false, true, false, true }));
  // The same about any axis, with the rounding that this brings.
  const Vector axis = Vector(0.3, -0.7, 0.2).normalized();
  for (Index i = 0; i < 4; ++i)
  {
    vectors.row(i) = axis * (i % 2 ? -1.1 : 0.7);
  }
  EXPECT_EQ(
    hexsweep::largestHalfSpace(vectors, -axis), (std::vector<bool>{ false, true, false, true }));
}
}

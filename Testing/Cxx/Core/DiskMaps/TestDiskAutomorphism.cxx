// SPDX-License-Identifier: BSD-3-Clause
// Images of circles against images of their points; balance against its definition.
#include "Core/DiskMaps/DiskAutomorphism.h"

#include "Support/CapMeshes.h"

namespace TestDiskAutomorphism
{
using hexsweep::Circle;
using hexsweep::DiskAutomorphism;
using test::Pi;
using Complex = std::complex<double>;

std::vector<DiskAutomorphism> someMaps()
{
  return { DiskAutomorphism(), DiskAutomorphism(0.0, std::polar(1.0, 2.0)),
    DiskAutomorphism({ 0.5, -0.3 }, 1.0), DiskAutomorphism({ -0.2, 0.9 }, std::polar(1.0, -1.0)),
    DiskAutomorphism({ 0.99, 0.0 }, std::polar(1.0, 0.5)) };
}

Complex balance(const DiskAutomorphism& map, const std::vector<double>& angles,
  const std::vector<double>& weights)
{
  Complex mean = 0.0;
  double total = 0.0;
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    mean += weights[i] * map(std::polar(1.0, angles[i]));
    total += weights[i];
  }
  return mean / total;
}

TEST(DiskAutomorphism, KeepsTheUnitDiskAndItsMetric)
{
  // |z - w| / |1 - conj(z) w| is what disk automorphisms leave unchanged.
  const auto distance = [](const Complex& z, const Complex& w) {
    return std::abs(z - w) / std::abs(1.0 - std::conj(z) * w);
  };
  for (const DiskAutomorphism& map : someMaps())
  {
    for (int k = 0; k < 12; ++k)
    {
      const Complex z = std::polar(1.0, 0.5 * k);
      EXPECT_NEAR(std::abs(map(z)), 1.0, 1e-13);
      const Complex a = std::polar(0.07 * k, 0.5 * k);
      const Complex b = std::polar(0.5, -0.3 * k);
      EXPECT_NEAR(distance(map(a), map(b)), distance(a, b), 1e-12);
    }
  }
  EXPECT_LT(std::abs(DiskAutomorphism({ 0.5, -0.3 }, std::polar(1.0, 1.2))({ 0.5, -0.3 })), 1e-16);
  const DiskAutomorphism map = someMaps()[3];
  const Complex z(0.2, 0.1);
  const Complex turn = std::polar(1.0, 0.7);
  EXPECT_LT(std::abs(map.turned(turn)(z) - turn * map(z)), 1e-15);
}

TEST(DiskAutomorphism, CirclesGoToTheCirclesOfTheirPoints)
{
  for (const DiskAutomorphism& map : someMaps())
  {
    for (const Circle& circle :
      { Circle{ { 0.0, 0.0 }, 0.3 }, Circle{ { 0.4, -0.5 }, 0.2 }, Circle{ { 0.0, 0.6 }, 1e-6 },
        Circle{ { -0.1, 0.2 }, 0.7 }, Circle{ { 0.0, 0.0 }, 1.0 } })
    {
      const Circle image = map(circle);
      for (int k = 0; k < 16; ++k)
      {
        const Complex z = Complex(circle.center.x(), circle.center.y()) +
          std::polar(circle.radius, 2.0 * Pi * k / 16.0);
        const Complex w = map(z);
        EXPECT_NEAR(std::abs(w - Complex(image.center.x(), image.center.y())), image.radius, 3e-14);
      }
    }
  }
}

TEST(DiskAutomorphism, BalancingMapBringsTheMeanToTheOrigin)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(0.05, 1.0);
  for (const int m : { 3, 10, 200 })
  {
    for (const DiskAutomorphism& crowd : someMaps())
    {
      std::vector<double> angles;
      std::vector<double> weights;
      double angle = uniform(generator);
      for (int i = 0; i < m; ++i)
      {
        // Uneven, and crowded by the map.
        angle += 2.0 * Pi / m * uniform(generator);
        angles.push_back(std::arg(crowd(std::polar(1.0, angle))));
        weights.push_back(m == 3 ? 1.0 : uniform(generator));
      }
      const DiskAutomorphism map = hexsweep::balancingMap(angles, weights);
      EXPECT_LT(std::abs(balance(map, angles, weights)), 1e-12);
    }
  }
}

TEST(DiskAutomorphism, BalancedPointsStay)
{
  std::vector<double> angles;
  for (int i = 0; i < 20; ++i)
  {
    angles.push_back(2.0 * Pi * i / 20.0);
  }
  const DiskAutomorphism map = hexsweep::balancingMap(angles, std::vector<double>(20, 3.0));
  EXPECT_LT(std::abs(map({ 0.3, 0.2 }) - Complex(0.3, 0.2)), 1e-15);
}

TEST(DiskAutomorphism, BalanceIsNatural)
{
  // Points that an automorphism has moved are balanced onto the same places but for a turn.
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(0.2, 1.0);
  std::vector<double> angles;
  std::vector<double> weights;
  for (int i = 0; i < 30; ++i)
  {
    angles.push_back(0.2 * i + 0.1 * uniform(generator));
    weights.push_back(uniform(generator));
  }
  const DiskAutomorphism plain = hexsweep::balancingMap(angles, weights);
  for (const DiskAutomorphism& move : someMaps())
  {
    std::vector<double> moved;
    for (const double angle : angles)
    {
      moved.push_back(std::arg(move(std::polar(1.0, angle))));
    }
    const DiskAutomorphism other = hexsweep::balancingMap(moved, weights);
    const auto ratio = [&](std::size_t i) {
      return other(std::polar(1.0, moved[i])) / plain(std::polar(1.0, angles[i]));
    };
    for (std::size_t i = 1; i < angles.size(); ++i)
    {
      EXPECT_LT(std::abs(ratio(i) - ratio(0)), 1e-10);
    }
  }
}

TEST(DiskAutomorphism, TurnsOfPointsOnTheCircle)
{
  for (const DiskAutomorphism& map : someMaps())
  {
    double before = map.turnAt(1.0);
    for (int i = 1; i <= 720; ++i)
    {
      const Complex z = std::polar(1.0, Pi * i / 360.0);
      const double turn = map.turnAt(z);
      EXPECT_LT(std::abs(map(z) - z * std::polar(1.0, turn)), 1e-12);
      EXPECT_LT(std::abs(turn - before), 3.0); // no whole turn between
      before = turn;
    }
  }
}

TEST(DiskAutomorphism, BalanceOfHeavyPoints)
{
  // Nearly half of the weight in one place: Newton's steps alone would leave the disk.
  for (const double heavy : { 0.4, 0.49, 0.499 })
  {
    const std::vector<double> angles{ 0.0, 0.1, 0.3, 0.4 };
    const std::vector<double> weights{ heavy, 0.5 - heavy, 0.2, 0.3 };
    EXPECT_LT(std::abs(balance(hexsweep::balancingMap(angles, weights), angles, weights)), 1e-11)
      << heavy;
  }
}
}

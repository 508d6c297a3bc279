// SPDX-License-Identifier: BSD-3-Clause
// The certificate on known shapes, its coefficients against exact numbers and the shape functions.
#include "Core/Hexahedra/HexCertificate.h"

#include "Core/Common/Expansion.h"
#include "Core/Hexahedra/BezierHex.h"
#include "Support/HexSamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <random>

namespace TestHexCertificate
{
using hexsweep::certifyHex;
using hexsweep::Expansion;
using hexsweep::HexCorners;
using hexsweep::Validity;
using hexsweep::Vector3;

template <typename Number>
hexsweep::HexEdges<Number> edgesOf(const HexCorners& corners)
{
  std::array<Vector3<Number>, 8> points;
  for (int i = 0; i < 8; ++i)
  {
    points[static_cast<std::size_t>(i)] = { corners(i, 0), corners(i, 1), corners(i, 2) };
  }
  return hexsweep::hexEdges(points);
}

double greatestLength(const Vector3<double> (&edges)[2][2])
{
  double greatest = 0.0;
  for (const auto& row : edges)
  {
    for (const auto& edge : row)
    {
      greatest = std::max(greatest, std::sqrt(dot(edge, edge)));
    }
  }
  return greatest;
}

double bernstein(int i, double t)
{
  return i == 0 ? (1.0 - t) * (1.0 - t) : i == 1 ? 2.0 * t * (1.0 - t) : t * t;
}

HexCorners hexOf(std::initializer_list<double> coordinates)
{
  return Eigen::Map<const HexCorners>(coordinates.begin());
}

/// A cube whose corner 6 is moved into the plane of its three neighbours, where the edges have no
/// volume: the sum of its coordinates is 2.
HexCorners flatCorner()
{
  HexCorners corners = test::unitCube();
  corners.row(6) << 0.5, 0.5, 1.0;
  return corners;
}

TEST(HexCertificate, BezierFormIsTheJacobianOfTheShapeFunctions)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int n = 0; n < 200; ++n)
  {
    const HexCorners corners = test::shakenCube(0.8, generator);
    const auto coefficients = hexsweep::bezierCoefficients(edgesOf<double>(corners));
    const double u = uniform(generator);
    const double v = uniform(generator);
    const double w = uniform(generator);
    double sum = 0.0;
    for (int i = 0; i < 27; ++i)
    {
      sum += coefficients[static_cast<std::size_t>(i)] * bernstein(i % 3, u) *
        bernstein(i / 3 % 3, v) * bernstein(i / 9, w);
    }
    EXPECT_NEAR(sum, test::jacobianAt<double>(corners, u, v, w), 1e-13);
  }
}

TEST(HexCertificate, RoundingStaysWithinItsBound)
{
  std::mt19937 generator(4);
  double worst = 0.0;
  for (int n = 0; n < 600; ++n)
  {
    HexCorners corners = test::randomHex(generator);
    // Up to 1e9 sizes from the origin: the differences are rounded but once.
    corners.col(0).array() += n % 3 == 0 ? 0.0 : n % 3 == 1 ? 1e3 : 1e9;
    const auto edges = edgesOf<double>(corners);
    const auto rounded = hexsweep::bezierCoefficients(edges);
    const auto exact = hexsweep::bezierCoefficients(edgesOf<Expansion>(corners));
    const double lengths =
      greatestLength(edges.u) * greatestLength(edges.v) * greatestLength(edges.w);
    for (std::size_t i = 0; i < 27; ++i)
    {
      const double error = std::abs(toDouble(Expansion(rounded[i]) - exact[i]));
      worst = std::max(worst, error / (hexsweep::BezierErrorBound * lengths));
    }
  }
  EXPECT_LT(worst, 0.1);
  // Zero would mean that nothing was rounded and nothing tested.
  EXPECT_GT(worst, 1e-6);
}

TEST(HexCertificate, BoxesAreCertifiedWithTheirVolume)
{
  const HexCorners box = test::unitCube() * Eigen::Vector3d(2.0, 0.5, 10.0).asDiagonal();
  const auto certificate = certifyHex(box);
  EXPECT_EQ(certificate.validity, Validity::Certified);
  EXPECT_LE(certificate.jacobianLowerBound, 10.0);
  EXPECT_NEAR(certificate.jacobianLowerBound, 10.0, 1e-11);
}

TEST(HexCertificate, NegativeBetweenPositiveCornersIsCaught)
{
  const HexCorners shapes[] = {
    // A flat rectangle below, a tall one turned by 180 degrees above: negative at the centre.
    hexOf({ -2, -0.05, 0, 2, -0.05, 0, 2, 0.05, 0, -2, 0.05, 0, //
      0.5, 1, 1, -0.5, 1, 1, -0.5, -1, 1, 0.5, -1, 1 }),
    // Negative in the middle of an edge, positive at the centre.
    hexOf(
      { 0, -4, 8, 16, 9, -9, 5, 19, -2, 8, 14, -8, 5, -6, 13, 15, -3, 7, 12, 16, 19, -6, 7, 15 }),
    // Negative in a face, positive in the middle of each edge and at the centre.
    hexOf({ 8, 7, -9, 14, -2, 2, 13, 2, -2, -9, 19, 1, -1, 5, 13, 16, -2, 9, 16, 18, 4, 5, 4, 18 }),
    // Positive at corners, middles of edges and faces and at the centre.
    hexOf({ -9, -4, 1, 5, 0, -5, 10, 6, -7, 3, 19, -4, 4, -7, 4, 13, 3, 12, 6, 13, 8, -1, 6, 9 }),
    hexOf({ 0, -3, 9, 8, -1, -6, 11, 13, 5, 3, 5, 3, 2, 7, 19, 5, 6, 19, 12, 17, 9, 0, 19, 7 }),
  };
  for (const HexCorners& corners : shapes)
  {
    for (int i = 0; i < 8; ++i)
    {
      EXPECT_GT(test::jacobianAt<double>(corners, i % 2, i / 2 % 2, i / 4), 0.0);
    }
    const double least = test::leastJacobian(corners, 33);
    EXPECT_LT(least, 0.0) << corners;
    const auto certificate = certifyHex(corners);
    EXPECT_EQ(certificate.validity, Validity::InvertedInside) << corners;
    EXPECT_LE(certificate.jacobianLowerBound, least);
    EXPECT_GE(certificate.jacobianLowerBound, 1.02 * least);
  }
}

TEST(HexCertificate, ValidShapesWithNegativeCoefficientsAreNotRejected)
{
  std::mt19937 generator(8);
  int bisected = 0;
  for (int n = 0; n < 8000; ++n)
  {
    const HexCorners corners = test::shakenCube(0.5, generator);
    const auto coefficients = hexsweep::bezierCoefficients(edgesOf<double>(corners));
    const bool negative = *std::min_element(coefficients.begin(), coefficients.end()) < -1e-3;
    if (negative && certifyHex(corners).validity == Validity::Certified)
    {
      ++bisected;
      EXPECT_GT(test::leastJacobian(corners, 9), 0.0) << corners;
    }
  }
  EXPECT_GT(bisected, 10);
}

TEST(HexCertificate, ZeroIsToldFromTheNextNumber)
{
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(certifyHex(flatCorner()).validity, Validity::InvertedCorner);
  for (const double place : { 0.0, 3.0, 1048576.0 })
  {
    HexCorners corners = flatCorner().array() + place;
    EXPECT_EQ(certifyHex(corners).validity, Validity::InvertedCorner) << place;
    const double z = corners(6, 2);
    corners(6, 2) = std::nextafter(z, -infinity);
    EXPECT_EQ(certifyHex(corners).validity, Validity::InvertedCorner) << place;
    corners(6, 2) = std::nextafter(z, infinity);
    const auto certificate = certifyHex(corners);
    EXPECT_EQ(certificate.validity, Validity::Certified) << place;
    EXPECT_GT(certificate.jacobianLowerBound, 0.0);
    EXPECT_LE(certificate.jacobianLowerBound, corners(6, 2) - z);
  }
}

TEST(HexCertificate, TouchingZeroBetweenCornersIsNeverCertified)
{
  // The section at height w has the axes (1 - w) a + w b with b = -a turned: half way it vanishes.
  const HexCorners half = hexOf({ -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, //
    1, 1, 1, -1, 1, 1, -1, -1, 1, 1, -1, 1 });
  EXPECT_EQ(certifyHex(half).validity, Validity::InvertedInside);
  // A third of the way, where no bisection comes: not certified, but nothing found either.
  HexCorners third = half;
  third.bottomRows<4>().leftCols<2>() *= 2.0;
  const auto certificate = certifyHex(third);
  EXPECT_NE(certificate.validity, Validity::Certified);
  EXPECT_LE(certificate.jacobianLowerBound, 0.0);
  EXPECT_GE(certificate.jacobianLowerBound, -0.1);
}

TEST(HexCertificate, FlatAndDegenerateOnesAreCaught)
{
  // In one plane, no two corners at the same place.
  HexCorners corners = test::unitCube();
  corners.bottomRows<4>().leftCols<2>().array() += 0.125;
  corners.col(2) = 0.25 * corners.col(0) + 0.5 * corners.col(1);
  EXPECT_EQ(certifyHex(corners).validity, Validity::InvertedCorner);

  corners = test::unitCube();
  corners.row(1) = corners.row(0);
  EXPECT_EQ(certifyHex(corners).validity, Validity::Degenerate);
  EXPECT_TRUE(std::isnan(certifyHex(corners).jacobianLowerBound));
  corners.setConstant(7.0);
  EXPECT_EQ(certifyHex(corners).validity, Validity::Degenerate);
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    corners = test::unitCube();
    corners(3, 1) = bad;
    EXPECT_EQ(certifyHex(corners).validity, Validity::Degenerate);
  }
}

TEST(HexCertificate, SizeDoesNotMatter)
{
  std::mt19937 generator(5);
  for (int n = 0; n < 200; ++n)
  {
    const HexCorners corners = test::shakenCube(0.45, generator);
    const auto truth = certifyHex(corners);
    for (const int exponent : { -900, -300, -100, -20, 20, 100, 300, 900 })
    {
      const HexCorners scaled = corners * std::ldexp(1.0, exponent);
      const auto certificate = certifyHex(scaled);
      EXPECT_EQ(certificate.validity, truth.validity) << "2^" << exponent;
      if (std::abs(exponent) <= 300)
      {
        EXPECT_NEAR(std::ldexp(certificate.jacobianLowerBound, -3 * exponent),
          truth.jacobianLowerBound, 1e-12);
      }
    }
  }
}
}

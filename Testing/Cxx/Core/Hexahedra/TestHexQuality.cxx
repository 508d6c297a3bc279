// SPDX-License-Identifier: BSD-3-Clause
// Corner Jacobians and scaled Jacobian against closed forms.
#include "Core/Hexahedra/HexQuality.h"

#include "Support/HexSamples.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace TestHexQuality
{
using hexsweep::HexCorners;
using hexsweep::hexQuality;
using hexsweep::Validity;

using test::unitCube;

HexCorners transformed(const HexCorners& corners, const Eigen::Matrix3d& matrix)
{
  return corners * matrix.transpose();
}

HexCorners turnedInsideOut(const HexCorners& corners)
{
  HexCorners turned;
  turned << corners.bottomRows<4>(), corners.topRows<4>();
  return turned;
}

TEST(HexQuality, CornerJacobiansOfAnAffineCubeAreItsDeterminant)
{
  Eigen::Matrix3d matrix;
  matrix << 2, 1, 0.5, 0, 3, 1, 0.25, 0, 4;
  const auto jacobians = hexsweep::cornerJacobians(transformed(unitCube(), matrix));
  for (int i = 0; i < 8; ++i)
  {
    EXPECT_NEAR(jacobians[i], matrix.determinant(), 1e-13 * matrix.determinant()) << "corner " << i;
  }
}

TEST(HexQuality, ShearedCubeHasTheCosineOfTheShear)
{
  // All corners of a parallelepiped share one frame: e1, e2 and (s, 0, 1) give 1 / sqrt(1 + s^2).
  for (const double shear : { 0.0, 0.5, 1.0, 3.0 })
  {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    matrix(0, 2) = shear;
    const auto quality = hexQuality(transformed(unitCube(), matrix));
    EXPECT_NEAR(quality.scaledJacobian, 1.0 / std::sqrt(1.0 + shear * shear), 1e-15);
    EXPECT_EQ(quality.validity, Validity::Undecided);
    EXPECT_FALSE(quality.insideOut);
  }
}

TEST(HexQuality, PulledCornerHasItsClosedForm)
{
  // Corner 6 at (a, a, a): the edges to corners 5, 7 and 2 have the determinant 3 a - 2, and each
  // the squared length 2 (1 - a)^2 + a^2.
  HexCorners corners = unitCube();
  corners.row(6).setConstant(0.5);
  EXPECT_NEAR(hexsweep::cornerJacobians(corners)[6], -0.5, 1e-15);
  const auto quality = hexQuality(corners);
  EXPECT_EQ(quality.validity, Validity::InvertedCorner);
  EXPECT_NEAR(quality.scaledJacobian, -0.5 / std::pow(std::sqrt(3.0) / 2.0, 3), 1e-14);

  corners.row(6).setConstant(2.0 / 3.0 + 1e-3);
  EXPECT_EQ(hexQuality(corners).validity, Validity::Undecided);
  corners.row(6).setConstant(2.0 / 3.0 - 1e-3);
  EXPECT_EQ(hexQuality(corners).validity, Validity::InvertedCorner);
}

TEST(HexQuality, InsideOutHexIsRecognised)
{
  const auto quality = hexQuality(turnedInsideOut(unitCube()));
  EXPECT_NEAR(quality.scaledJacobian, -1.0, 1e-15);
  EXPECT_EQ(quality.validity, Validity::InvertedCorner);
  EXPECT_TRUE(quality.insideOut);
}

TEST(HexQuality, PositiveCornersWithNegativeCenterAreInvertedInside)
{
  // A flat rectangle below, a tall one turned by 180 degrees above. The upright edges all rise by
  // one, so the corners have the determinants 4 * 0.1 and 1 * 2; but half way the section has the
  // axes (1.5, 0) and (0, -0.95).
  HexCorners corners;
  corners << -2, -0.05, 0, 2, -0.05, 0, 2, 0.05, 0, -2, 0.05, 0, //
    0.5, 1, 1, -0.5, 1, 1, -0.5, -1, 1, 0.5, -1, 1;
  const auto jacobians = hexsweep::cornerJacobians(corners);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(jacobians[i], 0.4, 1e-15);
    EXPECT_NEAR(jacobians[i + 4], 2.0, 1e-15);
  }
  const auto quality = hexQuality(corners);
  EXPECT_EQ(quality.validity, Validity::InvertedInside);
  EXPECT_NEAR(quality.scaledJacobian, -1.0, 1e-15);
  EXPECT_FALSE(quality.insideOut);
}

TEST(HexQuality, DegenerateHexesAreNoPerfectOnes)
{
  HexCorners corners = unitCube();
  corners.row(1) = corners.row(0);
  auto quality = hexQuality(corners);
  EXPECT_EQ(quality.validity, Validity::Degenerate);
  EXPECT_LE(quality.scaledJacobian, 0.0);

  corners.setConstant(7.0);
  quality = hexQuality(corners);
  EXPECT_EQ(quality.validity, Validity::Degenerate);
  EXPECT_EQ(quality.scaledJacobian, 0.0);

  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    corners = unitCube();
    corners(3, 1) = bad;
    quality = hexQuality(corners);
    EXPECT_EQ(quality.validity, Validity::Degenerate);
    EXPECT_TRUE(std::isnan(quality.scaledJacobian));
  }
}

TEST(HexQuality, SizePlaceAndAttitudeDoNotMatter)
{
  HexCorners corners = unitCube();
  corners.row(6) = Eigen::RowVector3d(1.25, 0.75, 1.5);
  corners.row(3) = Eigen::RowVector3d(-0.25, 1.125, 0.125);
  const double truth = hexQuality(corners).scaledJacobian;
  ASSERT_GT(truth, 0.1);
  for (const double size : { 1e-60, 1e-12, 1e-6, 1e6, 1e60 })
  {
    EXPECT_NEAR(hexQuality(size * corners).scaledJacobian, truth, 1e-14) << "size " << size;
  }
  // Coordinates are stored with about 1e-16 of their size: 1e6 sizes away 1e-10 is left.
  const HexCorners far = corners.rowwise() + Eigen::RowVector3d(1e6, -1e6, 1e6);
  EXPECT_NEAR(hexQuality(far).scaledJacobian, truth, 1e-9);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  EXPECT_NEAR(hexQuality(transformed(corners, turn)).scaledJacobian, truth, 1e-14);
}

TEST(HexQuality, SummaryCountsEveryKind)
{
  hexsweep::Points points(16, 3);
  points.topRows<8>() = unitCube();
  points.bottomRows<8>() = unitCube();
  points.row(14).setConstant(0.5);
  hexsweep::Hexes hexes(4, 8);
  hexes << 0, 1, 2, 3, 4, 5, 6, 7, // the cube
    4, 5, 6, 7, 0, 1, 2, 3,        // inside out
    8, 9, 10, 11, 12, 13, 14, 15,  // a pulled corner: inverted
    0, 0, 2, 3, 4, 5, 6, 7;        // an edge without length
  const auto qualities = hexsweep::hexQualities(points, hexes);
  const auto summary = hexsweep::summarize(qualities);
  EXPECT_EQ(summary.hexes, 4);
  EXPECT_EQ(summary.inverted, 2);
  EXPECT_EQ(summary.insideOut, 1);
  EXPECT_EQ(summary.degenerate, 1);
  EXPECT_EQ(summary.notCertified, 3);
  EXPECT_EQ(summary.undecided, 0);
  EXPECT_EQ(summary.invertedInside, 0);
  EXPECT_NEAR(summary.minJacobianLowerBound, -1.0, 1e-12);
  EXPECT_NEAR(summary.minScaledJacobian, -1.0, 1e-15);
  double sum = 0.0;
  for (const auto& quality : qualities)
  {
    sum += quality.scaledJacobian;
  }
  EXPECT_NEAR(summary.meanScaledJacobian, sum / 4.0, 1e-15);
  EXPECT_EQ(hexsweep::summarize({}).hexes, 0);
  EXPECT_TRUE(std::isnan(hexsweep::summarize({}).minJacobianLowerBound));
}

// An odd number of hexahedra of every kind: good and bad ones, with edges without length, lost,
// and of sizes whose products leave the range of double.
hexsweep::Points mixedHexes(int count)
{
  std::mt19937 generator(9);
  hexsweep::Points corners(8 * count, 3);
  for (int h = 0; h < count; ++h)
  {
    HexCorners hex = test::randomHex(generator);
    if (h % 50 == 7)
    {
      hex.row(h % 8) = hex.row(h % 4 < 2 ? 1 : 2);
    }
    if (h % 50 == 11)
    {
      hex(h % 8, h % 3) = std::numeric_limits<double>::quiet_NaN();
    }
    if (h % 50 == 23)
    {
      hex *= h % 100 == 23 ? 1e-70 : 1e70;
    }
    if (h % 50 == 31)
    {
      hex(0, 0) = std::numeric_limits<double>::infinity();
    }
    corners.middleRows<8>(8 * h) = hex;
  }
  return corners;
}

bool isSame(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

TEST(HexQualities, BatchesSayWhatSingleHexesDo)
{
  const int count = 5001;
  const hexsweep::Points corners = mixedHexes(count);
  const auto certified = hexsweep::hexQualities(corners);
  const auto plain = hexsweep::hexQualities(corners, false);
  ASSERT_EQ(certified.size(), 5001u);
  for (int h = 0; h < count; ++h)
  {
    const HexCorners hex = corners.middleRows<8>(8 * h);
    const auto single = hexQuality(hex);
    const auto certificate = hexsweep::certifyHex(hex);
    const auto& quality = certified[static_cast<std::size_t>(h)];
    const auto& uncertified = plain[static_cast<std::size_t>(h)];
    ASSERT_EQ(quality.validity, certificate.validity) << "hexahedron " << h;
    ASSERT_TRUE(isSame(quality.jacobianLowerBound, certificate.jacobianLowerBound) ||
      std::abs(quality.jacobianLowerBound - certificate.jacobianLowerBound) <=
        0.011 * std::abs(certificate.jacobianLowerBound))
      << "hexahedron " << h << ": " << quality.jacobianLowerBound << ", "
      << certificate.jacobianLowerBound;
    ASSERT_EQ(uncertified.validity, single.validity) << "hexahedron " << h;
    ASSERT_TRUE(std::isnan(uncertified.jacobianLowerBound));
    ASSERT_EQ(quality.insideOut, single.insideOut) << "hexahedron " << h;
    ASSERT_TRUE(isSame(quality.scaledJacobian, single.scaledJacobian) ||
      std::abs(quality.scaledJacobian - single.scaledJacobian) < 1e-14)
      << "hexahedron " << h << ": " << quality.scaledJacobian << ", " << single.scaledJacobian;
    ASSERT_TRUE(isSame(quality.scaledJacobian, uncertified.scaledJacobian));
  }
}

TEST(HexQualities, MeshAndThreadsGiveTheSameBits)
{
  const int count = 9001;
  const hexsweep::Points corners = mixedHexes(count);
  hexsweep::Hexes hexes(count, 8);
  for (hexsweep::Index i = 0; i < hexes.size(); ++i)
  {
    hexes(i / 8, i % 8) = i;
  }
  const auto backwards = [](hexsweep::Index pieces,
                           const std::function<void(hexsweep::Index)>& call) {
    EXPECT_GT(pieces, 1);
    for (hexsweep::Index p = pieces; p-- > 0;)
    {
      call(p);
    }
  };
  const auto alone = hexsweep::hexQualities(corners);
  const auto mesh = hexsweep::hexQualities(corners, hexes, true, backwards);
  for (std::size_t h = 0; h < alone.size(); ++h)
  {
    ASSERT_TRUE(isSame(alone[h].scaledJacobian, mesh[h].scaledJacobian)) << h;
    ASSERT_TRUE(isSame(alone[h].jacobianLowerBound, mesh[h].jacobianLowerBound)) << h;
    ASSERT_EQ(alone[h].validity, mesh[h].validity) << h;
  }
}

TEST(HexQualities, VerdictsAreThoseOfTheCertificate)
{
  const int count = 5001;
  const hexsweep::Points corners = mixedHexes(count);
  hexsweep::Hexes hexes(count, 8);
  std::vector<const double*> pointers;
  for (hexsweep::Index i = 0; i < hexes.size(); ++i)
  {
    hexes(i / 8, i % 8) = i;
    pointers.push_back(corners.data() + 3 * i);
  }
  const auto certified = hexsweep::hexQualities(corners);
  const auto verdicts = hexsweep::hexVerdicts(corners, hexes);
  std::vector<hexsweep::HexQuality> alone(count);
  hexsweep::hexVerdicts(pointers.data(), count, alone.data());
  ASSERT_EQ(certified.size(), static_cast<std::size_t>(count));
  ASSERT_EQ(verdicts.size(), static_cast<std::size_t>(count));
  for (std::size_t h = 0; h < certified.size(); ++h)
  {
    for (const auto& verdict : { verdicts[h], alone[h] })
    {
      ASSERT_TRUE(isSame(verdict.scaledJacobian, certified[h].scaledJacobian)) << h;
      ASSERT_EQ(verdict.validity, certified[h].validity) << h;
      ASSERT_EQ(verdict.insideOut, certified[h].insideOut) << h;
      // A bound all the same, where there is one.
      const auto jacobians =
        hexsweep::cornerJacobians(corners.middleRows<8>(8 * static_cast<hexsweep::Index>(h)));
      ASSERT_FALSE(verdict.jacobianLowerBound > jacobians.minCoeff()) << h;
    }
  }
}
}

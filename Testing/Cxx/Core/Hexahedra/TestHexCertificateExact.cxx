// SPDX-License-Identifier: BSD-3-Clause
// Verdicts against another certificate, in exact numbers where intervals do not tell, on hexahedra
// that are hard to judge. HEXSWEEP_CERTIFICATE_HEXES sets how many, HEXSWEEP_CERTIFICATE_FIRST the
// first one.
#include "Core/Hexahedra/HexQuality.h"
#include "Support/ExactHexes.h"
#include "Support/HexSamples.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>

namespace TestHexCertificateExact
{
using hexsweep::HexCorners;
using hexsweep::HexQuality;
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::Validity;
using test::HexTruth;
using test::Truth;

std::uint64_t setting(const char* name, std::uint64_t otherwise)
{
  const char* text = std::getenv(name);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

bool isInverted(Validity validity)
{
  return validity == Validity::InvertedCorner || validity == Validity::InvertedInside;
}

struct Tally
{
  Index byIntervals = 0;
  Index unknown = 0;
  std::array<Index, 6> verdicts{};
};

/// What is wrong with a verdict; empty: nothing.
std::string contradiction(Validity validity, const HexTruth& truth)
{
  if (validity == Validity::Certified && truth.everywhere != Truth::Positive)
  {
    return "certified, but not positive";
  }
  if (isInverted(validity) && truth.everywhere == Truth::Positive)
  {
    return "inverted, but positive";
  }
  if (validity == Validity::InvertedCorner && truth.positiveCorners)
  {
    return "a corner inverted, but all are positive";
  }
  if (validity == Validity::InvertedInside && !truth.positiveCorners)
  {
    return "inverted inside alone, but a corner is";
  }
  return {};
}

bool hasEdgeWithoutLength(const HexCorners& x)
{
  constexpr int Ends[12][2] = { { 0, 1 }, { 1, 2 }, { 3, 2 }, { 0, 3 }, { 4, 5 }, { 5, 6 },
    { 7, 6 }, { 4, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
  return std::any_of(std::begin(Ends), std::end(Ends),
    [&](const int(&ends)[2]) { return x.row(ends[0]) == x.row(ends[1]); });
}

void judgeBatch(std::uint64_t first, Index count, Tally& tally)
{
  Points corners(8 * count, 3);
  for (Index h = 0; h < count; ++h)
  {
    corners.middleRows<8>(8 * h) = test::adversarialHex(first + static_cast<std::uint64_t>(h));
  }
  // Side by side in the kernels, as filters judge them.
  const std::vector<HexQuality> qualities = hexsweep::hexQualities(corners);
  for (Index h = 0; h < count; ++h)
  {
    const HexCorners hex = corners.middleRows<8>(8 * h);
    const HexQuality& quality = qualities[static_cast<std::size_t>(h)];
    const Validity alone = hexsweep::certifyHex(hex).validity;
    const HexTruth truth = test::truthOf(hex);
    const auto name = [&] {
      return "hexahedron " + std::to_string(first + static_cast<std::uint64_t>(h));
    };
    ASSERT_EQ(contradiction(quality.validity, truth), "") << name();
    ASSERT_EQ(contradiction(alone, truth), "") << name();
    ASSERT_EQ(alone == Validity::Degenerate, hasEdgeWithoutLength(hex)) << name();
    if (quality.validity == Validity::Certified)
    {
      ASSERT_GT(quality.scaledJacobian, 0.0) << name();
    }
    if (quality.validity == Validity::Degenerate && alone != Validity::Degenerate)
    {
      ASSERT_LT(std::abs(quality.scaledJacobian), 1e-14) << name();
    }
    tally.byIntervals += truth.byIntervals;
    tally.unknown += truth.everywhere == Truth::Unknown;
    ++tally.verdicts[static_cast<std::size_t>(quality.validity)];
  }
}

HexCorners hexOf(std::initializer_list<double> coordinates)
{
  return Eigen::Map<const HexCorners>(coordinates.begin());
}

TEST(HexCertificateExact, NeverContradictsExactNumbers)
{
  const std::uint64_t first = setting("HEXSWEEP_CERTIFICATE_FIRST", 0);
  const std::uint64_t count = setting("HEXSWEEP_CERTIFICATE_HEXES", 100000);
  constexpr std::uint64_t AtOnce = 4000;
  Tally tally;
  for (std::uint64_t done = 0; done < count && !HasFatalFailure(); done += AtOnce)
  {
    judgeBatch(first + done, static_cast<Index>(std::min(AtOnce, count - done)), tally);
  }
  for (std::size_t v = 0; v < tally.verdicts.size(); ++v)
  {
    RecordProperty("Validity" + std::to_string(v), std::to_string(tally.verdicts[v]));
  }
  RecordProperty("ByIntervals", std::to_string(tally.byIntervals));
  RecordProperty("TruthUnknown", std::to_string(tally.unknown));
  std::cout << "certified " << tally.verdicts[0] << ", a corner inverted " << tally.verdicts[1]
            << ", inverted inside " << tally.verdicts[2] << ", undecided " << tally.verdicts[3]
            << ", degenerate " << tally.verdicts[4] << "; truth by intervals " << tally.byIntervals
            << ", unknown " << tally.unknown << " of " << count << "\n";
  if (count >= 10000)
  {
    // Every verdict was put to the test, and the truth is nearly always known.
    for (std::size_t v = 0; v < 5; ++v)
    {
      EXPECT_GT(tally.verdicts[v], 0) << v;
    }
    EXPECT_LT(tally.unknown, static_cast<Index>(count / 1000));
    EXPECT_GT(tally.byIntervals, static_cast<Index>(count / 2));
    EXPECT_LT(tally.byIntervals, static_cast<Index>(count - count / 100));
  }
}

TEST(HexCertificateExact, TheOtherCertificateKnowsKnownShapes)
{
  const auto everywhere = [](const HexCorners& corners) {
    return test::truthOf(corners).everywhere;
  };
  const HexCorners cube = test::unitCube();
  EXPECT_EQ(everywhere(cube), Truth::Positive);
  EXPECT_TRUE(test::truthOf(cube).byIntervals);
  EXPECT_EQ(everywhere(-cube), Truth::NotPositive);
  // Positive corners, negative at the centre.
  HexCorners twisted = hexOf({ -2, -0.05, 0, 2, -0.05, 0, 2, 0.05, 0, -2, 0.05, 0, //
    0.5, 1, 1, -0.5, 1, 1, -0.5, -1, 1, 0.5, -1, 1 });
  EXPECT_EQ(everywhere(twisted), Truth::NotPositive);
  EXPECT_TRUE(test::truthOf(twisted).positiveCorners);
  // Positive at corners, middles of edges and faces and at the centre, and yet not everywhere.
  EXPECT_EQ(everywhere(hexOf({ -9, -4, 1, 5, 0, -5, 10, 6, -7, 3, 19, -4, 4, -7, 4, 13, 3, 12, 6,
              13, 8, -1, 6, 9 })),
    Truth::NotPositive);
  // Corner 6 in the plane of its neighbours, then a last bit to either side.
  HexCorners flat = cube;
  flat.row(6) << 0.5, 0.5, 1.0;
  EXPECT_EQ(everywhere(flat), Truth::NotPositive);
  EXPECT_FALSE(test::truthOf(flat).byIntervals);
  flat(6, 2) = std::nextafter(1.0, 2.0);
  EXPECT_EQ(everywhere(flat), Truth::Positive);
  flat(6, 2) = std::nextafter(1.0, 0.0);
  EXPECT_EQ(everywhere(flat), Truth::NotPositive);
  // Numbers of any magnitude are exact.
  for (const int exponent : { -340, 340, -1000 })
  {
    EXPECT_EQ(everywhere(cube * std::ldexp(1.0, exponent)), Truth::Positive) << exponent;
    EXPECT_EQ(everywhere(flat * std::ldexp(1.0, exponent)), Truth::NotPositive) << exponent;
  }
}
}

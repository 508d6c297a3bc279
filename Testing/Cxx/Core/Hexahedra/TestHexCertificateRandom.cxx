// SPDX-License-Identifier: BSD-3-Clause
// Verdicts on a million hexahedra against the Jacobian at many points of each.
#include "Core/Hexahedra/HexCertificate.h"
#include "Support/HexSamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace TestHexCertificateRandom
{
using hexsweep::HexCorners;
using hexsweep::Validity;

#ifdef NDEBUG
constexpr int NumberOfHexes = 1000000;
#else
constexpr int NumberOfHexes = 50000;
#endif
constexpr std::size_t NumberOfNearest = 1000;

/// One component of the derivative in one direction at Lattice^2 points of the other two.
template <std::size_t Lattice>
using Sheet = std::array<std::array<double, Lattice>, Lattice>;

// The four edges (a, b) of one direction, a the first and b the second of the other directions.
template <std::size_t Lattice>
Sheet<Lattice> interpolated(const double (&edges)[2][2])
{
  Sheet<Lattice> sheet;
  for (std::size_t a = 0; a < Lattice; ++a)
  {
    const double s = static_cast<double>(a) / (Lattice - 1.0);
    const double low = (1.0 - s) * edges[0][0] + s * edges[1][0];
    const double high = (1.0 - s) * edges[0][1] + s * edges[1][1];
    for (std::size_t b = 0; b < Lattice; ++b)
    {
      const double t = static_cast<double>(b) / (Lattice - 1.0);
      sheet[a][b] = (1.0 - t) * low + t * high;
    }
  }
  return sheet;
}

/// The least Jacobian at Lattice^3 points: jacobianAt(), but what they share is computed once.
template <std::size_t Lattice>
double leastOnLattice(const HexCorners& x)
{
  Sheet<Lattice> u[3];
  Sheet<Lattice> v[3];
  Sheet<Lattice> w[3];
  for (int c = 0; c < 3; ++c)
  {
    const auto edge = [&](int from, int to) { return x(to, c) - x(from, c); };
    u[c] =
      interpolated<Lattice>({ { edge(0, 1), edge(4, 5) }, { edge(3, 2), edge(7, 6) } }); // v, w
    v[c] =
      interpolated<Lattice>({ { edge(0, 3), edge(1, 2) }, { edge(4, 7), edge(5, 6) } }); // w, u
    w[c] =
      interpolated<Lattice>({ { edge(0, 4), edge(3, 7) }, { edge(1, 5), edge(2, 6) } }); // u, v
  }
  std::array<double, Lattice> least;
  least.fill(std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < Lattice; ++i)
  {
    for (std::size_t k = 0; k < Lattice; ++k)
    {
      const double vx = v[0][k][i];
      const double vy = v[1][k][i];
      const double vz = v[2][k][i];
      for (std::size_t j = 0; j < Lattice; ++j)
      {
        const double wx = w[0][i][j];
        const double wy = w[1][i][j];
        const double wz = w[2][i][j];
        const double jacobian = u[0][j][k] * (vy * wz - vz * wy) +
          u[1][j][k] * (vz * wx - vx * wz) + u[2][j][k] * (vx * wy - vy * wx);
        least[j] = jacobian < least[j] ? jacobian : least[j];
      }
    }
  }
  return *std::min_element(least.begin(), least.end());
}

struct Sample
{
  HexCorners corners;
  hexsweep::HexCertificate certificate;
  /// Least value over the lattice, relative to the product of the mean edges.
  double nearness;
};

TEST(HexCertificateRandom, LatticeIsThatOfTheShapeFunctions)
{
  std::mt19937 generator(1);
  for (int n = 0; n < 100; ++n)
  {
    const HexCorners corners = test::randomHex(generator);
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (int i = 0; i < 9 * 9 * 9; ++i)
    {
      const double jacobian =
        test::jacobianAt<double>(corners, i % 9 / 8.0, i / 9 % 9 / 8.0, i / 81 / 8.0);
      least = std::min(least, jacobian);
      most = std::max(most, std::abs(jacobian));
    }
    EXPECT_NEAR(leastOnLattice<9>(corners), least, 1e-11 * most);
  }
}

TEST(HexCertificateRandom, NoVerdictIsWrong)
{
  std::mt19937 generator(2);
  std::array<int, 6> counts{};
  std::vector<Sample> certified;
  std::vector<HexCorners> invertedInside;
  for (int n = 0; n < NumberOfHexes; ++n)
  {
    const HexCorners corners = test::randomHex(generator);
    const hexsweep::HexCertificate certificate = hexsweep::certifyHex(corners);
    ++counts[static_cast<std::size_t>(certificate.validity)];
    const double least = leastOnLattice<9>(corners);
    // What the two evaluations may differ by.
    const double rounding = 1e-11 * std::abs(least);
    ASSERT_LE(certificate.jacobianLowerBound, least + rounding) << "hexahedron " << n;
    switch (certificate.validity)
    {
      case Validity::Certified:
        ASSERT_GT(least, 0.0) << "hexahedron " << n;
        ASSERT_GT(certificate.jacobianLowerBound, 0.0) << "hexahedron " << n;
        certified.push_back(
          { corners, certificate, least / test::jacobianAt<double>(corners, 0.5, 0.5, 0.5) });
        break;
      case Validity::InvertedCorner:
      {
        long double corner = 1.0L;
        for (int i = 0; i < 8; ++i)
        {
          corner =
            std::min(corner, test::jacobianAt<long double>(corners, i % 2, i / 2 % 2, i / 4));
        }
        ASSERT_LE(corner, 0.0L) << "hexahedron " << n;
        break;
      }
      case Validity::InvertedInside:
        invertedInside.push_back(corners);
        break;
      default:
        break;
    }
  }
  RecordProperty("Certified", counts[0]);
  RecordProperty("InvertedCorner", counts[1]);
  RecordProperty("InvertedInside", counts[2]);
  RecordProperty("Undecided", counts[3]);
  EXPECT_GT(counts[0], NumberOfHexes / 10);
  EXPECT_GT(counts[1], NumberOfHexes / 10);
  EXPECT_GT(counts[2], NumberOfHexes / 10000);
  EXPECT_EQ(counts[3], 0);
  EXPECT_EQ(counts[4] + counts[5], 0);

  for (const HexCorners& corners : invertedInside)
  {
    if (leastOnLattice<9>(corners) > 0.0)
    {
      EXPECT_LT(test::leastJacobian(corners, 17), 0.0) << "a valid one rejected:\n" << corners;
    }
  }

  const std::size_t nearest = std::min(NumberOfNearest, certified.size());
  std::nth_element(certified.begin(), certified.begin() + static_cast<std::ptrdiff_t>(nearest) - 1,
    certified.end(), [](const Sample& a, const Sample& b) { return a.nearness < b.nearness; });
  std::size_t loose = 0;
  for (std::size_t n = 0; n < nearest; ++n)
  {
    const Sample& sample = certified[n];
    EXPECT_GT(leastOnLattice<64>(sample.corners), 0.0) << sample.corners;
    const double least = test::leastJacobian(sample.corners, 9);
    EXPECT_GT(least, 0.0) << "a false positive:\n" << sample.corners;
    EXPECT_LE(sample.certificate.jacobianLowerBound, least);
    loose += sample.certificate.jacobianLowerBound < 0.98 * least ? 1 : 0;
  }
  // The descent is caught in a narrow valley now and then.
  EXPECT_LE(loose, nearest / 100);
}
}

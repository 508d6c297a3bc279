// SPDX-License-Identifier: BSD-3-Clause
#include "DiskFill.h"

#include <array>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Terms of the series below: the ratio of two is at most 1 / 4.
constexpr int SeriesTerms = 26;

/// Summands of zeta(2k), k > 1: enough for double precision in what it is used for.
constexpr int ZetaTerms = 1000;

std::array<double, SeriesTerms> seriesCoefficients()
{
  std::array<double, SeriesTerms> coefficients{};
  double power = 1.0; // (2 pi)^2k
  for (int k = 1; k <= SeriesTerms; ++k)
  {
    power *= 4.0 * Pi * Pi;
    double zeta = Pi * Pi / 6.0;
    if (k > 1)
    {
      // The sum, and the integral in place of what lies beyond.
      zeta = std::pow(ZetaTerms + 0.5, 1.0 - 2.0 * k) / (2.0 * k - 1.0);
      for (int n = ZetaTerms; n >= 1; --n)
      {
        zeta += std::pow(n, -2.0 * k);
      }
    }
    coefficients[static_cast<std::size_t>(k) - 1] =
      zeta / (k * power * (2.0 * k + 1.0) * (2.0 * k + 2.0));
  }
  return coefficients;
}

/**
 * sum_n (cos(n x) - 1) / n^3 for |x| < 2 pi: the function whose second derivative is
 * log |2 sin(x / 2)|. Accurate relative to its size near 0, where differences of it are taken.
 */
double secondAntiderivative(double x)
{
  static const std::array<double, SeriesTerms> coefficients = seriesCoefficients();
  x = std::abs(x);
  x = x > Pi ? 2.0 * Pi - x : x;
  if (x == 0.0)
  {
    return 0.0;
  }
  const double x2 = x * x;
  double sum = 0.0;
  for (int k = SeriesTerms; k-- > 0;)
  {
    sum = (sum + coefficients[static_cast<std::size_t>(k)]) * x2;
  }
  return x2 * (0.5 * std::log(x) - 0.75 - sum);
}

/// Arcs this much shorter than their distance: the closed form cancels more digits than the
/// expansion about their middles leaves out.
constexpr double FarArcs = 1e-2;

bool isFar(double distance, double a, double b)
{
  const double chord = FarArcs * 2.0 * std::sin(0.5 * distance);
  return a * a + b * b < chord * chord;
}

/// Mean of log |2 sin(x / 2)| between two arcs of lengths a and b, far from each other, whose
/// middles are at this distance: Taylor's polynomial of degree 5.
double farMean(double distance, double a, double b)
{
  const double s = std::sin(0.5 * distance);
  const double s2 = s * s;
  const double a2 = a * a;
  const double b2 = b * b;
  const double second = -0.25 / s2;
  const double fourth = (0.25 - 0.375 / s2) / s2;
  return std::log(2.0 * std::abs(s)) + (a2 + b2) / 24.0 * second +
    (3.0 * a2 * a2 + 10.0 * a2 * b2 + 3.0 * b2 * b2) / 5760.0 * fourth;
}
}

Eigen::MatrixXd diskFillEnergy(const std::vector<double>& angles)
{
  const Index m = static_cast<Index>(angles.size());
  const double direction = angles[1] > angles[0] ? 1.0 : -1.0;
  const auto angle = [&](Index i) {
    return direction * angles[static_cast<std::size_t>(i % m)] + (i < m ? 0.0 : 2.0 * Pi);
  };
  Eigen::MatrixXd potential(m, m);
  for (Index j = 0; j < m; ++j)
  {
    for (Index i = j; i < m; ++i)
    {
      potential(i, j) = potential(j, i) = secondAntiderivative(angle(i) - angle(j));
    }
  }
  // Twice the Dirichlet integral between two arcs on which g' is 1.
  Eigen::MatrixXd arcs(m, m);
  Eigen::VectorXd length(m);
  for (Index e = 0; e < m; ++e)
  {
    length[e] = angle(e + 1) - angle(e);
  }
  for (Index f = 0; f < m; ++f)
  {
    const Index f1 = (f + 1) % m;
    for (Index e = f; e < m; ++e)
    {
      const Index e1 = (e + 1) % m;
      const double distance = angle(e) - angle(f) + 0.5 * (length[e] - length[f]);
      const double mean = isFar(distance, length[e], length[f])
        ? farMean(distance, length[e], length[f])
        : (potential(e1, f) + potential(e, f1) - potential(e1, f1) - potential(e, f)) /
          (length[e] * length[f]);
      arcs(e, f) = arcs(f, e) = -2.0 / Pi * mean;
    }
  }
  // g' on an arc is the difference of its ends over its length (divided by above).
  Eigen::MatrixXd energy(m, m);
  for (Index j = 0; j < m; ++j)
  {
    const Index before = (j + m - 1) % m;
    for (Index i = 0; i < m; ++i)
    {
      const Index above = (i + m - 1) % m;
      energy(i, j) = arcs(i, j) + arcs(above, before) - arcs(above, j) - arcs(i, before);
    }
  }
  return energy;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "DiskFill.h"

#include "Constants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
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

bool isFar(double squaredChord, double a, double b)
{
  return a * a + b * b < FarArcs * FarArcs * squaredChord;
}

/// Mean of log |2 sin(x / 2)| between two arcs of lengths a and b, far from each other: Taylor's
/// polynomial of degree 5 about their middles.
double farMean(double squaredChord, double a, double b)
{
  const double a2 = a * a;
  const double b2 = b * b;
  const double second = -1.0 / squaredChord;
  const double fourth = (1.0 - 6.0 / squaredChord) / squaredChord;
  return 0.5 * std::log(squaredChord) + (a2 + b2) / 24.0 * second +
    (3.0 * a2 * a2 + 10.0 * a2 * b2 + 3.0 * b2 * b2) / 5760.0 * fourth;
}
}

Eigen::MatrixXd diskFillEnergy(const std::vector<double>& angles)
{
  const Index m = static_cast<Index>(angles.size());
  const double direction = angles[1] > angles[0] ? 1.0 : -1.0;
  Eigen::VectorXd node(m + 1); // the first one again at the end
  node.head(m) = direction * Eigen::Map<const Eigen::VectorXd>(angles.data(), m);
  node[m] = node[0] + 2.0 * Pi;
  const Eigen::VectorXd length = node.tail(m) - node.head(m);
  const Eigen::ArrayXd middle = node.head(m) + 0.5 * length;
  const Eigen::ArrayXd cosine = middle.cos();
  const Eigen::ArrayXd sine = middle.sin();

  // Each is asked for by four pairs of arcs, most by none.
  Eigen::MatrixXd potentials =
    Eigen::MatrixXd::Constant(m + 1, m + 1, std::numeric_limits<double>::quiet_NaN());
  const auto potential = [&](Index i, Index j) {
    double& value = potentials(std::max(i, j), std::min(i, j));
    if (std::isnan(value))
    {
      value = secondAntiderivative(node[i] - node[j]);
    }
    return value;
  };
  // Twice the Dirichlet integral between two arcs on which g' is 1.
  Eigen::MatrixXd arcs(m, m);
  for (Index f = 0; f < m; ++f)
  {
    for (Index e = f; e < m; ++e)
    {
      const double dx = cosine[e] - cosine[f];
      const double dy = sine[e] - sine[f];
      const double squaredChord = dx * dx + dy * dy;
      const double mean = isFar(squaredChord, length[e], length[f])
        ? farMean(squaredChord, length[e], length[f])
        : (potential(e + 1, f) + potential(e, f + 1) - potential(e + 1, f + 1) - potential(e, f)) /
          (length[e] * length[f]);
      arcs(e, f) = arcs(f, e) = -2.0 / Pi * mean;
    }
  }
  // g' on an arc is the difference of its ends over its length (divided by above).
  Eigen::MatrixXd energy(m, m);
  for (Index j = 0; j < m; ++j)
  {
    const Index before = j > 0 ? j - 1 : m - 1;
    for (Index i = 0; i < m; ++i)
    {
      const Index above = i > 0 ? i - 1 : m - 1;
      energy(i, j) = arcs(i, j) + arcs(above, before) - arcs(above, j) - arcs(i, before);
    }
  }
  return energy;
}
}

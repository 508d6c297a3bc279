// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/DiskFill.h"

#include "Core/Common/Constants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
/// Summands of zeta(2k), k > 1: enough for double precision in what it is used for.
constexpr int ZetaTerms = 1000;

/// Terms of the series below: the ratio of two is at most 1 / 4.
constexpr int SeriesTerms = 26;

/// Chebyshev polynomials that give the same: the ratio of two coefficients is about 1 / 14.
constexpr int ChebyshevTerms = 16;

/// sum_k zeta(2k) / (k (2k + 1) (2k + 2)) (x / 2 pi)^2k for |x| <= pi, given (x / pi)^2.
double smoothPart(double squaredTurn)
{
  double sum = 0.0;
  for (int k = SeriesTerms; k >= 1; --k)
  {
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
    sum = (sum + zeta / (k * (2.0 * k + 1.0) * (2.0 * k + 2.0))) * squaredTurn / 4.0;
  }
  return sum;
}

/// Of smoothPart() between 0 and 1.
std::array<double, ChebyshevTerms> chebyshevCoefficients()
{
  std::array<double, ChebyshevTerms> coefficients{};
  for (int j = 0; j < ChebyshevTerms; ++j)
  {
    const double angle = Pi * (j + 0.5) / ChebyshevTerms;
    const double value = smoothPart(0.5 + 0.5 * std::cos(angle));
    for (int k = 0; k < ChebyshevTerms; ++k)
    {
      coefficients[static_cast<std::size_t>(k)] +=
        (k == 0 ? 1.0 : 2.0) / ChebyshevTerms * value * std::cos(k * angle);
    }
  }
  return coefficients;
}

/**
 * sum_n (cos(n x) - 1) / n^3 for |x| <= 2 pi: the function whose second derivative is
 * log |2 sin(x / 2)|. Accurate relative to its size near 0, where differences of it are taken.
 */
Eigen::ArrayXd secondAntiderivative(const Eigen::ArrayXd& x)
{
  static const std::array<double, ChebyshevTerms> coefficients = chebyshevCoefficients();
  using Lanes = Eigen::Array<double, 8, 1>; // what one pass of the recurrence works on
  Eigen::ArrayXd result(x.size());
  for (Index begin = 0; begin < x.size(); begin += Lanes::SizeAtCompileTime)
  {
    const Index count = std::min<Index>(Lanes::SizeAtCompileTime, x.size() - begin);
    Lanes distance = Lanes::Ones();
    distance.head(count) = x.segment(begin, count).abs();
    // Where this is 0, so is the factor of the sum; the logarithm of a tiny number stands in there.
    distance = distance.min(2.0 * Pi - distance).max(std::numeric_limits<double>::min());
    const Lanes square = distance.square();
    const Lanes t = 4.0 / (Pi * Pi) * square - 2.0;
    Lanes sum = Lanes::Zero(); // Clenshaw's recurrence \cite Clenshaw1955
    Lanes before = Lanes::Zero();
    for (std::size_t k = ChebyshevTerms - 1; k > 0; --k)
    {
      const Lanes next = coefficients[k] + t * sum - before;
      before = sum;
      sum = next;
    }
    const Lanes value =
      square * (0.5 * distance.log() - 0.75 - (coefficients[0] + 0.5 * t * sum - before));
    result.segment(begin, count) = value.head(count);
  }
  return result;
}

/// Arcs this much shorter than their distance: the expansion about their middles is exact to
/// rounding.
constexpr double FarArcs = 0.14;

/// The closed form cancels more than three digits.
constexpr double VeryFarArcs = 0.02;

/// Loops of no more nodes than this have few arcs far from each other.
constexpr Index ShortLoop = 48;

/**
 * Means of log |2 sin(x / 2)| between arcs and another one, far from each other: Taylor's
 * polynomial of degree 11 about their middles. The derivatives are polynomials in 1 / chord^2; the
 * arcs' moments are those of a sum of two uniform variables.
 *
 * @param squaredChords between the middles. @param squaredLengths of the arcs.
 */
Eigen::ArrayXd farMeans(const Eigen::Ref<const Eigen::ArrayXd>& squaredChords,
  const Eigen::Ref<const Eigen::ArrayXd>& squaredLengths, double otherSquaredLength)
{
  Eigen::ArrayXd means = 0.5 * squaredChords.log();
  for (Index e = 0; e < means.size(); ++e)
  {
    const double s = squaredChords[e];
    const double q = 1.0 / s;
    // The symmetric functions of the squared lengths over the squared chord.
    const double x = q * (squaredLengths[e] + otherSquaredLength);
    const double y = q * q * squaredLengths[e] * otherSquaredLength;
    const double second = x / 12.0;
    const double fourth = x * x / 80.0 + y / 60.0;
    const double sixth = x * (x * x / 448.0 + y / 112.0);
    const double eighth = x * x * (x * x / 2304.0 + y / 288.0) + y * y / 720.0;
    const double tenth = x * (x * x * (x * x / 11264.0 + 5.0 / 4224.0 * y) + y * y / 704.0);
    means[e] += -second / 2.0 + (s - 6.0) / 24.0 * fourth -
      ((s - 30.0) * s + 120.0) / 720.0 * sixth +
      (((s - 126.0) * s + 1680.0) * s - 5040.0) / 40320.0 * eighth -
      ((((s - 510.0) * s + 17640.0) * s - 151200.0) * s + 362880.0) / 3628800.0 * tenth;
  }
  return means;
}

/// The loop's nodes, the first one again at the end, and the arcs between them.
struct Arcs
{
  Eigen::ArrayXd node;
  Eigen::ArrayXd length;
  Eigen::ArrayXd squaredLength;
  Eigen::ArrayXd cosine; // of the middle
  Eigen::ArrayXd sine;

  explicit Arcs(const std::vector<double>& angles)
    : node(static_cast<Index>(angles.size()) + 1)
  {
    const Index m = static_cast<Index>(angles.size());
    const double direction = angles[1] > angles[0] ? 1.0 : -1.0;
    this->node.head(m) = direction * Eigen::Map<const Eigen::ArrayXd>(angles.data(), m);
    this->node[m] = this->node[0] + 2.0 * Pi;
    this->length = this->node.tail(m) - this->node.head(m);
    this->squaredLength = this->length.square();
    const Eigen::ArrayXd middle = this->node.head(m) + 0.5 * this->length;
    this->cosine = middle.cos();
    this->sine = middle.sin();
  }

  double squaredChord(Index e, Index f) const
  {
    const double x = this->cosine[e] - this->cosine[f];
    const double y = this->sine[e] - this->sine[f];
    return x * x + y * y;
  }

  bool areFar(Index e, Index f, double squaredChord, double ratio) const
  {
    return this->squaredLength[e] + this->squaredLength[f] < ratio * ratio * squaredChord;
  }

  /// @param difference that of the second antiderivative at the arcs' ends.
  double mean(Index e, Index f, double difference) const
  {
    const double chord = this->squaredChord(e, f);
    return this->areFar(e, f, chord, VeryFarArcs)
      ? farMeans(Eigen::Array<double, 1, 1>(chord), this->squaredLength.segment(e, 1),
          this->squaredLength[f])[0]
      : difference / (this->length[e] * this->length[f]);
  }
};

/// Means of log |2 sin(x / 2)| between each two arcs of a short loop.
Eigen::MatrixXd meansOfShortLoop(const Arcs& arcs)
{
  const Index m = arcs.length.size();
  // Between each two nodes, in one go; column by column the lower triangle.
  Eigen::ArrayXd difference((m + 1) * (m + 2) / 2);
  Index begin = 0;
  for (Index f = 0; f <= m; ++f)
  {
    difference.segment(begin, m + 1 - f) = arcs.node.tail(m + 1 - f) - arcs.node[f];
    begin += m + 1 - f;
  }
  const Eigen::ArrayXd potential = secondAntiderivative(difference);
  Eigen::MatrixXd means(m, m);
  const double* first = potential.data(); // between node f and those from it on
  for (Index f = 0; f < m; ++f)
  {
    const double* last = first + (m + 1 - f); // between node f + 1 and those from it on
    for (Index e = f; e < m; ++e)
    {
      const Index k = e - f;
      const double crossed = k > 0 ? last[k - 1] : first[1];
      means(e, f) = arcs.mean(e, f, first[k + 1] + crossed - last[k] - first[k]);
      means(f, e) = means(e, f);
    }
    first = last;
  }
  return means;
}

/// The same between the arcs begin ... end - 1 and another one.
Eigen::ArrayXd nearMeans(const Arcs& arcs, Index begin, Index end, Index f)
{
  const Index count = end - begin;
  Eigen::ArrayXd difference(2 * count + 2);
  difference.head(count + 1) = arcs.node.segment(begin, count + 1) - arcs.node[f];
  difference.tail(count + 1) = arcs.node.segment(begin, count + 1) - arcs.node[f + 1];
  const Eigen::ArrayXd potential = secondAntiderivative(difference);
  const double* first = potential.data();
  const double* last = first + count + 1;
  Eigen::ArrayXd means(count);
  for (Index i = 0; i < count; ++i)
  {
    means[i] = arcs.mean(begin + i, f, first[i + 1] + last[i] - last[i + 1] - first[i]);
  }
  return means;
}

Eigen::MatrixXd meansOfLongLoop(const Arcs& arcs)
{
  const Index m = arcs.length.size();
  Eigen::MatrixXd means(m, m);
  Eigen::ArrayXd squaredChord(m);
  for (Index f = 0; f < m; ++f)
  {
    const Index others = m - f;
    squaredChord.tail(others) = (arcs.cosine.tail(others) - arcs.cosine[f]).square() +
      (arcs.sine.tail(others) - arcs.sine[f]).square();
    const auto isFar = [&](Index e) { return arcs.areFar(e, f, squaredChord[e], FarArcs); };
    // The far ones about the middle; what else is far is taken for near.
    Index farBegin = f + 1 + (others - 1) / 2;
    Index farEnd = farBegin;
    while (farBegin > f + 1 && isFar(farBegin - 1))
    {
      --farBegin;
    }
    while (farEnd < m && isFar(farEnd))
    {
      ++farEnd;
    }
    auto column = means.col(f).array();
    column.segment(f, farBegin - f) = nearMeans(arcs, f, farBegin, f);
    const Index far = farEnd - farBegin;
    column.segment(farBegin, far) = farMeans(squaredChord.segment(farBegin, far),
      arcs.squaredLength.segment(farBegin, far), arcs.squaredLength[f]);
    column.tail(m - farEnd) = nearMeans(arcs, farEnd, m, f);
  }
  means.triangularView<Eigen::StrictlyUpper>() = means.transpose();
  return means;
}
}

Eigen::MatrixXd diskFillEnergy(const std::vector<double>& angles)
{
  const Arcs arcs(angles);
  const Index m = arcs.length.size();
  Eigen::MatrixXd energy = m > ShortLoop ? meansOfLongLoop(arcs) : meansOfShortLoop(arcs);
  // g' on an arc is the difference of its ends over its length (divided by above). Twice the
  // Dirichlet integral between two arcs on which it is 1 is -2 / pi times their mean.
  const Eigen::VectorXd lastMeans = energy.col(m - 1);
  Eigen::VectorXd step(m);
  for (Index j = m; j-- > 0;)
  {
    step = energy.col(j) - (j > 0 ? energy.col(j - 1).eval() : lastMeans);
    step *= -2.0 / Pi;
    energy(0, j) = step[0] - step[m - 1];
    energy.col(j).tail(m - 1) = step.tail(m - 1) - step.head(m - 1);
  }
  return energy;
}
}

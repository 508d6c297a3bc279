// SPDX-License-Identifier: BSD-3-Clause
// The energy of a filled disk against Fourier series and limits in closed form.
#include "Core/DiskMaps/DiskFill.h"

#include "Support/CapMeshes.h"
#include "Support/DenseTruth.h"

#include <complex>

namespace TestDiskFill
{
using hexsweep::Index;
using test::Pi;
using Angles = std::vector<double>;

Angles evenAngles(int m, double direction = 1.0)
{
  Angles angles;
  for (int k = 0; k < m; ++k)
  {
    angles.push_back(direction * 2.0 * Pi * k / m);
  }
  return angles;
}

Angles unevenAngles(int m, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(0.02, 1.0);
  Angles angles{ -0.7 };
  double total = uniform(generator);
  for (int k = 1; k < m; ++k)
  {
    const double step = uniform(generator);
    total += step;
    angles.push_back(angles.back() + step);
  }
  for (double& angle : angles)
  {
    angle *= 2.0 * Pi / total;
  }
  return angles;
}

Eigen::VectorXd valuesAt(const Angles& angles, const std::function<double(double)>& function)
{
  Eigen::VectorXd values(static_cast<Index>(angles.size()));
  for (Index i = 0; i < values.size(); ++i)
  {
    values[i] = function(angles[static_cast<std::size_t>(i)]);
  }
  return values;
}

double energy(const Angles& angles, const Eigen::VectorXd& values)
{
  return values.dot(hexsweep::diskFillEnergy(angles) * values);
}

/**
 * Twice pi sum n |c_n|^2 over the Fourier series of the piecewise linear function.
 *
 * Two integrations by parts: its n-th coefficient is sum_k (jump of the slope at node k)
 * e^(-i n angle_k) / (-pi n^2). Beyond `terms` the phases are taken to be independent.
 */
double seriesEnergy(const Angles& angles, const Eigen::VectorXd& values, int terms)
{
  const Index m = values.size();
  const auto slope = [&](Index k) {
    const double step = angles[static_cast<std::size_t>((k + 1) % m)] -
      angles[static_cast<std::size_t>(k)] + (k + 1 == m ? 2.0 * Pi : 0.0);
    return (values[(k + 1) % m] - values[k]) / step;
  };
  Eigen::VectorXd jumps(m);
  for (Index k = 0; k < m; ++k)
  {
    jumps[k] = slope(k) - slope((k + m - 1) % m);
  }
  double sum = 0.0;
  for (int n = terms; n >= 1; --n)
  {
    std::complex<double> coefficient = 0.0;
    for (Index k = 0; k < m; ++k)
    {
      coefficient += jumps[k] * std::polar(1.0, -n * angles[static_cast<std::size_t>(k)]);
    }
    sum += std::norm(coefficient) / (Pi * Pi * n * n * static_cast<double>(n));
  }
  sum += jumps.squaredNorm() / (2.0 * Pi * Pi * terms * static_cast<double>(terms));
  return 2.0 * Pi * sum;
}

TEST(DiskFill, EqualsTheFourierSeries)
{
  std::mt19937 generator(2);
  std::normal_distribution<double> normal;
  for (const int m : { 3, 4, 7, 30 })
  {
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
      const Angles angles = unevenAngles(m, seed);
      const Eigen::VectorXd values =
        Eigen::VectorXd::NullaryExpr(m, [&] { return normal(generator); });
      const double expected = seriesEnergy(angles, values, 20000);
      EXPECT_NEAR(energy(angles, values), expected, 1e-7 * expected) << m << " nodes";
    }
  }
}

TEST(DiskFill, EqualsTheAliasedSeriesOnEvenNodes)
{
  // On m even nodes the coefficients of cos(n t) alias to n + j m and carry (sin x / x)^2,
  // x = pi (n + j m) / m.
  for (const int m : { 16, 64, 256 })
  {
    for (const int n : { 1, 2, 5 })
    {
      double expected = 0.0;
      for (int j = 100000; j >= 0; --j)
      {
        for (const int k : { n + j * m, (j + 1) * m - n })
        {
          expected += 2.0 * Pi * k * std::pow(std::sin(Pi * n / m) * m / (Pi * k), 4);
        }
      }
      const Angles angles = evenAngles(m);
      EXPECT_NEAR(energy(angles, valuesAt(angles, [n](double t) { return std::cos(n * t + 0.3); })),
        expected, 1e-10 * expected)
        << m << " nodes, n = " << n;
    }
  }
}

TEST(DiskFill, ConvergesToTheEnergyOfRToTheNTimesCosine)
{
  // Equation (2) of the function r^n cos(n t) is 2 pi n.
  for (const int n : { 1, 2, 3 })
  {
    for (const bool even : { true, false })
    {
      // Each refinement halves every arc.
      Angles angles = even ? evenAngles(20) : unevenAngles(20, 4);
      double before = 0.0;
      for (int level = 0; level < 5; ++level)
      {
        const double error =
          std::abs(energy(angles, valuesAt(angles, [n](double t) { return std::cos(n * t); })) /
              (2.0 * Pi * n) -
            1.0);
        if (level > 0)
        {
          EXPECT_GT(before / error, 3.4) << n << ", " << even << ", " << level;
          EXPECT_LT(before / error, 9.0);
        }
        before = error;
        Angles finer;
        for (std::size_t k = 0; k < angles.size(); ++k)
        {
          const double next = k + 1 < angles.size() ? angles[k + 1] : angles[0] + 2.0 * Pi;
          finer.insert(finer.end(), { angles[k], 0.5 * (angles[k] + next) });
        }
        angles = finer;
      }
    }
  }
}

TEST(DiskFill, IsSymmetricSemidefiniteAndBlindToConstants)
{
  for (const int m : { 3, 10, 80 })
  {
    const Eigen::MatrixXd matrix = hexsweep::diskFillEnergy(unevenAngles(m, 6));
    const double size = matrix.norm();
    EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-12 * size);
    EXPECT_LT(matrix.rowwise().sum().cwiseAbs().maxCoeff(), 1e-12 * size);
    const Eigen::VectorXd eigenvalues = test::eigenvalues(matrix);
    EXPECT_GT(eigenvalues[0], -1e-12 * size);
    EXPECT_GT(eigenvalues[1], 1.0 / m); // nothing else is harmonic without energy
  }
}

TEST(DiskFill, TurnsAndReflectionsChangeNothing)
{
  const Angles angles = unevenAngles(25, 3);
  const Eigen::MatrixXd expected = hexsweep::diskFillEnergy(angles);
  Angles turned = angles;
  Angles reflected = angles;
  Angles later(angles.begin() + 10, angles.end()); // begins at another node
  for (std::size_t k = 0; k < angles.size(); ++k)
  {
    turned[k] += 2.0;
    reflected[k] = -angles[k];
    if (k < 10)
    {
      later.push_back(angles[k] + 2.0 * Pi);
    }
  }
  EXPECT_LT((hexsweep::diskFillEnergy(turned) - expected).norm(), 1e-11 * expected.norm());
  EXPECT_LT((hexsweep::diskFillEnergy(reflected) - expected).norm(), 1e-14 * expected.norm());
  const Eigen::MatrixXd other = hexsweep::diskFillEnergy(later);
  for (Index i = 0; i < 25; ++i)
  {
    for (Index j = 0; j < 25; ++j)
    {
      EXPECT_NEAR(other((i + 15) % 25, (j + 15) % 25), expected(i, j), 1e-12 * expected.norm());
    }
  }
}

TEST(DiskFill, VeryShortArcs)
{
  // Up by one over an arc of length e, down again over the opposite one. The mean of
  // log |x - y| over an arc is log e - 3/2, between the arcs it is log 2.
  for (const double e : { 1e-3, 1e-6, 1e-8 })
  {
    const Angles angles{ -0.5 * e, 0.5 * e, Pi - 0.5 * e, Pi + 0.5 * e };
    const double expected = 2.0 / Pi * (2.0 * (1.5 - std::log(e)) + 2.0 * std::log(2.0));
    EXPECT_NEAR(
      energy(angles, Eigen::Vector4d(0.0, 1.0, 1.0, 0.0)), expected, e * e + 1e-15 / e + 1e-12)
      << e;
  }
}

TEST(DiskFill, AnArcThatVanishesDoesNotMatter)
{
  // A node beside another one with the same value.
  const Angles angles = unevenAngles(12, 5);
  const auto function = [](double t) { return std::sin(t) + 0.4 * std::cos(3.0 * t); };
  const Eigen::VectorXd values = valuesAt(angles, function);
  const double expected = energy(angles, values);
  for (const double e : { 1e-4, 1e-6, 1e-8 })
  {
    Angles more = angles;
    more.insert(more.begin() + 5, angles[5] - e);
    Eigen::VectorXd moreValues(13);
    moreValues << values.head(5), values[5], values.tail(7);
    EXPECT_NEAR(energy(more, moreValues), expected, 100.0 * e + 1e-8) << e;
  }
}
}

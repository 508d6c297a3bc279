// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/DiskAutomorphism.h"

#include <numeric>

namespace hexsweep
{
namespace
{
using Complex = std::complex<double>;

/// Far from the balance each step gains digits in proportion to how evenly the points lie.
constexpr int MaximumSteps = 1000;

/// Newton's steps are taken up to this length; one as short as the last squares to rounding.
constexpr double LongestNewtonStep = 0.5;
constexpr double LastNewtonStep = 1e-9;
}

DiskAutomorphism::DiskAutomorphism(const Complex& toOrigin, const Complex& turn)
  : ToOrigin(toOrigin)
  , Turn(turn)
{
}

Complex DiskAutomorphism::operator()(const Complex& z) const
{
  return this->Turn * (z - this->ToOrigin) / (1.0 - std::conj(this->ToOrigin) * z);
}

Circle DiskAutomorphism::operator()(const Circle& circle) const
{
  const Complex c(circle.center.x(), circle.center.y());
  const double r = circle.radius;
  // The image's centre is the image of the pole's mirror image in the circle.
  const Complex center =
    (*this)(c + r * r * this->ToOrigin / (1.0 - this->ToOrigin * std::conj(c)));
  return { { center.real(), center.imag() }, std::abs((*this)(c + r) - center) };
}

double DiskAutomorphism::turnAt(const Complex& z) const
{
  // On the circle (z - a) / (1 - conj(a) z) is z w / conj(w) with this w in the right half plane.
  const Complex w = 1.0 - this->ToOrigin * std::conj(z);
  return 2.0 * std::atan2(w.imag(), w.real()) + std::arg(this->Turn);
}

std::vector<Complex> pointsAt(const std::vector<double>& angles)
{
  std::vector<Complex> points;
  points.reserve(angles.size());
  for (const double angle : angles)
  {
    points.push_back(std::polar(1.0, angle));
  }
  return points;
}

DiskAutomorphism balancingMap(
  const std::vector<Complex>& points, const std::vector<double>& weights)
{
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  Complex toOrigin = 0.0;
  for (int step = 0; step < MaximumSteps; ++step)
  {
    Complex mean = 0.0;
    Complex square = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      // As in turnAt(); std::complex would check each product and quotient for infinities.
      const double x = points[i].real();
      const double y = points[i].imag();
      const double u = 1.0 - toOrigin.real() * x - toOrigin.imag() * y;
      const double v = toOrigin.real() * y - toOrigin.imag() * x;
      const double norm = u * u + v * v;
      const double c = (u * u - v * v) / norm;
      const double s = 2.0 * u * v / norm;
      const Complex z(x * c - y * s, x * s + y * c);
      mean += weights[i] * z;
      square +=
        weights[i] * Complex(z.real() * z.real() - z.imag() * z.imag(), 2.0 * z.real() * z.imag());
    }
    mean /= total;
    square /= total;
    // Newton's step solves mean - a + square conj(a) = 0; the mean itself is a safe one.
    const Complex newton = (mean + square * std::conj(mean)) / (1.0 - std::norm(square));
    const Complex next = std::abs(newton) < LongestNewtonStep ? newton : mean;
    toOrigin = (next + toOrigin) / (1.0 + std::conj(toOrigin) * next);
    if (std::abs(newton) <= LastNewtonStep)
    {
      break;
    }
  }
  return { toOrigin, 1.0 };
}

DiskAutomorphism balancingMap(const std::vector<double>& angles, const std::vector<double>& weights)
{
  return balancingMap(pointsAt(angles), weights);
}
}

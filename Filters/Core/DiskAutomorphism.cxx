// SPDX-License-Identifier: BSD-3-Clause
#include "DiskAutomorphism.h"

#include <limits>
#include <numeric>

namespace hexsweep
{
namespace
{
using Complex = std::complex<double>;

/// Steps towards the balance: each gains digits in proportion to how evenly the points lie.
constexpr int MaximumSteps = 1000;
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

DiskAutomorphism balancingMap(const std::vector<double>& angles, const std::vector<double>& weights)
{
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  Complex toOrigin = 0.0;
  for (int step = 0; step < MaximumSteps; ++step)
  {
    const DiskAutomorphism map(toOrigin, 1.0);
    Complex mean = 0.0;
    for (std::size_t i = 0; i < angles.size(); ++i)
    {
      mean += weights[i] / total * map(std::polar(1.0, angles[i]));
    }
    toOrigin = (mean + toOrigin) / (1.0 + std::conj(toOrigin) * mean);
    if (std::abs(mean) <= std::numeric_limits<double>::epsilon())
    {
      break;
    }
  }
  return { toOrigin, 1.0 };
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexLoss.h"

#include <cmath>

namespace hexsweep
{
HexLoss::Place HexLoss::at(double x) const
{
  const double k = this->sharpness;
  if (k == 0.0)
  {
    return { (1.0 - x) * (1.0 - x), -2.0 * (1.0 - x), 2.0 };
  }
  const double t = k * (this->middle - x);
  if (t > 0.0)
  {
    return { 1.0 + t + 0.5 * t * t, -k * (1.0 + t), k * k };
  }
  const double value = std::exp(t);
  return { value, -k * value, k * k * value };
}
}

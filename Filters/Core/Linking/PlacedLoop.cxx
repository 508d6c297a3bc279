// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/PlacedLoop.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
Eigen::RowVector3d LoopPlace::between(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b) const
{
  return this->fraction == 1.0 ? b : a + this->fraction * (b - a);
}

LoopPlace placeOnLoop(const std::vector<double>& values, double v)
{
  const std::size_t n = values.size();
  double turned = v - std::floor(v - values.front());
  turned -= turned >= values.front() + 1.0 ? 1.0 : 0.0;
  const std::size_t after = static_cast<std::size_t>(
    std::upper_bound(values.begin(), values.end(), turned) - values.begin());
  LoopPlace place;
  place.edge = after == 0 ? 0 : after - 1;
  const double next = place.edge + 1 < n ? values[place.edge + 1] : values[0] + 1.0;
  place.fraction =
    std::min(1.0, std::max(0.0, (turned - values[place.edge]) / (next - values[place.edge])));
  constexpr double Rounding = 1e-9;
  place.fraction = place.fraction < Rounding ? 0.0 : place.fraction;
  place.fraction = place.fraction > 1.0 - Rounding ? 1.0 : place.fraction;
  return place;
}

double valueAt(const std::vector<double>& values, double place)
{
  const std::size_t n = values.size();
  const std::size_t edge = static_cast<std::size_t>(std::floor(place)) % n;
  const double fraction = place - std::floor(place);
  const double next = edge + 1 < n ? values[edge + 1] : values[0] + 1.0;
  return fraction == 0.0 ? values[edge] : values[edge] + fraction * (next - values[edge]);
}
}

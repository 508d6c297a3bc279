// SPDX-License-Identifier: BSD-3-Clause

#include "Support/SideTubes.h"

#include <random>

namespace test
{
SideTube tube(Index around, Index along, const TubePlace& place,
  const std::function<Index(double v, double u)>& faceOf, double shake)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> random(-shake, shake);
  SideTube side;
  side.surface.points.resize(around * (along + 1), 3);
  side.surface.triangles.resize(2 * around * along, 3);
  for (Index k = 0; k <= along; ++k)
  {
    for (Index j = 0; j < around; ++j)
    {
      const bool isInside = k > 0 && k < along;
      const double v = (static_cast<double>(j) + (isInside ? random(generator) : 0.0)) /
        static_cast<double>(around);
      const double u = (static_cast<double>(k) + (isInside ? random(generator) : 0.0)) /
        static_cast<double>(along);
      side.surface.points.row(k * around + j) = place(v, u);
    }
  }
  for (Index k = 0; k < along; ++k)
  {
    for (Index j = 0; j < around; ++j)
    {
      const Index a = k * around + j;
      const Index b = k * around + (j + 1) % around;
      const Index row = 2 * (k * around + j);
      side.surface.triangles.row(row) << a, b, b + around;
      side.surface.triangles.row(row + 1) << a, b + around, a + around;
      if (faceOf)
      {
        const Index face = faceOf((static_cast<double>(j) + 0.5) / static_cast<double>(around),
          (static_cast<double>(k) + 0.5) / static_cast<double>(along));
        side.faceIds.insert(side.faceIds.end(), 2, face);
      }
    }
  }
  for (Index j = 0; j < around; ++j)
  {
    side.sourceLoop.push_back(j);
  }
  return side;
}
}

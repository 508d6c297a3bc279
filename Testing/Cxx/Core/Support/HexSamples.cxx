// SPDX-License-Identifier: BSD-3-Clause

#include "Support/HexSamples.h"

namespace test
{
HexCorners unitCube()
{
  HexCorners corners;
  corners << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  return corners;
}

HexCorners shakenCube(double amplitude, std::mt19937& generator)
{
  std::uniform_real_distribution<double> shake(-amplitude, amplitude);
  HexCorners corners = unitCube();
  for (int i = 0; i < 24; ++i)
  {
    corners(i / 3, i % 3) += shake(generator);
  }
  return corners;
}

HexCorners randomHex(std::mt19937& generator)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto corners = shakenCube(0.7 * uniform(generator), generator);
  Eigen::Vector3d stretch;
  Eigen::Vector3d axis;
  Eigen::RowVector3d place;
  for (int i = 0; i < 3; ++i)
  {
    stretch[i] = std::pow(10.0, 4.0 * uniform(generator) - 2.0);
    axis[i] = uniform(generator) - 0.5;
    place[i] = 1000.0 * (uniform(generator) - 0.5);
  }
  const Eigen::AngleAxisd turn(6.0 * uniform(generator), axis.normalized());
  const Eigen::Matrix3d matrix = turn.toRotationMatrix() * stretch.asDiagonal();
  return (corners * matrix.transpose()).rowwise() + place;
}

double leastJacobian(const HexCorners& corners, int points)
{
  double best[3] = { 0.0, 0.0, 0.0 };
  long double least = jacobianAt<long double>(corners, 0.0, 0.0, 0.0);
  const auto attempt = [&](double u, double v, double w) {
    const long double value = jacobianAt<long double>(corners, u, v, w);
    if (value < least)
    {
      least = value;
      best[0] = u;
      best[1] = v;
      best[2] = w;
      return true;
    }
    return false;
  };
  for (int i = 0; i < points * points * points; ++i)
  {
    const double last = points - 1;
    attempt(i % points / last, i / points % points / last, i / points / points / last);
  }
  for (double step = 0.5 / points; step > 1e-7; step *= 0.5)
  {
    bool better = true;
    while (better)
    {
      better = false;
      const double from[3] = { best[0], best[1], best[2] };
      for (int i = 0; i < 27; ++i)
      {
        const auto moved = [step](double at, int direction) {
          return std::clamp(at + (direction - 1) * step, 0.0, 1.0);
        };
        better |= attempt(moved(from[0], i % 3), moved(from[1], i / 3 % 3), moved(from[2], i / 9));
      }
    }
  }
  return static_cast<double>(least);
}
}

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Linking sides of known shape: places in space of the strip's v (round the tube) and u.
 */
#ifndef SideTubes_h
#define SideTubes_h

#include "Core/Linking/SideStrip.h"

#include <cmath>
#include <functional>

namespace test
{
using hexsweep::Index;
using hexsweep::SideTube;
using TubePlace = std::function<Eigen::RowVector3d(double v, double u)>;

constexpr double TwoPi = 6.283185307179586;

/// A tube of `around` x `along` pairs of triangles, point k * around + j at v = j / around,
/// u = k / along; inner points shaken in the parameters. The source loop is the one at u = 0.
/// faceOf(v, u) of the middle of a pair gives its face.
SideTube tube(Index around, Index along, const TubePlace& place,
  const std::function<Index(double v, double u)>& faceOf = {}, double shake = 0.0);

/// Radius 1, height 3.
inline Eigen::RowVector3d Cylinder(double v, double u)
{
  return { std::cos(TwoPi * v), std::sin(TwoPi * v), 3.0 * u };
}
}

#endif

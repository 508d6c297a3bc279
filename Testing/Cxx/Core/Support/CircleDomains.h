// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangulated disks with circular holes, of any fineness.
 */
#ifndef CircleDomains_h
#define CircleDomains_h

#include "Core/DiskMaps/FilledDiskMap.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace test
{
using hexsweep::Circle;

/// The unit disk without open disks. Points: the unit circle's, hole by hole, the others.
struct CircleDomain
{
  std::vector<Circle> holes;
  hexsweep::TriangleMesh mesh;     ///< z = 0; nodes of the loops exactly on their circles
  std::vector<std::size_t> circle; ///< of each point: 0 the unit circle, 1 + h a hole, or Inside
  static constexpr std::size_t Inside = static_cast<std::size_t>(-1);
};

/// Delaunay triangulation of points within the unit circle (A. Bowyer, "Computing Dirichlet
/// tessellations", 1981), counter-clockwise; quadratic in time.
std::vector<std::array<hexsweep::Index, 3>> delaunay(std::vector<Eigen::RowVector2d> points);

/**
 * A circle domain with edges of about `spacing`; at least `around` of them on each circle, and
 * growing from there.
 */
CircleDomain circleDomain(
  const std::vector<Circle>& holes, double spacing, int around = 12, unsigned seed = 1);

/// Every triangle in four; new nodes of the loops are put onto their circles.
CircleDomain refined(const CircleDomain& coarse);

/// Points (x, y, 0) moved by a map of the plane.
hexsweep::Points warped(
  hexsweep::Points points, const std::function<std::complex<double>(std::complex<double>)>& map);

/// The plane on the unit sphere, conformally: the inverse of the stereographic projection.
hexsweep::Points onSphere(hexsweep::Points points);

/// Holes of many sizes that keep clear of each other and of the rim, by chance.
std::vector<Circle> scatteredHoles(std::size_t count, double smallest, double largest);

std::vector<Circle> oneRoundHole();
std::vector<Circle> threeRoundHoles();
std::vector<Circle> eightRoundHoles();

/// Centre and radius of one circle after the other.
Eigen::VectorXd coordinatesOf(const std::vector<Circle>& circles);

inline std::complex<double> complexOf(const Eigen::RowVector2d& p)
{
  return { p.x(), p.y() };
}
}

#endif

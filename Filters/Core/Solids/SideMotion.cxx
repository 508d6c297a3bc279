// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SideMotion.h"

#include "Core/Common/DenseAlgebra.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
/// Of the faces' lines, by area.
class MeanLines
{
public:
  void add(const FaceShape& face)
  {
    this->Sum += face.area * face.lines;
    this->Area += face.area;
  }

  NormalLines mean() const { return this->Sum / this->Area; }

private:
  NormalLines Sum = NormalLines::Zero();
  double Area = 0.0;
};

/// The mean velocity outward through a cap.
double flowThrough(
  const FaceGraph& graph, const CapCandidate& cap, const Eigen::Matrix<double, 6, 1>& motion)
{
  double flow = 0.0;
  for (const std::size_t f : cap.faces)
  {
    const FaceShape& face = graph.faces[f];
    flow += face.area * (face.normal.dot(motion.head<3>()) + face.moment.dot(motion.tail<3>()));
  }
  return flow / cap.area;
}

/// Of the first coordinates of all motions: three are shifts alone.
SideMotion bestMotion(const FaceGraph& graph, const NormalLines& across, const NormalLines& through,
  const CapCandidate& source, const CapCandidate& target, Index coordinates)
{
  // Motions that neither crosses, as the turning of a cylinder, are not to be taken along.
  constexpr double Idle = 1e-9;
  const auto part = [&](const NormalLines& lines) -> Eigen::MatrixXd {
    return lines.topLeftCorner(coordinates, coordinates);
  };
  const GeneralizedAxes axes = generalizedAxes(part(through),
    part(across + through) + Idle * Eigen::MatrixXd::Identity(coordinates, coordinates));
  if (axes.vectors.cols() != coordinates)
  {
    return { {}, std::numeric_limits<double>::infinity() }; // faces without area
  }
  Eigen::Matrix<double, 6, 1> best = Eigen::Matrix<double, 6, 1>::Zero();
  best.head(coordinates) = axes.vectors.col(coordinates - 1);
  const double crossed = best.dot(through * best);
  // What comes in by one end of a tube has not gone from cap to cap.
  constexpr double OneWay = 0.5;
  const double in = -flowThrough(graph, source, best) / std::sqrt(crossed);
  const double out = flowThrough(graph, target, best) / std::sqrt(crossed);
  const bool goesThrough = std::min(in, out) > OneWay || std::max(in, out) < -OneWay;
  return { { graph.center, best.head<3>().transpose(), best.tail<3>().transpose() / graph.radius },
    goesThrough ? best.dot(across * best) / crossed : std::numeric_limits<double>::infinity() };
}
}

SideMotion findSideMotion(const FaceGraph& graph, const std::vector<char>& isSide,
  const CapCandidate& source, const CapCandidate& target)
{
  MeanLines sides;
  for (std::size_t f = 0; f < isSide.size(); ++f)
  {
    if (isSide[f])
    {
      sides.add(graph.faces[f]);
    }
  }
  MeanLines caps;
  for (const CapCandidate* cap : { &source, &target })
  {
    for (const std::size_t face : cap->faces)
    {
      caps.add(graph.faces[face]);
    }
  }
  const auto best = [&, across = sides.mean(), through = caps.mean()](Index coordinates) {
    return bestMotion(graph, across, through, source, target, coordinates);
  };
  // The facets of a cylinder may lie along a screw a little better than along its axis.
  constexpr double Straight = 1e-3;
  constexpr double Alike = 2.0;
  SideMotion shift = best(3);
  if (shift.slip <= Straight)
  {
    return shift;
  }
  SideMotion any = best(6);
  return shift.slip <= Alike * any.slip ? shift : any;
}
}

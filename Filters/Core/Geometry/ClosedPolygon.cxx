// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/ClosedPolygon.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/LoopGeometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr double CornerAngle = Pi / 6.0;
constexpr double ShortestEdge = 1e-6; // of the loop
/// Half the length of a fillet that counts as one corner, of the loop.
constexpr double FilletReach = 0.005;
constexpr double SamePlace = 1e-12; // of the loop

double angleBetween(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Distance of two places along the loop, as a fraction of its length.
double apart(double a, double b)
{
  return std::abs(std::remainder(a - b, 1.0));
}
}

ClosedPolygon::ClosedPolygon(Points nodes)
  : Nodes(std::move(nodes))
  , Reached(reachedLengths(Nodes))
{
  if (!(this->length() > 0.0))
  {
    throw InvalidInput("a boundary loop has no length: its " + std::to_string(this->Nodes.rows()) +
      " nodes coincide at " + describe(this->Nodes.row(0)) + ". Remove the collapsed cells there.");
  }
}

double ClosedPolygon::fraction(Index node) const
{
  return this->Reached[static_cast<std::size_t>(node)] / this->length();
}

Eigen::RowVector3d ClosedPolygon::center() const
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (Index i = 0; i < this->Nodes.rows(); ++i)
  {
    const Index next = (i + 1) % this->Nodes.rows();
    const double edge =
      this->Reached[static_cast<std::size_t>(i) + 1] - this->Reached[static_cast<std::size_t>(i)];
    sum += 0.5 * edge * (this->Nodes.row(i) + this->Nodes.row(next));
  }
  return sum / this->length();
}

ClosedPolygon::Place ClosedPolygon::locate(double fraction) const
{
  const double along = (fraction - std::floor(fraction)) * this->length();
  const auto above = std::upper_bound(this->Reached.begin() + 1, this->Reached.end() - 1, along);
  const std::size_t edge = static_cast<std::size_t>(above - this->Reached.begin()) - 1;
  const double rounding = SamePlace * this->length();
  const double begin = this->Reached[edge];
  const double end = this->Reached[edge + 1];
  const Index a = static_cast<Index>(edge);
  if (along - begin <= rounding)
  {
    return { a, 0.0 };
  }
  return { a, end - along <= rounding ? 1.0 : (along - begin) / (end - begin) };
}

Eigen::RowVector3d ClosedPolygon::at(double fraction) const
{
  const Place place = this->locate(fraction);
  const Index next = (place.edge + 1) % this->Nodes.rows();
  return (1.0 - place.along) * this->Nodes.row(place.edge) + place.along * this->Nodes.row(next);
}

Eigen::RowVector3d ClosedPolygon::direction(double fraction) const
{
  const Index edge = this->locate(fraction).edge;
  return (this->Nodes.row((edge + 1) % this->Nodes.rows()) - this->Nodes.row(edge)).normalized();
}

std::vector<Index> loopCorners(const ClosedPolygon& loop)
{
  // The nodes that have an edge ahead.
  std::vector<Index> nodes;
  for (Index i = 0; i < loop.nodes().rows(); ++i)
  {
    const Index next = (i + 1) % loop.nodes().rows();
    if ((loop.nodes().row(next) - loop.nodes().row(i)).norm() > ShortestEdge * loop.length())
    {
      nodes.push_back(i);
    }
  }
  const std::size_t n = nodes.size();
  std::vector<Index> corners;
  std::vector<double> rounded(n, 0.0); // turn from chord to chord, where it may be a fillet
  for (std::size_t k = 0; k < n; ++k)
  {
    const Eigen::RowVector3d here = loop.nodes().row(nodes[k]);
    const Eigen::RowVector3d back = here - loop.nodes().row(nodes[(k + n - 1) % n]);
    const Eigen::RowVector3d ahead = loop.nodes().row(nodes[(k + 1) % n]) - here;
    if (angleBetween(back, ahead) > CornerAngle)
    {
      corners.push_back(nodes[k]);
      continue;
    }
    const double place = loop.fraction(nodes[k]);
    const double turn =
      angleBetween(here - loop.at(place - FilletReach), loop.at(place + FilletReach) - here);
    rounded[k] = turn > CornerAngle ? turn : 0.0;
  }
  const std::size_t sharp = corners.size();
  for (std::size_t k = 0; k < n; ++k)
  {
    const double place = loop.fraction(nodes[k]);
    bool highest = rounded[k] > 0.0;
    for (std::size_t c = 0; c < sharp && highest; ++c)
    {
      highest = apart(loop.fraction(corners[c]), place) > 2.0 * FilletReach;
    }
    // Neighbours on both sides; the first of several that turn equally is taken.
    for (std::size_t step = 1; step < n && highest; ++step)
    {
      const std::size_t before = (k + n - step) % n;
      const bool near = apart(loop.fraction(nodes[before]), place) <= 2.0 * FilletReach;
      highest = !near || rounded[before] < rounded[k] * (1.0 - 1e-9);
      if (!near)
      {
        break;
      }
    }
    for (std::size_t step = 1; step < n && highest; ++step)
    {
      const std::size_t after = (k + step) % n;
      const bool near = apart(loop.fraction(nodes[after]), place) <= 2.0 * FilletReach;
      highest = !near || rounded[after] <= rounded[k] * (1.0 + 1e-9);
      if (!near)
      {
        break;
      }
    }
    if (highest)
    {
      corners.push_back(nodes[k]);
    }
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}
}

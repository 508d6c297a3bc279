// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/LoopFit.h"

#include "Core/Geometry/AffineMap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
double LoopAnchors::operator()(double place) const
{
  const std::size_t n = this->source.size();
  const double from = this->source.front();
  const double s = from + (place - from - std::floor(place - from));
  const auto above = std::upper_bound(this->source.begin(), this->source.end(), s);
  const std::size_t k = static_cast<std::size_t>(above - this->source.begin()) - 1;
  const bool last = k + 1 == n;
  const double sEnd = last ? from + 1.0 : this->source[k + 1];
  const double tEnd = last ? this->target.front() + 1.0 : this->target[k + 1];
  const double t = (s - this->source[k]) / (sEnd - this->source[k]);
  return (1.0 - t) * this->target[k] + t * tEnd;
}

LoopFit::LoopFit(
  const ClosedPolygon& source, const ClosedPolygon& target, const Eigen::Matrix3d& linear)
  : Source(source)
  , Target(target)
  , Linear(linear.transpose())
  , SourceCenter(source.center())
  , TargetCenter(target.center())
  , Samples(std::clamp<Index>(2 * source.nodes().rows(), 128, 512))
{
  const ClosedPolygon moved(source.nodes() * this->Linear);
  this->Linear *= target.length() / moved.length();
  double squared = 0.0;
  for (Index i = 0; i < this->Samples; ++i)
  {
    squared += (target.at(this->sample(i)) - this->TargetCenter).squaredNorm();
    this->Places.push_back(this->movedPlace(this->sample(i)));
    this->Directions.push_back(this->movedDirection(this->sample(i)));
  }
  this->SquaredRadius = squared / static_cast<double>(this->Samples);
}

double LoopFit::sample(Index i) const
{
  return (static_cast<double>(i) + 0.5) / static_cast<double>(this->Samples);
}
Eigen::RowVector3d LoopFit::movedPlace(double s) const
{
  return this->TargetCenter + (this->Source.at(s) - this->SourceCenter) * this->Linear;
}
Eigen::RowVector3d LoopFit::movedDirection(double s) const
{
  return (this->Source.direction(s) * this->Linear).normalized();
}
double LoopFit::costAt(
  const Eigen::RowVector3d& place, const Eigen::RowVector3d& direction, double t) const
{
  return (this->Target.direction(t) - direction).squaredNorm() +
    (this->Target.at(t) - place).squaredNorm() / this->SquaredRadius;
}

double LoopFit::straightCost(double start) const
{
  double sum = 0.0;
  for (Index i = 0; i < this->Samples; ++i)
  {
    const std::size_t k = static_cast<std::size_t>(i);
    sum += this->costAt(this->Places[k], this->Directions[k], start + this->sample(i));
  }
  return sum / static_cast<double>(this->Samples);
}

double LoopFit::pieceCost(double s, double sLength, double t, double tLength) const
{
  const Index count =
    std::max<Index>(3, static_cast<Index>(std::ceil(sLength * static_cast<double>(this->Samples))));
  double sum = 0.0;
  for (Index i = 0; i < count; ++i)
  {
    const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double place = s + u * sLength;
    sum += this->costAt(this->movedPlace(place), this->movedDirection(place), t + u * tLength);
  }
  return sLength * sum / static_cast<double>(count);
}

double LoopFit::cornerCost(double s, double t) const
{
  constexpr double Beside = 1e-3; // of the loop: on the edges that meet in the corner
  double cost = 0.0;
  for (const double side : { -Beside, Beside })
  {
    cost += this->costAt(this->movedPlace(s + side), this->movedDirection(s + side), t + side);
  }
  return cost;
}

double LoopFit::alignedCost(const LoopAnchors& anchors) const
{
  if (anchors.source.empty())
  {
    return std::numeric_limits<double>::infinity();
  }
  Points from(this->Samples, 3);
  Points to(this->Samples, 3);
  for (Index i = 0; i < this->Samples; ++i)
  {
    from.row(i) = this->Source.at(this->sample(i));
    to.row(i) = this->Target.at(anchors(this->sample(i)));
  }
  const AffineMap map =
    fitAffineMap(from, to, areaVector(this->Source.nodes()), areaVector(this->Target.nodes()));
  const Points fitted = map.apply(from);
  double sum = 0.0;
  for (Index i = 0; i < this->Samples; ++i)
  {
    const Eigen::RowVector3d direction =
      this->Source.direction(this->sample(i)) * map.linear.transpose();
    sum += this->costAt(fitted.row(i), direction.normalized(), anchors(this->sample(i)));
  }
  return sum / static_cast<double>(this->Samples);
}

double LoopFit::shiftOf(const LoopAnchors& anchors) const
{
  // Unwrapped: the places rise from that of the first anchor, once round.
  double sum = 0.0;
  const double from = anchors.source.front();
  for (Index i = 0; i < this->Samples; ++i)
  {
    const double s = from + this->sample(i);
    sum += anchors(s) - s;
  }
  const double shift = sum / static_cast<double>(this->Samples);
  return shift - std::floor(shift);
}
}

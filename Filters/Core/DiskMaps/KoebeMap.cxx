// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/KoebeMap.h"

#include "Core/Common/DenseAlgebra.h"
#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/DiskMaps/ConformalAnnulus.h"
#include "Core/DiskMaps/DiskAutomorphism.h"
#include "Core/DiskMaps/DiskDomain.h"
#include "Core/DiskMaps/GluedSphere.h"
#include "Core/Geometry/LoopGeometry.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace hexsweep
{
namespace
{
/// Changes of the angles within a round.
constexpr int ChangesPerRound = 2;

/// Changes of the angles above this many radians tell nothing about the next ones.
constexpr double SettledAngle = 0.02;

/// Former changes from which the next one is extrapolated.
constexpr std::size_t AndersonMemory = 4;

/// Share of each neighbour in the overshoot. Best of those tried on 37 and 40 holes.
constexpr double OvershootSmoothing = 0.1;

using Complex = std::complex<double>;
using Angles = std::vector<double>;

/// Length of the loop's edges that belongs to each node: half of the two at it.
std::vector<double> nodeLengths(const PointsRef& points, const Loop& loop)
{
  std::vector<double> lengths(loop.size(), 0.0);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const std::size_t j = (i + 1) % loop.size();
    const double length = (points.row(loop[j]) - points.row(loop[i])).norm();
    lengths[i] += 0.5 * length;
    lengths[j] += 0.5 * length;
  }
  return lengths;
}

/// Appends an angle to those along a loop, less the whole turns that it is away from the last one.
void appendUnwrapped(Angles& angles, double angle)
{
  angles.push_back(angles.empty() ? angle : angles.back() + wrapAngle(angle - angles.back()));
}

/// Angles that a Moebius map of the disk balances, turned as a whole towards a reference.
/// @param points at the angles.
Angles balanced(const Angles& angles, const std::vector<Complex>& points,
  const std::vector<double>& weights, const Angles& reference)
{
  const DiskAutomorphism map = balancingMap(points, weights);
  Angles result = angles;
  double turn = 0.0;
  double total = 0.0;
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    result[i] += map.turnAt(points[i]);
    turn += weights[i] * (result[i] - reference[i]);
    total += weights[i];
  }
  for (double& angle : result)
  {
    angle -= turn / total;
  }
  return result;
}

//--------------------------------------------------------------------------------------------------
/// The image of a loop: its circle, and the nodes' angles about the centre.
struct LoopImage
{
  Circle circle;
  Angles angles;               // unwrapped along the loop
  std::vector<Complex> points; // of the unit circle at these angles
  double circularity = 0.0;
};

LoopImage fitCircle(const PlanePoints& image, const std::vector<double>& weights)
{
  // |z|^2 = 2 Re(conj(c) z) + (r^2 - |c|^2) is linear in c and in the bracket. Shifted and scaled
  // to the loop itself, so that small holes lose no digits.
  const Eigen::RowVector2d origin = image.row(0);
  double size = 0.0;
  for (Index i = 0; i < image.rows(); ++i)
  {
    size = std::max(size, (image.row(i) - origin).norm());
  }
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (Index i = 0; i < image.rows(); ++i)
  {
    const double weight = weights[static_cast<std::size_t>(i)];
    const Eigen::RowVector2d p = (image.row(i) - origin) / size;
    const Eigen::Vector3d row(2.0 * p.x(), 2.0 * p.y(), 1.0);
    normal += weight * row * row.transpose();
    right += weight * p.squaredNorm() * row;
  }
  const Eigen::Vector3d fit = leastSquares(normal, right);
  LoopImage result;
  result.circle.center = origin + size * fit.head<2>().transpose();
  result.circle.radius = size * std::sqrt(fit[2] + fit.head<2>().squaredNorm());
  for (Index i = 0; i < image.rows(); ++i)
  {
    const Eigen::RowVector2d arm = image.row(i) - result.circle.center;
    appendUnwrapped(result.angles, std::atan2(arm.y(), arm.x()));
    result.points.emplace_back(arm.x() / arm.norm(), arm.y() / arm.norm());
    result.circularity =
      std::max(result.circularity, std::abs(arm.norm() / result.circle.radius - 1.0));
  }
  return result;
}

/// A circle in the plane where another one is the unit circle.
Circle relativeTo(const Circle& unit, const Circle& circle)
{
  return { (circle.center - unit.center) / unit.radius, circle.radius / unit.radius };
}

//--------------------------------------------------------------------------------------------------
class KoebeIteration
{
public:
  KoebeIteration(
    const PointsRef& points, const SparseMatrix& laplacian, const std::vector<Loop>& loops)
    : Loops(loops)
    , Sphere(laplacian, loops, points)
  {
    for (const Loop& loop : loops)
    {
      Angles angles = arcLengthAngles(loopPoints(points, loop));
      for (double& angle : angles)
      {
        angle *= this->direction(this->Gluing.size());
      }
      this->Weights.push_back(nodeLengths(points, loop));
      this->Gluing.push_back(balanced(angles, pointsAt(angles), this->Weights.back(), angles));
    }
  }

  KoebeRound round()
  {
    for (int change = 0; change < ChangesPerRound; ++change)
    {
      if (!this->Images.empty())
      {
        this->changeGluing();
      }
      this->Sphere.map(this->Gluing);
      this->Images.clear();
      for (std::size_t p = 0; p < this->Loops.size(); ++p)
      {
        this->Images.push_back(fitCircle(this->Sphere.image(p), this->Weights[p]));
      }
    }
    const DiskAutomorphism map = this->normalization();
    KoebeRound round;
    for (std::size_t p = 1; p < this->Images.size(); ++p)
    {
      round.holes.push_back(map(relativeTo(this->Images[0].circle, this->Images[p].circle)));
    }
    return round;
  }

  /// The nodes of a loop on the given circle, in the normalised disk.
  PlanePoints places(std::size_t p, const Circle& onto) const
  {
    const DiskAutomorphism map = this->normalization();
    const Circle circle = relativeTo(this->Images[0].circle, this->Images[p].circle);
    PlanePoints result = circlePoints(circle, this->Images[p].angles);
    for (Index i = 0; i < result.rows(); ++i)
    {
      const Complex z = map({ result(i, 0), result(i, 1) });
      const Eigen::RowVector2d arm = Eigen::RowVector2d(z.real(), z.imag()) - onto.center;
      result.row(i) = onto.center + onto.radius * arm.normalized();
    }
    return result;
  }

  /// Whether the nodes of a loop come one after the other on its circle.
  bool isInOrder(std::size_t p) const { return turnsOnce(this->Images[p].angles, direction(p)); }

  double circularity(std::size_t p) const { return this->Images[p].circularity; }

private:
  /// Of the angles along a loop: the surface lies on its left.
  static double direction(std::size_t loop) { return loop == 0 ? 1.0 : -1.0; }

  DiskAutomorphism normalization() const
  {
    const std::vector<Complex>& outer = this->Images[0].points;
    const DiskAutomorphism map = balancingMap(outer, this->Weights[0]);
    const Complex first = map(outer[0]);
    return map.turned(std::conj(first) / std::abs(first));
  }

  /// Where a loop should be glued next, going by its image alone.
  Angles proposal(std::size_t p) const
  {
    const Angles& now = this->Gluing[p];
    const Angles target =
      balanced(this->Images[p].angles, this->Images[p].points, this->Weights[p], now);
    const std::size_t m = now.size();
    const auto error = [&](std::size_t i) { return target[i % m] - now[i % m]; };
    for (double overshoot = 1.0; overshoot > 0.01; overshoot *= 0.5)
    {
      Angles next(m);
      for (std::size_t i = 0; i < m; ++i)
      {
        next[i] = target[i] +
          overshoot *
            ((1.0 - 2.0 * OvershootSmoothing) * error(i) +
              OvershootSmoothing * (error(i + 1) + error(i + m - 1)));
      }
      if (turnsOnce(next, direction(p)))
      {
        return next;
      }
    }
    // The image itself is folded: part of the way is open.
    for (double share = 1.0; share > 0.01; share *= 0.5)
    {
      Angles next(m);
      for (std::size_t i = 0; i < m; ++i)
      {
        next[i] = now[i] + share * error(i);
      }
      if (turnsOnce(next, direction(p)))
      {
        return next;
      }
    }
    return now;
  }

  void changeGluing()
  {
    std::vector<Angles> proposals;
    std::vector<double> all;
    std::vector<double> change;
    for (std::size_t p = 0; p < this->Loops.size(); ++p)
    {
      proposals.push_back(this->proposal(p));
      for (std::size_t i = 0; i < proposals[p].size(); ++i)
      {
        all.push_back(proposals[p][i]);
        change.push_back(proposals[p][i] - this->Gluing[p][i]);
      }
    }
    const Step step{ Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Index>(all.size())),
      Eigen::Map<Eigen::VectorXd>(change.data(), static_cast<Index>(change.size())) };
    this->GreatestChange = step.change.cwiseAbs().maxCoeff();
    const Eigen::VectorXd mixed = this->extrapolate(step);
    Index first = 0;
    for (std::size_t p = 0; p < this->Loops.size(); ++p)
    {
      const Index m = static_cast<Index>(proposals[p].size());
      const Angles next(mixed.data() + first, mixed.data() + first + m);
      const Angles& taken = turnsOnce(next, direction(p)) ? next : proposals[p];
      this->Gluing[p] = balanced(taken, pointsAt(taken), this->Weights[p], taken);
      first += m;
    }
  }

  struct Step
  {
    Eigen::VectorXd proposal;
    Eigen::VectorXd change; // from what was glued to what is proposed
  };

  Eigen::VectorXd extrapolate(const Step& step)
  {
    if (this->GreatestChange > SettledAngle)
    {
      this->Former.clear();
    }
    const Index k = static_cast<Index>(this->Former.size());
    Eigen::VectorXd result = step.proposal;
    if (k > 0)
    {
      Eigen::MatrixXd changes(step.change.size(), k);
      Eigen::MatrixXd proposals(step.change.size(), k);
      for (Index i = 0; i < k; ++i)
      {
        changes.col(i) = step.change - this->Former[static_cast<std::size_t>(i)].change;
        proposals.col(i) = step.proposal - this->Former[static_cast<std::size_t>(i)].proposal;
      }
      result -= proposals * leastSquares(changes, step.change);
    }
    this->Former.push_back(step);
    if (this->Former.size() > AndersonMemory)
    {
      this->Former.erase(this->Former.begin());
    }
    return result;
  }

  const std::vector<Loop>& Loops;
  GluedSphere Sphere;
  std::vector<std::vector<double>> Weights; // see nodeLengths()
  std::vector<Angles> Gluing;               // balanced
  std::vector<LoopImage> Images;
  std::vector<Step> Former;
  double GreatestChange = std::numeric_limits<double>::infinity();
};

void checkOrder(bool isInOrder, const PointsRef& points, const Loop& loop)
{
  if (!isInOrder)
  {
    throw InvalidInput("the image of the loop through " + describe(points.row(loop[0])) +
      " does not wind evenly round: the triangulation there is too coarse or too distorted. Refine "
      "it, or improve it first.");
  }
}

KoebeMap mapOneHole(
  const PointsRef& points, const TrianglesRef& triangles, const std::vector<Loop>& loops)
{
  const ConformalAnnulus annulus = conformalAnnulus(points, triangles, loops);
  KoebeMap map;
  map.holes = { { Eigen::RowVector2d::Zero(), annulus.innerRadius } };
  map.rounds = { { map.holes, std::numeric_limits<double>::infinity() } };
  map.converged = true;
  map.circularity = { 0.0, 0.0 }; // the height is constant on either
  for (std::size_t p = 0; p < 2; ++p)
  {
    Angles angles;
    for (const Index v : loops[p])
    {
      appendUnwrapped(angles, annulus.angle[v] - annulus.angle[loops[0][0]]);
    }
    map.places.push_back(
      circlePoints({ { 0.0, 0.0 }, p == 0 ? 1.0 : annulus.innerRadius }, angles));
  }
  return map;
}

double squaredChange(const std::vector<Circle>& a, const std::vector<Circle>& b)
{
  double sum = 0.0;
  for (std::size_t h = 0; h < a.size(); ++h)
  {
    const double radius = a[h].radius - b[h].radius;
    sum += (a[h].center - b[h].center).squaredNorm() + radius * radius;
  }
  return sum;
}

/// Whether the last rounds changed no less than the best ones before them: what is left is
/// rounding.
bool isStagnant(const std::vector<KoebeRound>& rounds)
{
  constexpr std::ptrdiff_t Patience = 20;
  if (static_cast<std::ptrdiff_t>(rounds.size()) <= 2 * Patience)
  {
    return false;
  }
  const auto smaller = [](const KoebeRound& a, const KoebeRound& b) { return a.change < b.change; };
  const auto recent = rounds.end() - Patience;
  return std::min_element(recent, rounds.end(), smaller)->change >=
    0.5 * std::min_element(rounds.begin(), recent, smaller)->change;
}
}

KoebeMap koebeMap(const PointsRef& points, const TrianglesRef& triangles,
  const std::vector<Loop>& loops, const KoebeLimits& limits, const Progress& progress,
  Weights weights)
{
  reportProgress(progress, 0.0);
  if (loops.size() == 2)
  {
    return mapOneHole(points, triangles, loops);
  }
  KoebeMap result;
  KoebeIteration iteration(points, symmetricLaplacian(points, triangles, weights), loops);
  for (int done = 0;
       !result.converged && done < std::max(1, limits.maximumRounds) && !isStagnant(result.rounds);
       ++done)
  {
    KoebeRound round = iteration.round();
    round.change = done == 0 ? std::numeric_limits<double>::infinity()
                             : squaredChange(round.holes, result.rounds.back().holes);
    result.converged = round.change <= limits.tolerance;
    result.rounds.push_back(std::move(round));
    reportProgress(progress, (done + 1.0) / (limits.maximumRounds + 1.0));
  }
  for (std::size_t p = 0; p < loops.size(); ++p)
  {
    checkOrder(iteration.isInOrder(p), points, loops[p]);
  }
  result.holes = result.rounds.back().holes;
  for (std::size_t p = 0; p < loops.size(); ++p)
  {
    const Circle onto = p == 0 ? Circle{ { 0.0, 0.0 }, 1.0 } : result.holes[p - 1];
    result.places.push_back(iteration.places(p, onto));
    result.circularity.push_back(iteration.circularity(p));
  }
  return result;
}
}

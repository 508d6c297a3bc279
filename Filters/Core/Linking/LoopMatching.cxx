// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/LoopMatching.h"

#include "Core/Common/Constants.h"
#include "Core/Common/DenseAlgebra.h"
#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/AffineMap.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Linking/Assignment.h"
#include "Core/Linking/LoopCorrespondence.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr std::size_t DoubtsToName = 10;
/// A line whose angle to a plane has a smaller sine lies in it, as far as can be said.
constexpr double InPlane = 0.1;
/// Cosine below which two vectors are opposite: the smallest rotation has no axis of its own.
constexpr double Opposite = -0.99;
/// Centres that are closer, in lengths of the outer loop, give no direction.
constexpr double SameCenter = 1e-3;
/// Another hole whose distance is less than this many times that of the partner is as likely.
constexpr double NearlyAsClose = 1.5;

std::vector<ClosedPolygon> polygons(const PointsRef& points, const std::vector<Loop>& loops)
{
  std::vector<ClosedPolygon> result;
  for (const Loop& loop : loops)
  {
    result.emplace_back(loopPoints(points, loop));
  }
  return result;
}

std::size_t longest(const std::vector<ClosedPolygon>& loops)
{
  return static_cast<std::size_t>(
    std::max_element(loops.begin(), loops.end(),
      [](const ClosedPolygon& a, const ClosedPolygon& b) { return a.length() < b.length(); }) -
    loops.begin());
}

/// How the target runs and is turned against the source.
struct Direction
{
  bool reversed = false; ///< the target's loops run the other way
  bool isGuess = false;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

/// A direction about which a loop runs, or zero for one without area.
Eigen::Vector3d normalOf(const ClosedPolygon& loop)
{
  const Eigen::Vector3d area = areaVector(loop.nodes()).transpose();
  const bool flat = area.norm() > 1e-6 * loop.length() * loop.length();
  return flat ? area.normalized() : Eigen::Vector3d::Zero();
}

Direction findDirection(const ClosedPolygon& source, const ClosedPolygon& target)
{
  const Eigen::Vector3d from = normalOf(source);
  Eigen::Vector3d to = normalOf(target);
  Direction direction;
  if (from.isZero() || to.isZero())
  {
    direction.isGuess = true;
    return direction;
  }
  const Eigen::Vector3d line = (target.center() - source.center()).transpose();
  const bool hasLine = line.norm() > SameCenter * (source.length() + target.length());
  const double rise = hasLine ? from.dot(line.normalized()) : 0.0;
  const double targetRise = hasLine ? to.dot(line.normalized()) : 0.0;
  if (std::abs(rise) > InPlane && std::abs(targetRise) > InPlane)
  {
    direction.reversed = rise * targetRise < 0.0;
  }
  else
  {
    const bool sideBySide = hasLine && std::abs(rise) <= InPlane &&
      std::abs(targetRise) <= InPlane && std::abs(from.dot(to)) > std::sqrt(0.5);
    direction.reversed = (from.dot(to) < 0.0) != sideBySide;
    direction.isGuess = hasLine;
  }
  to *= direction.reversed ? -1.0 : 1.0;
  const Eigen::Vector3d axis = from.cross(line);
  direction.rotation = from.dot(to) < Opposite && axis.norm() > InPlane * line.norm()
    ? Eigen::AngleAxisd(
        std::atan2(from.cross(to).dot(axis.normalized()), from.dot(to)), axis.normalized())
        .toRotationMatrix()
    : leastRotation(from, to);
  return direction;
}

/// The other way round from the same first node.
ClosedPolygon reversed(const ClosedPolygon& loop)
{
  Points nodes = loop.nodes();
  nodes.bottomRows(nodes.rows() - 1).colwise().reverseInPlace();
  return ClosedPolygon(std::move(nodes));
}

Points placesOn(const ClosedPolygon& target, const LoopCorrespondence& correspondence)
{
  Points places(static_cast<Index>(correspondence.places.size()), 3);
  for (std::size_t i = 0; i < correspondence.places.size(); ++i)
  {
    places.row(static_cast<Index>(i)) = target.at(correspondence.places[i]);
  }
  return places;
}

/// The centre, to a millionth of the loop's length or so.
std::string describeCenter(const ClosedPolygon& loop)
{
  const double unit = std::pow(10.0, std::floor(std::log10(loop.length())) - 5.0);
  const Eigen::RowVector3d center =
    (loop.center() / unit).array().round().matrix() * unit + Eigen::RowVector3d::Zero();
  return describe(center);
}

std::string nameOf(const ClosedPolygon& loop, std::size_t number, bool outer)
{
  return "loop " + std::to_string(number) + " (" + (outer ? "the outer one" : "a hole") +
    ", around " + describeCenter(loop) + ")";
}

/// Two sets of holes to be paired.
struct Holes
{
  Points sourceCenters; ///< after the motion
  Points targetCenters;
  Eigen::VectorXd sourceRadii; ///< of circles of their lengths, after the motion
  Eigen::VectorXd targetRadii;

  /// Squared distances of the centres, moved by `shift`, and of the radii.
  Eigen::MatrixXd squaredDistances(const Eigen::RowVector3d& shift) const
  {
    const Index n = this->sourceCenters.rows();
    Eigen::MatrixXd squared(n, n);
    for (Index s = 0; s < n; ++s)
    {
      for (Index t = 0; t < n; ++t)
      {
        const double radii = this->sourceRadii[s] - this->targetRadii[t];
        squared(s, t) =
          (this->sourceCenters.row(s) + shift - this->targetCenters.row(t)).squaredNorm() +
          radii * radii;
      }
    }
    return squared;
  }
};

Holes gatherHoles(const std::vector<ClosedPolygon>& source,
  const std::vector<std::size_t>& sourceHoles, const std::vector<ClosedPolygon>& target,
  const std::vector<std::size_t>& targetHoles, const AffineMap& motion)
{
  const double scale = std::cbrt(std::abs(motion.linear.determinant()));
  const Index n = static_cast<Index>(sourceHoles.size());
  Holes holes{ Points(n, 3), Points(n, 3), Eigen::VectorXd(n), Eigen::VectorXd(n) };
  for (Index h = 0; h < n; ++h)
  {
    const ClosedPolygon& from = source[sourceHoles[static_cast<std::size_t>(h)]];
    const ClosedPolygon& to = target[targetHoles[static_cast<std::size_t>(h)]];
    holes.sourceCenters.row(h) = from.center();
    holes.targetCenters.row(h) = to.center();
    holes.sourceRadii[h] = scale * from.length() / (2.0 * Pi);
    holes.targetRadii[h] = to.length() / (2.0 * Pi);
  }
  holes.sourceCenters = motion.apply(holes.sourceCenters);
  return holes;
}

/// For each hole another one that is nearly as close as its partner, or -1. How far caps bulge over
/// their outer loops is no matter: the mean step along `normal` is taken out.
std::vector<Index> rivals(
  const Holes& holes, const std::vector<Index>& partner, const Eigen::RowVector3d& normal)
{
  double step = 0.0;
  for (std::size_t h = 0; h < partner.size(); ++h)
  {
    step += normal.dot(
      holes.targetCenters.row(partner[h]) - holes.sourceCenters.row(static_cast<Index>(h)));
  }
  const Eigen::MatrixXd squared =
    holes.squaredDistances(step / static_cast<double>(partner.size()) * normal);
  std::vector<Index> result;
  for (Index h = 0; h < squared.rows(); ++h)
  {
    const Index own = partner[static_cast<std::size_t>(h)];
    Index rival = -1;
    for (Index t = 0; t < squared.cols() && rival < 0; ++t)
    {
      rival = t != own && squared(h, t) <= NearlyAsClose * NearlyAsClose * squared(h, own) ? t : -1;
    }
    result.push_back(rival);
  }
  return result;
}

std::vector<std::size_t> allBut(std::size_t left, std::size_t count)
{
  std::vector<std::size_t> numbers;
  for (std::size_t l = 0; l < count; ++l)
  {
    if (l != left)
    {
      numbers.push_back(l);
    }
  }
  return numbers;
}

std::string doubtOfStart(const LoopCorrespondence& correspondence, const std::string& name)
{
  return "where " + name + " begins on its partner: begun " +
    describe(std::round(1e4 * std::abs(correspondence.runnerUpTurn)) / 1e4) +
    " of its length further " + (correspondence.runnerUpTurn > 0.0 ? "on" : "back") +
    ", it fits nearly as well";
}
}

MatchedLoops matchLoopsByShape(const PointsRef& sourcePoints, const std::vector<Loop>& sourceLoops,
  const PointsRef& targetPoints, const std::vector<Loop>& targetLoops,
  const std::string& sourceName, const std::string& targetName)
{
  if (sourceLoops.size() != targetLoops.size())
  {
    throw InvalidInput("the " + sourceName + verb(sourceName, " has ", " have ") +
      std::to_string(sourceLoops.size()) + " boundary loop(s), the " + targetName + " " +
      std::to_string(targetLoops.size()) + ". Both caps of a sweep have the same holes.");
  }
  const std::vector<ClosedPolygon> source = polygons(sourcePoints, sourceLoops);
  std::vector<ClosedPolygon> target = polygons(targetPoints, targetLoops);
  const std::size_t outer = longest(source);
  const std::size_t targetOuter = longest(target);
  const Direction direction = findDirection(source[outer], target[targetOuter]);
  if (direction.reversed)
  {
    std::transform(target.begin(), target.end(), target.begin(), reversed);
  }
  MatchedLoops matched;
  if (direction.isGuess)
  {
    matched.doubts.push_back("which way round " + nameOf(source[outer], outer, true) +
      " runs on the target: neither cap faces the other");
  }

  std::vector<std::size_t> partner(source.size(), targetOuter);
  std::vector<LoopCorrespondence> correspondences(source.size());
  correspondences[outer] = correspondLoops(source[outer], target[targetOuter], direction.rotation);
  if (source.size() > 1)
  {
    const Points places = placesOn(target[targetOuter], correspondences[outer]);
    const AffineMap motion = fitAffineMap(source[outer].nodes(), places,
      areaVector(source[outer].nodes()), areaVector(target[targetOuter].nodes()));
    const std::vector<std::size_t> holes = allBut(outer, source.size());
    const std::vector<std::size_t> targetHoles = allBut(targetOuter, target.size());
    const Holes both = gatherHoles(source, holes, target, targetHoles, motion);
    const std::vector<Index> chosen =
      leastCostAssignment(both.squaredDistances(Eigen::RowVector3d::Zero()));
    const std::vector<Index> rival =
      rivals(both, chosen, areaVector(target[targetOuter].nodes()).normalized());
    for (std::size_t h = 0; h < holes.size(); ++h)
    {
      partner[holes[h]] = targetHoles[static_cast<std::size_t>(chosen[h])];
      if (rival[h] >= 0)
      {
        matched.doubts.push_back("which hole of the target " +
          nameOf(source[holes[h]], holes[h], false) + " becomes: that around " +
          describeCenter(target[targetHoles[static_cast<std::size_t>(rival[h])]]) +
          " is nearly as close as the one taken, around " +
          describeCenter(target[partner[holes[h]]]));
      }
      correspondences[holes[h]] =
        correspondLoops(source[holes[h]], target[partner[holes[h]]], motion.linear);
    }
  }
  for (std::size_t s = 0; s < source.size(); ++s)
  {
    const ClosedPolygon& loop = target[partner[s]];
    const LoopCorrespondence& correspondence = correspondences[s];
    if (correspondence.isGuess())
    {
      matched.doubts.push_back(doubtOfStart(correspondence, nameOf(source[s], s, s == outer)));
    }
    matched.pairs.push_back({ source[s].nodes(), placesOn(loop, correspondence) });
    const double start = correspondence.places.front();
    matched.startFractions.push_back(start - std::floor(start));
  }
  return matched;
}

std::string describeDoubts(const std::vector<std::string>& doubts)
{
  if (doubts.empty())
  {
    return {};
  }
  std::string text = "Without linking sides the loops are matched by their shape, which leaves "
                     "open";
  for (std::size_t i = 0; i < std::min(doubts.size(), DoubtsToName); ++i)
  {
    text += (i > 0 ? "; " : " ") + doubts[i];
  }
  if (doubts.size() > DoubtsToName)
  {
    text += "; and " + std::to_string(doubts.size() - DoubtsToName) + " more";
  }
  return text + ". The sweep may be twisted: connect LinkingSides.";
}
}

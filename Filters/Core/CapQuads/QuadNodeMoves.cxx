// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/QuadNodeMoves.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
constexpr double BarrierWeight = 0.002;
/// Added to the diagonal, relative to its mean.
constexpr double NodeDamping = 1e-6;
constexpr int Backtracks = 4;
constexpr double SufficientNodeDecrease = 1e-4;
constexpr double LeastNodeGain = 1e-2; // of its sum, for a node to be moved
/// Of Newton's step: nodes follow each other from sweep to sweep.
constexpr double Relaxation = 1.4;
constexpr Index MovesAtOnce = 256;
constexpr Index MovedCornersAtOnce = 4096;

/// distortion() of an upright corner against a rectangle, above its least.
double distortionOf(double squareA, double squareB, double determinant, const double* wanted)
{
  const double det = wanted[0] * wanted[1] * determinant;
  if (!(det > 0.0))
  {
    return std::numeric_limits<double>::infinity();
  }
  const double squares = wanted[0] * wanted[0] * squareA + wanted[1] * wanted[1] * squareB;
  return (1.0 - VolumeWeight) * squares / (2.0 * det) + VolumeWeight * 0.5 * (1.0 / det + det) -
    1.0;
}
}

/// Edges of a corner, and what both sums need of them.
struct QuadNodeMoves::Arms
{
  Eigen::Vector3d a;
  Eigen::Vector3d b;
  double squareA;
  double squareB;
  double lengths; ///< their product
  double determinant;
  double jacobian;

  Arms(
    const Eigen::Vector3d& toNext, const Eigen::Vector3d& toPrevious, const Eigen::Vector3d& normal)
    : a(toNext)
    , b(toPrevious)
    , squareA(a.squaredNorm())
    , squareB(b.squaredNorm())
    , lengths(std::sqrt(squareA * squareB))
    , determinant(a.cross(b).dot(normal))
    , jacobian(determinant / lengths)
  {
  }
};

CurvePoint CornerLoss::at(double x) const
{
  const double k = this->sharpness;
  if (k == 0.0)
  {
    const double room = x - this->least;
    if (!(room > 0.0))
    {
      return { std::numeric_limits<double>::infinity(), 0.0, 0.0 };
    }
    const double loss = 1.0 - x;
    return { loss * loss - BarrierWeight * std::log(room), -2.0 * loss - BarrierWeight / room,
      2.0 + BarrierWeight / (room * room) };
  }
  const double t = k * (this->least - x);
  if (t > 0.0)
  {
    return { 1.0 + t + 0.5 * t * t, -k * (1.0 + t), k * k };
  }
  const double value = std::exp(t);
  return { value, -k * value, k * k * value };
}

QuadNodeMoves::QuadNodeMoves(const CapCorners& cap, const Points& points, const PointsRef& source)
  : Cap(cap)
  , Corners(cap.corners().size())
  , InverseLengths(cap.corners().size())
  , FreeNumber(static_cast<std::size_t>(points.rows()), -1)
  , Triangle(cap.freeNodes().size(), -1)
  , Normals(cap.freeNodes().size())
{
  for (std::size_t k = 0; k < cap.freeNodes().size(); ++k)
  {
    this->FreeNumber[static_cast<std::size_t>(cap.freeNodes()[k])] = static_cast<Index>(k);
  }
  this->makeCorners(source);
  this->sort();
  this->color();
  this->reset(points);
}

/// All that does not depend on where the nodes are.
void QuadNodeMoves::makeCorners(const PointsRef& source)
{
  forPieces(this->Cap.parallelFor(), static_cast<Index>(this->Corners.size()), MovedCornersAtOnce,
    [&](Index begin, Index end) {
      for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
      {
        const QuadCorner& corner = this->Cap.corners()[c];
        this->Corners[c] = { { corner.node[0], corner.node[1], corner.node[2] }, corner.column,
          Eigen::Vector3d::Zero(), { 1.0, 1.0 } };
        const std::array<double, 2> lengths = rectangleOf(source, this->Cap.quads(), corner);
        this->InverseLengths[c] = { 1.0 / lengths[0], 1.0 / lengths[1] };
      }
    });
}

void QuadNodeMoves::reset(const Points& points)
{
  this->Places = points;
  this->Awake.assign(this->Triangle.size(), 1);
  const Points normals = this->Cap.normals(points);
  for (std::size_t k = 0; k < this->Normals.size(); ++k)
  {
    this->Normals[k] = normals.row(this->Cap.freeNodes()[k]).transpose();
  }
  double wanted = 0.0; // areas of all corners
  double found = 0.0;
  for (std::size_t c = 0; c < this->Corners.size(); ++c)
  {
    Corner& corner = this->Corners[c];
    corner.normal = this->Cap.normal(this->Cap.corners()[c], normals).transpose();
    if (corner.column < 0)
    {
      wanted += 1.0 / (this->InverseLengths[c][0] * this->InverseLengths[c][1]);
      found += this->armsOf(corner).determinant;
    }
  }
  const double scale = std::sqrt(wanted / std::abs(found));
  for (std::size_t c = 0; c < this->Corners.size(); ++c)
  {
    this->Corners[c].wanted[0] = scale * this->InverseLengths[c][0];
    this->Corners[c].wanted[1] = scale * this->InverseLengths[c][1];
  }
}

/// The corners at each free node, one node after the other.
void QuadNodeMoves::sort()
{
  const auto numberOf = [&](
                          Index node) { return this->FreeNumber[static_cast<std::size_t>(node)]; };
  this->FirstIncidence.assign(this->Triangle.size() + 1, 0);
  for (const Corner& corner : this->Corners)
  {
    for (const Index node : corner.node)
    {
      if (numberOf(node) >= 0)
      {
        ++this->FirstIncidence[static_cast<std::size_t>(numberOf(node)) + 1];
      }
    }
  }
  for (std::size_t k = 1; k < this->FirstIncidence.size(); ++k)
  {
    this->FirstIncidence[k] += this->FirstIncidence[k - 1];
  }
  this->Incidences.resize(static_cast<std::size_t>(this->FirstIncidence.back()));
  std::vector<Index> next = this->FirstIncidence;
  for (std::size_t c = 0; c < this->Corners.size(); ++c)
  {
    for (int role = 0; role < 3; ++role)
    {
      const Index number = numberOf(this->Corners[c].node[role]);
      if (number >= 0)
      {
        this->Incidences[static_cast<std::size_t>(next[static_cast<std::size_t>(number)]++)] = {
          static_cast<Index>(c), role
        };
      }
    }
  }
}

/// Greedily; nodes across a quad share two of its corners.
void QuadNodeMoves::color()
{
  std::vector<int> colors(this->Triangle.size(), -1);
  std::vector<bool> taken;
  for (std::size_t k = 0; k < colors.size(); ++k)
  {
    taken.assign(this->Groups.size() + 1, false);
    for (Index i = this->FirstIncidence[k]; i < this->FirstIncidence[k + 1]; ++i)
    {
      const Corner& corner = this->cornerAt(i);
      for (const Index node : corner.node)
      {
        const Index other = this->FreeNumber[static_cast<std::size_t>(node)];
        if (other >= 0 && colors[static_cast<std::size_t>(other)] >= 0)
        {
          taken[static_cast<std::size_t>(colors[static_cast<std::size_t>(other)])] = true;
        }
      }
    }
    const auto first = std::find(taken.begin(), taken.end(), false) - taken.begin();
    colors[k] = static_cast<int>(first);
    if (static_cast<std::size_t>(first) == this->Groups.size())
    {
      this->Groups.emplace_back();
    }
    this->Groups[static_cast<std::size_t>(first)].push_back(static_cast<Index>(k));
  }
}

const CornerLoss& QuadNodeMoves::lossOf(const Corner& corner, const Losses& losses) const
{
  return corner.column < 0 ? losses.onSurface
                           : losses.atColumns[static_cast<std::size_t>(corner.column)];
}

QuadNodeMoves::Arms QuadNodeMoves::armsOf(const Corner& corner) const
{
  return { (this->Places.row(corner.node[1]) - this->Places.row(corner.node[0])).transpose(),
    (this->Places.row(corner.node[2]) - this->Places.row(corner.node[0])).transpose(),
    corner.normal };
}

void QuadNodeMoves::add(
  const Incidence& incidence, const Frame& frame, const Losses& losses, Sum& sum) const
{
  const Corner& corner = this->Corners[static_cast<std::size_t>(incidence.corner)];
  const int role = incidence.role;
  const Arms arms = this->armsOf(corner);
  const Eigen::Vector3d& a = arms.a;
  const Eigen::Vector3d& b = arms.b;
  const CurvePoint f = this->lossOf(corner, losses).at(arms.jacobian);
  // How much of each edge's change the node's step is.
  const double moveA = role == 0 ? -1.0 : role == 1 ? 1.0 : 0.0;
  const double moveB = role == 0 ? -1.0 : role == 2 ? 1.0 : 0.0;
  const Eigen::Vector2d planeA = frame * a;
  const Eigen::Vector2d planeB = frame * b;
  // The determinant is linear in the step, since both edges of node 0 change alike.
  const Eigen::Vector2d byDeterminant =
    frame * (moveA * b.cross(corner.normal) + moveB * corner.normal.cross(a));
  const Eigen::Vector2d byLengths =
    moveA / arms.squareA * planeA + moveB / arms.squareB * planeB; // of their logarithm
  const Eigen::Vector2d slope = byDeterminant / arms.lengths - arms.jacobian * byLengths;
  sum.value += f.value;
  sum.gradient += f.slope * slope;
  sum.curvature.noalias() += f.curvature * slope * slope.transpose();
  if (f.slope < 0.0 && arms.jacobian > 0.0)
  {
    if (corner.column < 0)
    {
      // The sine is concave in the angle between the edges; the curvature of the angle itself has
      // no sign and is left out.
      const Eigen::Vector2d turn = frame *
        (moveB / arms.squareB * corner.normal.cross(b) -
          moveA / arms.squareA * corner.normal.cross(a));
      sum.curvature.noalias() -= f.slope * arms.jacobian * turn * turn.transpose();
    }
    else
    {
      // Of each edge alone the Jacobian is a linear function on the sphere of its directions.
      const double weight = -f.slope * arms.jacobian;
      if (moveA != 0.0)
      {
        sum.curvature += weight / arms.squareA *
          (Eigen::Matrix2d::Identity() - planeA * planeA.transpose() / arms.squareA);
      }
      if (moveB != 0.0)
      {
        sum.curvature += weight / arms.squareB *
          (Eigen::Matrix2d::Identity() - planeB * planeB.transpose() / arms.squareB);
      }
    }
  }
  if (corner.column >= 0)
  {
    return;
  }
  const double squareWantedA = corner.wanted[0] * corner.wanted[0];
  const double squareWantedB = corner.wanted[1] * corner.wanted[1];
  const double area = corner.wanted[0] * corner.wanted[1];
  const double det = area * arms.determinant;
  const Eigen::Vector2d bySquares =
    2.0 * (squareWantedA * moveA * planeA + squareWantedB * moveB * planeB);
  const double stiffness =
    2.0 * (squareWantedA * std::abs(moveA) + squareWantedB * std::abs(moveB));
  const double squares = squareWantedA * arms.squareA + squareWantedB * arms.squareB;
  const Eigen::Vector2d d = area * byDeterminant / det; // of the determinant's logarithm
  const double shape = DistortionWeight * (1.0 - VolumeWeight) / (2.0 * det);
  const double volume = DistortionWeight * VolumeWeight * 0.5;
  sum.value += shape * squares + volume * (1.0 / det + det) - DistortionWeight;
  sum.gradient += shape * (bySquares - squares * d) + volume * (det - 1.0 / det) * d;
  sum.curvature.diagonal().array() += shape * stiffness;
  sum.curvature.noalias() -= shape * (bySquares * d.transpose() + d * bySquares.transpose());
  sum.curvature.noalias() += (2.0 * shape * squares + 2.0 * volume / det) * d * d.transpose();
}

double QuadNodeMoves::valueAt(Index number, const Eigen::RowVector3d& place,
  const Eigen::Vector3d& normal, const Losses& losses) const
{
  double value = 0.0;
  const Index node = this->Cap.freeNodes()[static_cast<std::size_t>(number)];
  const auto at = [&](Index other) -> Eigen::Vector3d {
    return (other == node ? place : Eigen::RowVector3d(this->Places.row(other))).transpose();
  };
  for (Index i = this->FirstIncidence[static_cast<std::size_t>(number)];
       i < this->FirstIncidence[static_cast<std::size_t>(number) + 1]; ++i)
  {
    const Incidence& incidence = this->Incidences[static_cast<std::size_t>(i)];
    const Corner& corner = this->Corners[static_cast<std::size_t>(incidence.corner)];
    const Eigen::Vector3d here = at(corner.node[0]);
    const Arms arms(at(corner.node[1]) - here, at(corner.node[2]) - here,
      incidence.role == 0 && corner.column < 0 ? normal : corner.normal);
    const CornerLoss& loss = this->lossOf(corner, losses);
    if (!(arms.jacobian >= losses.floor))
    {
      return std::numeric_limits<double>::infinity();
    }
    value += loss.at(arms.jacobian).value;
    if (corner.column < 0)
    {
      value += DistortionWeight *
        distortionOf(arms.squareA, arms.squareB, arms.determinant, corner.wanted);
    }
  }
  return value;
}

bool QuadNodeMoves::move(Index number, const Losses& losses)
{
  const auto k = static_cast<std::size_t>(number);
  const Index node = this->Cap.freeNodes()[k];
  Frame frame;
  const Eigen::Vector3d first = this->Normals[k].unitOrthogonal();
  frame.row(0) = first.transpose();
  frame.row(1) = this->Normals[k].cross(first).transpose();
  Sum sum;
  for (Index i = this->FirstIncidence[k]; i < this->FirstIncidence[k + 1]; ++i)
  {
    this->add(this->Incidences[static_cast<std::size_t>(i)], frame, losses, sum);
  }
  this->Awake[k] = 0;
  sum.curvature.diagonal().array() += NodeDamping * sum.curvature.trace();
  const double det = sum.curvature.determinant();
  if (!(det > 0.0) || !std::isfinite(sum.value))
  {
    return false;
  }
  const Eigen::Vector2d step(
    (sum.curvature(0, 1) * sum.gradient[1] - sum.curvature(1, 1) * sum.gradient[0]) / det,
    (sum.curvature(1, 0) * sum.gradient[0] - sum.curvature(0, 0) * sum.gradient[1]) / det);
  const double slope = step.dot(sum.gradient);
  if (!step.allFinite() || !(-slope > LeastNodeGain * sum.value))
  {
    return false;
  }
  double length = Relaxation;
  for (int backtrack = 0; backtrack < Backtracks; ++backtrack, length *= 0.5)
  {
    const SurfacePlace place = this->Cap.place(
      this->Places.row(node) + length * (step.transpose() * frame), this->Triangle[k]);
    const double value = this->valueAt(number, place.point, place.normal.transpose(), losses);
    if (value <= sum.value + SufficientNodeDecrease * length * slope)
    {
      this->Places.row(node) = place.point;
      this->Triangle[k] = place.triangle;
      this->Normals[k] = place.normal.transpose();
      for (Index i = this->FirstIncidence[k]; i < this->FirstIncidence[k + 1]; ++i)
      {
        const Incidence& incidence = this->Incidences[static_cast<std::size_t>(i)];
        Corner& corner = this->Corners[static_cast<std::size_t>(incidence.corner)];
        if (incidence.role == 0 && corner.column < 0)
        {
          corner.normal = this->Normals[k];
        }
      }
      return true;
    }
  }
  return false;
}

Index QuadNodeMoves::sweep(const Losses& losses)
{
  Index total = 0;
  std::vector<Index> movedNodes;
  std::vector<Index> nodes;
  std::vector<char> moved;
  for (const std::vector<Index>& group : this->Groups)
  {
    nodes.clear();
    for (const Index number : group)
    {
      if (this->Awake[static_cast<std::size_t>(number)])
      {
        nodes.push_back(number);
      }
    }
    moved.assign(nodes.size(), 0);
    forPieces(this->Cap.parallelFor(), static_cast<Index>(nodes.size()), MovesAtOnce,
      [&](Index begin, Index end) {
        for (Index n = begin; n < end; ++n)
        {
          moved[static_cast<std::size_t>(n)] =
            this->move(nodes[static_cast<std::size_t>(n)], losses) ? 1 : 0;
        }
      });
    movedNodes.clear();
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      if (moved[n])
      {
        movedNodes.push_back(nodes[n]);
      }
    }
    total += static_cast<Index>(movedNodes.size());
    this->wakeAround(movedNodes);
  }
  return total;
}

void QuadNodeMoves::wakeAround(const std::vector<Index>& moved)
{
  std::vector<Index> asleep;
  for (const Index number : moved)
  {
    const auto k = static_cast<std::size_t>(number);
    for (Index i = this->FirstIncidence[k]; i < this->FirstIncidence[k + 1]; ++i)
    {
      for (const Index node : this->cornerAt(i).node)
      {
        const Index other = this->FreeNumber[static_cast<std::size_t>(node)];
        if (other >= 0 && !this->Awake[static_cast<std::size_t>(other)])
        {
          this->Awake[static_cast<std::size_t>(other)] = 1; // looked at once
          asleep.push_back(other);
        }
      }
    }
  }
  if (this->Enough > 1.0)
  {
    return;
  }
  forPieces(this->Cap.parallelFor(), static_cast<Index>(asleep.size()), MovesAtOnce,
    [&](Index begin, Index end) {
      for (auto n = static_cast<std::size_t>(begin); n < static_cast<std::size_t>(end); ++n)
      {
        const auto k = static_cast<std::size_t>(asleep[n]);
        this->Awake[k] = this->isWanting(k) ? 1 : 0;
      }
    });
}

/// Whether a corner at a node is below what wakes it.
bool QuadNodeMoves::isWanting(std::size_t k) const
{
  if (this->Enough > 1.0)
  {
    return true;
  }
  for (Index i = this->FirstIncidence[k]; i < this->FirstIncidence[k + 1]; ++i)
  {
    if (!(this->armsOf(this->cornerAt(i)).jacobian >= this->Enough))
    {
      return true;
    }
  }
  return false;
}

void QuadNodeMoves::wake(double enough)
{
  this->Enough = enough;
  forPieces(this->Cap.parallelFor(), static_cast<Index>(this->Awake.size()), MovesAtOnce,
    [&](Index begin, Index end) {
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
      {
        this->Awake[k] = this->isWanting(k) ? 1 : 0;
      }
    });
}

double QuadNodeMoves::least() const
{
  double least = 1.0;
  for (std::size_t c = 0; c < this->Corners.size(); ++c)
  {
    if (this->Cap.corners()[c].movable)
    {
      least = std::min(least, this->armsOf(this->Corners[c]).jacobian);
    }
  }
  return least;
}
}

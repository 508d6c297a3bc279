// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/SectionDescent.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/FoldoverFreeEnergy.h"
#include "Core/Solvers/MultifrontalSolver.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
/// Shape counts, size hardly: sections grow and shrink on the way.
constexpr double VolumeWeight = 1.0 / 128.0;
/// Sine of a given corner below which a right angle is wanted instead.
constexpr double SharpestShape = 0.05;
constexpr int MaximumBacktracks = 25;
constexpr double SufficientDecrease = 1e-4;
/// Added to the diagonal, relative to its mean.
constexpr double Damping = 1e-6;
constexpr double Settled = 1e-3;     // relative decrease of the sum that ends a descent
constexpr double FirstEpsilon = 1.0; // of the wanted corner's area
constexpr double LastEpsilon = 1e-10;
constexpr double LeastRate = 0.3; // by which the regularisation falls in a round
constexpr int NewtonSteps = 6;    // of a round
constexpr double UntanglingPower = 1.0;
/// Of a corner's distortion in the sum that is relaxed: the plain sum would leave all the shear of
/// a turn to the few quads round the hole. A hole turned by 210 degrees: least scaled Jacobian of
/// the layers 0.06, 0.12, 0.15, 0.14 with powers of 1, 2, 3, 4.
constexpr double RelaxingPower = 3.0;

/// The edges of a corner are `next - node` and `previous - node`: signs of nodes 0, 1, 2 in each.
constexpr double EdgeSign[3][2] = { { -1.0, -1.0 }, { 1.0, 0.0 }, { 0.0, 1.0 } };

/// Lengths of the edges to the next node and to the previous one, and the angle between them.
struct CornerShape
{
  double next;
  double previous;
  double angle;
};

struct PlaneCorner
{
  std::array<Index, 3> node;    // itself, the next one of the quad, the previous one
  CornerShape atSource;         // what is wanted at the source,
  CornerShape atTarget;         // and at the target
  Eigen::Matrix2d inverseShape; // of the wanted edge matrix
  std::array<int, 18> slot{};   // see Implementation::findSlots()
};

CornerShape shapeOf(const PointsRef& points, const std::array<Index, 3>& node)
{
  const Eigen::RowVector3d next = points.row(node[1]) - points.row(node[0]);
  const Eigen::RowVector3d previous = points.row(node[2]) - points.row(node[0]);
  const double angle = std::atan2(next.cross(previous).norm(), next.dot(previous));
  const bool isUsable = std::sin(angle) > SharpestShape;
  return { next.norm(), previous.norm(), isUsable ? angle : 0.5 * Pi };
}

CornerShape between(const CornerShape& a, const CornerShape& b, double share)
{
  const auto mix = [share](double x, double y) { return (1.0 - share) * x + share * y; };
  return { mix(a.next, b.next), mix(a.previous, b.previous), mix(a.angle, b.angle) };
}

Eigen::Matrix2d edgesOf(const CornerShape& shape)
{
  Eigen::Matrix2d edges;
  edges << shape.next, shape.previous * std::cos(shape.angle), 0.0,
    shape.previous * std::sin(shape.angle);
  return edges;
}

Eigen::Matrix2d edgesOf(const PlaneCorner& corner, const PlanePoints& points)
{
  Eigen::Matrix2d edges;
  edges.col(0) = (points.row(corner.node[1]) - points.row(corner.node[0])).transpose();
  edges.col(1) = (points.row(corner.node[2]) - points.row(corner.node[0])).transpose();
  return edges;
}

/// From the curvature in the Jacobian's entries to that in the edges'.
Eigen::Matrix4d inEdges(const Eigen::Matrix4d& curvature, const Eigen::Matrix2d& inverseShape)
{
  Eigen::Matrix4d combine;
  for (int column = 0; column < 2; ++column)
  {
    for (int edge = 0; edge < 2; ++edge)
    {
      combine.block<2, 2>(2 * column, 2 * edge) =
        inverseShape(edge, column) * Eigen::Matrix2d::Identity();
    }
  }
  return combine.transpose() * curvature * combine;
}
}

struct SectionDescent::Implementation
{
  std::vector<PlaneCorner> Corners; // the movable ones
  std::vector<Index> FreeNodes;
  std::vector<int> Variable; // node -> free node or -1
  double ShapeArea = 0.0;    // twice that of all wanted quads, movable corners only
  double Scale = 1.0;        // from the wanted shapes to the section
  SparseMatrix Hessian;
  Eigen::VectorXd Gradient;
  std::optional<MultifrontalSolver> Solver;

  /// Where each corner's 2 x 2 blocks begin in the values: the two columns of block (i, j).
  void findSlots()
  {
    std::vector<Eigen::Triplet<double, int>> entries;
    const auto variables = [&](const PlaneCorner& corner) {
      return std::array<int, 3>{ this->variableOf(corner, 0), this->variableOf(corner, 1),
        this->variableOf(corner, 2) };
    };
    for (const PlaneCorner& corner : this->Corners)
    {
      for (const int i : variables(corner))
      {
        for (const int j : variables(corner))
        {
          for (int c = 0; i >= 0 && j >= 0 && c < 2; ++c)
          {
            entries.emplace_back(2 * i, 2 * j + c, 0.0);
            entries.emplace_back(2 * i + 1, 2 * j + c, 0.0);
          }
        }
      }
    }
    const Index n = 2 * static_cast<Index>(this->FreeNodes.size());
    this->Hessian.resize(n, n);
    this->Hessian.setFromTriplets(entries.begin(), entries.end());
    this->Gradient.resize(n);
    for (PlaneCorner& corner : this->Corners)
    {
      std::size_t slot = 0;
      for (const int i : variables(corner))
      {
        for (const int j : variables(corner))
        {
          for (int c = 0; c < 2; ++c)
          {
            corner.slot[slot++] = i >= 0 && j >= 0 ? this->slotOf(2 * i, 2 * j + c) : -1;
          }
        }
      }
    }
  }

  int variableOf(const PlaneCorner& corner, std::size_t i) const
  {
    return this->Variable[static_cast<std::size_t>(corner.node[i])];
  }

  int slotOf(int row, int column) const
  {
    const int* inner = this->Hessian.innerIndexPtr();
    const int* outer = this->Hessian.outerIndexPtr();
    return static_cast<int>(
      std::lower_bound(inner + outer[column], inner + outer[column + 1], row) - inner);
  }

  /// The wanted shapes, all together, are as large as the section.
  void fitScale(const PlanePoints& points)
  {
    double area = 0.0;
    for (const PlaneCorner& corner : this->Corners)
    {
      area += edgesOf(corner, points).determinant();
    }
    this->Scale = area > 0.0 ? std::sqrt(this->ShapeArea / area) : 1.0;
  }

  double valueAt(const PlanePoints& points, double epsilon, double power) const
  {
    double sum = 0.0;
    for (const PlaneCorner& corner : this->Corners)
    {
      const double value = distortionValue<2>(
        edgesOf(corner, points) * corner.inverseShape * this->Scale, epsilon, VolumeWeight);
      sum += power == 1.0 ? value : std::pow(value, power);
    }
    return sum;
  }

  double leastDeterminant(const PlanePoints& points) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const PlaneCorner& corner : this->Corners)
    {
      least = std::min(
        least, (edgesOf(corner, points) * corner.inverseShape * this->Scale).determinant());
    }
    return least;
  }

  Index inverted(const PlanePoints& points) const
  {
    return std::count_if(this->Corners.begin(), this->Corners.end(),
      [&](const PlaneCorner& c) { return !(edgesOf(c, points).determinant() > 0.0); });
  }

  void assemble(const PlanePoints& points, double epsilon, double power)
  {
    this->Gradient.setZero();
    double* values = this->Hessian.valuePtr();
    std::fill(values, values + this->Hessian.nonZeros(), 0.0);
    for (const PlaneCorner& corner : this->Corners)
    {
      const Eigen::Matrix2d inverse = corner.inverseShape * this->Scale;
      Distortion<2> d = distortion<2>(edgesOf(corner, points) * inverse, epsilon, VolumeWeight);
      if (power != 1.0)
      {
        const Eigen::Map<const Eigen::Vector4d> slope(d.gradient.data());
        const double outer = power * std::pow(d.value, power - 1.0);
        d.curvature += (power - 1.0) / d.value * slope * slope.transpose();
        d.curvature *= outer;
        d.gradient *= outer;
      }
      this->add(corner, d.gradient * inverse.transpose(), inEdges(d.curvature, inverse));
    }
    const double shift = Damping * this->Hessian.diagonal().mean();
    for (Index i = 0; i < this->Gradient.size(); ++i)
    {
      this->Hessian.coeffRef(i, i) += shift;
    }
  }

  /// @param gradient, curvature with respect to the corner's edges.
  void add(
    const PlaneCorner& corner, const Eigen::Matrix2d& gradient, const Eigen::Matrix4d& curvature)
  {
    std::size_t slot = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int row = this->variableOf(corner, i);
      if (row >= 0)
      {
        this->Gradient.segment<2>(2 * row) +=
          EdgeSign[i][0] * gradient.col(0) + EdgeSign[i][1] * gradient.col(1);
      }
      for (std::size_t j = 0; j < 3; ++j, slot += 2)
      {
        if (corner.slot[slot] < 0)
        {
          continue;
        }
        Eigen::Matrix2d block = Eigen::Matrix2d::Zero();
        for (int e = 0; e < 2; ++e)
        {
          for (int f = 0; f < 2; ++f)
          {
            block += EdgeSign[i][e] * EdgeSign[j][f] * curvature.block<2, 2>(2 * e, 2 * f);
          }
        }
        for (std::size_t c = 0; c < 2; ++c)
        {
          double* value = this->Hessian.valuePtr() + corner.slot[slot + c];
          value[0] += block(0, static_cast<Index>(c));
          value[1] += block(1, static_cast<Index>(c));
        }
      }
    }
  }

  /// Newton's step; not a number where the matrix is not positive definite to working accuracy.
  Eigen::VectorXd step()
  {
    try
    {
      this->Solver->factorize(this->Hessian);
      return this->Solver->solve(-this->Gradient);
    }
    catch (const SolverFailure&)
    {
      return Eigen::VectorXd::Constant(this->Gradient.size(), std::nan(""));
    }
  }

  PlanePoints moved(const PlanePoints& points, const Eigen::VectorXd& move, double t) const
  {
    PlanePoints next = points;
    for (std::size_t k = 0; k < this->FreeNodes.size(); ++k)
    {
      next.row(this->FreeNodes[k]) += t * move.segment<2>(2 * static_cast<Index>(k)).transpose();
    }
    return next;
  }

  /// @return the sum before and after.
  std::pair<double, double> descend(PlanePoints& points, double epsilon, double power, int steps)
  {
    double value = this->valueAt(points, epsilon, power);
    const double before = value;
    for (int s = 0; s < steps; ++s)
    {
      this->assemble(points, epsilon, power);
      const Eigen::VectorXd move = this->step();
      const double slope = move.dot(this->Gradient);
      if (!move.allFinite() || !(slope < 0.0))
      {
        break;
      }
      double t = 1.0;
      int backtrack = 0;
      PlanePoints next;
      double nextValue = value;
      for (; backtrack < MaximumBacktracks; ++backtrack, t *= 0.5)
      {
        next = this->moved(points, move, t);
        nextValue = this->valueAt(next, epsilon, power);
        if (std::isfinite(nextValue) && nextValue <= value + SufficientDecrease * t * slope)
        {
          break;
        }
      }
      if (backtrack == MaximumBacktracks)
      {
        break;
      }
      const bool settled = value - nextValue <= Settled * std::abs(value);
      points = std::move(next);
      value = nextValue;
      if (settled)
      {
        break;
      }
    }
    return { before, value };
  }
};

SectionDescent::SectionDescent(const QuadsRef& quads, const std::vector<bool>& fixed,
  const PointsRef& source, const PointsRef& target)
  : Self(std::make_unique<Implementation>())
{
  Implementation& self = *this->Self;
  const auto isFixed = [&](Index node) { return fixed[static_cast<std::size_t>(node)]; };
  self.Variable.assign(fixed.size(), -1);
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      PlaneCorner corner;
      corner.node = { quads(q, c), quads(q, (c + 1) % 4), quads(q, (c + 3) % 4) };
      int& variable = self.Variable[static_cast<std::size_t>(corner.node[0])];
      if (!isFixed(corner.node[0]) && variable < 0)
      {
        variable = static_cast<int>(self.FreeNodes.size());
        self.FreeNodes.push_back(corner.node[0]);
      }
      if (!isFixed(corner.node[0]) || !isFixed(corner.node[1]) || !isFixed(corner.node[2]))
      {
        corner.atSource = shapeOf(source, corner.node);
        corner.atTarget = shapeOf(target, corner.node);
        self.Corners.push_back(corner);
      }
    }
  }
  this->wantShapes(0.0);
  self.findSlots();
  if (!self.FreeNodes.empty())
  {
    self.Solver.emplace(self.Hessian, MultifrontalSolver::Kind::Cholesky);
  }
}

SectionDescent::~SectionDescent() = default;
SectionDescent::SectionDescent(SectionDescent&&) noexcept = default;

void SectionDescent::wantShapes(double share)
{
  this->Self->ShapeArea = 0.0;
  for (PlaneCorner& corner : this->Self->Corners)
  {
    const Eigen::Matrix2d wanted = edgesOf(between(corner.atSource, corner.atTarget, share));
    this->Self->ShapeArea += wanted.determinant();
    corner.inverseShape = wanted.inverse();
  }
}

Index SectionDescent::inverted(const PlanePoints& points) const
{
  return this->Self->inverted(points);
}

Index SectionDescent::untangle(PlanePoints& points, int rounds)
{
  Implementation& self = *this->Self;
  Index best = self.inverted(points);
  if (self.FreeNodes.empty())
  {
    return best;
  }
  self.fitScale(points);
  PlanePoints current = points;
  double epsilon = FirstEpsilon;
  for (int round = 0; round < rounds && best > 0; ++round)
  {
    const auto [before, after] = self.descend(current, epsilon, UntanglingPower, NewtonSteps);
    const Index left = self.inverted(current);
    if (left < best)
    {
      best = left;
      points = current;
    }
    epsilon = nextEpsilon(epsilon, self.leastDeterminant(current), before, after, LeastRate);
  }
  return best;
}

void SectionDescent::relax(PlanePoints& points, int steps)
{
  Implementation& self = *this->Self;
  if (!self.FreeNodes.empty() && self.inverted(points) == 0)
  {
    self.fitScale(points);
    PlanePoints next = points;
    self.descend(next, LastEpsilon, RelaxingPower, steps);
    if (self.inverted(next) == 0)
    {
      points = std::move(next);
    }
  }
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CapDescent.h"

#include "Core/Common/Errors.h"
#include "Core/Solvers/MultifrontalSolver.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace hexsweep
{
namespace
{
constexpr int MaximumBacktracks = 25;
constexpr double SufficientDecrease = 1e-4;
/// Added to the diagonal, relative to its mean: directions that no term sees stay put.
constexpr double Damping = 1e-6;

using TangentFrame = Eigen::Matrix<double, 2, 3>;

TangentFrame tangentFrame(const Eigen::RowVector3d& normal)
{
  TangentFrame frame;
  const Eigen::RowVector3d first = normal.unitOrthogonal();
  frame.row(0) = first;
  frame.row(1) = normal.cross(first);
  return frame;
}

/// The edges of a corner are `next - node` and `previous - node`: signs of nodes 0, 1, 2 in each.
constexpr double EdgeSign[3][2] = { { -1.0, -1.0 }, { 1.0, 0.0 }, { 0.0, 1.0 } };
}

/// Where each corner's blocks go in the Hessian of the free nodes, two unknowns a node.
struct CapDescent::System
{
  std::vector<int> Variable; // node -> free node or -1
  SparseMatrix Hessian;
  std::vector<int> Slots; // 9 a corner: value index of each column of each block's first row
  std::optional<MultifrontalSolver> Solver;

  /// Newton's step; not a number where the matrix is not positive definite to working accuracy.
  Eigen::VectorXd step(const Eigen::VectorXd& gradient)
  {
    try
    {
      this->Solver->factorize(this->Hessian);
      return this->Solver->solve(-gradient);
    }
    catch (const SolverFailure&)
    {
      return Eigen::VectorXd::Constant(gradient.size(), std::nan(""));
    }
  }

  /// Index of the first of two consecutive values: rows 2 i and 2 i + 1 of column 2 j + c.
  int slot(int i, int j, int c) const
  {
    const int column = 2 * j + c;
    const int* begin = this->Hessian.innerIndexPtr() + this->Hessian.outerIndexPtr()[column];
    const int* end = this->Hessian.innerIndexPtr() + this->Hessian.outerIndexPtr()[column + 1];
    return static_cast<int>(std::lower_bound(begin, end, 2 * i) - this->Hessian.innerIndexPtr());
  }
};

CapDescent::CapDescent(const CapCorners& cap)
  : Cap(cap)
  , Equations(std::make_unique<System>())
{
  System& system = *this->Equations;
  Index nodes = 0;
  for (const QuadCorner& corner : cap.corners())
  {
    nodes = std::max({ nodes, corner.node[0] + 1, corner.node[1] + 1, corner.node[2] + 1 });
  }
  system.Variable.assign(static_cast<std::size_t>(nodes), -1);
  for (std::size_t k = 0; k < cap.freeNodes().size(); ++k)
  {
    system.Variable[static_cast<std::size_t>(cap.freeNodes()[k])] = static_cast<int>(k);
  }
  const auto variables = [&](const QuadCorner& corner) {
    std::array<int, 3> v{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      v[i] = system.Variable[static_cast<std::size_t>(corner.node[i])];
    }
    return v;
  };
  std::vector<Eigen::Triplet<double, int>> entries;
  for (const QuadCorner& corner : cap.corners())
  {
    for (const int i : variables(corner))
    {
      for (const int j : variables(corner))
      {
        if (i >= 0 && j >= 0)
        {
          for (const int c : { 0, 1 })
          {
            entries.emplace_back(2 * i, 2 * j + c, 0.0);
            entries.emplace_back(2 * i + 1, 2 * j + c, 0.0);
          }
        }
      }
    }
  }
  const Index n = 2 * static_cast<Index>(cap.freeNodes().size());
  system.Hessian.resize(n, n);
  system.Hessian.setFromTriplets(entries.begin(), entries.end());
  for (const QuadCorner& corner : cap.corners())
  {
    for (const int i : variables(corner))
    {
      for (const int j : variables(corner))
      {
        for (const int c : { 0, 1 })
        {
          system.Slots.push_back(i >= 0 && j >= 0 ? system.slot(i, j, c) : -1);
        }
      }
    }
  }
  if (n > 0)
  {
    system.Solver.emplace(system.Hessian, MultifrontalSolver::Kind::Cholesky);
  }
}

CapDescent::~CapDescent() = default;

CapDescent::Result CapDescent::descend(
  const Points& points, const Term& term, int steps, double relativeDecrease) const
{
  System& system = *this->Equations;
  const std::vector<QuadCorner>& corners = this->Cap.corners();
  const std::vector<Index>& freeNodes = this->Cap.freeNodes();
  const Index count = static_cast<Index>(freeNodes.size());
  const Points normals = this->Cap.place(points).normals;
  std::vector<TangentFrame> frames;
  for (const Index i : freeNodes)
  {
    frames.push_back(tangentFrame(normals.row(i)));
  }
  std::vector<TangentFrame> planes;
  for (const QuadCorner& corner : corners)
  {
    planes.push_back(tangentFrame(this->Cap.normal(corner, normals)));
  }

  const auto edgesOf = [&](std::size_t c, const Points& at) {
    const QuadCorner& corner = corners[c];
    Eigen::Matrix<double, 3, 2> edges;
    edges.col(0) = (at.row(corner.node[1]) - at.row(corner.node[0])).transpose();
    edges.col(1) = (at.row(corner.node[2]) - at.row(corner.node[0])).transpose();
    return Eigen::Matrix2d(planes[c] * edges);
  };
  const auto valueAt = [&](const Points& at) {
    double sum = 0.0;
    for (std::size_t c = 0; c < corners.size(); ++c)
    {
      if (corners[c].movable)
      {
        sum += term(c, edgesOf(c, at)).value;
      }
    }
    return sum;
  };

  /// Fills gradient and Hessian; returns the sum.
  Eigen::VectorXd gradient(2 * count);
  const auto assemble = [&](const Points& at) {
    double sum = 0.0;
    gradient.setZero();
    double* values = system.Hessian.valuePtr();
    std::fill(values, values + system.Hessian.nonZeros(), 0.0);
    for (std::size_t c = 0; c < corners.size(); ++c)
    {
      if (!corners[c].movable)
      {
        continue;
      }
      const CornerTerm t = term(c, edgesOf(c, at));
      sum += t.value;
      Eigen::Matrix2d turn[3]; // from a node's frame to the corner's plane
      int variable[3];
      for (int i = 0; i < 3; ++i)
      {
        variable[i] = system.Variable[static_cast<std::size_t>(corners[c].node[i])];
        if (variable[i] >= 0)
        {
          turn[i] = planes[c] * frames[static_cast<std::size_t>(variable[i])].transpose();
          gradient.segment<2>(2 * variable[i]) += turn[i].transpose() *
            (EdgeSign[i][0] * t.gradient.col(0) + EdgeSign[i][1] * t.gradient.col(1));
        }
      }
      for (int i = 0; i < 3; ++i)
      {
        for (int j = 0; j < 3; ++j)
        {
          if (variable[i] < 0 || variable[j] < 0)
          {
            continue;
          }
          Eigen::Matrix2d block = Eigen::Matrix2d::Zero();
          for (int e = 0; e < 2; ++e)
          {
            for (int f = 0; f < 2; ++f)
            {
              block += EdgeSign[i][e] * EdgeSign[j][f] * t.curvature.block<2, 2>(2 * e, 2 * f);
            }
          }
          block = turn[i].transpose() * block * turn[j];
          for (int k = 0; k < 2; ++k)
          {
            const int slot = system.Slots[c * 18 + static_cast<std::size_t>(6 * i + 2 * j + k)];
            values[slot] += block(0, k);
            values[slot + 1] += block(1, k);
          }
        }
      }
    }
    return sum;
  };

  Result result;
  result.points = points;
  if (count == 0)
  {
    result.before = result.after = valueAt(points);
    return result;
  }
  double value = assemble(result.points);
  result.before = value;
  for (int step = 0; step < steps && gradient.squaredNorm() > 0.0; ++step)
  {
    const double shift = Damping * system.Hessian.diagonal().mean();
    for (Index i = 0; i < 2 * count; ++i)
    {
      system.Hessian.coeffRef(i, i) += shift;
    }
    const Eigen::VectorXd move = system.step(gradient);
    const double slope = move.dot(gradient);
    if (!move.allFinite() || !(slope < 0.0))
    {
      break;
    }
    double t = 1.0;
    Points next;
    double nextValue = value;
    int backtrack = 0;
    for (; backtrack < MaximumBacktracks; ++backtrack, t *= 0.5)
    {
      next = result.points;
      for (Index k = 0; k < count; ++k)
      {
        next.row(freeNodes[static_cast<std::size_t>(k)]) +=
          t * move.segment<2>(2 * k).transpose() * frames[static_cast<std::size_t>(k)];
      }
      nextValue = valueAt(next);
      if (std::isfinite(nextValue) && nextValue <= value + SufficientDecrease * t * slope)
      {
        break;
      }
    }
    if (backtrack == MaximumBacktracks)
    {
      break;
    }
    const bool settled = value - nextValue <= relativeDecrease * std::abs(value);
    result.points = std::move(next);
    value = settled || step + 1 == steps ? nextValue : assemble(result.points);
    if (settled)
    {
      break;
    }
  }
  result.after = value;
  const SurfacePlaces places = this->Cap.place(result.points);
  for (const Index i : freeNodes)
  {
    result.points.row(i) = places.points.row(i);
  }
  return result;
}
}

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

/// The plane's axes, and the normal.
Eigen::Matrix3d spaceFrame(const Eigen::RowVector3d& normal)
{
  Eigen::Matrix3d frame;
  frame << tangentFrame(normal), normal;
  return frame;
}

/// A term that does not look at what is along the third axis.
ColumnCornerTerm inSpace(const CornerTerm& plane)
{
  ColumnCornerTerm term{ plane.value, CornerEdges::Zero(), Eigen::Matrix<double, 6, 6>::Zero() };
  term.gradient.topRows<2>() = plane.gradient;
  for (int e = 0; e < 2; ++e)
  {
    for (int f = 0; f < 2; ++f)
    {
      term.curvature.block<2, 2>(3 * e, 3 * f) = plane.curvature.block<2, 2>(2 * e, 2 * f);
    }
  }
  return term;
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

/// The sum of the terms, about one set of points: steps are taken in their tangent planes.
struct CapDescent::Energy
{
  Energy(const CapCorners& cap, System& equations, const Term& term, const ColumnTerm& columnTerm,
    const Points& points)
    : Cap(cap)
    , Equations(equations)
    , PlaneTermOf(term)
    , ColumnTermOf(columnTerm)
    , Gradient(2 * static_cast<Index>(cap.freeNodes().size()))
  {
    const Points normals = cap.place(points).normals;
    for (const Index i : cap.freeNodes())
    {
      this->Frames.push_back(tangentFrame(normals.row(i)));
    }
    for (const QuadCorner& corner : cap.corners())
    {
      this->Spaces.push_back(spaceFrame(cap.normal(corner, normals)));
    }
  }

  double valueAt(const Points& at) const
  {
    double sum = 0.0;
    for (std::size_t c = 0; c < this->Spaces.size(); ++c)
    {
      if (this->Cap.corners()[c].movable)
      {
        sum += this->termOf(c, at).value;
      }
    }
    return sum;
  }

  /// Fills gradient and Hessian; returns the sum.
  double assemble(const Points& at)
  {
    double sum = 0.0;
    this->Gradient.setZero();
    double* values = this->Equations.Hessian.valuePtr();
    std::fill(values, values + this->Equations.Hessian.nonZeros(), 0.0);
    for (std::size_t c = 0; c < this->Spaces.size(); ++c)
    {
      if (this->Cap.corners()[c].movable)
      {
        const ColumnCornerTerm t = this->termOf(c, at);
        sum += t.value;
        this->add(c, t);
      }
    }
    return sum;
  }

  /// Newton's step from where assemble() was called last.
  Eigen::VectorXd step()
  {
    SparseMatrix& hessian = this->Equations.Hessian;
    const double shift = Damping * hessian.diagonal().mean();
    for (Index i = 0; i < this->Gradient.size(); ++i)
    {
      hessian.coeffRef(i, i) += shift;
    }
    return this->Equations.step(this->Gradient);
  }

  Points moved(const Points& from, const Eigen::VectorXd& move, double t) const
  {
    Points next = from;
    for (std::size_t k = 0; k < this->Frames.size(); ++k)
    {
      next.row(this->Cap.freeNodes()[k]) +=
        t * move.segment<2>(2 * static_cast<Index>(k)).transpose() * this->Frames[k];
    }
    return next;
  }

  const Eigen::VectorXd& gradient() const { return this->Gradient; }

private:
  ColumnCornerTerm termOf(std::size_t c, const Points& at) const
  {
    const QuadCorner& corner = this->Cap.corners()[c];
    CornerEdges edges;
    edges.col(0) = (at.row(corner.node[1]) - at.row(corner.node[0])).transpose();
    edges.col(1) = (at.row(corner.node[2]) - at.row(corner.node[0])).transpose();
    edges = this->Spaces[c] * edges;
    return corner.column >= 0 && this->ColumnTermOf
      ? this->ColumnTermOf(c, edges)
      : inSpace(this->PlaneTermOf(c, edges.topRows<2>()));
  }

  void add(std::size_t c, const ColumnCornerTerm& t)
  {
    const QuadCorner& corner = this->Cap.corners()[c];
    CornerEdges turn[3]; // from a node's frame to the corner's
    int variable[3];
    for (int i = 0; i < 3; ++i)
    {
      variable[i] = this->Equations.Variable[static_cast<std::size_t>(corner.node[i])];
      if (variable[i] >= 0)
      {
        turn[i] = this->Spaces[c] * this->Frames[static_cast<std::size_t>(variable[i])].transpose();
        this->Gradient.segment<2>(2 * variable[i]) += turn[i].transpose() *
          (EdgeSign[i][0] * t.gradient.col(0) + EdgeSign[i][1] * t.gradient.col(1));
      }
    }
    double* values = this->Equations.Hessian.valuePtr();
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        if (variable[i] < 0 || variable[j] < 0)
        {
          continue;
        }
        const Eigen::Matrix2d block = turn[i].transpose() * curvatureBetween(t, i, j) * turn[j];
        for (int k = 0; k < 2; ++k)
        {
          const int slot =
            this->Equations.Slots[c * 18 + static_cast<std::size_t>(6 * i + 2 * j + k)];
          values[slot] += block(0, k);
          values[slot + 1] += block(1, k);
        }
      }
    }
  }

  /// Of nodes i and j of a corner, in its frame.
  static Eigen::Matrix3d curvatureBetween(const ColumnCornerTerm& t, int i, int j)
  {
    Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
    for (int e = 0; e < 2; ++e)
    {
      for (int f = 0; f < 2; ++f)
      {
        block += EdgeSign[i][e] * EdgeSign[j][f] * t.curvature.block<3, 3>(3 * e, 3 * f);
      }
    }
    return block;
  }

  const CapCorners& Cap;
  System& Equations;
  const Term& PlaneTermOf;
  const ColumnTerm& ColumnTermOf;
  Eigen::VectorXd Gradient;
  std::vector<TangentFrame> Frames;    // of the free nodes
  std::vector<Eigen::Matrix3d> Spaces; // of the corners
};

CapDescent::Result CapDescent::descend(const Points& points, const Term& term, int steps,
  double relativeDecrease, const ColumnTerm& columnTerm) const
{
  Energy energy(this->Cap, *this->Equations, term, columnTerm, points);
  Result result;
  result.points = points;
  if (this->Cap.freeNodes().empty())
  {
    result.before = result.after = energy.valueAt(points);
    return result;
  }
  double value = energy.assemble(result.points);
  result.before = value;
  for (int step = 0; step < steps && energy.gradient().squaredNorm() > 0.0; ++step)
  {
    const Eigen::VectorXd move = energy.step();
    const double slope = move.dot(energy.gradient());
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
      next = energy.moved(result.points, move, t);
      nextValue = energy.valueAt(next);
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
    value = settled || step + 1 == steps ? nextValue : energy.assemble(result.points);
    if (settled)
    {
      break;
    }
  }
  result.after = value;
  const SurfacePlaces places = this->Cap.place(result.points);
  for (const Index i : this->Cap.freeNodes())
  {
    result.points.row(i) = places.points.row(i);
  }
  return result;
}
}

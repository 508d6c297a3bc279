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

/// The edges of a corner are `next - node` and `previous - node`: what its nodes 0, 1, 2 feel of a
/// curvature by both edges in D dimensions. Of the blocks (i, j) those with i <= j.
template <int D>
struct NodeCurvature
{
  using Block = Eigen::Matrix<double, D, D>;
  Block blocks[3][3];

  explicit NodeCurvature(const Eigen::Matrix<double, 2 * D, 2 * D>& byEdges)
  {
    const Block next = byEdges.template topLeftCorner<D, D>();
    const Block mixed = byEdges.template topRightCorner<D, D>();
    const Block previous = byEdges.template bottomRightCorner<D, D>();
    this->blocks[1][1] = next;
    this->blocks[1][2] = mixed;
    this->blocks[2][2] = previous;
    this->blocks[0][1] = -(next + mixed.transpose());
    this->blocks[0][2] = -(mixed + previous);
    this->blocks[0][0] = -(this->blocks[0][1] + this->blocks[0][2]);
  }
};
}

struct CapDescent::Terms
{
  const Term& plane;
  const Value* value = nullptr; // of the plane's term
  const ColumnTerm* column = nullptr;
};

/// Where each corner's blocks go in the Hessian of the free nodes, two unknowns a node.
struct CapDescent::System
{
  std::vector<int> Variable; // node -> free node or -1
  SparseMatrix Hessian;
  /// 18 a corner: value index of the first row of each column of its nine blocks; -1: none.
  std::vector<int> Slots;
  std::vector<int> Diagonal; // value indices
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
  for (int i = 0; i < static_cast<int>(n); ++i)
  {
    system.Diagonal.push_back(system.slot(i / 2, i / 2, i % 2) + i % 2);
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
  Energy(const CapCorners& cap, System& equations, const Terms& terms, const Points& points)
    : Cap(cap)
    , Equations(equations)
    , TermsOf(terms)
    , Gradient(2 * static_cast<Index>(cap.freeNodes().size()))
  {
    const Points normals = cap.normals(points);
    for (const Index i : cap.freeNodes())
    {
      this->Frames.push_back(tangentFrame(normals.row(i)));
    }
    for (std::size_t c = 0; c < cap.corners().size(); ++c)
    {
      if (cap.corners()[c].movable)
      {
        this->Movable.push_back(c);
        this->Spaces.push_back(spaceFrame(cap.normal(cap.corners()[c], normals)));
      }
    }
  }

  double valueAt(const Points& at) const
  {
    double sum = 0.0;
    for (std::size_t m = 0; m < this->Movable.size(); ++m)
    {
      const std::size_t c = this->Movable[m];
      const CornerEdges edges = this->edges(m, at);
      sum += this->hasColumnTerm(c) ? (*this->TermsOf.column)(c, edges).value
        : this->TermsOf.value       ? (*this->TermsOf.value)(c, edges.topRows<2>())
                                    : this->TermsOf.plane(c, edges.topRows<2>()).value;
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
    for (std::size_t m = 0; m < this->Movable.size(); ++m)
    {
      const std::size_t c = this->Movable[m];
      const CornerEdges edges = this->edges(m, at);
      if (this->hasColumnTerm(c))
      {
        const ColumnCornerTerm t = (*this->TermsOf.column)(c, edges);
        sum += t.value;
        this->add<3>(m, t.gradient, t.curvature);
      }
      else
      {
        const CornerTerm t = this->TermsOf.plane(c, edges.topRows<2>());
        sum += t.value;
        this->add<2>(m, t.gradient, t.curvature);
      }
    }
    return sum;
  }

  /// Newton's step from where assemble() was called last.
  Eigen::VectorXd step()
  {
    SparseMatrix& hessian = this->Equations.Hessian;
    double sum = 0.0;
    for (const int i : this->Equations.Diagonal)
    {
      sum += hessian.valuePtr()[i];
    }
    const double shift = Damping * sum / static_cast<double>(this->Equations.Diagonal.size());
    for (const int i : this->Equations.Diagonal)
    {
      hessian.valuePtr()[i] += shift;
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
  bool hasColumnTerm(std::size_t c) const
  {
    return this->TermsOf.column && this->Cap.corners()[c].column >= 0;
  }

  /// Of a movable corner, in its frame.
  CornerEdges edges(std::size_t m, const Points& at) const
  {
    const QuadCorner& corner = this->Cap.corners()[this->Movable[m]];
    CornerEdges edges;
    edges.col(0) = (at.row(corner.node[1]) - at.row(corner.node[0])).transpose();
    edges.col(1) = (at.row(corner.node[2]) - at.row(corner.node[0])).transpose();
    return this->Spaces[m] * edges;
  }

  /// Of a movable corner whose term looks at D coordinates of its frame.
  template <int D>
  void add(std::size_t m, const Eigen::Matrix<double, D, 2>& gradient,
    const Eigen::Matrix<double, 2 * D, 2 * D>& curvature)
  {
    const std::size_t c = this->Movable[m];
    const QuadCorner& corner = this->Cap.corners()[c];
    Eigen::Matrix<double, D, 2> turn[3]; // from a node's frame to the corner's
    const Eigen::Matrix<double, D, 1> pull[3] = { -gradient.rowwise().sum(), gradient.col(0),
      gradient.col(1) };
    int variable[3];
    for (int i = 0; i < 3; ++i)
    {
      variable[i] = this->Equations.Variable[static_cast<std::size_t>(corner.node[i])];
      if (variable[i] >= 0)
      {
        turn[i] = this->Spaces[m].template topRows<D>() *
          this->Frames[static_cast<std::size_t>(variable[i])].transpose();
        this->Gradient.template segment<2>(2 * variable[i]) += turn[i].transpose() * pull[i];
      }
    }
    const NodeCurvature<D> between(curvature);
    double* values = this->Equations.Hessian.valuePtr();
    const int* slots = this->Equations.Slots.data() + 18 * c;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = i; j < 3; ++j)
      {
        if (variable[i] < 0 || variable[j] < 0)
        {
          continue;
        }
        const Eigen::Matrix2d block = turn[i].transpose() * (between.blocks[i][j] * turn[j]).eval();
        for (int k = 0; k < 2; ++k)
        {
          double* column = values + slots[6 * i + 2 * j + k];
          column[0] += block(0, k);
          column[1] += block(1, k);
          if (i != j)
          {
            double* mirrored = values + slots[6 * j + 2 * i + k];
            mirrored[0] += block(k, 0);
            mirrored[1] += block(k, 1);
          }
        }
      }
    }
  }

  const CapCorners& Cap;
  System& Equations;
  const Terms& TermsOf;
  Eigen::VectorXd Gradient;
  std::vector<TangentFrame> Frames;    // of the free nodes
  std::vector<std::size_t> Movable;    // corners
  std::vector<Eigen::Matrix3d> Spaces; // of the movable corners
};

CapDescent::Result CapDescent::descend(const Points& points, const Term& term, int steps,
  double relativeDecrease, const ColumnTerm& columnTerm) const
{
  return this->descend(
    points, Terms{ term, nullptr, columnTerm ? &columnTerm : nullptr }, steps, relativeDecrease);
}

CapDescent::Result CapDescent::descend(const Points& points, const Term& term, const Value& value,
  int steps, double relativeDecrease) const
{
  return this->descend(points, Terms{ term, &value, nullptr }, steps, relativeDecrease);
}

CapDescent::Result CapDescent::descend(
  const Points& points, const Terms& terms, int steps, double relativeDecrease) const
{
  Energy energy(this->Cap, *this->Equations, terms, points);
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

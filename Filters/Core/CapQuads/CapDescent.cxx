// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CapDescent.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr int MaximumBacktracks = 25;
constexpr double SufficientDecrease = 1e-4;
/// Added to the diagonal, relative to its mean: directions that no term sees stay put.
constexpr double Damping = 1e-6;

constexpr Index QuadsAtOnce = 256;
constexpr Index NodesAtOnce = 2048;

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

CapDescent::CapDescent(const CapCorners& cap, NewtonEquations equations)
  : Cap(cap)
  , Equations(std::make_unique<CapEquations>(cap, equations))
{
}

CapDescent::~CapDescent() = default;

/// The sum of the terms, about one set of points: steps are taken in their tangent planes.
struct CapDescent::Energy
{
  Energy(const CapCorners& cap, CapEquations& equations, const Terms& terms, const Points& points)
    : Cap(cap)
    , Equations(equations)
    , TermsOf(terms)
    , Gradient(2 * static_cast<Index>(cap.freeNodes().size()))
    , Frames(cap.freeNodes().size())
    , Spaces(cap.corners().size())
    , Values(cap.quads().rows())
  {
    const Points normals = cap.normals(points);
    forPieces(cap.parallelFor(), static_cast<Index>(this->Frames.size()), NodesAtOnce,
      [&](Index begin, Index end) {
        for (Index k = begin; k < end; ++k)
        {
          const auto i = static_cast<std::size_t>(k);
          this->Frames[i] = tangentFrame(normals.row(cap.freeNodes()[i]));
        }
      });
    forPieces(cap.parallelFor(), static_cast<Index>(this->Spaces.size()), NodesAtOnce,
      [&](Index begin, Index end) {
        for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c)
        {
          if (cap.corners()[c].movable)
          {
            this->Spaces[c] = spaceFrame(cap.normal(cap.corners()[c], normals));
          }
        }
      });
  }

  double valueAt(const Points& at)
  {
    forPieces(
      this->Cap.parallelFor(), this->Values.size(), QuadsAtOnce, [&](Index begin, Index end) {
        for (Index q = begin; q < end; ++q)
        {
          this->Values[q] = 0.0;
          this->forCorners(q, [&](std::size_t c) {
            const CornerEdges edges = this->edges(c, at);
            this->Values[q] += this->hasColumnTerm(c) ? (*this->TermsOf.column)(c, edges).value
              : this->TermsOf.value ? (*this->TermsOf.value)(c, edges.topRows<2>())
                                    : this->TermsOf.plane(c, edges.topRows<2>()).value;
          });
        }
      });
    return this->sum();
  }

  /// Fills gradient and Hessian; returns the sum.
  double assemble(const Points& at)
  {
    this->Gradient.setZero();
    this->Equations.setZero();
    for (const std::vector<Index>& quads : this->Equations.colors())
    {
      forPieces(this->Cap.parallelFor(), static_cast<Index>(quads.size()), QuadsAtOnce,
        [&](Index begin, Index end) {
          for (Index k = begin; k < end; ++k)
          {
            const Index q = quads[static_cast<std::size_t>(k)];
            this->Values[q] = 0.0;
            this->forCorners(q, [&](std::size_t c) { this->Values[q] += this->addTerm(c, at); });
          }
        });
    }
    return this->sum();
  }

  /// Newton's step from the points where assemble() was called last.
  Eigen::VectorXd step(const Points& at)
  {
    this->Equations.damp(Damping);
    return this->Equations.step(
      this->Gradient, at(this->Cap.freeNodes(), Eigen::all), this->Cap.parallelFor());
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
  /// In the order of the quads, whoever has added up the corners of each.
  double sum() const
  {
    double sum = 0.0;
    for (Index q = 0; q < this->Values.size(); ++q)
    {
      sum += this->Values[q];
    }
    return sum;
  }

  /// The movable ones of a quad.
  template <typename Body>
  void forCorners(Index q, const Body& body) const
  {
    for (std::size_t c = this->Equations.firstCorner(q); c < this->Equations.firstCorner(q + 1);
         ++c)
    {
      if (this->Cap.corners()[c].movable)
      {
        body(c);
      }
    }
  }

  bool hasColumnTerm(std::size_t c) const
  {
    return this->TermsOf.column && this->Cap.corners()[c].column >= 0;
  }

  /// Of a movable corner, in its frame.
  CornerEdges edges(std::size_t c, const Points& at) const
  {
    const QuadCorner& corner = this->Cap.corners()[c];
    CornerEdges edges;
    edges.col(0) = (at.row(corner.node[1]) - at.row(corner.node[0])).transpose();
    edges.col(1) = (at.row(corner.node[2]) - at.row(corner.node[0])).transpose();
    return this->Spaces[c] * edges;
  }

  /// @return its value.
  double addTerm(std::size_t c, const Points& at)
  {
    const CornerEdges edges = this->edges(c, at);
    if (this->hasColumnTerm(c))
    {
      const ColumnCornerTerm t = (*this->TermsOf.column)(c, edges);
      this->add<3>(c, t.gradient, t.curvature);
      return t.value;
    }
    const CornerTerm t = this->TermsOf.plane(c, edges.topRows<2>());
    this->add<2>(c, t.gradient, t.curvature);
    return t.value;
  }

  /// Of a movable corner whose term looks at D coordinates of its frame.
  template <int D>
  void add(std::size_t c, const Eigen::Matrix<double, D, 2>& gradient,
    const Eigen::Matrix<double, 2 * D, 2 * D>& curvature)
  {
    Eigen::Matrix<double, D, 2> turn[3]; // from a node's frame to the corner's
    const Eigen::Matrix<double, D, 1> pull[3] = { -gradient.rowwise().sum(), gradient.col(0),
      gradient.col(1) };
    const std::array<int, 3> variable = this->Equations.variables(this->Cap.corners()[c]);
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (variable[i] >= 0)
      {
        turn[i] = this->Spaces[c].template topRows<D>() *
          this->Frames[static_cast<std::size_t>(variable[i])].transpose();
        this->Gradient.template segment<2>(2 * variable[i]) += turn[i].transpose() * pull[i];
      }
    }
    const NodeCurvature<D> between(curvature);
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = i; j < 3; ++j)
      {
        if (variable[i] < 0 || variable[j] < 0)
        {
          continue;
        }
        const Eigen::Matrix2d block = turn[i].transpose() * (between.blocks[i][j] * turn[j]).eval();
        this->Equations.add(c, i, j, block);
      }
    }
  }

  const CapCorners& Cap;
  CapEquations& Equations;
  const Terms& TermsOf;
  Eigen::VectorXd Gradient;
  std::vector<TangentFrame> Frames;    // of the free nodes
  std::vector<Eigen::Matrix3d> Spaces; // of the movable corners, by the numbers of all
  Eigen::VectorXd Values;              // of the quads
};

CapDescent::Result CapDescent::descend(const Points& points, const Term& term, int steps,
  double relativeDecrease, const ColumnTerm& columnTerm) const
{
  return this->descend(
    points, Terms{ term, nullptr, columnTerm ? &columnTerm : nullptr }, steps, relativeDecrease);
}

CapDescent::Result CapDescent::descend(const Points& points, const Term& term, const Value& value,
  int steps, double relativeDecrease, const ColumnTerm& columnTerm) const
{
  return this->descend(
    points, Terms{ term, &value, columnTerm ? &columnTerm : nullptr }, steps, relativeDecrease);
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
    const Eigen::VectorXd move = energy.step(result.points);
    ++result.steps;
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

// SPDX-License-Identifier: BSD-3-Clause
// Steps and sums of the descent against differences of sums that are made here, on a flat cap:
// there tangent planes are the cap, and nothing moves when nodes are put back on it.
#include "Core/CapQuads/CapDescent.h"

#include "Core/CapQuads/CornerTerms.h"

#include "Support/CapMeshes.h"
#include "Support/DenseTruth.h"
#include "Support/LentThreads.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace TestCapDescent
{
using hexsweep::CapCorners;
using hexsweep::CapDescent;
using hexsweep::CornerTerm;
using hexsweep::Index;
using hexsweep::Points;

/// A cap anywhere in space, and coordinates in its plane.
struct FlatCap
{
  hexsweep::QuadMesh mesh;
  hexsweep::TriangleMesh surface;
  std::vector<bool> fixed;
  Eigen::Matrix3d turn = test::someTurn(); // columns: the plane's axes and its normal

  FlatCap(int cells, const std::vector<test::Block>& holes, double shake, unsigned seed)
    : mesh(test::quadPlate(cells, holes, shake, seed))
    , surface(test::plate(cells, holes))
  {
    this->fixed = test::boundaryFlags(this->surface);
    const test::Similarity motion{ 2.5, this->turn, { 1.0, -3.0, 2.0 } };
    this->mesh.points = motion(this->mesh.points);
    this->surface.points = motion(this->surface.points);
  }

  CapCorners corners(const hexsweep::ParallelFor& parallelFor = {}) const
  {
    return { this->mesh.quads, this->fixed, this->surface, {}, this->mesh.points,
      hexsweep::LeaningColumns::PassedOver, parallelFor };
  }

  /// Along axis 0 or 1 of the plane.
  Eigen::RowVector3d axis(int i) const { return this->turn.col(i).transpose(); }

  /// Sum of the values over all corners with a free node.
  double sum(
    const Points& points, const std::function<CornerTerm(const Eigen::Matrix2d&)>& term) const
  {
    double result = 0.0;
    const Points plane = points * this->turn;
    for (Index q = 0; q < this->mesh.quads.rows(); ++q)
    {
      for (Index c = 0; c < 4; ++c)
      {
        const Index node = this->mesh.quads(q, c);
        const Index next = this->mesh.quads(q, (c + 1) % 4);
        const Index previous = this->mesh.quads(q, (c + 3) % 4);
        const auto isFixed = [&](Index i) { return this->fixed[static_cast<std::size_t>(i)]; };
        if (!isFixed(node) || !isFixed(next) || !isFixed(previous))
        {
          Eigen::Matrix2d edges;
          edges.col(0) = (plane.row(next) - plane.row(node)).head<2>().transpose();
          edges.col(1) = (plane.row(previous) - plane.row(node)).head<2>().transpose();
          result += term(edges).value;
        }
      }
    }
    return result;
  }
};

using PlainTerm = std::function<CornerTerm(const Eigen::Matrix2d&)>;

CapDescent::Term everywhere(const PlainTerm& term)
{
  return [=](std::size_t, const Eigen::Matrix2d& edges) { return term(edges); };
}

/// Half the squared lengths of both edges.
CornerTerm squaredLengths(const Eigen::Matrix2d& edges)
{
  return { 0.5 * edges.squaredNorm(), edges, Eigen::Matrix4d::Identity() };
}

/// No sum of terms of one edge each.
CornerTerm squaredDiagonal(const Eigen::Matrix2d& edges)
{
  const Eigen::Vector2d across = edges.col(0) - 0.6 * edges.col(1);
  Eigen::Matrix2d gradient;
  gradient << across, -0.6 * across;
  Eigen::Matrix<double, 2, 4> slope;
  slope << 1.0, 0.0, -0.6, 0.0, 0.0, 1.0, 0.0, -0.6;
  return sumOfTerms({ 0.5 * across.squaredNorm(), gradient, slope.transpose() * slope },
    squaredLengths(edges), 0.1);
}

/// Makes steps short, so that they are always accepted.
constexpr double Stiff = 1e4;

CornerTerm distorted(const Eigen::Matrix2d& edges)
{
  Eigen::Matrix2d inverse;
  inverse << 3.0, 0.7, -0.4, 2.0;
  return hexsweep::distortionTerm(edges, inverse, 0.1);
}

/// Gradient and second derivative of a sum by central differences: two unknowns a free node.
struct Differences
{
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;

  Differences(const FlatCap& cap, const std::vector<Index>& nodes, const Points& points,
    const PlainTerm& term, double step)
  {
    const Index n = 2 * static_cast<Index>(nodes.size());
    const auto at = [&](Index i, double a, Index j, double b) {
      Points moved = points;
      moved.row(nodes[static_cast<std::size_t>(i / 2)]) += a * cap.axis(static_cast<int>(i % 2));
      moved.row(nodes[static_cast<std::size_t>(j / 2)]) += b * cap.axis(static_cast<int>(j % 2));
      return cap.sum(moved, term);
    };
    this->gradient.resize(n);
    this->hessian.resize(n, n);
    const double h = step;
    for (Index i = 0; i < n; ++i)
    {
      this->gradient[i] = (at(i, h, i, 0.0) - at(i, -h, i, 0.0)) / (2.0 * h);
      for (Index j = 0; j < n; ++j)
      {
        this->hessian(i, j) =
          (at(i, h, j, h) - at(i, h, j, -h) - at(i, -h, j, h) + at(i, -h, j, -h)) / (4.0 * h * h);
      }
    }
  }
};

/// Moves of the free nodes along the plane's axes.
Eigen::VectorXd movesOf(
  const FlatCap& cap, const std::vector<Index>& nodes, const Points& from, const Points& to)
{
  Eigen::VectorXd moves(2 * static_cast<Index>(nodes.size()));
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    const Eigen::RowVector3d move = to.row(nodes[k]) - from.row(nodes[k]);
    EXPECT_LT(std::abs(move.dot(cap.turn.col(2))), 1e-14);
    for (int axis = 0; axis < 2; ++axis)
    {
      moves[2 * static_cast<Index>(k) + axis] = move.dot(cap.axis(axis));
    }
  }
  return moves;
}

void expectFixedStay(const FlatCap& cap, const Points& points)
{
  for (std::size_t i = 0; i < cap.fixed.size(); ++i)
  {
    if (cap.fixed[i])
    {
      EXPECT_EQ(points.row(static_cast<Index>(i)), cap.mesh.points.row(static_cast<Index>(i)));
    }
  }
}

// Differences of a quadratic function are exact: one step leads to where they vanish.
TEST(CapDescent, StepOnAQuadraticSumIsNewtons)
{
  const FlatCap cap(5, { { 2, 2, 1, 1 } }, 0.2, 3);
  const CapCorners corners = cap.corners();
  for (const PlainTerm& term : { PlainTerm(squaredLengths), PlainTerm(squaredDiagonal) })
  {
    const Points& start = cap.mesh.points;
    const Differences differences(cap, corners.freeNodes(), start, term, 0.5);
    const Eigen::VectorXd expected =
      -test::denseSolution(differences.hessian, differences.gradient);
    const CapDescent::Result result = CapDescent(corners).descend(start, everywhere(term), 1, 0.0);
    const Eigen::VectorXd moves = movesOf(cap, corners.freeNodes(), start, result.points);
    EXPECT_GT(expected.norm(), 0.1);
    // A millionth of the mean diagonal is added to the diagonal.
    EXPECT_LT((moves - expected).norm(), 1e-5 * expected.norm());
    EXPECT_NEAR(result.before, cap.sum(start, term), 1e-12 * result.before);
    EXPECT_NEAR(result.after, cap.sum(result.points, term), 1e-12 * result.before);
    expectFixedStay(cap, result.points);
  }
}

// With a known second derivative in place of the term's own the step tells the gradient.
TEST(CapDescent, GradientIsThatOfDifferences)
{
  const FlatCap cap(5, { { 2, 2, 1, 1 } }, 0.2, 3);
  const CapCorners corners = cap.corners();
  const Points& start = cap.mesh.points;
  const auto stiff = [](const Eigen::Matrix2d& edges) -> CornerTerm {
    const CornerTerm term = distorted(edges);
    return { term.value, term.gradient, Stiff * Eigen::Matrix4d::Identity() };
  };
  const Differences lengths(cap, corners.freeNodes(), start, squaredLengths, 0.5);
  const Differences differences(cap, corners.freeNodes(), start, distorted, 1e-4);
  const Eigen::VectorXd expected =
    -test::denseSolution(Stiff * lengths.hessian, differences.gradient);
  const CapDescent::Result result = CapDescent(corners).descend(start, everywhere(stiff), 1, 0.0);
  const Eigen::VectorXd moves = movesOf(cap, corners.freeNodes(), start, result.points);
  EXPECT_LT((moves - expected).norm(), 1e-5 * expected.norm());
}

// The value alone is asked along a step, and leads to the same place.
TEST(CapDescent, ValuesAloneLeadToTheSamePlace)
{
  const FlatCap cap(6, { { 2, 3, 2, 1 } }, 0.6, 5);
  const CapCorners corners = cap.corners();
  const CapDescent descent(corners);
  int values = 0;
  const auto value = [&](std::size_t, const Eigen::Matrix2d& edges) {
    ++values;
    return distorted(edges).value;
  };
  const CapDescent::Result full = descent.descend(cap.mesh.points, everywhere(distorted), 5, 0.0);
  const CapDescent::Result split =
    descent.descend(cap.mesh.points, everywhere(distorted), value, 5, 0.0);
  EXPECT_GT(values, 0);
  EXPECT_EQ(full.points, split.points);
  EXPECT_EQ(full.after, split.after);
}

// Corners at nodes with a column count twice, the second time across the column.
TEST(CapDescent, CornersUnderColumnsCountTwice)
{
  const FlatCap cap(4, {}, 0.2, 3);
  const Eigen::RowVector3d normal = cap.turn.col(2).transpose();
  const Eigen::RowVector3d leaning = normal + 0.8 * cap.axis(0) - 0.3 * cap.axis(1);
  // Node 1 is on the boundary, in quads 0 and 1.
  const CapCorners corners(
    cap.mesh.quads, cap.fixed, cap.surface, { { 1, leaning } }, cap.mesh.points);
  const CapDescent::Result result =
    CapDescent(corners).descend(cap.mesh.points, everywhere(squaredLengths), 0, 0.0);
  double expected = cap.sum(cap.mesh.points, squaredLengths);
  const Eigen::RowVector3d column = leaning.normalized();
  for (Index q = 0; q < 2; ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      if (cap.mesh.quads(q, c) == 1)
      {
        for (const Index other : { (c + 1) % 4, (c + 3) % 4 })
        {
          const Eigen::RowVector3d edge =
            cap.mesh.points.row(cap.mesh.quads(q, other)) - cap.mesh.points.row(1);
          expected += 0.5 * (edge - edge.dot(column) * column).squaredNorm();
        }
      }
    }
  }
  EXPECT_GT(corners.corners().size(), static_cast<std::size_t>(cap.mesh.quads.size()));
  EXPECT_NEAR(result.before, expected, 1e-12 * expected);
}

// With a term of their own they see their edges in space: lengths do not depend on the frame.
TEST(CapDescent, TermsAtColumnsSeeTheEdgesInSpace)
{
  const FlatCap cap(4, {}, 0.2, 3);
  const Eigen::RowVector3d normal = cap.turn.col(2).transpose();
  const Eigen::RowVector3d leaning = normal + 0.8 * cap.axis(0) - 0.3 * cap.axis(1);
  const CapCorners corners(
    cap.mesh.quads, cap.fixed, cap.surface, { { 1, leaning } }, cap.mesh.points);
  const auto lengthsAlong = [](std::size_t, const hexsweep::CornerEdges& edges) {
    // Lengths, and heights along the column once more.
    hexsweep::ColumnCornerTerm term{ 0.5 * edges.squaredNorm() + edges.row(2).sum(), edges,
      Eigen::Matrix<double, 6, 6>::Identity() };
    term.gradient.row(2).array() += 1.0;
    return term;
  };
  const CapDescent descent(corners);
  const double start =
    descent.descend(cap.mesh.points, everywhere(squaredLengths), 0, 0.0, lengthsAlong).before;
  double expected = cap.sum(cap.mesh.points, squaredLengths);
  const Eigen::RowVector3d column = leaning.normalized();
  for (Index q = 0; q < 2; ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      if (cap.mesh.quads(q, c) == 1)
      {
        for (const Index other : { (c + 1) % 4, (c + 3) % 4 })
        {
          const Eigen::RowVector3d edge =
            cap.mesh.points.row(cap.mesh.quads(q, other)) - cap.mesh.points.row(1);
          expected += 0.5 * edge.squaredNorm() + edge.dot(column);
        }
      }
    }
  }
  EXPECT_NEAR(start, expected, 1e-12 * expected);

  // A quadratic sum: its gradient vanishes after one step, so that another one leads nowhere.
  const Points end =
    descent.descend(cap.mesh.points, everywhere(squaredLengths), 3, 0.0, lengthsAlong).points;
  const Points further =
    descent.descend(end, everywhere(squaredLengths), 3, 0.0, lengthsAlong).points;
  EXPECT_GT((end - cap.mesh.points).norm(), 1e-3);
  EXPECT_LT((further - end).norm(), 1e-9);
}

// A column that leans far over the cap has corners only where they are asked for, and upright.
TEST(CapDescent, ColumnsThatLeanFarCountWhereUpright)
{
  const FlatCap cap(4, {}, 0.0, 3);
  const Eigen::RowVector3d normal = cap.turn.col(2).transpose();
  // Node 1 is on the boundary, in two quads; node 2 is its neighbor there.
  const auto countOf = [&](const std::vector<hexsweep::ColumnDirection>& columns,
                         hexsweep::LeaningColumns leaning) {
    return CapCorners(cap.mesh.quads, cap.fixed, cap.surface, columns, cap.mesh.points, leaning)
      .corners()
      .size();
  };
  using hexsweep::LeaningColumns;
  const std::size_t without = countOf({ { 2, normal } }, LeaningColumns::PassedOver);
  const auto cornersWith = [&](double height, LeaningColumns leaning) {
    return countOf({ { 1, height * normal + cap.axis(0) }, { 2, normal } }, leaning) - without;
  };
  EXPECT_EQ(cornersWith(0.2, LeaningColumns::PassedOver), 2u);
  EXPECT_EQ(cornersWith(0.01, LeaningColumns::PassedOver), 0u);
  EXPECT_EQ(cornersWith(0.01, LeaningColumns::WhereUpright), 2u);
  EXPECT_EQ(cornersWith(-0.01, LeaningColumns::WhereUpright), 0u); // the other tells the side
}

TEST(CapDescent, EndsWhereDifferencesVanish)
{
  const FlatCap cap(5, { { 2, 2, 1, 1 } }, 0.25, 8);
  const CapCorners corners = cap.corners();
  const Points& start = cap.mesh.points;
  const CapDescent::Result result =
    CapDescent(corners).descend(start, everywhere(distorted), 200, 1e-16);
  const Differences before(cap, corners.freeNodes(), start, distorted, 1e-4);
  const Differences after(cap, corners.freeNodes(), result.points, distorted, 1e-4);
  EXPECT_LT(after.gradient.norm(), 1e-6 * before.gradient.norm());
  EXPECT_GT(test::eigenvalues(after.hessian)[0], 0.0);
  EXPECT_NEAR(result.after, cap.sum(result.points, distorted), 1e-12 * result.after);
}

// The middle of four neighbours is the optimum of the squared lengths.
TEST(CapDescent, StartAtTheOptimumStays)
{
  const FlatCap cap(6, {}, 0.0, 1);
  const CapCorners corners = cap.corners();
  const CapDescent::Result result =
    CapDescent(corners).descend(cap.mesh.points, everywhere(squaredLengths), 10, 0.0);
  EXPECT_LT((result.points - cap.mesh.points).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_NEAR(result.after, result.before, 1e-14 * result.before);
}

TEST(CapDescent, NeverRaisesTheSum)
{
  int inverted = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    const FlatCap cap(6, { { 2, 3, 2, 1 } }, 0.8, seed);
    const CapCorners corners = cap.corners();
    inverted += corners.measure(cap.mesh.points).inverted > 0 ? 1 : 0;
    Points points = cap.mesh.points;
    const CapDescent descent(corners);
    double last = cap.sum(points, distorted);
    const double first = last;
    for (int round = 0; round < 4; ++round)
    {
      const CapDescent::Result result = descent.descend(points, everywhere(distorted), 2, 0.0);
      EXPECT_NEAR(result.before, cap.sum(points, distorted), 1e-9 * result.before);
      EXPECT_LE(result.after, result.before);
      points = result.points;
      const double now = cap.sum(points, distorted);
      EXPECT_LE(now, last * (1.0 + 1e-12)) << seed; // nodes are put back on the cap
      last = now;
    }
    EXPECT_LT(last, 0.9 * first);
    expectFixedStay(cap, points);
  }
  EXPECT_GT(inverted, 6);
}

// Few nodes: conjugate gradients arrive where the factorisation leads.
TEST(CapDescent, RoughStepsArriveWithTime)
{
  const FlatCap cap(8, { { 2, 3, 2, 1 } }, 0.3, 4);
  const CapCorners corners = cap.corners();
  const CapDescent::Result exact =
    CapDescent(corners).descend(cap.mesh.points, everywhere(distorted), 50, 0.0);
  const CapDescent descent(corners, hexsweep::NewtonEquations::Roughly);
  const CapDescent::Result first = descent.descend(cap.mesh.points, everywhere(distorted), 1, 0.0);
  EXPECT_LT(first.after, first.before);
  const CapDescent::Result rough = descent.descend(cap.mesh.points, everywhere(distorted), 50, 0.0);
  EXPECT_NEAR(rough.after, exact.after, 1e-9 * exact.after);
}

TEST(CapDescent, SameBitsInAnyOrder)
{
  const FlatCap cap(48, { { 8, 8, 8, 8 }, { 28, 24, 12, 12 } }, 0.4, 4);
  for (const auto equations :
    { hexsweep::NewtonEquations::Exactly, hexsweep::NewtonEquations::Roughly })
  {
    const auto descended = [&](const hexsweep::ParallelFor& parallelFor) -> CapDescent::Result {
      const CapCorners corners = cap.corners(parallelFor);
      return CapDescent(corners, equations).descend(cap.mesh.points, everywhere(distorted), 3, 0.0);
    };
    const CapDescent::Result one = descended({});
    for (const hexsweep::ParallelFor& order :
      { hexsweep::ParallelFor(test::backwards), hexsweep::ParallelFor(test::sideBySide) })
    {
      const CapDescent::Result other = descended(order);
      EXPECT_EQ(one.points, other.points);
      EXPECT_EQ(one.before, other.before);
      EXPECT_EQ(one.after, other.after);
    }
  }
}

TEST(CapDescent, WithoutFreeNodesNothingMoves)
{
  const FlatCap cap(1, {}, 0.0, 1);
  const CapCorners corners = cap.corners();
  const CapDescent::Result result =
    CapDescent(corners).descend(cap.mesh.points, everywhere(distorted), 5, 0.0);
  EXPECT_EQ(result.points, cap.mesh.points);
  EXPECT_EQ(result.before, 0.0); // no corner can move
  EXPECT_EQ(result.after, 0.0);
}
}

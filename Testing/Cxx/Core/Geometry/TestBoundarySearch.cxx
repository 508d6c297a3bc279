// SPDX-License-Identifier: BSD-3-Clause
// Rings off the boundary of a cap: facets of one curve are no mismatch, a moved cap is one.
#include "Core/Geometry/BoundarySearch.h"

#include "Support/CapMeshes.h"
#include "Support/SweepMeshes.h"

#include <numeric>

namespace TestBoundarySearch
{
using hexsweep::BoundaryMismatch;
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::Points;

/// n points of a closed curve; `spread` makes their spacing uneven.
Points sampled(
  const std::function<Eigen::RowVector3d(double)>& curve, Index n, double start, double spread = 0)
{
  Points points(n, 3);
  for (Index i = 0; i < n; ++i)
  {
    const double t = start + 2.0 * test::Pi * static_cast<double>(i) / static_cast<double>(n);
    points.row(i) = curve(t + spread * std::sin(3.0 * t));
  }
  return points;
}

Eigen::RowVector3d circle(double t)
{
  return { std::cos(t), std::sin(t), 0.0 };
}

/// Where a bent cylinder's end meets a cylinder across: a curve that leaves every plane.
Eigen::RowVector3d saddle(double t)
{
  return { std::cos(t), std::sin(t), 0.6 * std::cos(2.0 * t) };
}

Eigen::RowVector3d ellipse(double t)
{
  return { 3.0 * std::cos(t), std::sin(t), 0.5 * std::cos(t) };
}

/// A square of two units with n edges a side.
Points square(Index n)
{
  Points points(4 * n, 3);
  for (Index i = 0; i < n; ++i)
  {
    const double t = 2.0 * static_cast<double>(i) / static_cast<double>(n) - 1.0;
    points.row(i) << t, -1, 0;
    points.row(n + i) << 1, t, 0;
    points.row(2 * n + i) << -t, 1, 0;
    points.row(3 * n + i) << -1, -t, 0;
  }
  return points;
}

BoundaryMismatch mismatch(const Points& cap, const Points& ring)
{
  Loop loop(static_cast<std::size_t>(cap.rows()));
  std::iota(loop.begin(), loop.end(), Index{ 0 });
  return hexsweep::boundaryMismatch(cap, { loop }, { ring }, 1e-6);
}

TEST(BoundarySearch, FacetsOfOneCurveAreNoMismatch)
{
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    for (const auto& curve : { circle, saddle, ellipse })
    {
      for (const Index ringNodes : { 16, 40, 100 })
      {
        for (const Index capNodes : { 12, 17, 40, 99, 400 })
        {
          for (const double spread : { 0.0, 0.1 })
          {
            const Points ring = scale * sampled(curve, ringNodes, 0.0);
            const Points cap = scale * sampled(curve, capNodes, 0.123, spread);
            EXPECT_EQ(mismatch(cap, ring).nodes, 0) << ringNodes << " " << capNodes;
            EXPECT_EQ(mismatch(cap, ring).ringNodes, ringNodes);
          }
        }
      }
    }
  }
}

TEST(BoundarySearch, VerticesOnTheChordsOfTheOtherAreNoMismatch)
{
  const Points fine = sampled(circle, 48, 0.0);
  Points coarse(16, 3);
  for (Index i = 0; i < 16; ++i)
  {
    coarse.row(i) = 0.3 * fine.row(3 * i) + 0.7 * fine.row((3 * i + 1) % 48);
  }
  EXPECT_EQ(mismatch(coarse, fine).nodes, 0);
  EXPECT_EQ(mismatch(fine, coarse).nodes, 0);
}

TEST(BoundarySearch, PointsInSinglePrecisionAreNoMismatch)
{
  for (const Points& points : { square(9), sampled(saddle, 60, 0.2) })
  {
    const Points rounded = (1.37 * points).cast<float>().cast<double>();
    EXPECT_EQ(mismatch(rounded, 1.37 * points).nodes, 0);
  }
}

TEST(BoundarySearch, AMovedCapIsAMismatch)
{
  // A tenth of an edge, in the plane and across it.
  const double edge = 0.2;
  for (const Eigen::RowVector3d& shift :
    { Eigen::RowVector3d(0.1 * edge, 0, 0), Eigen::RowVector3d(0, 0, 0.1 * edge) })
  {
    const BoundaryMismatch found = mismatch(square(10).rowwise() + shift, square(10));
    EXPECT_NEAR(found.distance, 0.1 * edge, 1e-12);
    EXPECT_EQ(found.ringNodes, 40);
    // In the plane two sides slide along themselves, and next to corners anything may be a turn.
    EXPECT_EQ(found.nodes, shift[2] > 0 ? 40 : 16);
  }
}

TEST(BoundarySearch, FacetsDoNotExplainADistanceAcrossTheirPlane)
{
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    const Points ring = sampled(circle, 12, 0.0);
    const Points cap = sampled(circle, 15, 0.1);
    const Eigen::RowVector3d up(0, 0, 0.05);
    const BoundaryMismatch found = mismatch(scale * (cap.rowwise() + up), scale * ring);
    EXPECT_EQ(found.nodes, 12);
    EXPECT_GE(found.distance, 0.05 * scale * (1.0 - 1e-9));
    // Four sagittas explain a smaller circle no longer.
    EXPECT_EQ(mismatch(0.98 * cap, ring).nodes, 0);
    EXPECT_GT(mismatch(0.8 * cap, ring).nodes, 0);
  }
}

TEST(BoundarySearch, TheMismatchInWords)
{
  EXPECT_EQ(hexsweep::describeMismatch({}, "target surface", "last ring"), "");
  const BoundaryMismatch found =
    mismatch(square(10).rowwise() + Eigen::RowVector3d(0, 0, 0.0125), square(10));
  const std::string text = hexsweep::describeMismatch(found, "target surface", "last ring");
  EXPECT_NE(text.find("the boundary of the target surface is not the last ring: 40 of 40 nodes"),
    std::string::npos)
    << text;
  EXPECT_NE(text.find("by 0.0125 at ("), std::string::npos) << text;
}
}

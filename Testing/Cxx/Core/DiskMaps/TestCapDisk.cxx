// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/CapDisk.h"
#include "Core/Solvers/SurfaceLaplacian.h"

#include "Support/CapMeshes.h"

namespace TestCapDisk
{
using hexsweep::CapDisk;
using hexsweep::Circle;
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::PlanePoints;
using hexsweep::TriangleMesh;
using hexsweep::Weights;

double clearance(const std::vector<Circle>& circles)
{
  double least = 1.0;
  for (std::size_t i = 0; i < circles.size(); ++i)
  {
    least = std::min(least, 1.0 - circles[i].center.norm() - circles[i].radius);
    for (std::size_t j = 0; j < i; ++j)
    {
      least = std::min(least,
        (circles[i].center - circles[j].center).norm() - circles[i].radius - circles[j].radius);
    }
  }
  return least;
}

TEST(CapDisk, BoundaryFlags)
{
  const std::vector<bool> flags = hexsweep::boundaryFlags(6, { { 0, 5 }, { 3 } });
  EXPECT_EQ(flags, (std::vector<bool>{ true, false, false, true, false, true }));
}

TEST(CapDisk, MapToPlaneReproducesAPlaneCap)
{
  // The harmonic map with a linear boundary map is that linear map, for both weights.
  const TriangleMesh plane = test::plate(12, test::threeHoles(), 0.3);
  PlanePoints expected = plane.points.leftCols<2>();
  expected = (expected * (Eigen::Matrix2d() << 2, 0.5, -0.3, 1).finished()).eval();
  const std::vector<Loop> loops = test::loopsOf(plane);
  std::vector<PlanePoints> places;
  for (const Loop& loop : loops)
  {
    places.emplace_back(static_cast<Index>(loop.size()), 2);
    for (std::size_t k = 0; k < loop.size(); ++k)
    {
      places.back().row(static_cast<Index>(k)) = expected.row(loop[k]);
    }
  }
  const TriangleMesh mesh{ test::Similarity{ 3.0, test::someTurn(), { 1, 2, 3 } }(plane.points),
    plane.triangles };
  for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
  {
    const PlanePoints disk = hexsweep::mapToPlane(mesh, loops, places, weights);
    EXPECT_LT((disk - expected).cwiseAbs().maxCoeff(), 1e-13);
    for (std::size_t p = 0; p < loops.size(); ++p)
    {
      for (std::size_t k = 0; k < loops[p].size(); ++k)
      {
        EXPECT_EQ(disk.row(loops[p][k]), places[p].row(static_cast<Index>(k)));
      }
    }
  }
}

TEST(CapDisk, CirclesThatAreClearStayAsTheyAre)
{
  std::vector<Circle> circles{ { { 0.3, 0.0 }, 0.1 }, { { -0.3, 0.0 }, 0.05 } };
  hexsweep::separateCircles(circles);
  EXPECT_EQ(circles[0].radius, 0.1);
  EXPECT_EQ(circles[1].radius, 0.05);
}

TEST(CapDisk, CirclesAreShrunkUntilTheyAreClear)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-0.69, 0.69);
  for (int trial = 0; trial < 200; ++trial)
  {
    std::vector<Circle> circles;
    for (int i = 0; i < 8; ++i)
    {
      circles.push_back({ { uniform(generator), uniform(generator) }, 0.5 });
    }
    const std::vector<Circle> before = circles;
    hexsweep::separateCircles(circles);
    EXPECT_GT(clearance(circles), 0.0);
    for (std::size_t i = 0; i < circles.size(); ++i)
    {
      EXPECT_EQ(circles[i].center, before[i].center);
      EXPECT_GT(circles[i].radius, 0.0);
      EXPECT_LE(circles[i].radius, before[i].radius);
    }
  }
}

TEST(CapDisk, CentresThatCoincideOrLieOutside)
{
  std::vector<Circle> same{ { { 0.3, 0.0 }, 0.1 }, { { 0.3, 0.0 }, 0.1 } };
  test::expectInvalid([&] { hexsweep::separateCircles(same); }, "one point of the disk");
  std::vector<Circle> outside{ { { 1.0, 0.0 }, 0.1 } };
  EXPECT_THROW(hexsweep::separateCircles(outside), hexsweep::InvalidInput);
}

TEST(CapDisk, HoleAnglesRunClockwiseAndFitTheMap)
{
  // A loop of nine nodes drawn clockwise about a centre and turned by a known angle.
  const std::vector<double> lengths{ 0.0, 0.2, 1.0, 1.5, 2.5, 3.0, 4.0, 5.0, 5.9 };
  const Circle hole{ { 0.2, -0.1 }, 0.3 };
  for (const double turn : { -3.0, -0.5, 0.0, 1.0, 3.1 })
  {
    PlanePoints disk(9, 2);
    Loop loop;
    for (Index k = 0; k < 9; ++k)
    {
      const double angle = turn - lengths[static_cast<std::size_t>(k)];
      disk.row(8 - k) = hole.center + 0.25 * Eigen::RowVector2d(std::cos(angle), std::sin(angle));
      loop.push_back(8 - k);
    }
    const std::vector<double> angles = hexsweep::holeAngles(lengths, disk, loop, hole);
    for (std::size_t k = 0; k < 9; ++k)
    {
      EXPECT_NEAR(angles[k], turn - lengths[k], 1e-14);
    }
  }
}

TEST(CapDisk, FallsBackToMeanValueWeightsOnlyWhereThatHelps)
{
  const TriangleMesh mesh = test::disk(3, 8);
  const PlanePoints good = mesh.points.leftCols<2>();
  PlanePoints bad = good;
  bad.row(8) << -0.9, 0.0;
  PlanePoints worse = bad;
  worse.row(12) << 0.9, 0.05;
  const auto run = [&](Weights wanted, const PlanePoints& cotangent, const PlanePoints& meanValue) {
    CapDisk cap;
    cap.mesh = mesh;
    hexsweep::mapWithFallback(
      cap, wanted, [&](Weights w) { return w == Weights::Cotangent ? cotangent : meanValue; });
    return cap;
  };
  const CapDisk fine = run(Weights::Cotangent, good, bad);
  EXPECT_EQ(fine.weights, Weights::Cotangent);
  EXPECT_EQ(fine.disk, good);
  EXPECT_EQ(fine.flipsBefore, 0);

  const CapDisk helped = run(Weights::Cotangent, bad, good);
  EXPECT_EQ(helped.weights, Weights::MeanValue);
  EXPECT_EQ(helped.disk, good);
  EXPECT_GT(helped.flipsBefore, 0);
  EXPECT_TRUE(helped.flipped.empty());

  const CapDisk kept = run(Weights::Cotangent, bad, worse);
  EXPECT_EQ(kept.weights, Weights::Cotangent);
  EXPECT_EQ(kept.disk, bad);
  EXPECT_EQ(static_cast<Index>(kept.flipped.size()), kept.flipsBefore);

  const CapDisk asked = run(Weights::MeanValue, good, bad);
  EXPECT_EQ(asked.weights, Weights::MeanValue);
  EXPECT_EQ(asked.disk, bad);
}
}

// SPDX-License-Identifier: BSD-3-Clause
// The image of a similar cap is known to rounding: it is the image of the quads.
#include "Core/CapQuads/SweepProjection.h"

#include "Core/Solvers/SurfaceLaplacian.h"
#include "Core/Surfaces/QuadHalving.h"
#include "Core/Surfaces/SurfaceRefinement.h"
#include "Support/CapMeshes.h"
#include "Support/LentThreads.h"

namespace TestSweepProjection
{
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::Points;
using hexsweep::ProjectionMethod;
using hexsweep::QuadMesh;
using hexsweep::SweepProjection;
using hexsweep::SweepProjectionInput;
using hexsweep::TriangleMesh;
using hexsweep::Weights;

std::vector<test::Block> holes(std::size_t count)
{
  const std::vector<test::Block> blocks = test::threeHoles();
  return { blocks.begin(), blocks.begin() + static_cast<long>(count) };
}

std::vector<Loop> loopsOf(const QuadMesh& quads)
{
  return hexsweep::checkSurface(quads.quads, quads.points.rows(), "quads").loops;
}

/// Curved quads, and a triangulation of the same cap whose boundary has more nodes.
struct Cap
{
  QuadMesh quads;
  TriangleMesh surface;
};

Cap curvedCap(std::size_t holeCount, double height)
{
  Cap cap;
  cap.quads = test::quadPlate(12, holes(holeCount), 0.25);
  cap.quads.points = test::lifted(cap.quads.points,
    [height](double x, double y) { return height * (test::bump(x, y) + 0.3 * x * y); });
  const TriangleMesh halves{ cap.quads.points,
    hexsweep::halveQuads(cap.quads.points, cap.quads.quads) };
  std::vector<hexsweep::EdgeSubdivision> finer;
  for (const Loop& loop : loopsOf(cap.quads))
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      finer.push_back({ loop[i], loop[(i + 1) % loop.size()], { 0.3, 0.6 } });
    }
  }
  cap.surface = hexsweep::refineSurface(halves, finer, false).mesh;
  return cap;
}

using Motion = std::function<Points(const Points&)>;

/// Quads from the loops of a cap to those of its image.
QuadMesh sidesOf(const Cap& cap, const Motion& motion)
{
  return test::linkingSides(cap.quads.points, motion(cap.quads.points), loopsOf(cap.quads));
}

/// The sweep of a cap to its image.
SweepProjectionInput imageSweep(const Cap& cap, const Motion& motion)
{
  SweepProjectionInput input;
  input.source = cap.quads;
  input.sourceSurface = cap.surface;
  input.target = { motion(cap.surface.points), cap.surface.triangles };
  input.linking = test::traced(cap.quads, sidesOf(cap, motion));
  return input;
}

double greatest(const Points& a, const Points& b)
{
  return (a - b).rowwise().norm().maxCoeff();
}

/// Boundary nodes bit for bit at the end of their columns: the last ring of linkingSides().
void expectBoundaryExact(const SweepProjection& result, const QuadMesh& quads, const Points& image)
{
  for (const Loop& loop : loopsOf(quads))
  {
    for (const Index v : loop)
    {
      EXPECT_EQ(result.quads.points.row(v), image.row(v));
    }
  }
}

TEST(SweepProjection, HalvesAlongTheShorterDiagonal)
{
  Points points(6, 3);
  points << 0, 0, 0, 2, 0, 0, 2.5, 1, 0, 0.5, 1, 0, -1, 1, 0, -1.5, 0, 0;
  const auto quads = test::facesOf<hexsweep::Quads>({ 0, 1, 2, 3, 0, 3, 4, 5 });
  const auto triangles = hexsweep::halveQuads(points, quads);
  const auto expected = test::facesOf<hexsweep::Triangles>({ 1, 2, 3, 1, 3, 0, 0, 3, 4, 0, 4, 5 });
  EXPECT_EQ(triangles, expected);
}

TEST(SweepProjection, ASimilarCapIsReproducedToRounding)
{
  // Harmonic maps know angles and the loops' arc lengths only, and the two triangulations
  // correspond: both caps have the same map, and each node its own place.
  for (const std::size_t holeCount : { 0u, 1u, 3u })
  {
    const Cap cap = curvedCap(holeCount, 0.5);
    for (const double scale : { 0.1, 1.0, 7.0 })
    {
      const test::Similarity motion{ scale, test::someTurn(), { 3, -2, 4 } };
      const Points image = motion(cap.quads.points);
      for (const Weights weights : { Weights::Cotangent, Weights::MeanValue })
      {
        SweepProjectionInput input = imageSweep(cap, motion);
        input.weights = weights;
        const SweepProjection result = hexsweep::projectSweep(input);
        EXPECT_LT(greatest(result.quads.points, image), 1e-10 * scale);
        expectBoundaryExact(result, cap.quads, image);
        EXPECT_EQ(result.quads.outside, 0);
        EXPECT_LT(result.quads.maximumSourceDistance, 1e-14);
        EXPECT_EQ(result.quality.inverted, 0);
      }
    }
  }
}

TEST(SweepProjection, TheQuadsOwnTriangulationDoesWithoutASourceSurface)
{
  for (const std::size_t holeCount : { 0u, 1u, 3u })
  {
    const Cap cap = curvedCap(holeCount, 0.5);
    const test::Similarity motion{ 2.0, test::someTurn(), { 3, -2, 4 } };
    SweepProjectionInput input = imageSweep(cap, motion);
    input.sourceSurface.reset();
    // Halves of the quads, against the refined halves: the same surface, other boundary nodes.
    const SweepProjection result = hexsweep::projectSweep(input);
    expectBoundaryExact(result, cap.quads, motion(cap.quads.points));
    EXPECT_LT(greatest(result.quads.points, motion(cap.quads.points)), 0.02);
    EXPECT_EQ(result.quality.inverted, 0);

    input.target = { motion(cap.quads.points),
      hexsweep::halveQuads(cap.quads.points, cap.quads.quads) };
    EXPECT_LT(
      greatest(hexsweep::projectSweep(input).quads.points, motion(cap.quads.points)), 1e-10);
  }
}

TEST(SweepProjection, OtherTriangulationsOfAPlaneCapConverge)
{
  // Source and target are triangulated differently: only the truncation error is between them.
  double last = 0.0;
  for (const int refinement : { 1, 2, 4 })
  {
    const int cells = 12 * refinement;
    std::vector<test::Block> hole{ { 4 * refinement, 5 * refinement, 3 * refinement,
      2 * refinement } };
    const QuadMesh quads = test::quadPlate(cells, hole, 0.25, 3);
    SweepProjectionInput input;
    input.source = quads;
    input.sourceSurface = test::plate(cells, hole, 0.25, 5);
    input.target = test::plate(cells, hole, 0.25, 6);
    Points image = quads.points;
    image.col(2).array() += 1.0;
    input.target.points.col(2).array() += 1.0;
    input.linking = test::traced(quads, test::linkingSides(quads.points, image, loopsOf(quads)));
    const SweepProjection result = hexsweep::projectSweep(input);
    EXPECT_EQ(result.quality.inverted, 0);
    const double error = greatest(result.quads.points, image);
    EXPECT_LT(error, 0.3 / cells);
    if (last > 0.0)
    {
      // Of first order: at the hole's corners the map has no bounded second derivative.
      EXPECT_LT(error, 0.65 * last);
    }
    last = error;
  }
}

TEST(SweepProjection, AnAffineImageIsReproducedByTheAffineMethodOnly)
{
  // Angles change under shear: a harmonic map between the two is another map than the shear.
  Eigen::Matrix3d shape;
  shape << 1.5, 0.5, 0, -0.2, 0.8, 0, 0, 0, 1;
  const test::Similarity place{ 1.0, test::someTurn(), { 3, -2, 4 } };
  const auto motion = [&](const Points& points) { return place(points * shape.transpose()); };
  for (const std::size_t holeCount : { 0u, 1u, 3u })
  {
    const Cap cap = curvedCap(holeCount, 0.0);
    const Points image = motion(cap.quads.points);
    SweepProjectionInput input = imageSweep(cap, motion);
    input.method = ProjectionMethod::AffineLeastSquares;
    const SweepProjection affine = hexsweep::projectSweep(input);
    EXPECT_LT(greatest(affine.quads.points, image), 1e-13);
    expectBoundaryExact(affine, cap.quads, image);
    EXPECT_FALSE(affine.source.has_value());
    EXPECT_FALSE(affine.target.has_value());

    input.method = ProjectionMethod::Harmonic;
    const SweepProjection harmonic = hexsweep::projectSweep(input);
    EXPECT_GT(greatest(harmonic.quads.points, image), 1e-4);
    // Neither map is folded, though straight coarse quads at the holes' corners may be.
    EXPECT_TRUE(harmonic.source->flipped.empty());
    EXPECT_TRUE(harmonic.target->flipped.empty());
    expectBoundaryExact(harmonic, cap.quads, image);
  }
}

TEST(SweepProjection, EitherOrientationOfTheQuadsGivesTheSamePoints)
{
  for (const std::size_t holeCount : { 0u, 1u, 3u })
  {
    const Cap cap = curvedCap(holeCount, 0.5);
    SweepProjectionInput input =
      imageSweep(cap, test::Similarity{ 1.0, test::someTurn(), { 1, 2, 3 } });
    // Something that is not similar.
    input.target.points.col(0) *= 1.3;
    Points image = test::Similarity{ 1.0, test::someTurn(), { 1, 2, 3 } }(cap.quads.points);
    image.col(0) *= 1.3;
    const QuadMesh sides = test::linkingSides(cap.quads.points, image, loopsOf(cap.quads));
    for (const bool surface : { true, false })
    {
      if (!surface)
      {
        input.sourceSurface.reset();
      }
      input.source.quads = cap.quads.quads;
      input.linking = test::traced(input.source, sides);
      const SweepProjection plain = hexsweep::projectSweep(input);
      input.source.quads = test::turnedOver(cap.quads.quads);
      input.linking = test::traced(input.source, sides);
      const SweepProjection turned = hexsweep::projectSweep(input);
      EXPECT_LT(greatest(turned.quads.points, plain.quads.points), 1e-12);
      EXPECT_EQ(plain.quality.inverted, turned.quality.inverted);
      EXPECT_NEAR(plain.quality.minimum, turned.quality.minimum, 1e-10);
    }
  }
}

TEST(SweepProjection, TargetAndLinkingCellsMayFaceAnyWay)
{
  std::mt19937 generator(4);
  for (const std::size_t holeCount : { 0u, 1u, 3u })
  {
    const Cap cap = curvedCap(holeCount, 0.5);
    const test::Similarity motion{ 2.0, test::someTurn(), { 1, 2, 3 } };
    const SweepProjectionInput input = imageSweep(cap, motion);
    const Points plain = hexsweep::projectSweep(input).quads.points;
    for (int trial = 0; trial < 3; ++trial)
    {
      SweepProjectionInput shaken = input;
      for (Index t = 0; t < shaken.target.triangles.rows(); ++t)
      {
        if (trial == 0 || generator() % 2)
        {
          shaken.target.triangles.row(t).reverseInPlace();
        }
      }
      QuadMesh sides = sidesOf(cap, motion);
      for (Index q = 0; q < sides.quads.rows(); ++q)
      {
        if (generator() % 2)
        {
          sides.quads.row(q).reverseInPlace();
        }
      }
      shaken.linking = test::traced(shaken.source, sides);
      EXPECT_LT(greatest(hexsweep::projectSweep(shaken).quads.points, plain), 1e-12);
    }
  }
}

TEST(SweepProjection, WithoutLinkingSidesLoopsAreMatchedByShape)
{
  for (const std::size_t holeCount : { 0u, 1u, 3u })
  {
    const Cap cap = curvedCap(holeCount, 0.0);
    // No twist: turned about an axis in the plane of the cap.
    const test::Similarity motion{ 1.5,
      Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, 0).normalized()).toRotationMatrix(),
      { 3, -2, 4 } };
    SweepProjectionInput input = imageSweep(cap, motion);
    input.linking.reset();
    const SweepProjection result = hexsweep::projectSweep(input);
    EXPECT_LT(greatest(result.quads.points, motion(cap.quads.points)), 1e-10);
    EXPECT_EQ(result.startFractions.size(), holeCount + 1);
  }
}

TEST(SweepProjection, SizePlaceAndTurnDoNotMatter)
{
  for (const std::size_t holeCount : { 0u, 1u, 3u })
  {
    const Cap cap = curvedCap(holeCount, 0.5);
    SweepProjectionInput input =
      imageSweep(cap, test::Similarity{ 1.0, test::someTurn(), { 1, 2, 3 } });
    input.sourceSurface->points.col(0) *= 1.3;
    input.source.points.col(0) *= 1.3;
    const auto linkFrom = [&](const QuadMesh& from, const Points& to) {
      return test::traced(from, test::linkingSides(from.points, to, loopsOf(cap.quads)));
    };
    const Points image = test::Similarity{ 1.0, test::someTurn(), { 1, 2, 3 } }(cap.quads.points);
    input.linking = linkFrom(input.source, image);
    const Points plain = hexsweep::projectSweep(input).quads.points;
    for (const test::Placement& placement : test::placements())
    {
      SweepProjectionInput moved = input;
      moved.source.points = placement.motion(input.source.points);
      moved.sourceSurface->points = placement.motion(input.sourceSurface->points);
      moved.target.points = placement.motion(input.target.points);
      moved.linking = linkFrom(moved.source, placement.motion(image));
      // Weights feel the rounding of coordinates over slivers' heights, 1e-2 of the size.
      const double tolerance =
        std::max(1e-9, 1e5 * placement.relativeRounding) * placement.motion.scale;
      EXPECT_LT(
        greatest(hexsweep::projectSweep(moved).quads.points, placement.motion(plain)), tolerance)
        << placement.name;
    }
  }
}

TEST(SweepProjection, GivenMapsAreUsedAsTheyAre)
{
  for (const std::size_t holeCount : { 0u, 1u, 3u })
  {
    const Cap cap = curvedCap(holeCount, 0.5);
    const test::Similarity motion{ 1.0, test::someTurn(), { 1, 2, 3 } };
    SweepProjectionInput input = imageSweep(cap, motion);
    const SweepProjection automatic = hexsweep::projectSweep(input);
    const auto source = hexsweep::mapLinkedCaps(*input.sourceSurface, input.target,
      sidesOf(cap, motion), input.weights, input.matchTolerance);
    const auto target = hexsweep::mapLinkedCaps(input.target, *input.sourceSurface,
      sidesOf(cap, motion), input.weights, input.matchTolerance);
    input.sourceDisk = source.first;
    input.targetDisk = target.first;
    const SweepProjection given = hexsweep::projectSweep(input);
    EXPECT_EQ(given.quads.points, automatic.quads.points);

    // Another map of the target: its loops lie elsewhere.
    input.targetDisk->disk *= -1.0;
    test::expectInvalid([&] { hexsweep::projectSweep(input); }, "do not share their loops");
  }
}

TEST(SweepProjection, InputThatDoesNotFit)
{
  const Cap one = curvedCap(1, 0.5);
  const Cap three = curvedCap(3, 0.5);
  const test::Similarity motion{ 1.0, test::someTurn(), { 1, 2, 3 } };
  SweepProjectionInput input = imageSweep(one, motion);
  input.target = imageSweep(three, motion).target;
  EXPECT_THROW(hexsweep::projectSweep(input), hexsweep::InvalidInput);
  input.linking.reset();
  test::expectInvalid([&] { hexsweep::projectSweep(input); }, "boundary loop(s)");

  input = imageSweep(one, motion);
  input.sourceSurface = three.surface;
  EXPECT_THROW(hexsweep::projectSweep(input), hexsweep::InvalidInput);

  input = imageSweep(one, motion);
  input.target.points.col(0).array() += 5.0;
  EXPECT_THROW(hexsweep::projectSweep(input), hexsweep::InvalidInput);

  input = imageSweep(one, motion);
  input.target.points.col(0).array() += 0.1;
  test::expectInvalid([&] { hexsweep::projectSweep(input); }, "does not lie on the boundary");

  input = imageSweep(one, motion);
  input.source.quads.row(0).reverseInPlace();
  test::expectInvalid([&] { hexsweep::projectSweep(input); }, "opposite orientation");

  input = imageSweep(one, motion);
  input.source.quads = test::turnedOver(input.source.quads);
  test::expectInvalid([&] { hexsweep::projectSweep(input); }, "belong to other source quads");
}

TEST(SweepProjection, CanBeAbortedAtAnyTime)
{
  const Cap cap = curvedCap(1, 0.5);
  const SweepProjectionInput input =
    imageSweep(cap, test::Similarity{ 1.0, test::someTurn(), { 1, 2, 3 } });
  int reports = 0;
  double last = 0.0;
  hexsweep::projectSweep(input, [&](double fraction) {
    ++reports;
    EXPECT_GE(fraction, last);
    last = fraction;
    return true;
  });
  EXPECT_EQ(last, 1.0);
  for (int stop = 1; stop <= reports; ++stop)
  {
    int calls = 0;
    EXPECT_THROW(
      hexsweep::projectSweep(input, [&](double) { return ++calls < stop; }), hexsweep::Aborted);
  }
}

TEST(SweepProjection, UntanglingUnwindsATwistedMap)
{
  // The worst start there is: maps that were made before, the target's then twisted once round
  // between its two loops, which stay.
  const Cap cap = curvedCap(1, 0.2);
  const test::Similarity motion{ 2.0, test::someTurn(), { 1, 0, 3 } };
  SweepProjectionInput input = imageSweep(cap, motion);
  const hexsweep::LinkedDisks disks = hexsweep::mapLinkedCaps(
    *input.sourceSurface, input.target, sidesOf(cap, motion), Weights::Cotangent, 1e-6);
  input.sourceDisk = disks.first;
  input.targetDisk = disks.second;
  ASSERT_EQ(input.targetDisk->domain, hexsweep::DiskDomain::Annulus);
  hexsweep::PlanePoints& disk = input.targetDisk->disk;
  const std::vector<bool> boundary = hexsweep::boundaryFlags(disk.rows(), input.targetDisk->loops);
  const double logRadius = std::log(input.targetDisk->holes[0].radius);
  for (Index i = 0; i < disk.rows(); ++i)
  {
    if (!boundary[static_cast<std::size_t>(i)])
    {
      const double turn = 2.0 * 3.14159265358979323846 * std::log(disk.row(i).norm()) / logRadius;
      disk.row(i) = (disk.row(i) * Eigen::Rotation2Dd(-turn).toRotationMatrix()).eval();
    }
  }
  EXPECT_GT(hexsweep::projectSweep(input).quality.inverted, 5);
  input.ensureValid = true;
  const SweepProjection result = hexsweep::projectSweep(input);
  EXPECT_GT(result.invertedBefore, 5);
  EXPECT_EQ(result.quality.inverted, 0);
  input.improveQuality = true;
  const SweepProjection one = hexsweep::projectSweep(input);
  for (const hexsweep::ParallelFor& order :
    { hexsweep::ParallelFor(test::backwards), hexsweep::ParallelFor(test::sideBySide) })
  {
    input.parallelFor = order;
    EXPECT_EQ(one.quads.points, hexsweep::projectSweep(input).quads.points);
  }
  expectBoundaryExact(result, cap.quads, motion(cap.quads.points));
}
}

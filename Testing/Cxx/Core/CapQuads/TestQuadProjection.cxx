// SPDX-License-Identifier: BSD-3-Clause
// Barycentric coordinates are carried from triangle to triangle: equations (4) to (7).
#include "Core/CapQuads/QuadProjection.h"

#include "Support/CapMeshes.h"

namespace TestQuadProjection
{
using hexsweep::CapDisk;
using hexsweep::DiskDomain;
using hexsweep::FixedNode;
using hexsweep::Index;
using hexsweep::PlanePoints;
using hexsweep::Points;
using hexsweep::ProjectedQuads;
using hexsweep::TriangleMesh;

CapDisk capOf(const TriangleMesh& mesh, const PlanePoints& disk, DiskDomain domain)
{
  CapDisk cap;
  cap.mesh = mesh;
  cap.disk = disk;
  cap.domain = domain;
  cap.numberOfOriginalPoints = mesh.points.rows();
  return cap;
}

/// Points of a surface that is bent and stretched.
Points bent(const Points& points)
{
  Points result = points;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const double x = points(i, 0);
    const double y = points(i, 1);
    result.row(i) << 3 * x + 0.2 * y * y, std::sin(y), 5 + 0.5 * std::cos(2 * x + y);
  }
  return result;
}

/// Random places on triangles, as (triangle, barycentric coordinates).
struct Sample
{
  Index triangle;
  Eigen::RowVector3d coordinates;
};

std::vector<Sample> samples(Index triangles, int count)
{
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> uniform(0.05, 1.0);
  std::vector<Sample> result;
  for (int i = 0; i < count; ++i)
  {
    const Eigen::RowVector3d b(uniform(generator), uniform(generator), uniform(generator));
    result.push_back({ static_cast<Index>(generator() % triangles), b / b.sum() });
  }
  return result;
}

Points placed(const TriangleMesh& mesh, const std::vector<Sample>& places)
{
  Points points(static_cast<Index>(places.size()), 3);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    points.row(static_cast<Index>(i)).setZero();
    for (Index c = 0; c < 3; ++c)
    {
      points.row(static_cast<Index>(i)) +=
        places[i].coordinates[c] * mesh.points.row(mesh.triangles(places[i].triangle, c));
    }
  }
  return points;
}

std::vector<bool> all(Index n)
{
  return std::vector<bool>(static_cast<std::size_t>(n), true);
}

TEST(QuadProjection, CarriesBarycentricCoordinates)
{
  // Any injective map will do: here the plane of the source itself.
  const TriangleMesh plane = test::plate(12, test::threeHoles(), 0.3);
  const TriangleMesh source{ test::lifted(plane.points, test::bump), plane.triangles };
  const TriangleMesh target{ bent(plane.points), plane.triangles };
  const PlanePoints disk = plane.points.leftCols<2>();
  const std::vector<Sample> places = samples(plane.triangles.rows(), 500);
  const Points nodes = placed(source, places);
  const ProjectedQuads result = hexsweep::projectThroughDisks(nodes, all(nodes.rows()), {},
    capOf(source, disk, DiskDomain::Circles), capOf(target, disk, DiskDomain::Circles));
  EXPECT_LT((result.points - placed(target, places)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT(result.maximumSourceDistance, 1e-14);
  EXPECT_EQ(result.outside, 0);
}

TEST(QuadProjection, IsLinearInLogarithmAndAngleOnAnAnnulus)
{
  const TriangleMesh ring = test::annulus(0.2, 1.0, 6, 10);
  const TriangleMesh target{ bent(ring.points), ring.triangles };
  const std::vector<Sample> places = samples(ring.triangles.rows(), 500);
  const Points nodes = placed(ring, places);
  for (const double turn : { 0.0, 1.0, test::Pi, 4.0 })
  {
    const PlanePoints disk =
      ring.points.leftCols<2>() * Eigen::Rotation2Dd(turn).toRotationMatrix().transpose();
    const ProjectedQuads result = hexsweep::projectThroughDisks(nodes, all(nodes.rows()), {},
      capOf(ring, disk, DiskDomain::Annulus), capOf(target, disk, DiskDomain::Annulus));
    EXPECT_LT((result.points - placed(target, places)).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_EQ(result.outside, 0);
  }
}

TEST(QuadProjection, DiffersByTriangulationOnlyAsTheMapsDo)
{
  // Source and target triangulated differently over one plane: the disk is the plane.
  const TriangleMesh source = test::plate(12, test::threeHoles(), 0.3, 1);
  const TriangleMesh target = test::plate(12, test::threeHoles(), 0.3, 7);
  const Points nodes = placed(source, samples(source.triangles.rows(), 500));
  const ProjectedQuads result = hexsweep::projectThroughDisks(nodes, all(nodes.rows()), {},
    capOf(source, source.points.leftCols<2>(), DiskDomain::Disk),
    capOf(target, target.points.leftCols<2>(), DiskDomain::Disk));
  EXPECT_LT((result.points - nodes).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(QuadProjection, BoundaryNodesGoWhereTheyAreSentAndUnusedOnesStay)
{
  const TriangleMesh mesh = test::plate(6, {});
  const CapDisk cap = capOf(mesh, mesh.points.leftCols<2>(), DiskDomain::Disk);
  Points nodes = placed(mesh, samples(mesh.triangles.rows(), 10));
  nodes.row(3) << 1e9, 2, 3;
  std::vector<bool> used = all(10);
  used[3] = false;
  const std::vector<FixedNode> fixed{ { 5, { 0.1, 0.2, 0.3 } }, { 9, { 7, 8, 9 } } };
  const ProjectedQuads result = hexsweep::projectThroughDisks(nodes, used, fixed, cap, cap);
  EXPECT_EQ(result.points.row(3), nodes.row(3));
  for (const FixedNode& node : fixed)
  {
    EXPECT_EQ(result.points.row(node.point), node.position);
  }
  EXPECT_LT(result.maximumSourceDistance, 1e-14);

  const ProjectedQuads affine = hexsweep::projectAffinely(nodes, used,
    { { 5, nodes.row(5) }, { 9, nodes.row(9) }, { 0, nodes.row(0) } }, { 0, 5, 9 }, mesh);
  EXPECT_EQ(affine.points.row(3), nodes.row(3));
  EXPECT_EQ(affine.points.row(5), nodes.row(5));
}

TEST(QuadProjection, ReportsWhatLiesOffTheSourceAndOutsideTheTarget)
{
  const TriangleMesh mesh = test::plate(6, {});
  const CapDisk source = capOf(mesh, mesh.points.leftCols<2>(), DiskDomain::Disk);
  CapDisk target = source;
  target.disk.col(0) *= 0.5; // covers the left half
  Points nodes(4, 3);
  nodes << 0.1, 0.5, 0.0, 0.4, 0.5, 0.25, 0.6, 0.5, 0.0, 0.9, 0.3, 0.0;
  const ProjectedQuads result = hexsweep::projectThroughDisks(nodes, all(4), {}, source, target);
  EXPECT_NEAR(result.maximumSourceDistance, 0.25, 1e-15);
  EXPECT_EQ(result.outside, 2);
  // The nearest place of the target is taken.
  EXPECT_LT((result.points.row(0) - Eigen::RowVector3d(0.2, 0.5, 0)).norm(), 1e-14);
  EXPECT_LT((result.points.row(3) - Eigen::RowVector3d(1.0, 0.3, 0)).norm(), 1e-14);
}

TEST(QuadProjection, OnlyPositiveTrianglesOfTheTargetAreUsed)
{
  const TriangleMesh mesh = test::disk(4, 12);
  const CapDisk source = capOf(mesh, mesh.points.leftCols<2>(), DiskDomain::Disk);
  CapDisk target = source;
  target.disk.row(24) << 0.1, 0.9; // flips triangles about this node
  const Points nodes = placed(mesh, samples(mesh.triangles.rows(), 300));
  const ProjectedQuads result =
    hexsweep::projectThroughDisks(nodes, all(nodes.rows()), {}, source, target);
  EXPECT_TRUE(result.points.allFinite());

  target.disk.col(1) *= -1.0;
  target.disk.row(24) = source.disk.row(24);
  target.disk(24, 1) *= -1.0;
  test::expectInvalid(
    [&] { hexsweep::projectThroughDisks(nodes, all(nodes.rows()), {}, source, target); },
    "no triangle that is not flipped");
}

TEST(QuadProjection, DifferentDomains)
{
  const TriangleMesh mesh = test::annulus(0.3, 1.0, 4, 12);
  const PlanePoints disk = mesh.points.leftCols<2>();
  test::expectInvalid(
    [&] {
      hexsweep::projectThroughDisks(mesh.points, all(mesh.points.rows()), {},
        capOf(mesh, disk, DiskDomain::Annulus), capOf(mesh, disk, DiskDomain::Disk));
    },
    "different kinds of domain");
}

TEST(QuadProjection, AffineMapsArePerfectForTheTraditionalMethod)
{
  // A plane cap, stretched and sheared and set into space.
  const hexsweep::QuadMesh quads = test::quadPlate(8, { { 3, 3, 2, 1 } }, 0.3);
  Eigen::Matrix3d shape;
  shape << 2, 0.5, 0, -0.3, 0.7, 0, 0, 0, 1;
  const auto image = [&](const Points& points) {
    return test::Similarity{ 1.0, test::someTurn(), { 4, 5, 6 } }(points * shape.transpose());
  };
  const TriangleMesh plane = test::plate(8, { { 3, 3, 2, 1 } }, 0.3, 5);
  const TriangleMesh target{ image(plane.points), plane.triangles };
  const Points expected = image(quads.points);
  std::vector<FixedNode> fixed;
  std::vector<hexsweep::Loop> loops =
    hexsweep::checkSurface(quads.quads, quads.points.rows(), "quads").loops;
  for (const hexsweep::Loop& loop : loops)
  {
    for (const Index v : loop)
    {
      fixed.push_back({ v, expected.row(v) });
    }
  }
  const ProjectedQuads result =
    hexsweep::projectAffinely(quads.points, all(quads.points.rows()), fixed, loops[0], target);
  EXPECT_LT((result.points - expected).cwiseAbs().maxCoeff(), 1e-13);
  for (const FixedNode& node : fixed)
  {
    EXPECT_EQ(result.points.row(node.point), node.position);
  }
}

// The truth is the height of a surface that is folded along lines: all nodes end on it, also those
// whose nearest place is on a fold.
TEST(QuadProjection, AffineNodesEndOnAFoldedTarget)
{
  TriangleMesh target = test::plate(8, {});
  target.points.leftCols<2>() *= 8.0;
  const auto height = [](double x) { return 0.3 * std::abs(std::remainder(x, 4.0)); };
  for (Index i = 0; i < target.points.rows(); ++i)
  {
    target.points(i, 2) = height(target.points(i, 0));
  }
  Points nodes(4 + 300, 3);
  nodes.topRows<4>() << 0, 0, 0, 8, 0, 0, 8, 8, 0, 0, 8, 0;
  for (Index i = 4; i < nodes.rows(); ++i)
  {
    nodes.row(i) << 0.5 + 7.0 * static_cast<double>(i - 4) / 300,
      1.0 + std::fmod(0.77 * double(i), 6.0), 0;
  }
  std::vector<FixedNode> fixed;
  for (Index b = 0; b < 4; ++b)
  {
    fixed.push_back({ b, nodes.row(b) + Eigen::RowVector3d(0, 0, 1.0) }); // above the folds
  }
  const Points result =
    hexsweep::projectAffinely(nodes, all(nodes.rows()), fixed, { 0, 1, 2, 3 }, target).points;
  int onFolds = 0;
  for (Index i = 4; i < nodes.rows(); ++i)
  {
    EXPECT_NEAR(result(i, 2), height(result(i, 0)), 1e-14) << i;
    onFolds += std::abs(std::remainder(result(i, 0) - 2.0, 4.0)) < 1e-14;
  }
  EXPECT_GT(onFolds, 5);
}

TEST(QuadProjection, CanBeAborted)
{
  const TriangleMesh mesh = test::plate(6, {});
  const CapDisk cap = capOf(mesh, mesh.points.leftCols<2>(), DiskDomain::Disk);
  EXPECT_THROW(hexsweep::projectThroughDisks(
                 mesh.points, all(mesh.points.rows()), {}, cap, cap, [](double) { return false; }),
    hexsweep::Aborted);
}
}

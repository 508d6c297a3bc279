// SPDX-License-Identifier: BSD-3-Clause
#include "Support/CoarsePlates.h"
#include "Support/LentThreads.h"
#include "Support/StretchedCaps.h"

#include "Core/CapQuads/CapMeshing.h"
#include "Core/Geometry/TriangleSearch.h"

namespace TestCapMeshing
{
using namespace test;
using hexsweep::CapQuadOptions;
using hexsweep::CapQuads;
using hexsweep::checkCap;
using hexsweep::checkSurface;
using hexsweep::defaultQuadSize;
using hexsweep::meshCapWithQuads;

CapQuads meshed(const TriangleMesh& cap, double size, const std::vector<Index>& faceIds = {},
  const std::vector<Index>& keep = {})
{
  CapQuadOptions options;
  options.size = size;
  options.keep = keep;
  return meshCapWithQuads(cap, faceIds, options);
}

double sizeOf(const TriangleMesh& mesh)
{
  return (mesh.points.colwise().maxCoeff() - mesh.points.colwise().minCoeff()).norm();
}

double distanceFromSegment(
  const Eigen::RowVector3d& p, const Eigen::RowVector3d& a, const Eigen::RowVector3d& b)
{
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + t * (b - a) - p).norm();
}

/// Greatest distance of the quads' boundary nodes from the cap's boundary polygon.
double boundaryDistance(const TriangleMesh& cap, const hexsweep::QuadMesh& mesh)
{
  const auto capLoops = loopsOf(cap);
  double greatest = 0.0;
  for (const Loop& loop : checkSurface(mesh.quads, mesh.points.rows(), "quads").loops)
  {
    for (const Index node : loop)
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Loop& polygon : capLoops)
      {
        for (std::size_t i = 0; i < polygon.size(); ++i)
        {
          nearest = std::min(nearest,
            distanceFromSegment(mesh.points.row(node), cap.points.row(polygon[i]),
              cap.points.row(polygon[(i + 1) % polygon.size()])));
        }
      }
      greatest = std::max(greatest, nearest);
    }
  }
  return greatest;
}

double planeArea(const hexsweep::QuadMesh& mesh)
{
  double area = 0.0;
  for (Index q = 0; q < mesh.quads.rows(); ++q)
  {
    const Eigen::RowVector3d first =
      mesh.points.row(mesh.quads(q, 2)) - mesh.points.row(mesh.quads(q, 0));
    const Eigen::RowVector3d second =
      mesh.points.row(mesh.quads(q, 3)) - mesh.points.row(mesh.quads(q, 1));
    area += 0.5 * first.cross(second).z();
  }
  return area;
}

/// What every result must be, whatever the cap.
void checkQuads(const TriangleMesh& cap, const CapQuads& quads, double leastMinimum,
  double leastMean, const std::string& name)
{
  const auto topology = checkSurface(quads.mesh.quads, quads.mesh.points.rows(), "quads");
  EXPECT_NO_THROW(checkCap(topology, "quads")) << name;
  EXPECT_EQ(topology.loops.size(), loopsOf(cap).size()) << name;
  for (const Loop& loop : topology.loops)
  {
    EXPECT_GE(loop.size(), 8u) << name;
    EXPECT_EQ(loop.size() % 2, 0u) << name;
  }
  const hexsweep::TriangleSearch search(cap.points, cap.triangles);
  double offSurface = 0.0;
  for (Index i = 0; i < quads.mesh.points.rows(); ++i)
  {
    offSurface = std::max(offSurface, search.closest(quads.mesh.points.row(i)).distance);
  }
  EXPECT_LE(offSurface, 1e-12 * sizeOf(cap)) << name;
  EXPECT_LE(boundaryDistance(cap, quads.mesh), 1e-12 * sizeOf(cap)) << name;
  EXPECT_EQ(quads.inverted, 0) << name;
  EXPECT_GT(quads.minimumScaledJacobian, leastMinimum) << name;
  EXPECT_GT(quads.meanScaledJacobian, leastMean) << name;
  EXPECT_EQ(static_cast<Index>(quads.quadOrigin.size()), quads.mesh.quads.rows()) << name;
}

Index nodeAt(const hexsweep::QuadMesh& mesh, const Eigen::RowVector3d& place, double tolerance)
{
  Index node = -1;
  (mesh.points.rowwise() - place).rowwise().norm().minCoeff(&node);
  return (mesh.points.row(node) - place).norm() <= tolerance ? node : -1;
}

/// A sphere without the part that is more than `angle` from its south pole.
TriangleMesh sphereCap(Index rings, Index around, double angle)
{
  TriangleMesh mesh = disk(rings, around);
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    const double t = mesh.points.row(i).norm() * angle;
    const double p = std::atan2(mesh.points(i, 1), mesh.points(i, 0));
    mesh.points.row(i) << std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), -std::cos(t);
  }
  return mesh;
}

TEST(CapQuads, SquareOfTwoTrianglesIsCoveredByQuadsOfTheWantedSize)
{
  const TriangleMesh square = coarsePlate(1.0, {});
  ASSERT_EQ(square.triangles.rows(), 2);
  const CapQuads quads = meshed(square, 0.05);
  checkQuads(square, quads, 0.4, 0.85, "square");
  EXPECT_NEAR(planeArea(quads.mesh), 1.0, 1e-12);
  EXPECT_NEAR(static_cast<double>(quads.mesh.quads.rows()), 400.0, 80.0);
  // Sides divided evenly, corners kept.
  for (const Eigen::RowVector3d& corner : { Eigen::RowVector3d(0, 0, 0),
         Eigen::RowVector3d(1, 0, 0), Eigen::RowVector3d(1, 1, 0), Eigen::RowVector3d(0, 1, 0) })
  {
    EXPECT_GE(nodeAt(quads.mesh, corner, 0.0), 0);
  }
  for (int k = 0; k <= 20; ++k)
  {
    EXPECT_GE(nodeAt(quads.mesh, Eigen::RowVector3d(k / 20.0, 0.0, 0.0), 1e-12), 0) << k;
  }
}

TEST(CapQuads, CadFacetsWithoutInnerNodesAreMeshed)
{
  std::mt19937 generator(5);
  for (int trial = 0; trial < 4; ++trial)
  {
    const TriangleMesh cap = randomCoarsePlate(generator);
    const std::string name = "plate " + std::to_string(trial);
    checkQuads(cap, meshed(cap, defaultQuadSize(cap)), 0.2, 0.85, name);
    checkQuads(cap, meshed(cap, 0.1), 0.2, 0.8, name + ", size 0.1");
  }
}

TEST(CapQuads, ThreeQuartersOfASphere)
{
  for (const Index rings : { 6, 40 })
  {
    const TriangleMesh cap = sphereCap(rings, 4 * rings, 0.75 * Pi);
    checkQuads(cap, meshed(cap, 0.1), 0.4, 0.85, "rings " + std::to_string(rings));
  }
}

TEST(CapQuads, ThinWallsGetTwoQuadsAcross)
{
  const TriangleMesh ring = annulus(9.0, 10.0, 5, 200);
  const CapQuads quads = meshed(ring, 2.0);
  checkQuads(ring, quads, 0.3, 0.8, "thin annulus");
  // No edge of the boundary is longer than the wall is thick, no edge lies across it.
  const auto loops = checkSurface(quads.mesh.quads, quads.mesh.points.rows(), "quads").loops;
  std::vector<int> loopOf(static_cast<std::size_t>(quads.mesh.points.rows()), -1);
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    for (std::size_t i = 0; i < loops[l].size(); ++i)
    {
      const Index next = loops[l][(i + 1) % loops[l].size()];
      loopOf[static_cast<std::size_t>(loops[l][i])] = static_cast<int>(l);
      EXPECT_LE((quads.mesh.points.row(next) - quads.mesh.points.row(loops[l][i])).norm(), 1.0);
    }
  }
  for (Index q = 0; q < quads.mesh.quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      const int a = loopOf[static_cast<std::size_t>(quads.mesh.quads(q, c))];
      const int b = loopOf[static_cast<std::size_t>(quads.mesh.quads(q, (c + 1) % 4))];
      EXPECT_FALSE(a >= 0 && b >= 0 && a != b) << "quad " << q;
    }
  }
}

TEST(CapQuads, SmallHolesGetEightQuadsWhateverTheSize)
{
  const TriangleMesh cap = coarsePlate(2.0, { { 0.7, 0.5, 0.01, 40 } });
  checkQuads(cap, meshed(cap, 0.2), 0.4, 0.85, "tiny hole");
}

TEST(CapQuads, NeedlesAndFineTriangulationsAreRemeshed)
{
  for (const double height : { 1e-3, 1e-6, 1e-9 })
  {
    const TriangleMesh cap = needleStrips(height, false);
    checkQuads(cap, meshed(cap, 0.05), 0.3, 0.85, "needles " + std::to_string(height));
  }
  const TriangleMesh fine = annulus(1.0, 10.0, 60, 300);
  const CapQuads quads = meshed(fine, 1.0);
  checkQuads(fine, quads, 0.4, 0.85, "fine annulus");
  EXPECT_LT(quads.mesh.quads.rows(), 600);
}

TEST(CapQuads, BordersOfFacesStayEdges)
{
  const TriangleMesh cap = plate(12, threeHoles(), 0.0);
  std::vector<Index> faceIds;
  const auto faceAt = [](double x, double y) { return (x > 0.5 ? 1 : 0) + (y > 1.0 / 3 ? 2 : 0); };
  for (Index t = 0; t < cap.triangles.rows(); ++t)
  {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (Index c = 0; c < 3; ++c)
    {
      middle += cap.points.row(cap.triangles(t, c)) / 3.0;
    }
    faceIds.push_back(faceAt(middle.x(), middle.y()));
  }
  const CapQuads quads = meshed(cap, 0.04, faceIds);
  checkQuads(cap, quads, 0.2, 0.8, "four faces");
  for (Index q = 0; q < quads.mesh.quads.rows(); ++q)
  {
    double low[2] = { 1.0, 1.0 };
    double high[2] = { 0.0, 0.0 };
    for (Index c = 0; c < 4; ++c)
    {
      for (int d = 0; d < 2; ++d)
      {
        low[d] = std::min(low[d], quads.mesh.points(quads.mesh.quads(q, c), d));
        high[d] = std::max(high[d], quads.mesh.points(quads.mesh.quads(q, c), d));
      }
    }
    EXPECT_FALSE(low[0] < 0.5 - 1e-12 && high[0] > 0.5 + 1e-12) << "quad " << q;
    EXPECT_FALSE(low[1] < 1.0 / 3 - 1e-12 && high[1] > 1.0 / 3 + 1e-12) << "quad " << q;
    EXPECT_EQ(faceIds[static_cast<std::size_t>(quads.quadOrigin[static_cast<std::size_t>(q)])],
      faceAt(0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])));
  }
}

TEST(CapQuads, PointsToKeepAreNodes)
{
  const TriangleMesh cap = plate(12, threeHoles(), 0.2);
  const std::vector<Index> keep = { 40, 3, 7, cap.points.rows() - 1 };
  const CapQuads quads = meshed(cap, 0.06, {}, keep);
  checkQuads(cap, quads, 0.2, 0.8, "kept points");
  ASSERT_EQ(quads.keptNodes.size(), keep.size());
  for (std::size_t k = 0; k < keep.size(); ++k)
  {
    EXPECT_EQ(quads.mesh.points.row(quads.keptNodes[k]), cap.points.row(keep[k]));
  }
}

TEST(CapQuads, ScaleAndPlaceDoNotMatter)
{
  const TriangleMesh cap = plate(12, threeHoles(), 0.2);
  for (const Placement& placement : placements())
  {
    TriangleMesh moved = cap;
    moved.points = placement.motion(cap.points);
    const CapQuads quads = meshed(moved, 0.05 * placement.motion.scale);
    EXPECT_EQ(quads.inverted, 0) << placement.name;
    EXPECT_GT(quads.minimumScaledJacobian, 0.3) << placement.name;
    const hexsweep::TriangleSearch search(moved.points, moved.triangles);
    const double tolerance = sizeOf(moved) * std::max(1e-12, 10.0 * placement.relativeRounding);
    for (Index i = 0; i < quads.mesh.points.rows(); ++i)
    {
      EXPECT_LE(search.closest(quads.mesh.points.row(i)).distance, tolerance) << placement.name;
    }
  }
}

TEST(CapQuads, TheSameInputGivesTheSameBits)
{
  const TriangleMesh cap = curvedPlate(1, 0.5, 0.2, 1);
  const CapQuads first = meshed(cap, 0.05);
  const CapQuads second = meshed(cap, 0.05);
  EXPECT_EQ(first.mesh.quads, second.mesh.quads);
  EXPECT_EQ(first.mesh.points, second.mesh.points);
}

TEST(CapQuads, DefaultSizeGivesAboutAThousandQuads)
{
  const TriangleMesh square = coarsePlate(1.0, {});
  EXPECT_NEAR(defaultQuadSize(square), std::sqrt(1.0 / 1000.0), 1e-12);
  // A hole whose circumference asks for smaller ones.
  const TriangleMesh holed = coarsePlate(2.0, { { 1.0, 0.5, 0.05, 32 } });
  EXPECT_NEAR(defaultQuadSize(holed), 2.0 * 32 * 0.05 * std::sin(Pi / 32) / 12.0, 1e-12);
}

TEST(CapQuads, BadInputIsRefused)
{
  const TriangleMesh square = coarsePlate(1.0, {});
  for (const double size : { 0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    expectInvalid([&] { meshed(square, size); }, "wanted size");
  }
  expectInvalid([&] { meshed(square, 1e-5); }, "50 million");
  expectInvalid([&] { meshed(square, 0.1, { 1 }); }, "face ids");
  expectInvalid([&] { meshed(square, 0.1, {}, { 4 }); }, "point 4");
  TriangleMesh pieces = square;
  pieces.points.conservativeResize(7, 3);
  pieces.points.bottomRows(3) << 5, 0, 0, 6, 0, 0, 5, 1, 0;
  pieces.triangles.conservativeResize(3, 3);
  pieces.triangles.row(2) << 4, 5, 6;
  expectInvalid([&] { meshed(pieces, 0.1); }, "pieces");
  TriangleMesh flat = square;
  flat.points.setZero();
  expectInvalid([&] { defaultQuadSize(flat); }, "no area");
}

TEST(CapQuads, SameBitsInAnyOrder)
{
  for (const TriangleMesh& cap :
    { coarsePlate(1.0, { { 0.3, 0.4, 0.1, 24 } }), stretchedPlate(2, true, 3.0) })
  {
    CapQuadOptions options;
    options.size = sizeOf(cap) / 90.0;
    const CapQuads one = meshCapWithQuads(cap, {}, options);
    EXPECT_GT(one.mesh.quads.rows(), 2000);
    for (const hexsweep::ParallelFor& order :
      { hexsweep::ParallelFor(backwards), hexsweep::ParallelFor(sideBySide) })
    {
      options.parallelFor = order;
      const CapQuads other = meshCapWithQuads(cap, {}, options);
      EXPECT_EQ(one.mesh.points, other.mesh.points);
      EXPECT_EQ(one.mesh.quads, other.mesh.quads);
      EXPECT_EQ(one.quadOrigin, other.quadOrigin);
    }
  }
}

TEST(CapQuads, AnAbortEndsTheWork)
{
  CapQuadOptions options;
  options.size = 0.05;
  EXPECT_THROW(meshCapWithQuads(coarsePlate(1.0, {}), {}, options, [](double) { return false; }),
    hexsweep::Aborted);
}
}

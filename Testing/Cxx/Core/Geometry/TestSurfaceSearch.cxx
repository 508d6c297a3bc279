// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/SurfaceSearch.h"

#include "Support/CapMeshes.h"

namespace TestSurfaceSearch
{
using hexsweep::Index;
using hexsweep::Points;

TEST(SurfaceSearch, NormalsOfAPlaneAndOfASphere)
{
  const hexsweep::TriangleMesh plane = test::plate(5, {}, 0.3);
  const Points flat = hexsweep::SurfaceSearch(plane).project(plane.points).normals;
  EXPECT_LT(
    (flat - Eigen::RowVector3d(0, 0, 1).replicate(flat.rows(), 1)).cwiseAbs().maxCoeff(), 1e-14);

  double last = 0.0;
  for (const int cells : { 8, 16, 32 })
  {
    hexsweep::TriangleMesh cap = test::plate(cells, {}, 0.2);
    cap.points.col(0).array() -= 0.5;
    cap.points.col(1).array() -= 0.5;
    for (Index i = 0; i < cap.points.rows(); ++i)
    {
      cap.points(i, 2) = std::sqrt(1.0 - cap.points.row(i).head<2>().squaredNorm());
    }
    // A boundary vertex sees one side only: measured where triangles lie all round.
    double error = 0.0;
    const Points normals = hexsweep::SurfaceSearch(cap).project(cap.points).normals;
    for (Index i = 0; i < cap.points.rows(); ++i)
    {
      EXPECT_NEAR(normals.row(i).norm(), 1.0, 1e-14);
      if (cap.points.row(i).head<2>().cwiseAbs().maxCoeff() < 0.49)
      {
        error = std::max(error, (normals.row(i) - cap.points.row(i)).norm());
      }
    }
    EXPECT_LT(error, 1.5 / cells);
    if (last > 0.0)
    {
      EXPECT_LT(error, 0.7 * last);
    }
    last = error;
  }
}

TEST(SurfaceSearch, NearestPointsEqualBruteForce)
{
  hexsweep::TriangleMesh mesh = test::plate(12, test::threeHoles(), 0.3);
  mesh.points = test::lifted(mesh.points, test::bump);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-0.2, 1.2);
  Points queries(200, 3);
  for (Index i = 0; i < queries.size(); ++i)
  {
    queries.data()[i] = uniform(generator);
  }
  const hexsweep::SurfacePlaces places = hexsweep::SurfaceSearch(mesh).project(queries);
  for (Index i = 0; i < queries.rows(); ++i)
  {
    double least = 10.0;
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      const auto corner = [&](Index c) {
        return Eigen::RowVector3d(mesh.points.row(mesh.triangles(t, c)));
      };
      least = std::min(least,
        hexsweep::closestPointOnTriangle(queries.row(i), corner(0), corner(1), corner(2)).distance);
    }
    EXPECT_NEAR((places.points.row(i) - queries.row(i)).norm(), least, 1e-14);
  }
}

TEST(SurfaceSearch, NormalsAloneAreThoseOfTheNearestPoints)
{
  for (const double bulge : { 0.0, 1e-9, 0.3 })
  {
    hexsweep::TriangleMesh surface = test::plate(6, {}, 0.3);
    const Eigen::Matrix3d turn = Eigen::Quaterniond(0.5, 0.1, -0.7, 0.3).normalized().matrix();
    for (Index i = 0; i < surface.points.rows(); ++i)
    {
      surface.points(i, 2) = bulge * surface.points.row(i).head<2>().squaredNorm();
    }
    surface.points = (surface.points * turn).eval();
    const hexsweep::SurfaceSearch search(surface);
    const Points near = surface.points.array() + 0.01;
    EXPECT_LT((search.normals(near) - search.project(near).normals).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(SurfaceSearch, AStartNearThePointChangesNothing)
{
  for (const double bulge : { 0.0, 0.3 })
  {
    hexsweep::TriangleMesh surface = test::plate(5, test::threeHoles(), 0.3);
    surface.points =
      test::lifted(surface.points, [&](double x, double y) { return bulge * x * y; });
    const hexsweep::SurfaceSearch search(surface);
    std::mt19937 generator(2);
    std::uniform_real_distribution<double> uniform(-0.1, 1.1);
    for (int i = 0; i < 100; ++i)
    {
      const Eigen::RowVector3d asked(uniform(generator), uniform(generator), uniform(generator));
      const hexsweep::SurfacePlace sought = search.project(asked, -1);
      for (Index start = 0; start < surface.triangles.rows(); ++start)
      {
        const hexsweep::SurfacePlace place = search.project(asked, start);
        ASSERT_EQ(place.triangle, sought.triangle);
        ASSERT_EQ(place.point, sought.point);
        ASSERT_EQ(place.normal, sought.normal);
      }
    }
  }
}
}

// SPDX-License-Identifier: BSD-3-Clause
// Neighbours across edges against those of the surface.
#include "Core/Geometry/PlaneTriangulation.h"

#include "Support/CapMeshes.h"
#include "Support/PlaneMeshes.h"

#include "Core/Surfaces/SurfaceTopology.h"

#include <cstdint>

namespace TestPlaneTriangulation
{
using hexsweep::Index;
using hexsweep::PlaneTriangulation;
using hexsweep::Triangles;
using test::onGrid;
using test::PlaneMesh;
using test::shuffled;

TEST(PlaneTriangulation, NeighborsAreThoseOfTheSurface)
{
  for (const unsigned seed : { 1u, 2u })
  {
    const PlaneMesh mesh =
      shuffled(onGrid(test::plate(12, test::threeHoles(), 0.2, seed)), seed).mesh;
    const Triangles expected = hexsweep::triangleNeighbors(mesh.triangles);
    const PlaneTriangulation plane(mesh.points, mesh.triangles);
    ASSERT_EQ(static_cast<Index>(plane.numberOfTriangles()), mesh.triangles.rows());
    for (std::uint32_t t = 0; t < plane.numberOfTriangles(); ++t)
    {
      const PlaneTriangulation::Triangle& triangle = plane.triangle(t);
      const Index id = static_cast<Index>(triangle.id);
      for (std::uint32_t c = 0; c < 3; ++c)
      {
        const Index corner = static_cast<Index>((triangle.first + c) % 3);
        const PlaneTriangulation::Point& place = plane.point(triangle.corners[c]);
        EXPECT_EQ(Eigen::RowVector2d(place.x, place.y),
          Eigen::RowVector2d(mesh.points.row(mesh.triangles(id, corner))));
        const std::uint32_t across = triangle.across[c];
        EXPECT_EQ(across == PlaneTriangulation::None
            ? Index(-1)
            : static_cast<Index>(plane.triangle(across >> 2).id),
          expected(id, corner));
        if (across != PlaneTriangulation::None)
        {
          EXPECT_EQ(plane.triangle(across >> 2).across[across & 3], 4 * t + c);
        }
      }
    }
  }
}
}

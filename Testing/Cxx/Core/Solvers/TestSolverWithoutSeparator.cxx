// SPDX-License-Identifier: BSD-3-Clause
// Parts of a matrix that fall into two without a separator: fronts that eliminate nothing.
#include "Core/DiskMaps/FilledDiskMap.h"
#include "Core/Solvers/SurfaceLaplacian.h"

#include "Support/CapMeshes.h"

namespace TestSolverWithoutSeparator
{
using namespace hexsweep;

TEST(SolverWithoutSeparator, SolvesAFilledAnnulus)
{
  // Dissected meshes that have such parts.
  for (const auto& [around, rings] :
    std::vector<std::pair<Index, Index>>{ { 96, 6 }, { 144, 12 }, { 144, 30 } })
  {
    const TriangleMesh mesh = test::annulus(0.3, 1.0, rings, around);
    const std::vector<Loop> loops = test::loopsOf(mesh);
    const PlanePoints outer =
      circlePoints({ { 0.0, 0.0 }, 1.0 }, arcLengthAngles(loopPoints(mesh.points, loops[0])));
    const FilledDiskMap map =
      filledDiskMap(cotangentLaplacian(mesh.points, mesh.triangles), mesh.points, loops, outer);
    // All turns by one cell are symmetries.
    EXPECT_LT(map.holes[0].center.norm(), 1e-12);
    for (Index k = 0; k < rings; ++k)
    {
      const double radius = map.disk.row(k * around).norm();
      for (Index j = 1; j < around; ++j)
      {
        ASSERT_NEAR(map.disk.row(k * around + j).norm(), radius, 1e-12);
      }
    }
  }
}
}

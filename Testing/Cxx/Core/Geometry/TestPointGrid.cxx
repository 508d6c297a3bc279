// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/PointGrid.h"

#include "Support/CapMeshes.h"

#include <set>

namespace TestPointGrid
{
using hexsweep::Index;
using hexsweep::PointGrid;
using hexsweep::Points;

std::set<Index> near(const PointGrid& grid, const Eigen::RowVector3d& place, double radius)
{
  std::set<Index> found;
  grid.forEachNear(place, radius, [&](Index id, double) { EXPECT_TRUE(found.insert(id).second); });
  return found;
}

TEST(PointGrid, FindsWhatALoopOverAllPointsFinds)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const double size : { 1e-6, 1.0, 1e6 })
  {
    Points points(600, 3);
    for (Index i = 0; i < points.size(); ++i)
    {
      points.data()[i] = size * uniform(generator);
    }
    std::vector<Index> ids;
    for (Index i = 0; i < points.rows(); i += 2)
    {
      ids.push_back(i);
    }
    const PointGrid grid(points, ids, 0.3 * size);
    std::size_t count = 0;
    for (Index i = 0; i < points.rows(); ++i)
    {
      for (const double radius : { 0.1 * size, 0.3 * size })
      {
        std::set<Index> expected;
        for (const Index id : ids)
        {
          if ((points.row(id) - points.row(i)).norm() <= radius)
          {
            expected.insert(id);
          }
        }
        EXPECT_EQ(near(grid, points.row(i), radius), expected);
        count += expected.size();
      }
    }
    EXPECT_GT(count, 1000u);
  }
}

TEST(PointGrid, CoincidentPointsAndPlacesFarAway)
{
  const Points points = Points::Ones(3, 3);
  const PointGrid grid(points, { 0, 2 }, 0.0);
  EXPECT_EQ(near(grid, { 1, 1, 1 }, 0.0), (std::set<Index>{ 0, 2 }));
  EXPECT_TRUE(near(grid, { 1, 1, std::nextafter(1.0, 2.0) }, 0.0).empty());
  EXPECT_TRUE(near(grid, { 1e300, 1, 1 }, 0.0).empty());
  EXPECT_TRUE(near(PointGrid(points, {}, 1.0), { 1, 1, 1 }, 1.0).empty());
}
}

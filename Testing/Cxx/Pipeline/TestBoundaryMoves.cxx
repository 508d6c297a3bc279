// SPDX-License-Identifier: BSD-3-Clause
// MoveBoundaryNodes: better hexahedra, by nodes that stay on their faces of the solid.
#include "FailureSolids.h"
#include "SolidGrids.h"

#include "HexSweepArrays.h"

#include <vtkStaticCellLocator.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace TestBoundaryMoves
{
using hexsweep::arrays::BoundaryId;
using hexsweep::arrays::HexPointIds;
using test::report;

class MovedBoundaries : public testing::TestWithParam<const char*>
{
};

/// Faces of the boundary quads at each point of the hexahedra.
std::map<vtkIdType, std::set<vtkIdType>> facesOfPoints(test::SolidSweep& sweep)
{
  auto* boundary = vtkUnstructuredGrid::SafeDownCast(sweep.filter->GetOutputDataObject(1));
  vtkDataArray* pointIds = boundary->GetPointData()->GetArray(HexPointIds);
  vtkDataArray* faceIds = boundary->GetCellData()->GetArray(BoundaryId);
  std::map<vtkIdType, std::set<vtkIdType>> faces;
  for (vtkIdType q = 0; q < boundary->GetNumberOfCells(); ++q)
  {
    vtkIdType count;
    const vtkIdType* corners;
    boundary->GetCellPoints(q, count, corners);
    for (vtkIdType c = 0; c < count; ++c)
    {
      faces[static_cast<vtkIdType>(pointIds->GetTuple1(corners[c]))].insert(
        static_cast<vtkIdType>(faceIds->GetTuple1(q)));
    }
  }
  return faces;
}

TEST_P(MovedBoundaries, RaiseTheMinimumOnTheSolid)
{
  const test::Grid solid = test::failureGrid(GetParam());
  test::SolidSweep given(solid);
  given.filter->Update();
  test::SolidSweep moved(solid);
  moved.filter->MoveBoundaryNodesOn();
  moved.filter->Update();
  const auto least = [](test::SolidSweep& sweep) {
    return report(sweep.hexes(), hexsweep::reports::MinScaledJacobian);
  };
  EXPECT_GT(least(moved), least(given) + 0.04);
  EXPECT_EQ(report(moved.hexes(), hexsweep::reports::NotCertified), 0.0);
  EXPECT_FALSE(given.hexes()->GetFieldData()->HasArray(hexsweep::reports::MovedBoundaryNodes));

  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(solid);
  locator->BuildLocator();
  const double size = test::sizeOf(solid);
  ASSERT_EQ(moved.hexes()->GetNumberOfPoints(), given.hexes()->GetNumberOfPoints());
  vtkIdType count = 0;
  double greatest = 0.0;
  for (const auto& [point, faces] : facesOfPoints(given))
  {
    const std::array<double, 3> before = test::pointOf(given.hexes(), point);
    const std::array<double, 3> after = test::pointOf(moved.hexes(), point);
    const double way = std::hypot(after[0] - before[0], after[1] - before[1], after[2] - before[2]);
    if (way == 0.0)
    {
      continue;
    }
    ++count;
    greatest = std::max(greatest, way);
    EXPECT_EQ(faces.size(), 1u) << "a node of a rim or an edge of the solid has moved: " << point;
    double place[3];
    vtkIdType cell;
    int sub;
    double distance2;
    locator->FindClosestPoint(after.data(), place, cell, sub, distance2);
    EXPECT_LT(std::sqrt(distance2), 1e-9 * size) << point;
  }
  EXPECT_GT(count, 0);
  EXPECT_EQ(report(moved.hexes(), hexsweep::reports::MovedBoundaryNodes), count);
  EXPECT_NEAR(
    report(moved.hexes(), hexsweep::reports::GreatestBoundaryMove), greatest, 1e-12 * size);
}

INSTANTIATE_TEST_SUITE_P(
  Random, MovedBoundaries, testing::Values("../random/f6", "../random/f10", "../random/f4"));

TEST(BoundaryMoves, CapsAreThoseThatAreTakenWithout)
{
  // Rough meshes that rank the ways are made alike.
  test::SolidSweep given(test::solidGrid("elbow"));
  given.filter->Update();
  test::SolidSweep moved(test::solidGrid("elbow"));
  moved.filter->MoveBoundaryNodesOn();
  moved.filter->Update();
  for (const char* caps : { hexsweep::reports::SourceFaceIds, hexsweep::reports::TargetFaceIds })
  {
    EXPECT_EQ(report(moved.hexes(), caps), report(given.hexes(), caps)) << caps;
  }
}

TEST(BoundaryMoves, SinglePrecisionMovesTheSameNodes)
{
  std::array<double, 2> counts{};
  for (const int precision : { 0, 1 })
  {
    test::SolidSweep sweep(test::failureGrid("../random/f10"));
    sweep.filter->MoveBoundaryNodesOn();
    sweep.filter->SetOutputPointsPrecision(precision);
    sweep.filter->Update();
    counts[static_cast<std::size_t>(precision)] =
      report(sweep.hexes(), hexsweep::reports::MovedBoundaryNodes);
    EXPECT_EQ(report(sweep.hexes(), hexsweep::reports::NotCertified), 0.0);
  }
  EXPECT_GT(counts[0], 0.0);
  EXPECT_EQ(counts[0], counts[1]);
}

TEST(BoundaryMoves, WhatCannotBeBetterStays)
{
  test::SolidSweep given(test::failureGrid("../random/a1"));
  given.filter->Update();
  test::SolidSweep moved(test::failureGrid("../random/a1"));
  moved.filter->MoveBoundaryNodesOn();
  moved.filter->Update();
  EXPECT_EQ(report(moved.hexes(), hexsweep::reports::MovedBoundaryNodes), 0.0);
  ASSERT_EQ(moved.hexes()->GetNumberOfPoints(), given.hexes()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < given.hexes()->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(test::pointOf(moved.hexes(), i), test::pointOf(given.hexes(), i)) << i;
  }
}
}

// SPDX-License-Identifier: BSD-3-Clause
// What vtkCageHexInterior refuses.
#include "CageHexCase.h"

#include <vtkSweepQuadProjector.h>

#include <limits>

namespace TestCageHexErrors
{
using hexsweep::Points;
using hexsweep::Quads;
using test::gridOf;
using test::someSweep;
using test::Sweep;
using Case = test::CageHexCase;

TEST(CageHexInterior, EmptyInput)
{
  Case source(someSweep());
  source.source = vtkSmartPointer<vtkUnstructuredGrid>::New();
  source.expectError("source quads are empty");
  Case target(someSweep());
  target.target = vtkSmartPointer<vtkPolyData>::New();
  target.expectError("target quads are empty");
  Case linking(someSweep());
  linking.linking = vtkSmartPointer<vtkUnstructuredGrid>::New();
  linking.expectError("linking sides are empty");
}

TEST(CageHexInterior, MissingPort)
{
  const char* names[3] = { "source quads are missing", "target quads are missing",
    "linking sides are missing" };
  for (int port = 0; port < 3; ++port)
  {
    const Sweep sweep = someSweep();
    vtkNew<vtkCageHexInterior> filter;
    test::Events events(filter);
    const Case input(sweep);
    vtkPointSet* data[3] = { input.source, input.target, input.linking };
    for (int other = 0; other < 3; ++other)
    {
      if (other != port)
      {
        filter->SetInputData(other, data[other]);
      }
    }
    filter->Update();
    ASSERT_EQ(events.errors.size(), 1u);
    EXPECT_NE(events.errors.front().find(names[port]), std::string::npos) << events.errors.front();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
}

TEST(CageHexInterior, CellsThatAreNotQuads)
{
  Case input(someSweep());
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->DeepCopy(input.source);
  const vtkIdType ids[3] = { 0, 1, 2 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, ids);
  input.source = grid;
  input.expectError("not a quad");
}

TEST(CageHexInterior, MixedOrientationOfTheSource)
{
  Sweep sweep = someSweep();
  sweep.quads.row(7) = sweep.quads.row(7).reverse().eval();
  Case input(sweep);
  input.expectError("opposite orientation");
}

TEST(CageHexInterior, ClosedSourceSurface)
{
  Points cube(8, 3);
  cube << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  Quads faces(6, 4);
  faces << 0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7;
  Case input(someSweep());
  input.source = gridOf(cube, faces);
  input.target = gridOf(cube, faces);
  input.expectError("closed surface");
}

TEST(CageHexInterior, CoordinateThatIsNotFinite)
{
  for (int port = 0; port < 3; ++port)
  {
    Sweep sweep = someSweep();
    Points* points[3] = { &sweep.source, &sweep.target, &sweep.linkingPoints };
    (*points[port])(5, 1) = std::numeric_limits<double>::quiet_NaN();
    Case input(sweep);
    input.expectError("not a finite number");
  }
}

TEST(CageHexInterior, LoopsThatDoNotMatch)
{
  Sweep source = someSweep();
  source.source.rowwise() += Eigen::RowVector3d(0.1, 0, 0);
  Case(source).expectError("of the source quads");
  Sweep target = someSweep();
  target.target.rowwise() += Eigen::RowVector3d(0.1, 0, 0);
  Case(target).expectError("last ring of the linking sides does not lie on");
}

TEST(CageHexInterior, DifferentConnectivity)
{
  const Sweep sweep = someSweep();
  Case fewer(sweep);
  fewer.target = gridOf(sweep.target, sweep.quads.topRows(sweep.quads.rows() - 1));
  fewer.expectError("connectivity");

  Case other(sweep);
  Quads quads = sweep.quads;
  std::swap(quads(3, 0), quads(3, 1));
  other.target = gridOf(sweep.target, quads);
  other.expectError("quad 3 has other points");

  Case morePoints(sweep);
  Points points(sweep.target.rows() + 1, 3);
  points << sweep.target, Eigen::RowVector3d(0, 0, 0);
  morePoints.target = gridOf(points, sweep.quads);
  morePoints.expectError("points instead of");
}

TEST(CageHexInterior, MethodsThatDoNotExist)
{
  Case input(someSweep());
  input.filter->SetMethod(7);
  input.expectError("Method 7 does not exist");
}

TEST(CageHexInterior, AnErrorIsForgottenWhenTheInputIsMended)
{
  Case input(someSweep());
  input.filter->SetMethod(7);
  input.expectError("does not exist");
  input.filter->SetMethodToBlend();
  EXPECT_GT(input.run()->GetNumberOfCells(), 0);
  EXPECT_EQ(input.events.errors.size(), 1u);
}

TEST(CageHexInterior, LinkingSidesThatCollapseAreNamed)
{
  vtkNew<vtkSweepQuadProjector> projector;
  projector->SetInputData(0, test::readGrid("bad_rings/source_quads"));
  projector->SetInputData(1, test::readGrid("bad_rings/target_surface"));
  projector->SetInputData(2, test::readGrid("bad_rings/linking_quads"));
  projector->SetInputData(3, test::readGrid("bad_rings/source_surface"));
  vtkNew<vtkCageHexInterior> filter;
  test::Events events(filter);
  filter->SetInputData(0, test::readGrid("bad_rings/source_quads"));
  filter->SetInputConnection(1, projector->GetOutputPort());
  filter->SetInputData(2, test::readGrid("bad_rings/linking_quads"));
  filter->Update();
  ASSERT_EQ(events.errors.size(), 1u);
  // The hole has 32 nodes; its edges turn round between rings 5 and 6 of 12.
  EXPECT_NE(events.errors[0].find("a hole (loop 1, 32 nodes"), std::string::npos)
    << events.errors[0];
  EXPECT_NE(events.errors[0].find("ring 6 is turned over against ring 5"), std::string::npos)
    << events.errors[0];
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}
}

// SPDX-License-Identifier: BSD-3-Clause

#include "CageHexCase.h"

#include "HexSweepArrays.h"

#include <vtkMeshQuality.h>

namespace test
{
vtkSmartPointer<vtkPoints> pointsOf(const Points& points)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataTypeToDouble();
  for (Index i = 0; i < points.rows(); ++i)
  {
    result->InsertNextPoint(points.row(i).data());
  }
  return result;
}

CageHexCase::CageHexCase(const Sweep& sweep)
  : source(gridOf(sweep.source, sweep.quads))
  , target(gridOf(sweep.target, sweep.quads))
  , linking(gridOf(sweep.linkingPoints, sweep.linkingQuads))
  , events(filter)
{
}

vtkUnstructuredGrid* CageHexCase::run()
{
  this->filter->SetSourceQuadsData(this->source);
  this->filter->SetTargetQuadsData(this->target);
  this->filter->SetLinkingSidesData(this->linking);
  this->filter->Update();
  return this->filter->GetOutput();
}

double CageHexCase::report(const std::string& name)
{
  return this->filter->GetOutput()
    ->GetFieldData()
    ->GetArray((hexsweep::reports::Prefix + name).c_str())
    ->GetTuple1(0);
}

void CageHexCase::expectError(const std::string& part)
{
  vtkUnstructuredGrid* output = this->run();
  ASSERT_EQ(this->events.errors.size(), 1u) << part;
  const std::string& text = this->events.errors.front();
  EXPECT_NE(text.find(part), std::string::npos) << "got: " << text;
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  EXPECT_EQ(output->GetNumberOfCells(), 0);
}

Sweep someSweep()
{
  return makeSweep(12, 9, true, evenLayers(5), affineMotion);
}

vtkIdType countInverted(vtkUnstructuredGrid* grid)
{
  vtkIdType inverted = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    inverted += vtkMeshQuality::HexScaledJacobian(grid->GetCell(cell)) <= 0.0;
  }
  return inverted;
}
}

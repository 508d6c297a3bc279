// SPDX-License-Identifier: BSD-3-Clause
// A program of somebody else's: judges a block of hexahedra with the installed package.
#include <vtkCellType.h>
#include <vtkCellTypeSource.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkHexValidity.h>
#include <vtkNew.h>

#include <cmath>
#include <iostream>

int main()
{
  vtkNew<vtkCellTypeSource> block;
  block->SetCellType(VTK_HEXAHEDRON);
  block->SetBlocksDimensions(4, 3, 2);
  vtkNew<vtkHexValidity> validity;
  validity->SetInputConnection(block->GetOutputPort());
  validity->Update();

  vtkFieldData* report = validity->GetOutput()->GetFieldData();
  const double hexes = report->GetArray("SweepReportHexes")->GetTuple1(0);
  const double inverted = report->GetArray("SweepReportInverted")->GetTuple1(0);
  const double worst = report->GetArray("SweepReportMinScaledJacobian")->GetTuple1(0);
  std::cout << hexes << " hexahedra, " << inverted << " inverted, scaled Jacobian at least "
            << worst << "\n";
  return hexes == 24 && inverted == 0 && std::abs(worst - 1.0) < 1e-12 ? 0 : 1;
}

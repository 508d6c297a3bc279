// SPDX-License-Identifier: BSD-3-Clause
// sweep_solid <solid.vtu> <source face id> <layers> <hexes.vtu>
//
// One filter does the whole job. It never throws: what is wrong comes as an event, with a message
// for the user, and the output is empty.
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkOneToOneSweep.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdlib>
#include <iostream>

namespace
{
void showMessage(vtkObject*, unsigned long event, void*, void* text)
{
  std::cerr << (event == vtkCommand::ErrorEvent ? "error: " : "warning: ")
            << static_cast<const char*>(text) << "\n";
}

double reported(vtkUnstructuredGrid* hexes, const char* name)
{
  return hexes->GetFieldData()->GetArray(name)->GetTuple1(0);
}
}

int main(int argc, char* argv[])
{
  if (argc != 5)
  {
    std::cerr << "usage: sweep_solid <solid.vtu> <source face id> <layers> <hexes.vtu>\n";
    return 2;
  }
  vtkNew<vtkXMLUnstructuredGridReader> solid;
  solid->SetFileName(argv[1]);

  vtkNew<vtkOneToOneSweep> sweep;
  vtkNew<vtkCallbackCommand> messages;
  messages->SetCallback(showMessage);
  sweep->AddObserver(vtkCommand::ErrorEvent, messages);
  sweep->AddObserver(vtkCommand::WarningEvent, messages);
  sweep->SetInputConnection(solid->GetOutputPort());
  sweep->AddSourceFaceId(std::atoi(argv[2]));
  sweep->SetNumberOfLayers(std::atoi(argv[3]));
  sweep->Update();

  vtkUnstructuredGrid* hexes = sweep->GetOutput();
  if (hexes->GetNumberOfCells() == 0)
  {
    return 1;
  }
  std::cout << hexes->GetNumberOfCells() << " hexes, " << reported(hexes, "SweepReportNotCertified")
            << " of them not certified, scaled Jacobian "
            << reported(hexes, "SweepReportMinScaledJacobian") << " at least\n";
  auto* boundary = vtkUnstructuredGrid::SafeDownCast(sweep->GetOutputDataObject(1));
  std::cout << boundary->GetNumberOfCells()
            << " boundary quads, each with the face id of the solid\n";

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(argv[4]);
  writer->SetInputData(hexes);
  writer->SetDataModeToBinary();
  return writer->Write() ? 0 : 1;
}

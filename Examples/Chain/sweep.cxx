// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCageHexInterior.h>
#include <vtkNew.h>
#include <vtkSweepQuadProjector.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

int main()
{
  vtkNew<vtkXMLUnstructuredGridReader> quads, source, target, sides;
  quads->SetFileName("Data/cases/c_open/source_quads.vtu");
  source->SetFileName("Data/cases/c_open/source_surface.vtu");
  target->SetFileName("Data/cases/c_open/target_surface.vtu");
  sides->SetFileName("Data/cases/c_open/linking_quads.vtu");

  vtkNew<vtkSweepQuadProjector> projector;
  projector->SetSourceQuadsConnection(quads->GetOutputPort());
  projector->SetTargetSurfaceConnection(target->GetOutputPort());
  projector->SetLinkingSidesConnection(sides->GetOutputPort());
  projector->SetSourceSurfaceConnection(source->GetOutputPort());

  vtkNew<vtkCageHexInterior> interior;
  interior->SetSourceQuadsConnection(quads->GetOutputPort());
  interior->SetTargetQuadsConnection(projector->GetOutputPort());
  interior->SetLinkingSidesConnection(sides->GetOutputPort());

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName("c_open.vtu");
  writer->SetInputConnection(interior->GetOutputPort());
  writer->SetDataModeToBinary();
  return writer->Write() ? 0 : 1;
}

// SPDX-License-Identifier: BSD-3-Clause
// Meshes a CAD file as the command line does: sweep_part <part.step> <size> <mesh.vtu>
#include <vtkCADReader.h>
#include <vtkManyToManySweep.h>
#include <vtkNew.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cstdlib>

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    return 2;
  }
  vtkNew<vtkCADReader> part;
  part->SetFileName(argv[1]);
  vtkNew<vtkManyToManySweep> sweep;
  sweep->SetSolidConnection(part->GetOutputPort());
  sweep->SetSize(std::atof(argv[2]));
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputConnection(sweep->GetOutputPort());
  writer->SetFileName(argv[3]);
  return writer->Write() ? 0 : 1;
}

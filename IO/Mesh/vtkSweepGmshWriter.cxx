// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSweepGmshWriter.h"

#include "Core/Common/Errors.h"

#include "HexSweepGmsh.h"
#include "HexSweepMeshSets.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkSweepGmshWriter);

//------------------------------------------------------------------------------
void vtkSweepGmshWriter::WriteMesh(const hexsweep::MeshSets& mesh, hexsweep::OutputFile& file,
  const std::function<bool(double)>& progress)
{
  hexsweep::GmshRecords records(file, this->Binary);
  switch (this->FileVersion)
  {
    case 22:
      hexsweep::writeGmsh22(mesh, records, progress);
      return;
    case 41:
      hexsweep::writeGmsh41(mesh, records, progress);
      return;
    default:
      throw hexsweep::InvalidInput("the file version is " + std::to_string(this->FileVersion) +
        ". It can be 22 (2.2) or 41 (4.1).");
  }
}

//------------------------------------------------------------------------------
void vtkSweepGmshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileVersion: " << this->FileVersion << "\n";
  os << indent << "Binary: " << (this->Binary ? "On" : "Off") << "\n";
}

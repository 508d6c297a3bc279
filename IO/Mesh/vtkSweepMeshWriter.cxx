// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSweepMeshWriter.h"

#include "Core/Common/Errors.h"

#include "HexSweepInputCheck.h"
#include "HexSweepMeshSets.h"
#include "HexSweepOutputFile.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkErrorCode.h>
#include <vtkInformation.h>

#include <new>

vtkSweepMeshWriter::~vtkSweepMeshWriter()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
int vtkSweepMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
  return 1;
}

//------------------------------------------------------------------------------
void vtkSweepMeshWriter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("no file is named: set FileName.");
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    return;
  }
  try
  {
    hexsweep::checkData(this->GetInput(), "input");
    const hexsweep::MeshSets mesh = hexsweep::meshSets(this->GetInput());
    hexsweep::OutputFile file(this->FileName);
    this->WriteMesh(mesh, file, [this](double fraction) {
      this->UpdateProgress(fraction);
      return this->GetAbortExecute() == 0;
    });
    file.close();
  }
  catch (const hexsweep::Aborted&)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
  }
  catch (const hexsweep::WriteFailure& failure)
  {
    vtkErrorMacro(<< failure.what());
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
  }
  catch (const hexsweep::InvalidInput& problem)
  {
    vtkErrorMacro(<< problem.what());
    this->SetErrorCode(vtkErrorCode::UserError);
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro("not enough memory to write this mesh.");
    this->SetErrorCode(vtkErrorCode::UserError);
  }
}

//------------------------------------------------------------------------------
void vtkSweepMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

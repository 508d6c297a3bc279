// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepFailure.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkDataObject.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>

namespace hexsweep
{
namespace
{
/// Opens the protected member, which the macro's setter would follow by Modified().
struct ErrorCodeOf : vtkAlgorithm
{
  static void set(vtkAlgorithm* self, unsigned long code)
  {
    self->*(&ErrorCodeOf::ErrorCode) = code;
  }
};

/// Hears the executive's next error: an error that somebody observes is not displayed.
class NextExecutiveError : public vtkCommand
{
public:
  static NextExecutiveError* New() { return new NextExecutiveError; }

  void Execute(vtkObject* executive, unsigned long, void* text) override
  {
    executive->RemoveObserver(this);
    const std::string message = static_cast<const char*>(text);
    if (message.find("returned failure for request") == std::string::npos)
    {
      vtkOutputWindowDisplayErrorText(message.c_str());
    }
  }
};

bool failedUpTo(vtkAlgorithm* algorithm)
{
  bool failed = algorithm->GetErrorCode() != vtkErrorCode::NoError;
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      failed = failed || failedUpTo(algorithm->GetInputAlgorithm(port, i));
    }
  }
  return failed;
}

/// Whether an input is empty since a filter before this one failed, which has said why.
bool emptyAfterFailure(vtkAlgorithm* self)
{
  for (int port = 0; port < self->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < self->GetNumberOfInputConnections(port); ++i)
    {
      vtkDataObject* input = self->GetInputDataObject(port, i);
      const bool empty = !input || input->GetNumberOfElements(vtkDataObject::CELL) == 0;
      if (empty && failedUpTo(self->GetInputAlgorithm(port, i)))
      {
        return true;
      }
    }
  }
  return false;
}
}

void reportFailure(vtkAlgorithm* self, const std::string& problem)
{
  ErrorCodeOf::set(self, vtkErrorCode::UserError);
  if (!emptyAfterFailure(self))
  {
    vtkErrorWithObjectMacro(self, << problem);
  }
  if (vtkObject::GetGlobalWarningDisplay())
  {
    vtkNew<NextExecutiveError> next;
    self->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, next);
  }
}

void clearFailure(vtkAlgorithm* self)
{
  ErrorCodeOf::set(self, vtkErrorCode::NoError);
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepRun.h"

#include "HexSweepFailure.h"
#include "HexSweepInputCheck.h"
#include "HexSweepThreadPool.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkPointSet.h>
#include <vtkSMPTools.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkVersion.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <new>

namespace hexsweep
{
namespace
{
/// Progress of an algorithm and its abort flag, as this VTK version has them.
bool continues(vtkAlgorithm* self)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220816)
  return !self->CheckAbort();
#else
  return !self->GetAbortExecute();
#endif
}

void askWhetherToGoOn(vtkAlgorithm* self)
{
  if (!continues(self))
  {
    throw Aborted();
  }
}

void clearOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* output = vtkDataObject::GetData(outputs, port))
    {
      output->Initialize();
    }
  }
}

/// Whether one input is empty on a rank > 0; see isIdleRank().
bool isEmptyPiece(vtkInformationVector* outputs, vtkDataSet* data, const std::string& what)
{
  const int piece =
    outputs->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  if (piece <= 0 || !data)
  {
    return false;
  }
  if (data->GetNumberOfCells() > 0)
  {
    throw InvalidInput("the " + what +
      ": distributed over several ranks, but a cap is swept as a whole. Gather it on the first "
      "rank (a serial reader leaves it there) before sweeping.");
  }
  return true;
}
}

void acceptSurfaces(vtkInformation* portInformation)
{
  portInformation->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  portInformation->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  portInformation->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  portInformation->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
}

vtkDataSet* inputDataSet(vtkInformationVector** inputs, int port)
{
  return inputs[port]->GetNumberOfInformationObjects() > 0 ? vtkPointSet::GetData(inputs[port], 0)
                                                           : nullptr;
}

bool isIdleRank(vtkInformationVector* outputs, vtkInformationVector** inputs,
  const std::vector<std::string>& portNames)
{
  std::vector<std::pair<vtkDataSet*, std::string>> data;
  for (std::size_t port = 0; port < portNames.size(); ++port)
  {
    data.emplace_back(inputDataSet(inputs, static_cast<int>(port)), portNames[port]);
  }
  return isIdleRank(outputs, data);
}

bool isIdleRank(
  vtkInformationVector* outputs, const std::vector<std::pair<vtkDataSet*, std::string>>& data)
{
  bool empty = false;
  for (const auto& [set, name] : data)
  {
    empty = isEmptyPiece(outputs, set, name) || empty;
  }
  return empty;
}

std::string chosenArray(vtkAlgorithm* algorithm)
{
  vtkInformation* chosen = algorithm->GetInputArrayInformation(0);
  const char* name = chosen->Get(vtkDataObject::FIELD_NAME());
  return !name || std::string(name) == "None" ? std::string() : name;
}

Progress pipelineProgress(vtkAlgorithm* self, double from, double to)
{
  return [self, from, to](double fraction) {
    // Not a number where it is only asked whether to go on.
    self->UpdateProgress(std::isnan(fraction)
        ? self->GetProgress()
        : from + (to - from) * std::min(std::max(fraction, 0.0), 1.0));
    return continues(self);
  };
}

ParallelFor smpFor()
{
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  if (threads == 1)
  {
    return {}; // progress can be reported, and an abort noticed, after every piece then
  }
  if (vtkSMPTools::GetBackend() == std::string("STDThread"))
  {
    return [pool = std::make_shared<ThreadPool>(threads)](
             Index count, const std::function<void(Index)>& call) { pool->run(count, call); };
  }
  return [](Index count, const std::function<void(Index)>& call) {
    // An exception that leaves a thread would end the process.
    std::vector<std::exception_ptr> failures(static_cast<std::size_t>(count));
    vtkSMPTools::For(0, count, 1, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        try
        {
          call(i);
        }
        catch (...)
        {
          failures[static_cast<std::size_t>(i)] = std::current_exception();
        }
      }
    });
    for (const std::exception_ptr& failure : failures)
    {
      if (failure)
      {
        std::rethrow_exception(failure);
      }
    }
  };
}

int runFilter(vtkAlgorithm* self, vtkInformationVector* outputs, const std::function<void()>& body)
{
  clearFailure(self);
  std::string problem;
  std::unique_ptr<char[]> reserve; // for the words, where there is no other memory left
  try
  {
    reserve.reset(new char[std::size_t{ 1 } << 18]);
    checkInputs(self);
    askWhetherToGoOn(self);
    body();
    askWhetherToGoOn(self); // an abort that came late is none that is not heard
    return 1;
  }
  catch (const Aborted&)
  {
    clearOutputs(outputs);
    return 1;
  }
  catch (const std::bad_alloc&)
  {
    reserve.reset();
    problem = "not enough memory for this mesh. Use a coarser one or fewer layers.";
  }
  catch (const std::exception& error)
  {
    problem = error.what();
  }
  clearOutputs(outputs);
  reportFailure(self, problem);
  return 0;
}
}

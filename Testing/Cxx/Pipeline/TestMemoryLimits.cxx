// SPDX-License-Identifier: BSD-3-Clause
// Filters and writers under limits of memory from far too little to enough: a mesh or an error,
// never the death of the process.
#include "EveryFilter.h"

#include <vtkHexGridWriter.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOneToOneSweep.h>
#include <vtkSweepAbaqusWriter.h>
#include <vtkSweepGmshWriter.h>
#include <vtkSweepSets.h>

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

namespace TestMemoryLimits
{
using namespace test;

enum Outcome
{
  Done = 3,
  Refused = 4,
  Silent = 5,
  Threw = 6
};

/// Pages that this process has in its address space, in bytes.
rlim_t addressSpace()
{
  std::ifstream file("/proc/self/statm");
  rlim_t pages = 0;
  file >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

/// What becomes of some work with so many more bytes, in a process of its own. @param work returns
/// an Outcome.
int outcomeWithin(rlim_t bytes, const std::function<int()>& work)
{
  // What was let go of is not kept for the next who asks.
  mallopt(M_MMAP_THRESHOLD, 1 << 15);
  mallopt(M_TRIM_THRESHOLD, 1 << 15);
  malloc_trim(0);
  const pid_t child = fork();
  if (child == 0)
  {
    const rlim_t limit = addressSpace() + bytes;
    const rlimit both = { limit, limit };
    setrlimit(RLIMIT_AS, &both);
    int outcome = Threw;
    try
    {
      outcome = work();
    }
    catch (...)
    {
    }
    _exit(outcome);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

/// From less than VTK's own objects leave to more than enough.
/// @return whether some limit was felt.
bool expectDoneOrRefused(const std::function<int()>& work, rlim_t enough)
{
  bool refused = false;
  for (rlim_t bytes = rlim_t{ 1 } << 19; bytes < enough; bytes += bytes / 3)
  {
    const int outcome = outcomeWithin(bytes, work);
    EXPECT_TRUE(outcome == Done || outcome == Refused)
      << "with " << bytes << " bytes: " << (outcome < 0 ? "signal " : "outcome ")
      << std::abs(outcome);
    refused = refused || outcome == Refused;
  }
  EXPECT_EQ(outcomeWithin(4 * enough, work), Done);
  return refused;
}

int outcomeOf(vtkAlgorithm* filter)
{
  filter->Update();
  return hasOutput(filter) ? Done : filter->GetErrorCode() != 0 ? Refused : Silent;
}

/// The sweep of a block into some tens of thousands of hexahedra.
vtkSmartPointer<vtkAlgorithm> fineSweep()
{
  const vtkSmartPointer<vtkAlgorithm> filter = filterUse("OneToOneSweep").on();
  vtkOneToOneSweep::SafeDownCast(filter)->SetSize(0.04);
  return filter;
}

TEST(MemoryLimits, EndSweepsInWords)
{
  vtkObject::GlobalWarningDisplayOff();
  EXPECT_TRUE(expectDoneOrRefused([] { return outcomeOf(fineSweep()); }, rlim_t{ 100 } << 20));
  vtkObject::GlobalWarningDisplayOn();
}

TEST(MemoryLimits, EndTheFiltersAfterItInWords)
{
  const vtkSmartPointer<vtkAlgorithm> sweep = fineSweep();
  sweep->Update();
  const Grid hexes = deepCopy(vtkUnstructuredGrid::SafeDownCast(sweep->GetOutputDataObject(0)));
  const Grid boundary = deepCopy(vtkUnstructuredGrid::SafeDownCast(sweep->GetOutputDataObject(1)));
  vtkObject::GlobalWarningDisplayOff();
  for (const char* name : { "HexValidity", "SweepSets" })
  {
    const FilterUse& use = filterUse(name);
    SCOPED_TRACE(name);
    const vtkSmartPointer<vtkAlgorithm> filter = use.on(0, hexes);
    if (use.inputs.size() > 1)
    {
      filter->SetInputDataObject(1, boundary);
    }
    EXPECT_TRUE(expectDoneOrRefused([&] { return outcomeOf(filter); }, rlim_t{ 20 } << 20));
  }
  vtkObject::GlobalWarningDisplayOn();
}

template <typename Writer>
int outcomeOfWriting(vtkDataObject* data, const std::string& name)
{
  vtkNew<Writer> writer;
  writer->SetInputDataObject(data);
  writer->SetFileName(name.c_str());
  writer->Write();
  const bool isThere = access(name.c_str(), F_OK) == 0; // takes no memory
  std::remove(name.c_str());
  const bool failed = writer->GetErrorCode() != 0;
  return failed ? (isThere ? Silent : Refused) : isThere ? Done : Silent;
}

TEST(MemoryLimits, EndWritersInWordsWithoutAFile)
{
  const vtkSmartPointer<vtkAlgorithm> sweep = fineSweep();
  vtkNew<vtkSweepSets> sets;
  sets->SetHexesConnection(sweep->GetOutputPort(0));
  sets->SetBoundaryConnection(sweep->GetOutputPort(1));
  sets->Update();
  const std::string name = std::string(HEXSWEEP_TEST_OUTPUT_DIR) + "/MemoryLimits";
  vtkObject::GlobalWarningDisplayOff();
  EXPECT_TRUE(expectDoneOrRefused(
    [&] { return outcomeOfWriting<vtkSweepAbaqusWriter>(sets->GetOutput(), name + ".inp"); },
    rlim_t{ 20 } << 20));
  EXPECT_TRUE(expectDoneOrRefused(
    [&] { return outcomeOfWriting<vtkSweepGmshWriter>(sets->GetOutput(), name + ".msh"); },
    rlim_t{ 20 } << 20));
  // It takes next to nothing, block by block.
  expectDoneOrRefused(
    [&] {
      return outcomeOfWriting<vtkHexGridWriter>(sweep->GetOutputDataObject(0), name + ".vtu");
    },
    rlim_t{ 5 } << 20);
  vtkObject::GlobalWarningDisplayOn();
}
}
#endif

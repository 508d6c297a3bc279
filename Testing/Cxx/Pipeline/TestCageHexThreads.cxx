// SPDX-License-Identifier: BSD-3-Clause
// vtkCageHexInterior on several threads, its progress and its abort.
#include "CageHexCase.h"

#include "HexSweepArrays.h"

#include <vtkCageHexInterior.h>

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

namespace TestCageHexThreads
{
using test::gridOf;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// A bent volume: its rings are no affine images of each other.
test::Sweep bentSweep(int cells, int layers)
{
  return test::makeSweep(
    cells, cells, true, test::evenLayers(layers), [](double x, double y, double t) {
      const double wave = std::sin(3.0 * t);
      return Eigen::RowVector3d(
        x + 0.3 * wave + 0.05 * wave * std::sin(3.0 * x + y), y + 0.2 * t * t, t + 0.1 * wave * x);
    });
}

vtkSmartPointer<vtkCageHexInterior> filterOf(const test::Sweep& sweep)
{
  auto filter = vtkSmartPointer<vtkCageHexInterior>::New();
  filter->SetMethodToBlend();
  filter->SetEnsureValid(false);
  filter->SetSourceQuadsData(gridOf(sweep.source, sweep.quads));
  filter->SetTargetQuadsData(gridOf(sweep.target, sweep.quads));
  filter->SetLinkingSidesData(gridOf(sweep.linkingPoints, sweep.linkingQuads));
  return filter;
}

/// A curved volume whose interior must be untangled and polished, all settings at their defaults.
vtkSmartPointer<vtkCageHexInterior> filterWithDefaults()
{
  const test::Sweep sweep =
    test::makeSweep(14, 11, true, test::evenLayers(6), [](double x, double y, double t) {
      const double u = std::sin(3.0 * x + 2.0 * y);
      const double v = std::sin(4.0 * y - 2.0 * x);
      const double w = std::sin(2.0 * x + 3.0 * y);
      return Eigen::RowVector3d(x + 0.18 * ((1 - t) * v + t * w), y + 0.18 * ((1 - t) * w + t * u),
        1.5 * t + 0.6 * ((1 - t) * u + t * v));
    });
  auto filter = vtkSmartPointer<vtkCageHexInterior>::New();
  filter->SetSourceQuadsData(gridOf(sweep.source, sweep.quads));
  filter->SetTargetQuadsData(gridOf(sweep.target, sweep.quads));
  filter->SetLinkingSidesData(gridOf(sweep.linkingPoints, sweep.linkingQuads));
  return filter;
}

void expectSameBits(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->GetDataType(), b->GetDataType());
  ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
  const std::size_t bytes = static_cast<std::size_t>(a->GetNumberOfValues()) *
    static_cast<std::size_t>(a->GetDataTypeSize());
  EXPECT_EQ(std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes), 0)
    << (a->GetName() ? a->GetName() : "no name");
}

void expectSameGrids(vtkUnstructuredGrid* one, vtkUnstructuredGrid* more)
{
  expectSameBits(one->GetPoints()->GetData(), more->GetPoints()->GetData());
  expectSameBits(one->GetCells()->GetConnectivityArray(), more->GetCells()->GetConnectivityArray());
  expectSameBits(one->GetCells()->GetOffsetsArray(), more->GetCells()->GetOffsetsArray());
  for (int i = 0; i < one->GetPointData()->GetNumberOfArrays(); ++i)
  {
    expectSameBits(one->GetPointData()->GetArray(i), more->GetPointData()->GetArray(i));
  }
  for (int i = 0; i < one->GetCellData()->GetNumberOfArrays(); ++i)
  {
    expectSameBits(one->GetCellData()->GetArray(i), more->GetCellData()->GetArray(i));
  }
}

/// Runs the rest of a test with real threads, whatever the backend was.
class Threads
{
public:
  explicit Threads(int count)
    : Backend(vtkSMPTools::GetBackend())
  {
    vtkSMPTools::SetBackend("STDThread");
    vtkSMPTools::Initialize(count);
  }
  ~Threads()
  {
    vtkSMPTools::Initialize(0);
    vtkSMPTools::SetBackend(this->Backend.c_str());
  }
  Threads(const Threads&) = delete;
  void operator=(const Threads&) = delete;

private:
  std::string Backend;
};

TEST(CageHexThreads, SameBitsWithAnyNumberOfThreads)
{
  const test::Sweep sweep = bentSweep(40, 45);
  const auto run = [&](int threads) -> Grid {
    const Threads used(threads);
    const auto filter = filterOf(sweep);
    filter->Update();
    return filter->GetOutput();
  };
  const Grid one = run(1);
  ASSERT_GT(one->GetNumberOfCells(), 0);
  for (const int threads : { 2, 3 })
  {
    const Grid more = run(threads);
    expectSameGrids(one, more);
  }
}

TEST(CageHexThreads, SameBitsWithAllDefaults)
{
  const auto run = [&](int threads) -> Grid {
    const Threads used(threads);
    const auto filter = filterWithDefaults();
    filter->Update();
    return filter->GetOutput();
  };
  const Grid one = run(1);
  ASSERT_GT(one->GetNumberOfCells(), 0);
  // Everything had its turn.
  auto* method =
    vtkStringArray::SafeDownCast(one->GetFieldData()->GetAbstractArray(hexsweep::reports::Method));
  ASSERT_TRUE(method);
  EXPECT_EQ(std::string(method->GetValue(0)), "Blend + untangling + raised minimum + polish");
  for (const int threads : { 2, 3 })
  {
    expectSameGrids(one, run(threads));
  }
}

TEST(CageHexThreads, ProgressMovesOnTheCallersThread)
{
  const Threads used(2);
  const auto filter = filterOf(bentSweep(30, 90));
  struct Seen
  {
    std::vector<double> progress;
    std::thread::id caller = std::this_thread::get_id();
    bool elsewhere = false;
  } seen;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&seen);
  observer->SetCallback([](vtkObject* caller, unsigned long, void* client, void*) {
    auto* to = static_cast<Seen*>(client);
    to->progress.push_back(vtkAlgorithm::SafeDownCast(caller)->GetProgress());
    to->elsewhere = to->elsewhere || to->caller != std::this_thread::get_id();
  });
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  filter->Update();
  EXPECT_TRUE(std::is_sorted(seen.progress.begin(), seen.progress.end()));
  EXPECT_FALSE(seen.elsewhere);
  EXPECT_GE(seen.progress.size(), 5u);
}

TEST(CageHexThreads, ProgressAndAbortsWithAllDefaults)
{
  const Threads used(2);
  struct Seen
  {
    std::vector<double> progress;
    double stopAt = 2.0;
    int callsAfterTheAbort = 0;
    bool aborted = false;
  };
  const auto run = [&](double stopAt, Seen& seen) {
    const auto filter = filterWithDefaults();
    seen.stopAt = stopAt;
    vtkNew<vtkCallbackCommand> observer;
    observer->SetClientData(&seen);
    observer->SetCallback([](vtkObject* caller, unsigned long, void* client, void*) {
      auto* to = static_cast<Seen*>(client);
      auto* self = vtkAlgorithm::SafeDownCast(caller);
      to->progress.push_back(self->GetProgress());
      // The executive itself says that it is done.
      to->callsAfterTheAbort += to->aborted && self->GetProgress() < 1.0;
      if (self->GetProgress() >= to->stopAt)
      {
        to->aborted = true;
        self->SetAbortExecute(1);
      }
    });
    filter->AddObserver(vtkCommand::ProgressEvent, observer);
    filter->Update();
    return filter->GetOutput()->GetNumberOfCells();
  };
  Seen whole;
  EXPECT_GT(run(2.0, whole), 0);
  EXPECT_GE(whole.progress.size(), 10u);
  EXPECT_TRUE(std::is_sorted(whole.progress.begin(), whole.progress.end()));
  for (const double fraction : { 0.05, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.95 })
  {
    Seen seen;
    EXPECT_EQ(run(fraction, seen), 0) << fraction;
    EXPECT_TRUE(seen.aborted) << fraction;
    EXPECT_EQ(seen.callsAfterTheAbort, 0) << fraction;
  }
}

TEST(CageHexThreads, AnAbortEmptiesTheOutput)
{
  for (const int threads : { 1, 2 })
  {
    const Threads used(threads);
    for (const double fraction : { 0.0, 0.3, 0.75 })
    {
      const auto filter = filterOf(bentSweep(15, 90));
      test::expectEmptyWhenAborted(filter, fraction);
    }
  }
}
}

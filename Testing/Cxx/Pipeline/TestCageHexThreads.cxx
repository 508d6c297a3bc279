// SPDX-License-Identifier: BSD-3-Clause
// vtkCageHexInterior on several threads, its progress and its abort.
#include "../Core/SweepMeshes.h"
#include "CapGrids.h"
#include "TestEvents.h"

#include <vtkCageHexInterior.h>

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

namespace
{
using hexsweep::Index;
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

Grid gridOf(const hexsweep::Points& points, const hexsweep::Quads& quads)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> copies;
  copies->SetDataTypeToDouble();
  for (Index i = 0; i < points.rows(); ++i)
  {
    copies->InsertNextPoint(points.row(i).data());
  }
  grid->SetPoints(copies);
  grid->Allocate(quads.rows());
  for (Index q = 0; q < quads.rows(); ++q)
  {
    const vtkIdType ids[4] = { quads(q, 0), quads(q, 1), quads(q, 2), quads(q, 3) };
    grid->InsertNextCell(VTK_QUAD, 4, ids);
  }
  return grid;
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
}

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
    expectSameBits(one->GetPoints()->GetData(), more->GetPoints()->GetData());
    expectSameBits(
      one->GetCells()->GetConnectivityArray(), more->GetCells()->GetConnectivityArray());
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

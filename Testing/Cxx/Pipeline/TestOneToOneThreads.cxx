// SPDX-License-Identifier: BSD-3-Clause
// vtkOneToOneSweep on several threads.
#include "SolidGrids.h"

#include <vtkCellArray.h>
#include <vtkSMPTools.h>

#include <cstring>

namespace TestOneToOneThreads
{
using namespace test;

/// All defaults but the size of the quads, which is small enough for several pieces of work.
Grid swept(const std::string& name, double quadSize, int threads)
{
  Grid grid = Grid::New();
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false), [&] {
    SolidSweep sweep(solidGrid(name));
    sweep.filter->SetQuadSize(quadSize);
    sweep.filter->SetNumberOfLayers(4);
    sweep.filter->Update();
    EXPECT_EQ(sweep.messages(), "");
    grid->DeepCopy(sweep.hexes());
  });
  return grid;
}

void expectSameBits(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
  const std::size_t bytes = static_cast<std::size_t>(a->GetNumberOfValues()) *
    static_cast<std::size_t>(a->GetDataTypeSize());
  EXPECT_EQ(std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes), 0)
    << (a->GetName() ? a->GetName() : "no name");
}

TEST(OneToOneThreads, SameBitsWithAnyNumberOfThreads)
{
  // A prism, and one whose target quads go through disk maps.
  for (const auto& [name, quadSize] : { std::pair{ "flange", 1.0 }, std::pair{ "loft", 0.5 } })
  {
    SCOPED_TRACE(name);
    const Grid one = swept(name, quadSize, 1);
    ASSERT_GT(one->GetNumberOfCells(), 8000);
    for (const int threads : { 2, 3 })
    {
      const Grid more = swept(name, quadSize, threads);
      expectSameBits(one->GetPoints()->GetData(), more->GetPoints()->GetData());
      expectSameBits(
        one->GetCells()->GetConnectivityArray(), more->GetCells()->GetConnectivityArray());
      for (int i = 0; i < one->GetCellData()->GetNumberOfArrays(); ++i)
      {
        expectSameBits(one->GetCellData()->GetArray(i), more->GetCellData()->GetArray(i));
      }
    }
  }
}
}

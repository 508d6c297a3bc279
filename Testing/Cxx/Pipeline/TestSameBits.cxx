// SPDX-License-Identifier: BSD-3-Clause
// All cases and solids give the same bits without threads and with any number of them.
#include "EveryFilter.h"
#include "SolidGrids.h"

#include <vtkCageHexInterior.h>
#include <vtkSMPTools.h>
#include <vtkSweepQuadProjector.h>

#include <cstring>

namespace TestSameBits
{
using namespace test;

void expectSameArray(vtkAbstractArray* one, vtkAbstractArray* other)
{
  auto* a = vtkDataArray::SafeDownCast(one);
  auto* b = vtkDataArray::SafeDownCast(other);
  ASSERT_EQ(a == nullptr, b == nullptr);
  if (!a)
  {
    return;
  }
  ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
  const auto bytes = static_cast<std::size_t>(a->GetNumberOfValues()) *
    static_cast<std::size_t>(a->GetDataTypeSize());
  EXPECT_TRUE(bytes == 0 || std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes) == 0)
    << (a->GetName() ? a->GetName() : "no name");
}

/// Points, corners and all arrays of points and cells.
void expectSameMesh(vtkUnstructuredGrid* one, vtkUnstructuredGrid* other)
{
  ASSERT_GT(one->GetNumberOfCells(), 0);
  expectSameArray(one->GetPoints()->GetData(), other->GetPoints()->GetData());
  expectSameArray(
    one->GetCells()->GetConnectivityArray(), other->GetCells()->GetConnectivityArray());
  vtkDataSetAttributes* ofOne[] = { one->GetPointData(), one->GetCellData() };
  vtkDataSetAttributes* ofOther[] = { other->GetPointData(), other->GetCellData() };
  for (std::size_t kind = 0; kind < 2; ++kind)
  {
    ASSERT_EQ(ofOne[kind]->GetNumberOfArrays(), ofOther[kind]->GetNumberOfArrays());
    for (int a = 0; a < ofOne[kind]->GetNumberOfArrays(); ++a)
    {
      expectSameArray(ofOne[kind]->GetAbstractArray(a), ofOther[kind]->GetAbstractArray(a));
    }
  }
}

Grid sweptSolid(const CadSolid& solid)
{
  SolidSweep sweep(solidGrid(solid.name));
  sweep.name(solid.source, solid.target);
  sweep.filter->SetQuadSize(solid.quadSize);
  sweep.filter->SetNumberOfLayers(solid.layers);
  sweep.filter->Update();
  EXPECT_TRUE(sweep.events.errors.empty());
  return sweep.hexes();
}

Grid sweptCase(const std::string& name)
{
  const SweepGrids sweep = readCase(name);
  vtkNew<vtkSweepQuadProjector> projector;
  projector->SetSourceQuadsData(sweep.sourceQuads);
  projector->SetTargetSurfaceData(sweep.targetSurface);
  projector->SetSourceSurfaceData(sweep.sourceSurface);
  projector->SetLinkingSidesData(sweep.linkingSides);
  vtkNew<vtkCageHexInterior> interior;
  interior->SetSourceQuadsData(sweep.sourceQuads);
  interior->SetTargetQuadsConnection(projector->GetOutputPort());
  interior->SetLinkingSidesData(sweep.linkingSides);
  interior->Update();
  return interior->GetOutput();
}

void expectSameWithThreads(const std::function<Grid()>& swept)
{
  const auto run = [&](int threads, const char* backend) {
    Grid grid;
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config(threads, backend, false), [&] { grid = deepCopy(swept().Get()); });
    return grid;
  };
  const Grid alone = run(1, "Sequential");
  for (int threads = 1; threads <= 4; ++threads)
  {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    expectSameMesh(alone, run(threads, "STDThread"));
  }
}

class SameBitsOfSolids : public testing::TestWithParam<CadSolid>
{
};

TEST_P(SameBitsOfSolids, WithoutThreadsAndWithOneToFour)
{
  expectSameWithThreads([] { return sweptSolid(GetParam()); });
}

INSTANTIATE_TEST_SUITE_P(Data, SameBitsOfSolids, testing::ValuesIn(cadSolids()));

class SameBitsOfCases : public testing::TestWithParam<const char*>
{
};

TEST_P(SameBitsOfCases, WithoutThreadsAndWithOneToFour)
{
  expectSameWithThreads([] { return sweptCase(GetParam()); });
}

// bad_rings cannot be swept.
INSTANTIATE_TEST_SUITE_P(Data, SameBitsOfCases,
  testing::Values("c_open", "chord_mismatch", "fig7_growing_hole", "fig8_concave_twisted_hole",
    "fig9_spongecake", "fine_coarse", "gear_round", "hole_moves", "hole_twist120", "holes40",
    "taper10", "twist270_L", "ubend"));
}

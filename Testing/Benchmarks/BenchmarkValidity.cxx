// SPDX-License-Identifier: BSD-3-Clause
// One million hexahedra judged by the filters: the certificate, its bound and the scaled Jacobian
// against Verdict's scaled Jacobian alone.
#include "Interleaved.h"

#include <vtkHexValidity.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellQuality.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkMeshQuality.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
constexpr vtkIdType CellsPerSide = 100;

/// A block of hexahedra with all points shaken by up to `amplitude` of a cell.
vtkSmartPointer<vtkUnstructuredGrid> shakenBlock(double amplitude)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> shake(-amplitude, amplitude);
  constexpr vtkIdType Points = CellsPerSide + 1;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->Allocate(Points * Points * Points);
  for (vtkIdType k = 0; k < Points; ++k)
  {
    for (vtkIdType j = 0; j < Points; ++j)
    {
      for (vtkIdType i = 0; i < Points; ++i)
      {
        const double dx = shake(generator);
        const double dy = shake(generator);
        const double dz = shake(generator);
        points->InsertNextPoint(
          static_cast<double>(i) + dx, static_cast<double>(j) + dy, static_cast<double>(k) + dz);
      }
    }
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->AllocateExact(CellsPerSide * CellsPerSide * CellsPerSide, 8);
  for (vtkIdType k = 0; k < CellsPerSide; ++k)
  {
    for (vtkIdType j = 0; j < CellsPerSide; ++j)
    {
      for (vtkIdType i = 0; i < CellsPerSide; ++i)
      {
        const vtkIdType low = i + Points * (j + Points * k);
        const vtkIdType high = low + Points * Points;
        const vtkIdType ids[8] = { low, low + 1, low + 1 + Points, low + Points, high, high + 1,
          high + 1 + Points, high + Points };
        grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
      }
    }
  }
  return grid;
}

void judgeHexes(benchmark::State& state, double amplitude)
{
  vtkObject::GlobalWarningDisplayOff(); // that some of them are inverted
  const auto grid = shakenBlock(amplitude);
  vtkNew<vtkHexValidity> validity;
  validity->SetInputData(grid);
  vtkNew<vtkCellQuality> cellQuality;
  cellQuality->SetInputData(grid);
  cellQuality->SetQualityMeasureToScaledJacobian();
  vtkNew<vtkMeshQuality> meshQuality;
  meshQuality->SetInputData(grid);
  meshQuality->SetHexQualityMeasureToScaledJacobian();

  const auto run = [](vtkAlgorithm* filter) {
    filter->Modified();
    filter->Update();
  };
  test::Interleaved runs;
  runs.add("certificate", [&] { run(validity); });
  runs.add("vtkCellQuality", [&] { run(cellQuality); });
  runs.add("vtkMeshQuality", [&] { run(meshQuality); });
  runs.report(state);

  vtkCellData* judged = validity->GetOutput()->GetCellData();
  vtkDataArray* ours = judged->GetArray("ScaledJacobian");
  vtkDataArray* theirs = cellQuality->GetOutput()->GetCellData()->GetArray("CellQuality");
  double difference = 0.0;
  vtkIdType certified = 0;
  for (vtkIdType cell = 0; cell < ours->GetNumberOfTuples(); ++cell)
  {
    difference =
      std::max(difference, std::abs(ours->GetComponent(cell, 0) - theirs->GetComponent(cell, 0)));
    certified += judged->GetArray("Validity")->GetComponent(cell, 0) == vtkHexValidity::CERTIFIED;
  }
  state.counters["certified"] = static_cast<double>(certified);
  state.counters["difference"] = difference;
}
}

BENCHMARK_CAPTURE(judgeHexes, Good, 0.1)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(judgeHexes, Shaken, 0.25)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(judgeHexes, Tangled, 0.4)->Iterations(1)->Unit(benchmark::kSecond);

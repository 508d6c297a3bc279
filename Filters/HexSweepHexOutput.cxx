// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepHexOutput.h"

#include "Core/Errors.h"
#include "Core/SweptHexes.h"
#include "HexSweepBridge.h"
#include "HexSweepGrid.h"
#include "HexSweepMethods.h"
#include "HexSweepQualityArrays.h"
#include "vtkCageHexInterior.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <utility>

namespace hexsweep
{
namespace
{
constexpr int PolishingRounds = 6;
constexpr Index HexesAPiece = Index{ 1 } << 17;

void addQualities(const std::vector<HexQuality>& qualities, vtkCellData* cellData)
{
  const Index hexes = static_cast<Index>(qualities.size());
  QualityArrays arrays(hexes);
  forPieces(smpFor(), hexes, HexesAPiece, [&](Index begin, Index end) {
    for (Index h = begin; h < end; ++h)
    {
      arrays.set(h, qualities[static_cast<std::size_t>(h)]);
    }
  });
  arrays.addTo(cellData);
  cellData->SetActiveScalars("ScaledJacobian");
}

void addAttributes(const SourceAttributes& source, Index layers, vtkUnstructuredGrid* output)
{
  vtkPointData* pointData = output->GetPointData();
  vtkCellData* cellData = output->GetCellData();
  if (source.data)
  {
    carryAttributes(source.data->GetPointData(), source.pointIds, layers + 1, pointData);
    carryAttributes(source.data->GetCellData(), source.cellIds, layers, cellData);
  }
  pointData->AddArray(newRepeatedIds("SourcePointIds", source.pointIds, layers + 1));
  pointData->AddArray(newLayerNumbers(static_cast<Index>(source.pointIds.size()), layers + 1));
  cellData->AddArray(newRepeatedIds("SourceCellIds", source.cellIds, layers));
  cellData->AddArray(newLayerNumbers(static_cast<Index>(source.cellIds.size()), layers));
}
}

HexOutput writeHexes(const SweepCage& cage, const SourceAttributes& source,
  const HexOutputSettings& settings, StageClock& stages, const Progress& progress,
  vtkUnstructuredGrid* output)
{
  InteriorOptions options;
  options.ensureValid = settings.ensureValid;
  options.polishingRounds = settings.ensureValid && settings.improveQuality &&
      settings.method == vtkCageHexInterior::AUTOMATIC
    ? PolishingRounds
    : 0;
  options.parallelFor = smpFor();
  HexOutput result;
  result.interior =
    sweepInterior(cage, interiorStarts(settings.method), options, progressPart(progress, 0.0, 0.9));
  stages.finish(result.interior.steps);
  Points points = std::move(result.interior.points);
  if (settings.precision == vtkAlgorithm::SINGLE_PRECISION)
  {
    // Judged as stored.
    points = points.cast<float>().cast<double>().eval();
  }
  result.layers = cage.boundary.numberOfLayers();
  result.sourceIsBottom = sourceIsBottom(cage.quads, points, result.layers, smpFor());
  const vtkSmartPointer<vtkIdTypeArray> connectivity =
    newSweptConnectivity(cage.quads, cage.source.rows(), result.layers, result.sourceIsBottom);
  const auto hexes = hexView(connectivity);
  const std::vector<HexQuality> qualities =
    hexQualities(points, hexes, settings.certify, smpFor(), progressPart(progress, 0.9, 0.95));
  result.summary = summarize(qualities);
  stages.finish("Quality");
  if (result.summary.inverted + result.summary.degenerate > 0)
  {
    result.warnings.push_back(describeInverted(points, hexes, qualities, result.interior.fixed));
    if (settings.failIfInvalid)
    {
      throw InvalidInput(result.warnings.back());
    }
  }
  if (settings.certify && result.summary.undecided > 0)
  {
    result.warnings.push_back(std::to_string(result.summary.undecided) + " of " +
      std::to_string(result.summary.hexes) +
      " hexahedra are undecided: their Jacobian comes too near to zero to be told from it. "
      "Threshold the cell array Validity (3) to see them, and treat them as inverted.");
  }
  output->SetPoints(newSweptPoints(points, settings.precision));
  setSweptCells(output, connectivity);
  reportProgress(progress, 0.97);
  addAttributes(source, result.layers, output);
  addQualities(qualities, output->GetCellData());
  vtkFieldData* fieldData = output->GetFieldData();
  addQualityReport(fieldData, result.summary);
  addReport(fieldData, "SweepReportMethod", result.interior.method);
  addStepReport(fieldData, result.interior, options);
  reportProgress(progress, 1.0);
  return result;
}
}

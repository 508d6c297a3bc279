// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepHexOutput.h"

#include "Core/Common/Errors.h"
#include "Core/Common/StoppablePieces.h"
#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/SectionInterior.h"
#include "Core/Interior/SweptHexes.h"
#include "HexSweepArrays.h"
#include "HexSweepGrid.h"
#include "HexSweepHexText.h"
#include "HexSweepQualityArrays.h"
#include "HexSweepRun.h"
#include "HexSweepWriter.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

namespace hexsweep
{
namespace
{
constexpr Index HexesAPiece = Index{ 1 } << 17;

/// Points, hexahedra, and what they have from the source quads.
void fillGrid(const PointsRef& points, vtkIdTypeArray* connectivity, Index layers,
  const SourceAttributes& source, int precision, const Progress& progress,
  vtkUnstructuredGrid* output)
{
  const auto part = [&](double from, double to) { return progressPart(progress, from, to); };
  output->SetPoints(newSweptPoints(points, precision, part(0.0, 0.3)));
  setSweptCells(output, connectivity, part(0.3, 0.4));
  vtkPointData* pointData = output->GetPointData();
  vtkCellData* cellData = output->GetCellData();
  if (source.data)
  {
    carryAttributes(
      source.data->GetPointData(), source.pointIds, layers + 1, pointData, part(0.4, 0.5));
    carryAttributes(source.data->GetCellData(), source.cellIds, layers, cellData, part(0.5, 0.6));
  }
  pointData->AddArray(
    newRepeatedIds(arrays::SourcePointIds, source.pointIds, layers + 1, part(0.6, 0.7)));
  pointData->AddArray(
    newLayerNumbers(static_cast<Index>(source.pointIds.size()), layers + 1, part(0.7, 0.8)));
  cellData->AddArray(newRepeatedIds(arrays::SourceCellIds, source.cellIds, layers, part(0.8, 0.9)));
  cellData->AddArray(
    newLayerNumbers(static_cast<Index>(source.cellIds.size()), layers, part(0.9, 1.0)));
}

void addQualities(
  const std::vector<HexQuality>& qualities, const Progress& progress, vtkCellData* cellData)
{
  const Index hexes = static_cast<Index>(qualities.size());
  QualityArrays arrays(hexes);
  forStoppablePieces(smpFor(), progress, hexes, HexesAPiece, [&](Index begin, Index end) {
    for (Index h = begin; h < end; ++h)
    {
      arrays.set(h, qualities[static_cast<std::size_t>(h)]);
    }
  });
  arrays.addTo(cellData);
  cellData->SetActiveScalars(arrays::ScaledJacobian);
}
}

HexOutput writeHexes(const SweepCage& cage, const SourceAttributes& source,
  const HexOutputSettings& settings, StageClock& stages, const Progress& progress,
  vtkUnstructuredGrid* output)
{
  const auto method = static_cast<InteriorKind>(settings.method);
  const bool automatic = method == InteriorKind::Automatic;
  InteriorOptions options;
  options.ensureValid = settings.ensureValid;
  if (!settings.ensureValid || !settings.improveQuality || !automatic)
  {
    options.polishingRounds = 0;
  }
  options.parallelFor = smpFor();
  options.keepQualities = settings.certify;
  if (settings.precision == vtkAlgorithm::SINGLE_PRECISION)
  {
    options.precision = Precision::Single;
  }
  SweepInterior interior =
    sweepInterior(cage, interiorStarts(method, cage.isRuled, windingOf(cage.boundary)), options,
      progressPart(progress, 0.0, 0.9));
  stages.finish(stagesOf(interior.steps));
  const Index layers = cage.boundary.numberOfLayers();
  vtkSmartPointer<vtkIdTypeArray> connectivity = newSweptConnectivity(cage.quads,
    cage.source.rows(), layers, interior.sourceIsBottom, progressPart(progress, 0.9, 0.91));
  const auto hexes = hexView(connectivity);
  const std::vector<HexQuality> qualities = !interior.qualities.empty()
    ? std::move(interior.qualities)
    : hexQualities(
        interior.points, hexes, settings.certify, smpFor(), progressPart(progress, 0.91, 0.95));
  const HexQualitySummary summary = summarize(qualities);
  stages.finish("Quality");

  HexOutput result;
  result.sourceIsBottom = interior.sourceIsBottom;
  const JudgedHexes judged = { summary, static_cast<Index>(qualities.size()),
    [&](Index h) { return qualities[static_cast<std::size_t>(h)]; },
    [&](Index h) {
      HexCorners places;
      for (int c = 0; c < 8; ++c)
      {
        places.row(c) = interior.points.row(hexes(h, c));
      }
      return places;
    } };
  const auto advice = [&]() {
    return interiorAdvice(interior.points, cage.source.rows(), summary.notCertified, interior.fixed,
      { settings.ensureValid, automatic, interior.lostByRounding });
  };
  if (summary.inverted + summary.degenerate > 0)
  {
    result.warnings.push_back(describeInverted(judged, advice()));
    if (settings.failIfInvalid)
    {
      throw InvalidInput(result.warnings.back());
    }
  }
  if (settings.certify && summary.undecided > 0)
  {
    result.warnings.push_back(describeUndecided(judged, advice()));
  }

  if (settings.reflection.turnsOver())
  {
    result.sourceIsBottom = !result.sourceIsBottom;
    connectivity =
      newSweptConnectivity(cage.quads, cage.source.rows(), layers, result.sourceIsBottom, {});
  }
  fillGrid(reflected(std::move(interior.points), settings.reflection), connectivity, layers, source,
    settings.precision, progressPart(progress, 0.95, 0.98), output);
  addQualities(qualities, progressPart(progress, 0.98, 1.0), output->GetCellData());
  vtkFieldData* fieldData = output->GetFieldData();
  addQualityReport(fieldData, summary);
  addReport(fieldData, reports::Method, interior.method);
  addStepReport(fieldData, interior, options);
  return result;
}

void writeSweptGrid(const PointsRef& points, const SweepCage& cage, const SourceAttributes& source,
  int precision, const Progress& progress, vtkUnstructuredGrid* output)
{
  const Index layers = cage.boundary.numberOfLayers();
  const vtkSmartPointer<vtkIdTypeArray> connectivity = newSweptConnectivity(cage.quads,
    cage.source.rows(), layers, sourceIsBottom(cage.quads, points, layers, smpFor()), {});
  fillGrid(points, connectivity, layers, source, precision, progress, output);
}
}

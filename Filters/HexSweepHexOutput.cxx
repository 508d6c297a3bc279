// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepHexOutput.h"

#include "Core/Common/Errors.h"
#include "Core/Common/MemoryBudget.h"
#include "Core/Common/StoppablePieces.h"
#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/SectionInterior.h"
#include "Core/Interior/SweptHexes.h"
#include "HexSweepArrays.h"
#include "HexSweepAsking.h"
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

#include <utility>

namespace hexsweep
{
namespace
{
constexpr Index HexesAPiece = Index{ 1 } << 17;

/// Points, hexahedra, and what they have from the source quads.
void fillGrid(vtkPoints* points, vtkIdTypeArray* connectivity, Index layers,
  const SourceAttributes& source, const Progress& progress, vtkUnstructuredGrid* output)
{
  const auto part = [&](double from, double to) { return progressPart(progress, from, to); };
  output->SetPoints(points);
  setSweptCells(output, connectivity, part(0.0, 0.1));
  vtkPointData* pointData = output->GetPointData();
  vtkCellData* cellData = output->GetCellData();
  if (source.data)
  {
    carryAttributes(
      source.data->GetPointData(), source.pointIds, layers + 1, pointData, part(0.1, 0.3));
    carryAttributes(source.data->GetCellData(), source.cellIds, layers, cellData, part(0.3, 0.5));
  }
  pointData->AddArray(
    newRepeatedIds(arrays::SourcePointIds, source.pointIds, layers + 1, part(0.5, 0.6)));
  pointData->AddArray(
    newLayerNumbers(static_cast<Index>(source.pointIds.size()), layers + 1, part(0.6, 0.7)));
  cellData->AddArray(newRepeatedIds(arrays::SourceCellIds, source.cellIds, layers, part(0.7, 0.9)));
  cellData->AddArray(
    newLayerNumbers(static_cast<Index>(source.cellIds.size()), layers, part(0.9, 1.0)));
}

bool isAutomatic(const HexOutputSettings& settings)
{
  return static_cast<InteriorKind>(settings.method) == InteriorKind::Automatic;
}

void setQualities(
  const std::vector<HexQuality>& qualities, const Progress& progress, QualityArrays& arrays)
{
  const Index hexes = static_cast<Index>(qualities.size());
  forStoppablePieces(smpFor(), progress, hexes, HexesAPiece, [&](Index begin, Index end) {
    for (Index h = begin; h < end; ++h)
    {
      arrays.set(h, qualities[static_cast<std::size_t>(h)]);
    }
  });
}
}

std::vector<InteriorStart> startsOf(const SweepCage& cage, const HexOutputSettings& settings)
{
  if (settings.begun.points)
  {
    return { startAt(settings.begun.method, *settings.begun.points) };
  }
  return interiorStarts(
    static_cast<InteriorKind>(settings.method), cage.isRuled, windingOf(cage.boundary));
}

InteriorOptions interiorOptions(const HexOutputSettings& settings, const Progress& progress)
{
  InteriorOptions options;
  options.ensureValid = settings.ensureValid;
  if (!settings.ensureValid || !settings.improveQuality || !isAutomatic(settings))
  {
    options.polishingRounds = settings.isTrial ? 1 : 0;
  }
  options.parallelFor = askingFor(progress);
  options.keepQualities = settings.certify;
  if (settings.precision == vtkAlgorithm::SINGLE_PRECISION)
  {
    options.precision = Precision::Single;
  }
  return options;
}

HexOutput writeHexes(const SweepCage& cage, const SourceAttributes& source,
  const HexOutputSettings& settings, StageClock& stages, const Progress& progress,
  vtkUnstructuredGrid* output)
{
  checkHexBudget(
    static_cast<double>(cage.quads.rows()) * static_cast<double>(cage.boundary.numberOfLayers()),
    "Use coarser quads or fewer layers.");
  const bool automatic = isAutomatic(settings);
  const InteriorOptions options = interiorOptions(settings, progress);
  SweepInterior interior =
    sweepInterior(cage, startsOf(cage, settings), options, progressPart(progress, 0.0, 0.9));
  stages.finish(stagesOf(interior.steps));
  const Index layers = cage.boundary.numberOfLayers();
  vtkSmartPointer<vtkIdTypeArray> connectivity = newSweptConnectivity(cage.quads,
    cage.source.rows(), layers, interior.sourceIsBottom, progressPart(progress, 0.9, 0.91));
  const auto hexes = hexView(connectivity);
  std::vector<HexQuality> qualities = !interior.qualities.empty()
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

  // What is written is let go of before the next is: it all is as large as the grid.
  QualityArrays qualityArrays(static_cast<vtkIdType>(qualities.size()));
  setQualities(qualities, progressPart(progress, 0.95, 0.96), qualityArrays);
  qualities = std::vector<HexQuality>();
  if (settings.reflection.turnsOver())
  {
    result.sourceIsBottom = !result.sourceIsBottom;
    connectivity = nullptr;
    connectivity =
      newSweptConnectivity(cage.quads, cage.source.rows(), layers, result.sourceIsBottom, {});
  }
  const vtkSmartPointer<vtkPoints> points =
    newSweptPoints(reflected(std::move(interior.points), settings.reflection), settings.precision,
      progressPart(progress, 0.96, 0.97));
  fillGrid(points, connectivity, layers, source, progressPart(progress, 0.97, 1.0), output);
  qualityArrays.addTo(output->GetCellData());
  output->GetCellData()->SetActiveScalars(arrays::ScaledJacobian);
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
  fillGrid(newSweptPoints(points, precision, progressPart(progress, 0.0, 0.3)), connectivity,
    layers, source, progressPart(progress, 0.3, 1.0), output);
}
}

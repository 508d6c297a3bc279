// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCageHexInterior.h"

#include "Core/CageMesh.h"
#include "Core/Errors.h"
#include "Core/HexQuality.h"
#include "Core/SweptHexes.h"
#include "Core/TopologicalModel.h"
#include "HexSweepBridge.h"
#include "HexSweepCage.h"
#include "HexSweepGrid.h"
#include "HexSweepHexText.h"
#include "HexSweepInteriorReport.h"
#include "HexSweepMethods.h"
#include "HexSweepQualityArrays.h"

#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkCageHexInterior);

namespace
{
using hexsweep::HexQuality;
using hexsweep::Index;
using hexsweep::Points;

constexpr int PolishingRounds = 6;

struct SweptMesh
{
  Index layers = 0;
  Points points;
  vtkSmartPointer<vtkIdTypeArray> connectivity;

  Eigen::Map<const hexsweep::Hexes> hexes() const { return hexsweep::hexView(this->connectivity); }
};

SweptMesh sweptMesh(Points points, const hexsweep::SweepCage& cage, bool sourceIsBottom)
{
  SweptMesh mesh;
  mesh.layers = cage.boundary.numberOfLayers();
  mesh.points = std::move(points);
  mesh.connectivity =
    hexsweep::newSweptConnectivity(cage.quads, cage.source.rows(), mesh.layers, sourceIsBottom);
  return mesh;
}

Points modelOf(const hexsweep::SweepCage& cage)
{
  return hexsweep::topologicalModel(cage.target,
    hexsweep::cageQuads(cage.quads,
      hexsweep::physicalModel(cage.source, cage.target, cage.quads, cage.boundary),
      cage.boundary.numberOfLayers()),
    cage.boundary);
}

// Points, hexahedra, and what they have from the source quads.
void fillGrid(const SweptMesh& mesh, vtkDataSet* source, const std::vector<Index>& sourceCellIds,
  int precision, const hexsweep::Progress& progress, vtkUnstructuredGrid* output)
{
  hexsweep::reportProgress(progress, 0.0);
  output->SetPoints(hexsweep::newSweptPoints(mesh.points, precision));
  hexsweep::setSweptCells(output, mesh.connectivity);
  hexsweep::reportProgress(progress, 0.4);
  const Index pointsPerLayer = source->GetNumberOfPoints();
  std::vector<Index> pointIds(static_cast<std::size_t>(pointsPerLayer));
  std::iota(pointIds.begin(), pointIds.end(), Index{ 0 });
  vtkPointData* pointData = output->GetPointData();
  hexsweep::carryAttributes(source->GetPointData(), pointIds, mesh.layers + 1, pointData);
  pointData->AddArray(hexsweep::newRepeatedIds("SourcePointIds", pointIds, mesh.layers + 1));
  pointData->AddArray(hexsweep::newLayerNumbers(pointsPerLayer, mesh.layers + 1));
  hexsweep::reportProgress(progress, 0.7);
  vtkCellData* cellData = output->GetCellData();
  hexsweep::carryAttributes(source->GetCellData(), sourceCellIds, mesh.layers, cellData);
  cellData->AddArray(hexsweep::newRepeatedIds("SourceCellIds", sourceCellIds, mesh.layers));
  cellData->AddArray(
    hexsweep::newLayerNumbers(static_cast<Index>(sourceCellIds.size()), mesh.layers));
}

hexsweep::JudgedHexes judgedHexes(const SweptMesh& mesh, const std::vector<HexQuality>& qualities,
  const hexsweep::HexQualitySummary& summary)
{
  const auto corners = [&mesh](Index h) {
    hexsweep::HexCorners places;
    for (int c = 0; c < 8; ++c)
    {
      places.row(c) = mesh.points.row(mesh.hexes()(h, c));
    }
    return places;
  };
  return { summary, static_cast<Index>(qualities.size()),
    [&qualities](Index h) { return qualities[static_cast<std::size_t>(h)]; }, corners };
}

void addQualities(const std::vector<HexQuality>& qualities, vtkCellData* cellData)
{
  const Index hexes = static_cast<Index>(qualities.size());
  hexsweep::QualityArrays arrays(hexes);
  constexpr Index hexesAPiece = Index{ 1 } << 17;
  hexsweep::forPieces(hexsweep::smpFor(), hexes, hexesAPiece, [&](Index begin, Index end) {
    for (Index h = begin; h < end; ++h)
    {
      arrays.set(h, qualities[static_cast<std::size_t>(h)]);
    }
  });
  arrays.addTo(cellData);
  cellData->SetActiveScalars("ScaledJacobian");
}
}

vtkCageHexInterior::vtkCageHexInterior()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

int vtkCageHexInterior::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  // All three are needed; optional here so that RequestData says which one is missing, and why.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkCageHexInterior::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "EnsureValid: " << (this->EnsureValid ? "On" : "Off") << "\n";
  os << indent << "ImproveQuality: " << (this->ImproveQuality ? "On" : "Off") << "\n";
  os << indent << "Certify: " << (this->Certify ? "On" : "Off") << "\n";
  os << indent << "GenerateTopologicalModel: " << (this->GenerateTopologicalModel ? "On" : "Off")
     << "\n";
  os << indent << "FailIfInvalid: " << (this->FailIfInvalid ? "On" : "Off") << "\n";
}

int vtkCageHexInterior::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  const auto body = [&]() {
    vtkDataSet* sourceData = hexsweep::inputDataSet(inputs, 0);
    vtkDataSet* targetData = hexsweep::inputDataSet(inputs, 1);
    vtkDataSet* linkingData = hexsweep::inputDataSet(inputs, 2);
    if (hexsweep::isIdleRank(outputs, inputs, { "source quads", "target quads", "linking sides" }))
    {
      return;
    }
    hexsweep::StageClock clock;
    const std::vector<hexsweep::InteriorStart> starts = hexsweep::interiorStarts(this->Method);
    const hexsweep::CageInput cage =
      hexsweep::readCage(sourceData, targetData, linkingData, this->MatchTolerance);
    clock.finish("Read");
    hexsweep::reportProgress(hexsweep::pipelineProgress(this), 0.05);

    hexsweep::InteriorOptions options;
    options.ensureValid = this->EnsureValid;
    options.polishingRounds =
      this->EnsureValid && this->ImproveQuality && this->Method == AUTOMATIC ? PolishingRounds : 0;
    options.parallelFor = hexsweep::smpFor();
    if (this->OutputPointsPrecision == SINGLE_PRECISION)
    {
      options.precision = hexsweep::Precision::Single;
    }
    hexsweep::SweepInterior interior =
      hexsweep::sweepInterior(cage, starts, options, hexsweep::pipelineProgress(this, 0.05, 0.9));
    clock.finish(interior.steps);
    const SweptMesh mesh = sweptMesh(std::move(interior.points), cage, interior.sourceIsBottom);
    const std::vector<HexQuality> qualities = hexsweep::hexQualities(mesh.points, mesh.hexes(),
      this->Certify, hexsweep::smpFor(), hexsweep::pipelineProgress(this, 0.9, 0.95));
    const hexsweep::HexQualitySummary summary = hexsweep::summarize(qualities);
    clock.finish("Quality");
    const hexsweep::JudgedHexes judged = judgedHexes(mesh, qualities, summary);
    const auto advice = [&]() {
      return hexsweep::interiorAdvice(mesh.points, cage.source.rows(), summary.notCertified,
        interior.fixed, { this->EnsureValid, this->Method == AUTOMATIC, interior.lostByRounding });
    };
    if (summary.inverted + summary.degenerate > 0)
    {
      const std::string problem = hexsweep::describeInverted(judged, advice());
      if (this->FailIfInvalid)
      {
        throw hexsweep::InvalidInput(problem);
      }
      vtkWarningMacro(<< problem);
    }
    if (this->Certify && summary.undecided > 0)
    {
      vtkWarningMacro(<< hexsweep::describeUndecided(judged, advice()));
    }

    vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
    fillGrid(mesh, sourceData, cage.sourceCellIds, this->OutputPointsPrecision,
      hexsweep::pipelineProgress(this, 0.95, 0.98), output);
    addQualities(qualities, output->GetCellData());

    vtkFieldData* fieldData = output->GetFieldData();
    fieldData->PassData(targetData->GetFieldData());
    fieldData->PassData(sourceData->GetFieldData());
    // The quads' own floor is not that of the hexahedra.
    fieldData->RemoveArray("SweepReportFloorScaledJacobian");
    hexsweep::addQualityReport(fieldData, summary);
    hexsweep::addReport(fieldData, "SweepReportMethod", interior.method);
    hexsweep::addStepReport(fieldData, interior, options);
    if (this->GenerateTopologicalModel)
    {
      Points model = modelOf(cage);
      const bool sourceIsBottom = hexsweep::sourceIsBottom(
        cage.quads, model, cage.boundary.numberOfLayers(), hexsweep::smpFor());
      fillGrid(sweptMesh(std::move(model), cage, sourceIsBottom), sourceData, cage.sourceCellIds,
        this->OutputPointsPrecision, hexsweep::pipelineProgress(this, 0.98, 1.0),
        vtkUnstructuredGrid::GetData(outputs, 1));
    }
    clock.finish("Output");
    clock.report(fieldData);
  };
  return hexsweep::runFilter(this, outputs, body);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCageHexInterior.h"

#include "Core/Describe.h"
#include "Core/Errors.h"
#include "Core/HexQuality.h"
#include "Core/LinkingRings.h"
#include "Core/RingCollapse.h"
#include "Core/SurfaceTopology.h"
#include "Core/SweepBoundary.h"
#include "Core/SweptHexes.h"
#include "HexSweepBridge.h"
#include "HexSweepGrid.h"
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

#include <chrono>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkCageHexInterior);

namespace
{
using hexsweep::HexQuality;
using hexsweep::Index;
using hexsweep::Points;

constexpr Index NumberOfNamedCells = 10;
constexpr int PolishingRounds = 4;

// Seconds of each stage of the work, for the report.
class StageClock
{
public:
  void finish(const std::string& stage)
  {
    const auto now = std::chrono::steady_clock::now();
    this->Names.push_back(stage);
    this->Seconds.push_back(std::chrono::duration<double>(now - this->Start).count());
    this->Start = now;
  }

  // Work that was timed where it was done.
  void finish(const std::vector<hexsweep::InteriorStep>& steps)
  {
    for (const hexsweep::InteriorStep& step : steps)
    {
      this->Names.push_back(step.name);
      this->Seconds.push_back(step.seconds);
    }
    this->Start = std::chrono::steady_clock::now();
  }

  void report(vtkFieldData* fieldData) const
  {
    hexsweep::addReport(fieldData, "SweepReportStages", this->Names);
    hexsweep::addReport(fieldData, "SweepReportSeconds", this->Seconds);
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  std::vector<std::string> Names;
  std::vector<double> Seconds;
};

// The inputs, checked against each other.
struct Cage : hexsweep::SweepCage
{
  std::vector<Index> sourceCellIds;
};

Cage readCage(
  vtkDataSet* sourceData, vtkDataSet* targetData, vtkDataSet* linkingData, double matchTolerance)
{
  hexsweep::SurfaceInput source = hexsweep::readQuads(sourceData, "source quads");
  hexsweep::SurfaceInput target = hexsweep::readQuads(targetData, "target quads");
  const hexsweep::SurfaceInput linking = hexsweep::readQuads(linkingData, "linking sides");
  const Index n = source.points.rows();
  if (target.points.rows() != n)
  {
    throw hexsweep::InvalidInput(
      "the target quads do not have the connectivity of the source quads: " +
      std::to_string(target.points.rows()) + " points instead of " + std::to_string(n) +
      ". Make them from the source quads (SweepQuadProjector).");
  }
  const hexsweep::SurfaceTopology topology =
    hexsweep::checkSurface(source.faces, n, "source quads");
  hexsweep::checkCap(topology, "source quads");
  Cage cage;
  cage.quads = source.faces;
  hexsweep::checkSameQuads(cage.quads, hexsweep::Quads(target.faces));

  const hexsweep::LinkingRings rings = hexsweep::traceLinkingRings(
    source.points, topology.loops, linking.points, hexsweep::Quads(linking.faces), matchTolerance);
  hexsweep::matchTargetLoops(target.points, topology.loops, rings, linking.points, matchTolerance);
  cage.boundary = hexsweep::gatherSweepBoundary(
    source.points, target.points, topology.loops, rings, linking.points);
  hexsweep::checkRings(cage.boundary, topology.loops);
  cage.source = std::move(source.points);
  cage.target = std::move(target.points);
  cage.sourceCellIds = std::move(source.cellIds);
  return cage;
}

struct SweptMesh
{
  Index layers = 0;
  Points points;
  vtkSmartPointer<vtkIdTypeArray> connectivity;
  std::vector<HexQuality> qualities;

  Eigen::Map<const hexsweep::Hexes> hexes() const { return hexsweep::hexView(this->connectivity); }
};

bool isBad(const HexQuality& quality)
{
  return quality.validity == hexsweep::Validity::InvertedCorner ||
    quality.validity == hexsweep::Validity::InvertedInside ||
    quality.validity == hexsweep::Validity::Degenerate;
}

std::string describeProblem(const SweptMesh& mesh, const hexsweep::HexQualitySummary& summary,
  const hexsweep::SweepInterior& interior)
{
  std::string text = std::to_string(summary.inverted) + " of " + std::to_string(summary.hexes) +
    " hexahedra are inverted";
  if (summary.degenerate > 0)
  {
    text +=
      " and " + std::to_string(summary.degenerate) + " are degenerate (an edge has no length)";
  }
  text += ". The first:";
  const auto hexes = mesh.hexes();
  Index named = 0;
  for (Index h = 0; h < hexes.rows() && named < NumberOfNamedCells; ++h)
  {
    const HexQuality& quality = mesh.qualities[static_cast<std::size_t>(h)];
    if (isBad(quality))
    {
      Eigen::RowVector3d center = Eigen::RowVector3d::Zero();
      for (int c = 0; c < 8; ++c)
      {
        center += 0.125 * mesh.points.row(hexes(h, c));
      }
      text += "\n  cell " + std::to_string(h) + " at " + hexsweep::describe(center) +
        ", scaled Jacobian " + hexsweep::describe(quality.scaledJacobian);
      ++named;
    }
  }
  text += "\nThreshold the cell array Validity (1, 2 and 4) to see all of them.";
  const std::vector<Index>& conflicts = interior.fixed.conflicts;
  if (!conflicts.empty())
  {
    text += " " + std::to_string(conflicts.size()) +
      " of them have a corner between a cap and a linking side that is inverted whatever the "
      "interior does (the first is cell " +
      std::to_string(conflicts.front()) + "): correct the target quads or the linking sides there.";
  }
  return text +
    " Check the target quads and the linking sides first (folded quads make inverted hexahedra); "
    "refine the quads, use more layers where the section changes quickly, or let EnsureValid and "
    "the method Automatic do what they can.";
}

// What the cascade did, step by step, and what no interior could have done.
void addStepReport(vtkFieldData* fieldData, const hexsweep::SweepInterior& interior,
  const hexsweep::InteriorOptions& options)
{
  if (!options.ensureValid && options.polishingRounds == 0)
  {
    return;
  }
  std::vector<std::string> names;
  std::vector<double> notCertified;
  std::vector<double> mended;
  for (const hexsweep::InteriorStep& step : interior.steps)
  {
    names.push_back(step.name);
    notCertified.push_back(static_cast<double>(step.notCertified));
    mended.push_back(static_cast<double>(step.mended));
  }
  hexsweep::addReport(fieldData, "SweepReportSteps", names);
  hexsweep::addReport(fieldData, "SweepReportStepNotCertified", notCertified);
  hexsweep::addReport(fieldData, "SweepReportStepMended", mended);
  hexsweep::addReport(fieldData, "SweepReportFloorScaledJacobian", interior.fixed.floor);
  hexsweep::addReport(
    fieldData, "SweepReportCornerConflicts", static_cast<Index>(interior.fixed.conflicts.size()));
}

void addPointArrays(vtkDataSet* source, const SweptMesh& mesh, vtkUnstructuredGrid* output)
{
  std::vector<Index> ids(static_cast<std::size_t>(source->GetNumberOfPoints()));
  std::iota(ids.begin(), ids.end(), Index{ 0 });
  vtkPointData* pointData = output->GetPointData();
  hexsweep::carryAttributes(source->GetPointData(), ids, mesh.layers + 1, pointData);
  pointData->AddArray(hexsweep::newRepeatedIds("SourcePointIds", ids, mesh.layers + 1));
  pointData->AddArray(hexsweep::newLayerNumbers(source->GetNumberOfPoints(), mesh.layers + 1));
}

void addCellArrays(vtkDataSet* source, const std::vector<Index>& sourceCellIds,
  const SweptMesh& mesh, vtkUnstructuredGrid* output)
{
  vtkCellData* cellData = output->GetCellData();
  hexsweep::carryAttributes(source->GetCellData(), sourceCellIds, mesh.layers, cellData);
  cellData->AddArray(hexsweep::newRepeatedIds("SourceCellIds", sourceCellIds, mesh.layers));
  cellData->AddArray(
    hexsweep::newLayerNumbers(static_cast<Index>(sourceCellIds.size()), mesh.layers));
  hexsweep::QualityArrays arrays(mesh.hexes().rows());
  constexpr Index hexesAPiece = Index{ 1 } << 17;
  hexsweep::forPieces(
    hexsweep::smpFor(), mesh.hexes().rows(), hexesAPiece, [&](Index begin, Index end) {
      for (Index h = begin; h < end; ++h)
      {
        arrays.set(h, mesh.qualities[static_cast<std::size_t>(h)]);
      }
    });
  arrays.addTo(cellData);
  cellData->SetActiveScalars("ScaledJacobian");
}
}

vtkCageHexInterior::vtkCageHexInterior()
{
  this->SetNumberOfInputPorts(3);
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
    StageClock clock;
    const std::vector<hexsweep::InteriorStart> starts = hexsweep::interiorStarts(this->Method);
    const Cage cage = readCage(sourceData, targetData, linkingData, this->MatchTolerance);
    clock.finish("Read");

    hexsweep::InteriorOptions options;
    options.ensureValid = this->EnsureValid;
    options.polishingRounds =
      this->EnsureValid && this->ImproveQuality && this->Method == AUTOMATIC ? PolishingRounds : 0;
    options.parallelFor = hexsweep::smpFor();
    hexsweep::SweepInterior interior =
      hexsweep::sweepInterior(cage, starts, options, hexsweep::pipelineProgress(this, 0.05, 0.9));
    clock.finish(interior.steps);
    SweptMesh mesh;
    mesh.points = std::move(interior.points);
    if (this->OutputPointsPrecision == SINGLE_PRECISION)
    {
      // Judged as stored.
      mesh.points = mesh.points.cast<float>().cast<double>().eval();
    }

    const hexsweep::Progress rest = hexsweep::pipelineProgress(this, 0.9, 1.0);
    hexsweep::reportProgress(rest, 0.0);
    mesh.layers = cage.boundary.numberOfLayers();
    mesh.connectivity = hexsweep::newSweptConnectivity(cage.quads, cage.source.rows(), mesh.layers,
      hexsweep::sourceIsBottom(cage.quads, mesh.points, mesh.layers, hexsweep::smpFor()));
    mesh.qualities =
      hexsweep::hexQualities(mesh.points, mesh.hexes(), this->Certify, hexsweep::smpFor());
    const hexsweep::HexQualitySummary summary = hexsweep::summarize(mesh.qualities);
    clock.finish("Quality");
    hexsweep::reportProgress(rest, 0.5);
    if (summary.inverted + summary.degenerate > 0)
    {
      const std::string problem = describeProblem(mesh, summary, interior);
      if (this->FailIfInvalid)
      {
        throw hexsweep::InvalidInput(problem);
      }
      vtkWarningMacro(<< problem);
    }
    if (this->Certify && summary.undecided > 0)
    {
      vtkWarningMacro(<< summary.undecided << " of " << summary.hexes
                      << " hexahedra are undecided: their Jacobian comes too near to zero to be "
                         "told from it. Threshold the cell array Validity (3) to see them, and "
                         "treat them as inverted.");
    }

    vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
    output->SetPoints(hexsweep::newSweptPoints(mesh.points, this->OutputPointsPrecision));
    hexsweep::setSweptCells(output, mesh.connectivity);
    addPointArrays(sourceData, mesh, output);
    addCellArrays(sourceData, cage.sourceCellIds, mesh, output);

    vtkFieldData* fieldData = output->GetFieldData();
    fieldData->PassData(targetData->GetFieldData());
    fieldData->PassData(sourceData->GetFieldData());
    hexsweep::addQualityReport(fieldData, summary);
    hexsweep::addReport(fieldData, "SweepReportMethod", interior.method);
    addStepReport(fieldData, interior, options);
    clock.finish("Output");
    clock.report(fieldData);
  };
  return hexsweep::runFilter(this, outputs, body);
}

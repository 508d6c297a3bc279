// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLinkingSideMesher.h"

#include "Core/Common/Constants.h"
#include "Core/Linking/LinkingSides.h"
#include "Core/Solids/SweepSize.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "HexSweepArrays.h"
#include "HexSweepAsking.h"
#include "HexSweepChoices.h"
#include "HexSweepInteriorReport.h"
#include "HexSweepLayers.h"
#include "HexSweepLinkingReport.h"
#include "HexSweepReader.h"
#include "HexSweepRun.h"
#include "HexSweepSolidReader.h"
#include "HexSweepWriter.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <string>
#include <utility>

vtkStandardNewMacro(vtkLinkingSideMesher);

namespace
{
using namespace hexsweep;

/// The sides as they were read.
LinkingSurface givenSurface(SolidInput input)
{
  return { { std::move(input.points), std::move(input.triangles) }, std::move(input.faceIds),
    std::move(input.quads), std::move(input.quadOfTriangle) };
}
}

//------------------------------------------------------------------------------
vtkLinkingSideMesher::vtkLinkingSideMesher()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
int vtkLinkingSideMesher::FillInputPortInformation(int, vtkInformation* info)
{
  acceptSurfaces(info);
  return 1;
}

//------------------------------------------------------------------------------
int vtkLinkingSideMesher::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(this, outputs, [&] { this->Execute(inputs, outputs); });
}

//------------------------------------------------------------------------------
void vtkLinkingSideMesher::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (isIdleRank(outputs, inputs, { "source quads", "linking surface", "target surface" }))
  {
    return;
  }
  checkPrecision(this->OutputPointsPrecision);
  checkFeatureAngle(this->FeatureAngle);
  const LayerRequest layers = requestedLayers(this);
  StageClock clock;
  const QuadInput given = readQuads(inputDataSet(inputs, 0), "source quads");
  const QuadMesh& quads = given.mesh;
  const SurfaceTopology topology = checkSurface(quads.quads, quads.points.rows(), "source quads");
  checkCap(topology, "source quads");
  const LinkingSurface surface =
    joinLinkingSurface(givenSurface(readSolid(inputDataSet(inputs, 1), chosenArray(this)).surface),
      this->MatchTolerance, this->FeatureAngle * Pi / 180.0);
  clock.finish("Read");
  const std::vector<SideTube> sides = splitLinkingSides(surface, quads.points, topology.loops);
  checkSweepBudget(static_cast<double>(quads.quads.rows()), sideLength(sides), layers.size, layers);
  const LinkingMesh linking = meshLinkingSides(quads.points, topology.loops, sides, layers,
    this->MatchTolerance, pipelineProgress(this, 0.1, 0.95), askingFor(pipelineProgress(this)));

  clock.finish("Linking sides");
  auto* output = vtkUnstructuredGrid::GetData(outputs);
  output->SetPoints(
    vtkSmartPointer<vtkPoints>::Take(newPoints(linking.rings.points, this->OutputPointsPrecision)));
  setCells(output, linking.quads, VTK_QUAD);
  addIds(output->GetPointData(), arrays::SourcePointIds, linking.sourcePoint);
  addIds(output->GetPointData(), arrays::SweepLayer, linking.nodeRing);
  addIds(output->GetCellData(), arrays::SweepLayer, linking.quadLayer);
  addIds(output->GetCellData(), arrays::LoopId,
    loopsOfQuads(topology.loops, linking.rings.numberOfLayers()));
  std::vector<Index> faceIds;
  for (std::size_t q = 0; q < linking.quadSide.size(); ++q)
  {
    faceIds.push_back(sides[static_cast<std::size_t>(linking.quadSide[q])]
                        .faceIds[static_cast<std::size_t>(linking.quadTriangle[q])]);
  }
  addIds(output->GetCellData(), arrays::BoundaryId, faceIds);
  output->GetFieldData()->PassData(inputDataSet(inputs, 1)->GetFieldData());
  addLinkingReport(output->GetFieldData(), linking);
  addReport(output->GetFieldData(), reports::IgnoredCells, given.ignoredCells);
  clock.finish("Output");
  addStageReport(output->GetFieldData(), clock);

  std::vector<std::string> warnings = linkingWarnings(linking);
  if (vtkDataSet* target = inputDataSet(inputs, 2))
  {
    warnings.push_back(
      describeMissedTarget(linking.rings.points, topology.loops, linking.rings.numberOfLayers(),
        readTriangles(target, "target surface").mesh, this->MatchTolerance));
  }
  for (const std::string& warning : warnings)
  {
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
}

//------------------------------------------------------------------------------
void vtkLinkingSideMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}

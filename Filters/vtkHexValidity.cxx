// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexValidity.h"

#include "Core/HexQuality.h"
#include "HexSweepBridge.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkSMPThreadLocalObject.h>
#include <vtkSMPTools.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkHexValidity);

namespace
{
using hexsweep::HexQuality;
using hexsweep::Validity;

constexpr vtkIdType NumberOfNamedCells = 10;
// Between two of these portions progress is shown and an abort is heard.
constexpr vtkIdType CellsPerPortion = 1 << 18;

// Corners of a voxel in the order of a hexahedron.
constexpr int VoxelCorners[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };

bool isJudged(int cellType)
{
  return cellType == VTK_HEXAHEDRON || cellType == VTK_VOXEL;
}

hexsweep::HexCorners cornersOf(vtkDataSet* data, vtkIdType cell, int type, vtkIdList* ids)
{
  data->GetCellPoints(cell, ids);
  hexsweep::HexCorners corners;
  for (int i = 0; i < 8; ++i)
  {
    const int corner = type == VTK_VOXEL ? VoxelCorners[i] : i;
    data->GetPoint(ids->GetId(corner), corners.row(i).data());
  }
  return corners;
}

class JudgeCells
{
public:
  JudgeCells(vtkDataSet* data, std::vector<HexQuality>& qualities)
    : Data(data)
    , Qualities(qualities)
  {
  }

  void operator()(vtkIdType begin, vtkIdType end)
  {
    vtkIdList* ids = this->Ids.Local();
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      HexQuality& quality = this->Qualities[static_cast<std::size_t>(cell)];
      const int type = this->Data->GetCellType(cell);
      if (isJudged(type))
      {
        quality = hexsweep::hexQuality(cornersOf(this->Data, cell, type, ids));
      }
      else
      {
        quality.scaledJacobian = std::numeric_limits<double>::quiet_NaN();
        quality.validity = Validity::NotJudged;
      }
    }
  }

private:
  vtkDataSet* Data;
  std::vector<HexQuality>& Qualities;
  vtkSMPThreadLocalObject<vtkIdList> Ids;
};

std::vector<HexQuality> judge(vtkDataSet* data, const hexsweep::Progress& progress)
{
  const vtkIdType cells = data->GetNumberOfCells();
  std::vector<HexQuality> qualities(static_cast<std::size_t>(cells));
  // The first call from one thread builds what the data set needs for calls from several.
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(0, ids);
  JudgeCells judgeCells(data, qualities);
  for (vtkIdType begin = 0; begin < cells; begin += CellsPerPortion)
  {
    const vtkIdType end = std::min(cells, begin + CellsPerPortion);
    vtkSMPTools::For(begin, end, judgeCells);
    hexsweep::reportProgress(progress, static_cast<double>(end) / static_cast<double>(cells));
  }
  return qualities;
}

// Cells that another rank owns, or that are switched off, are not this mesh's to report.
bool isOwned(vtkUnsignedCharArray* ghosts, vtkIdType cell)
{
  constexpr int NotOurs = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  return !ghosts || (ghosts->GetValue(cell) & NotOurs) == 0;
}

bool isBad(Validity validity)
{
  return validity == Validity::InvertedCorner || validity == Validity::InvertedInside ||
    validity == Validity::Degenerate;
}

std::string describeCell(vtkDataSet* data, vtkIdType cell, const HexQuality& quality)
{
  vtkNew<vtkIdList> ids;
  const Eigen::RowVector3d center =
    cornersOf(data, cell, data->GetCellType(cell), ids).colwise().mean();
  std::ostringstream text;
  text << "\n  cell " << cell << " at (" << center[0] << ", " << center[1] << ", " << center[2]
       << "), ";
  if (quality.validity == Validity::Degenerate)
  {
    text << "degenerate";
  }
  else
  {
    text << "scaled Jacobian " << quality.scaledJacobian;
  }
  return text.str();
}

std::string describeBadCells(
  vtkDataSet* data, const std::vector<HexQuality>& qualities, vtkUnsignedCharArray* ghosts)
{
  std::string text;
  vtkIdType named = 0;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells() && named < NumberOfNamedCells; ++cell)
  {
    const HexQuality& quality = qualities[static_cast<std::size_t>(cell)];
    if (isBad(quality.validity) && isOwned(ghosts, cell))
    {
      text += describeCell(data, cell, quality);
      ++named;
    }
  }
  return text;
}

std::string describeProblem(vtkDataSet* data, const std::vector<HexQuality>& qualities,
  const hexsweep::HexQualitySummary& summary, vtkUnsignedCharArray* ghosts)
{
  std::ostringstream text;
  if (summary.insideOut == summary.hexes)
  {
    text << "the mesh is inside out: all " << summary.hexes
         << " hexahedra have negative Jacobians at every corner, because their points are in "
            "left-handed order. Swap the first four points of each hexahedron with the last four.";
    return text.str();
  }
  text << summary.inverted << " of " << summary.hexes << " hexahedra are inverted";
  if (summary.degenerate > 0)
  {
    text << " and " << summary.degenerate
         << " are degenerate (an edge without length, or a coordinate that is not finite)";
  }
  text << ". The first:" << describeBadCells(data, qualities, ghosts)
       << "\nThreshold the cell array Validity (1, 2 and 4) to see all of them; move their points, "
          "or mesh that region anew.";
  return text.str();
}

void addArrays(vtkDataSet* output, const std::vector<HexQuality>& qualities)
{
  const vtkIdType cells = output->GetNumberOfCells();
  vtkNew<vtkDoubleArray> scaledJacobian;
  scaledJacobian->SetName("ScaledJacobian");
  scaledJacobian->SetNumberOfValues(cells);
  vtkNew<vtkUnsignedCharArray> validity;
  validity->SetName("Validity");
  validity->SetNumberOfValues(cells);
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const HexQuality& quality = qualities[static_cast<std::size_t>(cell)];
    scaledJacobian->SetValue(cell, quality.scaledJacobian);
    validity->SetValue(cell, static_cast<unsigned char>(quality.validity));
  }
  output->GetCellData()->AddArray(scaledJacobian);
  output->GetCellData()->AddArray(validity);
}

void addReports(vtkFieldData* fieldData, const hexsweep::HexQualitySummary& summary)
{
  hexsweep::addReport(fieldData, "SweepReportHexes", summary.hexes);
  hexsweep::addReport(fieldData, "SweepReportInverted", summary.inverted);
  hexsweep::addReport(fieldData, "SweepReportDegenerate", summary.degenerate);
  hexsweep::addReport(fieldData, "SweepReportNotCertified", summary.notCertified);
  hexsweep::addReport(fieldData, "SweepReportMinScaledJacobian", summary.minScaledJacobian);
  hexsweep::addReport(fieldData, "SweepReportMeanScaledJacobian", summary.meanScaledJacobian);
}
}

void vtkHexValidity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FailIfInvalid: " << (this->FailIfInvalid ? "On" : "Off") << "\n";
}

int vtkHexValidity::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return hexsweep::runFilter(this, outputs, [&]() {
    vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
    vtkDataSet* output = vtkDataSet::GetData(outputs);
    // Unlike a cap, a mesh of hexahedra may well be spread over the ranks: each judges its own.
    const int piece = outputs->GetInformationObject(0)->Get(
      vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
    if (!input || input->GetNumberOfCells() == 0)
    {
      if (piece > 0)
      {
        return;
      }
      throw hexsweep::InvalidInput("the input is empty (no cells). Connect a mesh of hexahedra.");
    }
    const std::vector<HexQuality> qualities = judge(input, hexsweep::pipelineProgress(this));

    vtkUnsignedCharArray* ghosts = input->GetCellGhostArray();
    hexsweep::HexQualitySummary summary;
    for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
    {
      if (isOwned(ghosts, cell))
      {
        summary.add(qualities[static_cast<std::size_t>(cell)]);
      }
    }
    if (summary.hexes == 0)
    {
      vtkWarningMacro("the input has no hexahedra: nothing was judged.");
    }
    if (summary.inverted + summary.degenerate > 0)
    {
      const std::string problem = describeProblem(input, qualities, summary, ghosts);
      if (this->FailIfInvalid)
      {
        throw hexsweep::InvalidInput(problem);
      }
      vtkWarningMacro(<< problem);
    }
    output->ShallowCopy(input);
    addArrays(output, qualities);
    addReports(output->GetFieldData(), summary);
  });
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSweepQuadProjector.h"

#include "Core/CapQuads/SweepProjection.h"
#include "Core/Common/Describe.h"
#include "Core/Linking/LoopMatching.h"
#include "HexSweepBridge.h"
#include "HexSweepCapDiskGrid.h"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSweepQuadProjector);

namespace
{
using namespace hexsweep;

constexpr std::size_t QuadsToName = 10;

/// The source quads' cells and data on new points, with their quality.
void writeQuads(const SweepProjection& projection, const SurfaceInput& quads, vtkDataSet* source,
  int precision, vtkUnstructuredGrid* output)
{
  output->SetPoints(
    vtkSmartPointer<vtkPoints>::Take(newPoints(projection.quads.points, precision)));
  setCells(output, quads.faces, VTK_QUAD);
  output->GetPointData()->PassData(source->GetPointData());
  vtkCellData* cellData = output->GetCellData();
  cellData->CopyAllocate(source->GetCellData(), quads.faces.rows());
  vtkNew<vtkDoubleArray> jacobian;
  jacobian->SetName("ScaledJacobian");
  jacobian->SetNumberOfValues(quads.faces.rows());
  for (Index q = 0; q < quads.faces.rows(); ++q)
  {
    cellData->CopyData(source->GetCellData(), quads.cellIds[static_cast<std::size_t>(q)], q);
    jacobian->SetValue(q, projection.quality.scaledJacobian[q]);
  }
  cellData->AddArray(jacobian);
}

/// Methods by their number in MethodType.
constexpr std::pair<ProjectionMethod, const char*> Methods[] = {
  { ProjectionMethod::Harmonic, "Harmonic" },
  { ProjectionMethod::PaperHarmonic, "PaperHarmonic" },
  { ProjectionMethod::AffineLeastSquares, "AffineLeastSquares" },
};

void writeReport(const SweepProjection& projection, const char* method, vtkFieldData* field)
{
  addReport(field, "SweepReportMethod", std::string(method));
  addReport(field, "SweepReportInvertedQuads", projection.quality.inverted);
  addReport(field, "SweepReportInvertedBefore", projection.invertedBefore);
  addReport(field, "SweepReportRounds", static_cast<Index>(projection.rounds));
  addReport(field, "SweepReportMinScaledJacobian", projection.quality.minimum);
  addReport(field, "SweepReportMeanScaledJacobian", projection.quality.mean);
  addReport(field, "SweepReportFloorScaledJacobian", projection.fixedCorners.floor);
  addReport(field, "SweepReportFixedInvertedQuads",
    static_cast<Index>(projection.fixedCorners.inverted.size()));
  addReport(field, "SweepReportMaximumSourceDistance", projection.quads.maximumSourceDistance);
  addReport(field, "SweepReportOutside", projection.quads.outside);
  if (projection.source)
  {
    addReport(field, "SweepReportFlipsBefore",
      projection.source->flipsBefore + projection.target->flipsBefore);
    addReport(
      field, "SweepReportMaximumBoundaryDistance", projection.target->maximumBoundaryDistance);
    addReport(field, "SweepReportFlipsAfter",
      static_cast<Index>(projection.source->flipped.size() + projection.target->flipped.size()));
  }
  if (projection.nitsche)
  {
    addReport(field, "SweepReportNitscheRatio", projection.nitsche->ratio());
  }
  if (!projection.startFractions.empty())
  {
    addReport(field, "SweepReportLoopStarts", projection.startFractions);
  }
}

/// What to tell the user about a map that the Nitsche bound forbids; empty if it does not.
std::string describeNitsche(const SweepProjection& projection)
{
  if (!projection.nitsche || projection.nitsche->ratio() > 1.0)
  {
    return {};
  }
  const NitscheCondition& nitsche = *projection.nitsche;
  const double degrees = 45.0 / std::atan(1.0) * nitsche.turn;
  return "the Nitsche bound is violated: the hole's conformal radius r is " +
    describe(nitsche.sourceRadius) + " on the source cap and " + describe(nitsche.targetRadius) +
    " on the target cap, and it turns by " + describe(degrees) +
    " degrees; PaperHarmonic is one-to-one only if it is below 2 r cos(turn) / (1 + r^2) = " +
    describe(nitsche.greatestTargetRadius()) + " on the target cap. " +
    std::to_string(projection.source->flipped.size()) +
    " triangles of the source surface are flipped. Set Method to Harmonic, which has no such "
    "bound.";
}

/// The first few of some cells with places: " cell 3 at (0, 1, 0), cell 7 at ..."
std::string listCells(const std::vector<std::pair<Index, Eigen::RowVector3d>>& cells)
{
  std::string text;
  for (std::size_t i = 0; i < cells.size() && i < QuadsToName; ++i)
  {
    text += (i > 0 ? ", cell " : " cell ") + std::to_string(cells[i].first) + " at " +
      describe(cells[i].second);
  }
  return text + (cells.size() > QuadsToName ? ", ..." : "");
}

/// What to tell the user about inverted quads; empty if there are none.
std::string describeInverted(const SweepProjection& projection, const QuadsRef& quads)
{
  if (projection.quality.inverted == 0)
  {
    return {};
  }
  std::vector<std::pair<Index, Eigen::RowVector3d>> atCorners;
  std::vector<bool> isAtCorner(static_cast<std::size_t>(quads.rows()), false);
  for (const FixedCorner& corner : projection.fixedCorners.inverted)
  {
    isAtCorner[static_cast<std::size_t>(corner.quad)] = true;
    atCorners.emplace_back(
      corner.quad, projection.quads.points.row(quads(corner.quad, corner.corner)));
  }
  std::vector<std::pair<Index, Eigen::RowVector3d>> others;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    if (!isAtCorner[static_cast<std::size_t>(q)] && !(projection.quality.scaledJacobian[q] > 0.0))
    {
      Eigen::RowVector3d center = Eigen::RowVector3d::Zero();
      for (Index c = 0; c < 4; ++c)
      {
        center += 0.25 * projection.quads.points.row(quads(q, c));
      }
      others.emplace_back(q, center);
    }
  }
  std::string text = std::to_string(projection.quality.inverted) + " of " +
    std::to_string(quads.rows()) +
    " quads are inverted on the target cap; hexes on them will be inverted too.";
  if (!atCorners.empty())
  {
    text += " " + std::to_string(atCorners.size()) +
      " of them have their corner between two fixed boundary edges that meet at 180 degrees or "
      "more, which no place of the inner nodes cures:" +
      listCells(atCorners) +
      ". Move the boundary nodes (the ends of the linking sides) there, so that a corner of the "
      "quads meets a corner of the target cap, or change the source quads so that two or more "
      "meet at that node.";
  }
  if (!others.empty())
  {
    text += (atCorners.empty() ? " These are:" : " The others:") + listCells(others) +
      ". Refine the source quads there.";
  }
  return text;
}
}

//------------------------------------------------------------------------------
vtkSweepQuadProjector::vtkSweepQuadProjector()
{
  this->SetNumberOfInputPorts(4);
  this->SetNumberOfOutputPorts(3);
}

//------------------------------------------------------------------------------
int vtkSweepQuadProjector::FillInputPortInformation(int port, vtkInformation* info)
{
  acceptSurfaces(info);
  info->Set(INPUT_IS_OPTIONAL(), port < 2 ? 0 : 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSweepQuadProjector::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(this, outputs, [&] { this->Execute(inputs, outputs); });
}

//------------------------------------------------------------------------------
void vtkSweepQuadProjector::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* source = inputDataSet(inputs, 0);
  vtkDataSet* target = inputDataSet(inputs, 1);
  vtkDataSet* sourceSurface = inputDataSet(inputs, 3);
  if (isIdleRank(
        outputs, inputs, { "source quads", "target surface", "linking sides", "source surface" }))
  {
    return;
  }
  if (this->Method < HARMONIC || this->Method > AFFINE_LEAST_SQUARES)
  {
    throw InvalidInput("Method " + std::to_string(this->Method) +
      " does not exist. Choose Harmonic (0), PaperHarmonic (1) or AffineLeastSquares (2).");
  }
  const auto& [method, methodName] = Methods[this->Method];
  const SurfaceInput quads = readQuads(source, "source quads");
  const SurfaceInput triangles = readTriangles(target, "target surface");
  SurfaceInput sourceTriangles;

  SweepProjectionInput input;
  input.source = { quads.points, quads.faces };
  input.target = { triangles.points, triangles.faces };
  input.linking = readOptionalQuads(inputDataSet(inputs, 2), "linking sides");
  input.method = method;
  input.matchTolerance = this->MatchTolerance;
  input.singlePrecision = this->OutputPointsPrecision == SINGLE_PRECISION;
  input.ensureValid = this->EnsureValid;
  input.improveQuality = this->ImproveQuality;
  if (sourceSurface)
  {
    sourceTriangles = readTriangles(sourceSurface, "source surface");
    input.sourceSurface = TriangleMesh{ sourceTriangles.points, sourceTriangles.faces };
  }
  else
  {
    sourceTriangles.ignoredCells = quads.ignoredCells;
    sourceTriangles.cellIds.reserve(quads.cellIds.size() * 2);
    for (const Index id : quads.cellIds)
    {
      sourceTriangles.cellIds.insert(sourceTriangles.cellIds.end(), 2, id);
    }
  }
  if (this->DiskMaps == FROM_INPUT && method != ProjectionMethod::AffineLeastSquares)
  {
    if (!sourceSurface)
    {
      throw InvalidInput("DiskMaps is FromInput, but the source surface is missing. Connect the "
                         "source cap with its disk map to SourceSurface.");
    }
    input.sourceDisk = readCapDisk(sourceSurface, "source surface");
    input.targetDisk = readCapDisk(target, "target surface");
  }

  if (this->DiskMaps != FROM_INPUT && input.method != ProjectionMethod::AffineLeastSquares)
  {
    checkAreas(triangles, "target surface");
    if (sourceSurface)
    {
      checkAreas(sourceTriangles, "source surface");
    }
    else
    {
      sourceTriangles.points = quads.points;
      sourceTriangles.faces = halveQuads(quads.points, quads.faces);
      checkAreas(sourceTriangles, "source quads");
    }
  }

  const SweepProjection projection = projectSweep(input, pipelineProgress(this, 0.1, 0.9));

  auto* output = vtkUnstructuredGrid::GetData(outputs, 0);
  writeQuads(projection, quads, source, this->OutputPointsPrecision, output);
  output->GetFieldData()->PassData(source->GetFieldData());
  writeReport(projection, methodName, output->GetFieldData());
  addReport(output->GetFieldData(), "SweepReportIgnoredCells", quads.ignoredCells);
  if (projection.source)
  {
    writeCapDisk(*projection.source, sourceTriangles, sourceSurface ? sourceSurface : source,
      this->OutputPointsPrecision, false, vtkUnstructuredGrid::GetData(outputs, 1));
    writeCapDisk(*projection.target, triangles, target, this->OutputPointsPrecision, false,
      vtkUnstructuredGrid::GetData(outputs, 2));
    for (const auto& [cap, name] : { std::make_pair(&*projection.source, "source surface"),
           std::make_pair(&*projection.target, "target surface") })
    {
      const std::string flips = describeFlips(*cap, name);
      if (!flips.empty())
      {
        vtkWarningMacro(<< flips);
      }
    }
  }
  for (const std::string& warning :
    { describeNitsche(projection), describeDoubts(projection.doubts),
      describeMismatch(projection.sourceMismatch, "source surface", "boundary of the source quads"),
      describeMismatch(
        projection.targetMismatch, "target surface", "last ring of the linking sides") })
  {
    if (!warning.empty())
    {
      vtkWarningMacro(<< warning);
    }
  }
  const std::string inverted = describeInverted(projection, input.source.quads);
  if (!inverted.empty())
  {
    vtkWarningMacro(<< inverted);
  }
}

//------------------------------------------------------------------------------
void vtkSweepQuadProjector::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "DiskMaps: " << this->DiskMaps << "\n";
  os << indent << "EnsureValid: " << this->EnsureValid << "\n";
  os << indent << "ImproveQuality: " << this->ImproveQuality << "\n";
  os << indent << "MatchTolerance: " << this->MatchTolerance << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}

// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepInteriorReport.h"

#include "Core/Describe.h"
#include "HexSweepBridge.h"

namespace hexsweep
{
void StageClock::report(vtkFieldData* fieldData) const
{
  addReport(fieldData, "SweepReportStages", this->Names);
  addReport(fieldData, "SweepReportSeconds", this->Seconds);
}

void addStepReport(
  vtkFieldData* fieldData, const SweepInterior& interior, const InteriorOptions& options)
{
  if (!options.ensureValid && options.polishingRounds == 0)
  {
    return;
  }
  std::vector<std::string> names;
  std::vector<double> notCertified;
  std::vector<double> mended;
  for (const InteriorStep& step : interior.steps)
  {
    names.push_back(step.name);
    notCertified.push_back(static_cast<double>(step.notCertified));
    mended.push_back(static_cast<double>(step.mended));
  }
  addReport(fieldData, "SweepReportSteps", names);
  addReport(fieldData, "SweepReportStepNotCertified", notCertified);
  addReport(fieldData, "SweepReportStepMended", mended);
  addReport(fieldData, "SweepReportFloorScaledJacobian", interior.fixed.floor);
  addReport(
    fieldData, "SweepReportCornerConflicts", static_cast<Index>(interior.fixed.conflicts.size()));
}

namespace
{
constexpr Index NumberOfNamedCells = 10;

bool isBad(const HexQuality& quality)
{
  return quality.validity == Validity::InvertedCorner ||
    quality.validity == Validity::InvertedInside || quality.validity == Validity::Degenerate;
}

}

std::string describeInverted(const PointsRef& points, const HexesRef& hexes,
  const std::vector<HexQuality>& qualities, const FixedCorners& fixed)
{
  const HexQualitySummary summary = summarize(qualities);
  std::string text = std::to_string(summary.inverted) + " of " + std::to_string(summary.hexes) +
    " hexahedra are inverted";
  if (summary.degenerate > 0)
  {
    text +=
      " and " + std::to_string(summary.degenerate) + " are degenerate (an edge has no length)";
  }
  text += ". The first:";
  Index named = 0;
  for (Index h = 0; h < hexes.rows() && named < NumberOfNamedCells; ++h)
  {
    const HexQuality& quality = qualities[static_cast<std::size_t>(h)];
    if (isBad(quality))
    {
      Eigen::RowVector3d center = Eigen::RowVector3d::Zero();
      for (int c = 0; c < 8; ++c)
      {
        center += 0.125 * points.row(hexes(h, c));
      }
      text += "\n  cell " + std::to_string(h) + " at " + describe(center) + ", scaled Jacobian " +
        describe(quality.scaledJacobian);
      ++named;
    }
  }
  text += "\nThreshold the cell array Validity (1, 2 and 4) to see all of them.";
  const std::vector<Index>& conflicts = fixed.conflicts;
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
}

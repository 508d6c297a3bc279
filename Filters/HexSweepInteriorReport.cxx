// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepInteriorReport.h"

#include "Core/Common/Describe.h"
#include "HexSweepArrays.h"
#include "HexSweepWriter.h"

namespace hexsweep
{
std::vector<Stage> stagesOf(const std::vector<InteriorStep>& steps)
{
  std::vector<Stage> stages;
  for (const InteriorStep& step : steps)
  {
    stages.push_back({ step.name, step.seconds });
  }
  return stages;
}

void addStageReport(vtkFieldData* fieldData, const StageClock& clock)
{
  std::vector<std::string> names;
  std::vector<double> seconds;
  for (const Stage& stage : clock.stages())
  {
    names.push_back(stage.name);
    seconds.push_back(stage.seconds);
  }
  addReport(fieldData, reports::Stages, names);
  addReport(fieldData, reports::Seconds, seconds);
}

std::vector<std::string> interiorReports()
{
  return { reports::Steps, reports::StepNotCertified, reports::StepMended,
    reports::FloorScaledJacobian, reports::CornerConflicts };
}

void addStepReport(
  vtkFieldData* fieldData, const SweepInterior& interior, const InteriorOptions& options)
{
  if (!options.ensureValid && options.polishingRounds == 0)
  {
    return;
  }
  std::vector<std::string> names;
  std::vector<Index> notCertified;
  std::vector<Index> mended;
  for (const InteriorStep& step : interior.steps)
  {
    names.push_back(step.name);
    notCertified.push_back(step.notCertified);
    mended.push_back(step.mended);
  }
  addReport(fieldData, reports::Steps, names);
  addIds(fieldData, reports::StepNotCertified, notCertified);
  addIds(fieldData, reports::StepMended, mended);
  addReport(fieldData, reports::FloorScaledJacobian, interior.fixed.floor);
  addReport(
    fieldData, reports::CornerConflicts, static_cast<Index>(interior.fixed.conflicts.size()));
}

namespace
{
enum Place
{
  SourceQuads,
  TargetQuads,
  LinkingSides
};

struct ConflictText
{
  ConflictCause cause;
  Place place;
  const char* text;
};

// What is wrong, and how to mend it.
constexpr ConflictText ConflictTexts[] = {
  { ConflictCause::Corner, SourceQuads,
    "a corner between the source quads and a linking side is turned over: correct the source "
    "quads or the linking side" },
  { ConflictCause::Corner, TargetQuads,
    "a corner between the target quads and a linking side is turned over: correct the target "
    "quads or the linking side" },
  { ConflictCause::Corner, LinkingSides,
    "a corner between two linking sides is turned over: mesh these linking sides anew" },
  { ConflictCause::Fold, SourceQuads,
    "the source quads fold, those round a point do not face one side: correct the source quads" },
  { ConflictCause::Fold, TargetQuads,
    "the target quads fold, those round a point do not face one side: correct the target quads" },
  { ConflictCause::Fold, LinkingSides,
    "a linking side folds, its columns run back or its rings cross: mesh this linking side anew" },
  { ConflictCause::Edge, SourceQuads,
    "points of the source quads or of the columns from them coincide: move them apart" },
  { ConflictCause::Edge, TargetQuads,
    "points of the target quads or of the columns to them coincide: move them apart" },
  { ConflictCause::Edge, LinkingSides,
    "points of a linking side coincide, in a ring or along a column: move them apart" },
  { ConflictCause::Inside, SourceQuads,
    "all eight points are on the boundary, which is too crooked between them: use more layers" },
};

Place placeOf(const Conflict& conflict, Index pointsPerLayer, Index points)
{
  if (conflict.cause == ConflictCause::Inside || conflict.node < pointsPerLayer)
  {
    return SourceQuads;
  }
  return conflict.node >= points - pointsPerLayer ? TargetQuads : LinkingSides;
}

std::string describeConflicts(
  const PointsRef& points, Index pointsPerLayer, const FixedCorners& fixed)
{
  std::string text;
  for (const ConflictText& kind : ConflictTexts)
  {
    Index count = 0;
    const Conflict* first = nullptr;
    for (const Conflict& conflict : fixed.conflicts)
    {
      if (conflict.cause == kind.cause &&
        placeOf(conflict, pointsPerLayer, points.rows()) == kind.place)
      {
        first = first ? first : &conflict;
        ++count;
      }
    }
    if (first)
    {
      text += "\n  " + std::to_string(count) + ", the first cell " + std::to_string(first->hex) +
        " at " + describe(points.row(first->node)) + ": " + kind.text + ".";
    }
  }
  return text;
}
}

std::string interiorAdvice(const PointsRef& points, Index pointsPerLayer, Index bad,
  const FixedCorners& fixed, const InteriorSettings& settings)
{
  std::string text;
  if (settings.lostByRounding > 0)
  {
    text = "single precision is too coarse for " + std::to_string(settings.lostByRounding) +
      " of them: set OutputPointsPrecision to double, or move the mesh nearer to the origin.";
    if (settings.lostByRounding >= bad)
    {
      return text;
    }
    text += "\nBesides, ";
  }
  const Index conflicts = static_cast<Index>(fixed.conflicts.size());
  if (conflicts > 0)
  {
    text += "caps and linking sides alone make " + std::to_string(conflicts) +
      " hexahedra bad, whatever the interior does:" +
      describeConflicts(points, pointsPerLayer, fixed);
    if (conflicts >= bad)
    {
      return text;
    }
    text += "\nFor the others ";
  }
  if (!settings.ensureValid)
  {
    return text + "switch EnsureValid on, which untangles them where that is possible.";
  }
  if (!settings.automatic)
  {
    return text + "use the method Automatic, which tries several methods.";
  }
  return text +
    "check the target quads and the linking sides first (folded quads make inverted hexahedra), "
    "then refine the quads, or use more layers where the section changes quickly.";
}
}

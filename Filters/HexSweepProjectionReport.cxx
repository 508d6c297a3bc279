// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepProjectionReport.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Describe.h"
#include "Core/Linking/LoopMatching.h"
#include "HexSweepArrays.h"
#include "HexSweepCapDiskGrid.h"
#include "HexSweepWriter.h"

#include <utility>

namespace hexsweep
{
namespace
{
constexpr std::size_t QuadsToName = 10;

/// What to tell the user about a map that the Nitsche bound forbids; empty if it does not.
std::string describeNitsche(const SweepProjection& projection)
{
  if (!projection.nitsche || projection.nitsche->ratio() > 1.0)
  {
    return {};
  }
  const NitscheCondition& nitsche = *projection.nitsche;
  const double degrees = 180.0 / Pi * nitsche.turn;
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

/// What to tell the user about quads that do not wind as the sides do; empty if all do.
std::string describeMissedHoles(const SweepProjection& projection)
{
  if (projection.missedHoles.empty())
  {
    return {};
  }
  std::string text = "loops turn by up to " + describe(180.0 / Pi * projection.winding) +
    " degrees about each other along the linking sides, and the quads are too coarse to be drawn "
    "along: on the target cap they lead to";
  for (std::size_t i = 0; i < projection.missedHoles.size() && i < QuadsToName; ++i)
  {
    const MissedHole& hole = projection.missedHoles[i];
    text += std::string(i > 0 ? "," : "") + " the hole at " + describe(hole.place) + " by " +
      std::to_string(hole.turns) + " whole turn(s) too many or too few";
  }
  return text + (projection.missedHoles.size() > QuadsToName ? ", ..." : "") +
    ". Hexes there will be inverted. Refine the source quads round the holes, or cut the volume "
    "into shorter sweeps.";
}
}

void addProjectionReport(
  vtkFieldData* field, const SweepProjection& projection, const std::string& method)
{
  addReport(field, reports::Method, method);
  if (projection.target)
  {
    addReport(field, reports::Weights, std::string(nameOf(projection.target->weights)));
  }
  addReport(field, reports::InvertedQuads, projection.quality.inverted);
  addReport(field, reports::InvertedBefore, projection.invertedBefore);
  addReport(field, reports::Rounds, static_cast<Index>(projection.rounds));
  addReport(field, reports::MinScaledJacobian, projection.quality.minimum);
  addReport(field, reports::MeanScaledJacobian, projection.quality.mean);
  addReport(field, reports::FloorScaledJacobian, projection.fixedCorners.floor);
  addReport(field, reports::FixedInvertedQuads,
    static_cast<Index>(projection.fixedCorners.inverted.size()));
  addReport(field, reports::MaximumSourceDistance, projection.quads.maximumSourceDistance);
  addReport(field, reports::Outside, projection.quads.outside);
  if (projection.source)
  {
    addReport(
      field, reports::FlipsBefore, projection.source->flipsBefore + projection.target->flipsBefore);
    addReport(field, reports::MaximumBoundaryDistance, projection.target->maximumBoundaryDistance);
    addReport(field, reports::FlipsAfter,
      static_cast<Index>(projection.source->flipped.size() + projection.target->flipped.size()));
  }
  if (projection.carried)
  {
    addReport(field, reports::Winding, 180.0 / Pi * projection.winding);
  }
  if (projection.nitsche)
  {
    addReport(field, reports::NitscheRatio, projection.nitsche->ratio());
  }
  if (!projection.startFractions.empty())
  {
    addReport(field, reports::LoopStarts, projection.startFractions);
  }
}

std::vector<std::string> projectionWarnings(
  const SweepProjection& projection, const QuadsRef& quads)
{
  std::vector<std::string> warnings;
  if (projection.source)
  {
    warnings.push_back(describeFlips(*projection.source, "source surface"));
    warnings.push_back(describeFlips(*projection.target, "target surface"));
  }
  warnings.push_back(describeNitsche(projection));
  warnings.push_back(describeDoubts(projection.doubts));
  warnings.push_back(
    describeMismatch(projection.sourceMismatch, "source surface", "boundary of the source quads"));
  warnings.push_back(describeMismatch(
    projection.targetMismatch, "target surface", "last ring of the linking sides"));
  warnings.push_back(describeMissedHoles(projection));
  warnings.push_back(describeInverted(projection, quads));
  return warnings;
}
}

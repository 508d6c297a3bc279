// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepHexText.h"

#include "Core/Common/Describe.h"

#include <algorithm>
#include <initializer_list>

namespace hexsweep
{
namespace
{
constexpr Index NumberOfNamedCells = 10;

/// Where the first of those with one of these verdicts are.
std::string listFirst(const JudgedHexes& hexes, std::initializer_list<Validity> verdicts)
{
  std::string text = " The first:";
  Index named = 0;
  for (Index h = 0; h < hexes.count && named < NumberOfNamedCells; ++h)
  {
    const HexQuality quality = hexes.quality(h);
    if (std::find(verdicts.begin(), verdicts.end(), quality.validity) == verdicts.end())
    {
      continue;
    }
    const Eigen::RowVector3d center = hexes.corners(h).colwise().mean();
    text += "\n  cell " + std::to_string(h) + " at " + describe(center) + ", ";
    text += quality.validity == Validity::Degenerate
      ? "degenerate"
      : "scaled Jacobian " + describe(quality.scaledJacobian);
    text += quality.validity == Validity::InvertedInside ? ", inverted between its corners" : "";
    ++named;
  }
  return text;
}
}

std::string describeInverted(const JudgedHexes& hexes, const std::string& advice)
{
  const HexQualitySummary& summary = hexes.summary;
  if (summary.insideOut == summary.hexes)
  {
    return "the mesh is inside out: all " + std::to_string(summary.hexes) +
      " hexahedra have negative Jacobians at every corner, because their points are in "
      "left-handed order. Swap the first four points of each hexahedron with the last four.";
  }
  std::string text = std::to_string(summary.inverted) + " of " + std::to_string(summary.hexes) +
    " hexahedra are inverted";
  if (summary.degenerate > 0)
  {
    text += " and " + std::to_string(summary.degenerate) +
      " are degenerate (an edge without length, flat but for rounding, or a coordinate that is "
      "not finite)";
  }
  return text + "." +
    listFirst(hexes, { Validity::InvertedCorner, Validity::InvertedInside, Validity::Degenerate }) +
    "\nThreshold the cell array Validity (1, 2 and 4) to see all of them; " + advice;
}

std::string describeUndecided(const JudgedHexes& hexes, const std::string& advice)
{
  return std::to_string(hexes.summary.undecided) + " of " + std::to_string(hexes.summary.hexes) +
    " hexahedra are undecided: their Jacobian comes too near to zero to be told from it." +
    listFirst(hexes, { Validity::Undecided }) +
    "\nThreshold the cell array Validity (3) to see all of them, and treat them as inverted: " +
    advice;
}
}

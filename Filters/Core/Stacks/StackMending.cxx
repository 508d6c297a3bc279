// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/StackMending.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/FixedCorners.h"
#include "Core/Hexahedra/HexMinimum.h"
#include "Core/Hexahedra/HexUntangling.h"
#include "Core/Hexahedra/LowHexes.h"

#include <algorithm>
#include <utility>

namespace hexsweep
{
namespace
{
/// Scaled Jacobian up to which low ones are raised.
constexpr double StackEnough = 0.4;

/// What hexahedra are to look like: boxes with the mean lengths of their edges.
HexBoxes meanBoxes(const PointsRef& points, const HexesRef& hexes)
{
  constexpr int Edges[3][4][2] = { { { 0, 1 }, { 3, 2 }, { 4, 5 }, { 7, 6 } },
    { { 0, 3 }, { 1, 2 }, { 4, 7 }, { 5, 6 } }, { { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } } };
  HexBoxes boxes(hexes.rows(), 3);
  for (Index h = 0; h < hexes.rows(); ++h)
  {
    for (Index axis = 0; axis < 3; ++axis)
    {
      double length = 0.0;
      for (const auto& edge : Edges[axis])
      {
        length += 0.25 * (points.row(hexes(h, edge[0])) - points.row(hexes(h, edge[1]))).norm();
      }
      boxes(h, axis) = length;
    }
  }
  return boxes;
}

HexQualitySummary judge(MendedStack& stack, const HexesRef& hexes,
  const StackMendingOptions& options, const Progress& progress)
{
  stack.qualities = hexQualities(stack.points, hexes, true, options.parallelFor, progress);
  return summarize(stack.qualities);
}
}

MendedStack mendStack(Points points, const HexesRef& hexes, const std::vector<bool>& fixed,
  const StackMendingOptions& options, const Progress& progress)
{
  MendedStack stack;
  stack.points = std::move(points);
  HexQualitySummary summary = judge(stack, hexes, options, progressPart(progress, 0.0, 0.1));
  if (options.ensureValid && summary.notCertified > 0)
  {
    UntangledHexes untangled = untangleHexes(stack.points, hexes, meanBoxes(stack.points, hexes),
      fixed, options.parallelFor, progressPart(progress, 0.1, 0.4));
    stack.points = std::move(untangled.points);
    stack.method += " + untangling";
    summary = judge(stack, hexes, options, progressPart(progress, 0.4, 0.45));
  }
  if (!options.improveQuality || summary.minScaledJacobian >= StackEnough)
  {
    return stack;
  }
  const double wanted =
    std::min(StackEnough, fixedCorners(stack.points, hexes, fixed, options.parallelFor).floor);
  if (summary.minScaledJacobian < wanted)
  {
    stack.points = raiseMinimum(stack.points, hexes, fixed, wanted, Certificates::Stay,
      options.parallelFor, progressPart(progress, 0.45, 0.7))
                     .points;
    stack.points = raiseLowHexes(
      stack.points, hexes, fixed, wanted, options.parallelFor, progressPart(progress, 0.7, 0.95))
                     .points;
    stack.method += " + raised minimum";
    judge(stack, hexes, options, progressPart(progress, 0.95, 1.0));
  }
  return stack;
}
}

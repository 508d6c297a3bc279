// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/CapCrossings.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Surfaces/SurfaceCrossings.h"
#include "Core/Surfaces/SurfaceFolds.h"
#include "Core/Surfaces/SurfacePart.h"

namespace hexsweep
{
void checkCapCrossings(
  const SolidSurface& solid, const std::vector<Index>& triangles, const std::string& name)
{
  const SurfacePart part = surfacePart(solid.points, solid.triangles, triangles);
  const auto cell = [&](Index row) {
    return describeCell(solid, triangles[static_cast<std::size_t>(row)]);
  };
  const std::optional<SurfaceCrossing> crossing = findCrossing(part.mesh);
  if (crossing)
  {
    throw InvalidInput("the " + name + " crosses itself at " + describe(crossing->place) + ": " +
      cell(crossing->first) + " and " + cell(crossing->second) +
      " go through each other or lie upon each other. Repair this face, or the holes that cross "
      "there, and tessellate the solid again.");
  }
  if (const std::optional<SurfaceFold> fold = findFold(part.mesh))
  {
    throw InvalidInput("the " + name + " is folded at " + describe(fold->place) + ": " +
      cell(fold->turnedOver) + " is turned over and lies nearly upon " + cell(fold->upright) +
      " beside it. Repair this face, and tessellate the solid again.");
  }
}
}

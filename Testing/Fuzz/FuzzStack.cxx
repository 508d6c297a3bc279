// SPDX-License-Identifier: BSD-3-Clause
// Solids with several caps: directions, the plane, columns.
#include "FuzzInput.h"

#include "Core/Solids/CanonicalSolid.h"
#include "Core/Stacks/RevolvedSpace.h"
#include "Core/Stacks/StackSweep.h"
#include "Support/SolidShapes.h"

namespace
{
using namespace hexsweep;

/// Columns of cubes of different heights.
SolidInput solidFrom(fuzz::Input& input)
{
  const test::Cell size = { static_cast<int>(input.count(2, 3)),
    static_cast<int>(input.count(2, 3)), 3 };
  std::vector<Index> low;
  std::vector<Index> high;
  for (int i = 0; i < size[0] * size[1]; ++i)
  {
    low.push_back(input.whole(0, 1));
    high.push_back(input.whole(1, 3));
  }
  SolidInput solid = test::cubes(size, [&](int i, int j, int k) {
    const auto column = static_cast<std::size_t>(j * size[0] + i);
    return (column == 0 && k == 0) || (k >= low[column] && k < high[column]);
  });
  fuzz::damage(input, solid.points, solid.triangles);
  solid.faceIds.resize(static_cast<std::size_t>(solid.triangles.rows()), 1);
  return solid;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input input(data, size);
  const SolidInput solid = solidFrom(input);
  fuzz::expectOrderly([&] {
    checkSolidInput(solid);
    SolidOptions options;
    options.partTouching = true;
    const SolidSurface surface = makeSolidSurface(canonicalSolid(solid).input, options);
    const double draft = 0.3 * input.share();
    StackOptions stack;
    const double extent = fuzz::extentOf(solid.points);
    stack.size = input.rarely(16) ? input.special() : (0.3 + 0.3 * input.share()) * extent;
    stack.layers = input.count(2, 4) - 1;
    // Slits between curves that do not become one take small quads, and many.
    stack.imprintTolerance = input.rarely(8) ? 0.3 * input.share() : 0.3 + 0.2 * input.share();
    for (const CapLikeFaces& faces : stackDirections(surface, draft))
    {
      if (faces.isStack() && !fuzz::isLaborious(stack.size, extent))
      {
        fuzz::expectOrderly([&] { sweepStack(surface, faces, stack, fuzz::patience()); });
        break;
      }
    }
    findRevolvedStack(surface, draft);
  });
  return 0;
}

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
  constexpr int Across = 3;
  int low[Across * Across];
  int high[Across * Across];
  for (int i = 0; i < Across * Across; ++i)
  {
    low[i] = static_cast<int>(input.whole(0, 1));
    high[i] = static_cast<int>(input.whole(1, 3));
  }
  SolidInput solid = test::cubes({ Across, Across, 3 }, [&](int i, int j, int k) {
    return (i == 0 && j == 0 && k == 0) || (k >= low[j * Across + i] && k < high[j * Across + i]);
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
    stack.size = input.whole(0, 7) == 0 ? input.special() : 0.7 + input.share();
    stack.layers = input.whole(0, 3);
    stack.imprintTolerance = 0.5 * input.share();
    for (const CapLikeFaces& faces : stackDirections(surface, draft))
    {
      if (faces.isStack() && !(stack.size < 0.3))
      {
        fuzz::expectOrderly([&] { sweepStack(surface, faces, stack); });
        break;
      }
    }
    findRevolvedStack(surface, draft);
  });
  return 0;
}

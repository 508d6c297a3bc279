// SPDX-License-Identifier: BSD-3-Clause
// Hexahedra by themselves: judged, untangled, polished.
#include "FuzzInput.h"

#include "Core/Hexahedra/HexPolishing.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Hexahedra/HexUntangling.h"
#include "Support/HexBlocks.h"

#include <random>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace hexsweep;
  fuzz::Input input(data, size);
  test::HexBlock block = test::makeBlock(input.count(2, 3));
  const HexBoxes boxes = HexBoxes::Ones(block.hexes.rows(), 3);
  if (input.whole(0, 1) == 0)
  {
    fuzz::damage(input, block.points, block.hexes);
    block.fixed.resize(static_cast<std::size_t>(block.points.rows()), false);
  }
  else
  {
    fuzz::damagePoints(input, block.points);
  }
  fuzz::expectOrderly([&] { hexQualities(block.points, block.hexes); });
  if (block.hexes.rows() != boxes.rows())
  {
    return 0;
  }
  fuzz::expectOrderly([&] {
    const UntangledHexes untangled =
      untangleHexes(block.points, block.hexes, boxes, block.fixed, {}, fuzz::patience());
    polishHexes(untangled.points, block.hexes, block.fixed, 2, {}, fuzz::patience());
  });
  return 0;
}

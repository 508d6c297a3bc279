// SPDX-License-Identifier: BSD-3-Clause
// Verdicts on single hexahedra, held against exact numbers.
#include "FuzzInput.h"

#include "Core/Hexahedra/HexQuality.h"
#include "Support/ExactHexes.h"
#include "Support/HexSamples.h"

#include <cstdlib>

namespace
{
hexsweep::HexCorners hexFrom(fuzz::Input& input)
{
  hexsweep::HexCorners corners = test::unitCube();
  const fuzz::Index kind = input.whole(0, 3);
  for (Eigen::Index i = 0; i < corners.size(); ++i)
  {
    double& value = corners.data()[i];
    value = kind == 0 ? input.bits()
      : kind == 1     ? static_cast<double>(input.whole(-4, 4))
      : kind == 2     ? value + 1.5 * (input.share() - 0.5)
                      : value;
  }
  for (fuzz::Index count = input.whole(0, 4); count > 0; --count)
  {
    corners(input.whole(0, 7), input.whole(0, 2)) = input.special();
  }
  return corners;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using hexsweep::Validity;
  fuzz::Input input(data, size);
  const hexsweep::HexCorners corners = hexFrom(input);
  const Validity alone = hexsweep::certifyHex(corners).validity;
  const hexsweep::HexQuality quality = hexsweep::hexQualities(corners, true).front();
  if (!corners.allFinite())
  {
    if (alone != Validity::Degenerate || quality.validity != Validity::Degenerate)
    {
      std::abort();
    }
    return 0;
  }
  const auto isGood = [](Validity v) { return v == Validity::Certified; };
  const auto isBad = [](Validity v) {
    return v == Validity::InvertedCorner || v == Validity::InvertedInside;
  };
  const bool good = isGood(alone) || isGood(quality.validity);
  const bool bad = isBad(alone) || isBad(quality.validity);
  if (!good && !bad)
  {
    return 0; // whatever is true
  }
  const test::Truth truth = test::truthEverywhere(corners, 300);
  if ((good && truth == test::Truth::NotPositive) || (bad && truth == test::Truth::Positive))
  {
    std::abort();
  }
  return 0;
}

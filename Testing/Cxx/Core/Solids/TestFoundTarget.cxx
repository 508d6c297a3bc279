// SPDX-License-Identifier: BSD-3-Clause
// Targets that nobody named, at the end of sweeps that turn back more or less.
#include "Core/Solids/FoundTarget.h"

#include "Support/CapMeshes.h"

namespace TestFoundTarget
{
/// Up a cylinder of radius 10 to height 1, in over the rim, and down inside by `depth`.
hexsweep::SweepBoundary cup(double depth)
{
  constexpr hexsweep::Index Around = 32;
  constexpr int Layers = 60;
  hexsweep::SweepBoundary boundary;
  boundary.outerSize = Around;
  for (int k = 0; k <= Layers; ++k)
  {
    const double t = static_cast<double>(k) / Layers;
    const double radius = t < 0.6 ? 10.0 : 3.0;
    hexsweep::Points ring(Around, 3);
    for (hexsweep::Index j = 0; j < Around; ++j)
    {
      const double angle = 2.0 * test::Pi * static_cast<double>(j) / Around;
      ring.row(j) << radius * std::cos(angle), radius * std::sin(angle),
        t < 0.6 ? t / 0.6 : 1.0 - depth * (t - 0.6) / 0.4;
    }
    boundary.rings.push_back(ring);
  }
  return boundary;
}

TEST(FoundTarget, UpToAQuarterBack)
{
  EXPECT_NO_THROW(hexsweep::checkFoundTarget(cup(0.0), { 7 }));
  EXPECT_NO_THROW(hexsweep::checkFoundTarget(cup(0.2), { 7 }));
  test::expectInvalid(
    [] { hexsweep::checkFoundTarget(cup(0.3), { 7 }); }, "face 7 fits the source cap best");
  test::expectInvalid([] { hexsweep::checkFoundTarget(cup(0.9), { 7 }); }, "Name the target faces");
}
}

// SPDX-License-Identifier: BSD-3-Clause
// Caps: checked, mapped to the disk, meshed with quads.
#include "FuzzInput.h"

#include "Core/CapQuads/CapMeshing.h"
#include "Core/DiskMaps/CanonicalDiskMap.h"
#include "Core/Geometry/CoordinateRange.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "Support/CapMeshes.h"

namespace
{
using namespace hexsweep;

TriangleMesh capFrom(fuzz::Input& input)
{
  const std::vector<test::Block> holes = { { 1, 1, 1, 1 }, { 3, 2, 1, 1 } };
  const auto count = static_cast<std::ptrdiff_t>(input.whole(0, 2));
  TriangleMesh cap = input.whole(0, 2) == 0
    ? test::disk(input.whole(1, 3), input.whole(3, 9))
    : test::plate(5, { holes.begin(), holes.begin() + count }, 0.3 * input.share());
  fuzz::damage(input, cap.points, cap.triangles);
  return cap;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input input(data, size);
  TriangleMesh cap = capFrom(input);
  fuzz::expectOrderly([&] {
    checkCoordinates(cap.points, cap.triangles, "cap");
    cap.triangles = orientFaces(cap.triangles, "cap");
    const auto treatment = static_cast<HoleTreatment>(input.whole(0, 2));
    const auto weights = static_cast<Weights>(input.whole(0, 1));
    const auto improvement = static_cast<TriangulationImprovement>(input.whole(0, 2));
    fuzz::expectOrderly([&] {
      canonicalDiskMap(cap, treatment, weights, improvement, { 1e-8, 10 });
    });
    CapQuadOptions options;
    options.size = input.whole(0, 15) == 0 ? input.special() : 0.2 + 0.8 * input.share();
    options.chordTolerance = input.whole(0, 3) == 0 ? 0.1 : 0.0;
    if (options.size > 0.1)
    {
      meshCapWithQuads(cap, {}, options);
    }
  });
  return 0;
}

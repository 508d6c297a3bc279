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

/// A plate with two holes of a cell at most, or a disk.
TriangleMesh capFrom(fuzz::Input& input)
{
  if (input.whole(0, 2) == 0)
  {
    return test::disk(input.count(1, 3), input.whole(3, 9));
  }
  const std::vector<test::Block> holes = { { 1, 1, 1, 1 }, { 3, 2, 1, 1 } };
  const auto count = static_cast<std::ptrdiff_t>(input.count(2, 3)) - 1;
  const int cells = count == 2 ? 5 : 3;
  return test::plate(cells, { holes.begin(), holes.begin() + count }, 0.3 * input.share());
}

CapQuadOptions optionsFrom(fuzz::Input& input, double extent)
{
  CapQuadOptions options;
  options.size = input.rarely(16) ? input.special() : (0.3 + 0.4 * input.share()) * extent;
  options.chordTolerance = input.rarely(16) ? 0.1 : 0.0;
  return options;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input input(data, size);
  TriangleMesh cap = capFrom(input);
  fuzz::damage(input, cap.points, cap.triangles);
  fuzz::expectOrderly([&] {
    checkCoordinates(cap.points, cap.triangles, "cap");
    cap.triangles = orientFaces(cap.triangles, "cap");
    const auto treatment = static_cast<HoleTreatment>(input.whole(0, 2));
    const auto weights = static_cast<Weights>(input.whole(0, 1));
    const auto improvement = static_cast<TriangulationImprovement>(input.whole(0, 2));
    fuzz::expectOrderly([&] {
      canonicalDiskMap(cap, treatment, weights, improvement, { 1e-8, 10 }, fuzz::patience());
    });
    const double extent = fuzz::extentOf(cap.points);
    const CapQuadOptions options = optionsFrom(input, extent);
    if (!fuzz::isLaborious(options.size, extent))
    {
      meshCapWithQuads(cap, {}, options, fuzz::patience());
    }
  });
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// Triangles with face ids, as a reader hands them on: bodies, surface, candidates, quads, sides,
// cage, interior.
#include "FuzzInput.h"

#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/SweepInterior.h"
#include "Core/Solids/CanonicalSolid.h"
#include "Core/Solids/FaceQuads.h"
#include "Core/Solids/HinderingEdges.h"
#include "Core/Solids/SolidBodies.h"
#include "Core/Solids/SolidCage.h"
#include "Core/Solids/SourceQuads.h"
#include "Core/Solids/SweepChoice.h"
#include "Core/Solids/SweepForecast.h"
#include "Support/SolidShapes.h"

#include <bitset>

namespace
{
using namespace hexsweep;

/// Cubes of a grid, some left out, each plane of their surface one face or not.
SolidInput solidFrom(fuzz::Input& input)
{
  const test::Cell size = { static_cast<int>(input.count(2, 3)),
    static_cast<int>(input.count(1, 2)), static_cast<int>(input.count(2, 3)) };
  const std::bitset<18> left(
    static_cast<unsigned long long>(input.whole(0, 3) == 0 ? input.whole(0, 65535) : 0));
  const auto place = [&](int i, int j, int k) {
    return static_cast<std::size_t>((k * size[1] + j) * size[0] + i);
  };
  SolidInput solid = test::cubes(
    size, [&](int i, int j, int k) { return place(i, j, k) == 0 || !left[place(i, j, k)]; });
  if (input.whole(0, 4) == 0)
  {
    solid = test::soup(solid);
  }
  fuzz::damage(input, solid.points, solid.triangles);
  solid.faceIds.resize(static_cast<std::size_t>(solid.triangles.rows()), 1);
  for (fuzz::Index count = input.whole(0, 3); count > 0; --count)
  {
    solid.faceIds[static_cast<std::size_t>(
      input.whole(0, static_cast<Index>(solid.faceIds.size()) - 1))] = input.whole(-3, 9);
  }
  if (input.whole(0, 7) == 0)
  {
    solid.faceIds.clear();
  }
  return solid;
}

void sweepBody(const SolidInput& body, const SolidOptions& options, fuzz::Input& input)
{
  const CanonicalSolid canonical = canonicalSolid(body);
  const SolidSurface surface = makeSolidSurface(canonical.input, options);
  const SweepChoice choice = chooseSweeps(surface, {}, {});
  const SweepTopology& topology = choice.sweeps.front();
  forecastSweep(surface, topology);
  const double quadSize = (input.rarely(8) ? 0.2 : 0.4) * fuzz::extentOf(canonical.input.points);
  const SourceQuads quads =
    makeSourceQuads(canonical.input, surface, topology, quadSize, fuzz::patience());
  if (quads.mesh.quads.rows() > 100)
  {
    return; // large meshes tell no more, and take long
  }
  SolidCageInput cageInput{ surface, topology, quads.mesh,
    sidePatches(canonical.input, surface, topology), {} };
  cageInput.layers.layers = input.count(2, 4);
  cageInput.leastTriangles = input.rarely(32) ? cageInput.leastTriangles : 10.0;
  cageInput.imprinted = quads.imprinted;
  const SolidCage cage = makeUnhinderedCage(std::move(cageInput), {}, fuzz::patience());
  InteriorOptions interior;
  interior.keepQualities = true;
  sweepInterior(
    cage, interiorStarts(InteriorKind::Automatic, cage.isRuled), interior, fuzz::patience());
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input input(data, size);
  const SolidInput solid = solidFrom(input);
  fuzz::expectOrderly([&] {
    SolidOptions options;
    options.partTouching = input.whole(0, 1) == 1;
    checkSolidInput(solid);
    for (const SolidBody& body : solidBodies(solid, {}, options))
    {
      fuzz::expectOrderly([&] { sweepBody(body.input, options, input); });
    }
  });
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// Linking sides as triangles: joined, split into tubes, meshed with columns.
#include "FuzzInput.h"

#include "Core/Geometry/CoordinateRange.h"
#include "Core/Linking/LinkingSides.h"
#include "Core/Linking/LinkingSurface.h"
#include "Core/Surfaces/QuadHalving.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "Support/SweepMeshes.h"

#include <cmath>

namespace
{
using namespace hexsweep;

test::Sweep sweepFrom(fuzz::Input& input, double bend)
{
  const bool hole = input.rarely(4);
  const int cells = hole ? 3 : static_cast<int>(input.count(2, 3));
  const int layers = static_cast<int>(input.count(1, 3));
  return test::makeSweep(
    cells, cells, hole, test::evenLayers(layers), [=](double x, double y, double t) {
      return Eigen::RowVector3d(x * (1.0 + bend * t), y + bend * t * t, 2.0 * t);
    });
}

LayerRequest layersFrom(fuzz::Input& input)
{
  LayerRequest request;
  request.layers = input.whole(0, 5);
  request.size = input.whole(0, 3) == 0 ? input.special() : 0.0;
  request.growth = input.whole(0, 3) == 0 ? input.special() : 1.0;
  request.bothEnds = input.rarely(4);
  return request;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input input(data, size);
  const double bend = input.share();
  const test::Sweep sweep = sweepFrom(input, bend);
  LinkingSurface given;
  given.mesh = { sweep.linkingPoints, halveQuads(sweep.linkingPoints, sweep.linkingQuads) };
  fuzz::damage(input, given.mesh.points, given.mesh.triangles);
  for (Index t = 0; t < given.mesh.triangles.rows() && bend > 0.5; ++t)
  {
    given.faceIds.push_back(input.whole(0, 2));
  }
  const LayerRequest request = layersFrom(input);
  const double leastTriangles = input.rarely(32) ? SideTube().leastTriangles : 10.0;
  fuzz::expectOrderly([&] {
    checkCoordinates(given.mesh.points, given.mesh.triangles, "linking surface");
    const SurfaceTopology topology = checkSurface(sweep.quads, sweep.source.rows(), "source quads");
    const LinkingSurface surface = joinLinkingSurface(given, 1e-6, 0.5);
    std::vector<SideTube> sides = splitLinkingSides(surface, sweep.source, topology.loops);
    for (SideTube& side : sides)
    {
      side.leastTriangles = leastTriangles;
    }
    if (!fuzz::isLaborious(request.size, fuzz::extentOf(given.mesh.points)))
    {
      meshLinkingSides(sweep.source, topology.loops, sides, request, 1e-6, fuzz::patience());
    }
  });
  return 0;
}

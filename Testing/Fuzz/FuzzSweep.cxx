// SPDX-License-Identifier: BSD-3-Clause
// Quads, linking sides and a target that somebody else made: rings, projection, every interior
// method.
#include "FuzzInput.h"

#include "Core/CapQuads/SweepProjection.h"
#include "Core/Geometry/CoordinateRange.h"
#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/RingCollapse.h"
#include "Core/Interior/SweepInterior.h"
#include "Core/Interior/SweptHexes.h"
#include "Core/Linking/LinkingRings.h"
#include "Core/Surfaces/QuadHalving.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "Support/SweepMeshes.h"

namespace
{
using namespace hexsweep;

/// One of the meshes of a sweep is damaged.
test::Sweep sweepFrom(fuzz::Input& input)
{
  const bool hole = input.rarely(4);
  const int cells = hole ? 3 : static_cast<int>(input.count(2, 4));
  const double twist = 3.0 * input.share();
  const double bulge = input.share();
  const auto motion = [=](double x, double y, double t) {
    const double c = std::cos(twist * t);
    const double s = std::sin(twist * t);
    return Eigen::RowVector3d(c * x - s * y + t, s * x + c * y, 2.0 * t + bulge * t * x * y);
  };
  test::Sweep sweep = test::makeSweep(
    cells, cells, hole, test::evenLayers(static_cast<int>(input.count(2, 4))), motion);
  switch (input.whole(0, 3))
  {
    case 0:
      fuzz::damage(input, sweep.source, sweep.quads);
      break;
    case 1:
      fuzz::damagePoints(input, sweep.target);
      break;
    case 2:
      fuzz::damage(input, sweep.linkingPoints, sweep.linkingQuads);
      break;
    default:
      break;
  }
  return sweep;
}

void project(const test::Sweep& sweep, const std::optional<RingStack>& rings, fuzz::Input& input)
{
  SweepProjectionInput projection;
  projection.source = { sweep.source, sweep.quads };
  projection.target = { sweep.target, halveQuads(sweep.target, sweep.quads) };
  projection.linking = rings;
  projection.method = static_cast<ProjectionMethod>(input.whole(0, 2));
  projection.ensureValid = input.whole(0, 1) == 1;
  projection.improveQuality = input.whole(0, 1) == 1;
  projectSweep(projection, fuzz::patience());
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input input(data, size);
  const test::Sweep sweep = sweepFrom(input);
  fuzz::expectOrderly([&] {
    checkCoordinates(sweep.source, sweep.quads, "source quads");
    if (sweep.target.rows() < sweep.source.rows())
    {
      return;
    }
    checkCoordinates(sweep.target, sweep.quads, "target quads");
    const SurfaceTopology topology = checkSurface(sweep.quads, sweep.source.rows(), "source quads");
    checkCap(topology, "source quads");
    if (input.whole(0, 3) == 0) // loops are matched by shape: most of an input's time
    {
      project(sweep, std::nullopt, input);
      return;
    }
    const RingStack rings =
      traceLinkingRings(sweep.source, topology.loops, sweep.linkingPoints, sweep.linkingQuads);
    if (input.whole(0, 1) == 0)
    {
      project(sweep, rings, input);
      return;
    }
    matchTargetLoops(sweep.target, rings);
    SweepCage cage;
    cage.source = sweep.source;
    cage.target = sweep.target;
    cage.quads = sweep.quads;
    cage.boundary = gatherSweepBoundary(sweep.source, sweep.target, rings);
    checkRings(cage.boundary, topology.loops);
    InteriorOptions options;
    options.ensureValid = input.whole(0, 1) == 1;
    options.keepQualities = true;
    options.precision = input.whole(0, 1) == 1 ? Precision::Single : Precision::Double;
    const int lastMethod = static_cast<int>(interiorMethodNames().size()) - 1;
    sweepInterior(cage, interiorStarts(static_cast<InteriorKind>(input.whole(0, lastMethod))),
      options, fuzz::patience());
  });
  return 0;
}

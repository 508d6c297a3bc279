// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CarriedSource.h"

#include "Core/Common/Errors.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Linking/QuadWinding.h"
#include "Core/Linking/SectionMarch.h"
#include "Core/Surfaces/QuadHalving.h"

#include <utility>

namespace hexsweep
{
namespace
{
/// From the carried quads' boundary to the last ring.
RingStack lastStep(const Points& carried, const RingStack& rings)
{
  Index total = 0;
  for (const Loop& loop : rings.loops)
  {
    total += 2 * static_cast<Index>(loop.size());
  }
  Points points(total, 3);
  Index row = 0;
  for (std::size_t l = 0; l < rings.loops.size(); ++l)
  {
    const Index n = static_cast<Index>(rings.loops[l].size());
    points.middleRows(row, n) = loopPoints(carried, rings.loops[l]);
    points.middleRows(row + n, n) = ringPoints(rings, l, rings.numberOfLayers());
    row += 2 * n;
  }
  return stackRings(std::move(points), rings.loops, 1);
}

CapDisk flattened(const SectionFrame& frame, TriangleMesh mesh)
{
  CapDisk cap;
  cap.disk = frame.flatten(mesh.points);
  cap.mesh = std::move(mesh);
  cap.domain = DiskDomain::Disk;
  return cap;
}
}

std::optional<CarriedSource> carrySource(const QuadMesh& source, const RingStack& rings,
  const SweepSections& sections, const Progress& progress)
{
  try
  {
    const CarriedQuads carried = carryQuads(source.points, source.quads, sections, progress);
    CarriedSource result;
    result.quads.points = sections.frames.back().lift(
      carried.layers.back(), Eigen::VectorXd::Zero(source.points.rows()));
    result.quads.quads = source.quads;
    result.linking = lastStep(result.quads.points, rings);
    result.frame = sections.frames.back();
    return result;
  }
  catch (const SolverFailure&)
  {
    return std::nullopt;
  }
}

std::optional<PlaneDisks> planeDisks(const CarriedSource& source, const TriangleMesh& target)
{
  PlaneDisks disks;
  disks.source = flattened(
    source.frame, { source.quads.points, halveQuads(source.quads.points, source.quads.quads) });
  disks.target = flattened(source.frame, target);
  const DomainTriangles places =
    domainTriangles(DiskDomain::Disk, disks.target.disk, disks.target.mesh.triangles);
  if (places.flipped.size() == static_cast<std::size_t>(target.triangles.rows()))
  {
    disks.target.mesh.triangles.col(1).swap(disks.target.mesh.triangles.col(2));
  }
  else if (!places.flipped.empty())
  {
    return std::nullopt;
  }
  return disks;
}

std::vector<MissedHole> missedHoles(
  const QuadMesh& source, const Points& target, const SweepSections& sections)
{
  const std::vector<Index> turns = missedTurns(sections, source.quads,
    sections.frames.front().flatten(source.points), sections.frames.back().flatten(target));
  std::vector<MissedHole> missed;
  for (std::size_t l = 0; l < turns.size(); ++l)
  {
    if (turns[l] > 0)
    {
      const Index node = sections.nodes[static_cast<std::size_t>(sections.begins[l])];
      missed.push_back({ target.row(node), turns[l] });
    }
  }
  return missed;
}
}

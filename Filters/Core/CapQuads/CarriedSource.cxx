// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CarriedSource.h"

#include "Core/Common/Errors.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Linking/QuadWinding.h"
#include "Core/Linking/SectionMarch.h"
#include "Core/Surfaces/QuadHalving.h"

#include <algorithm>
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

namespace
{
/// Of the quads: where more are turned over in the plane of its rim, a cap bulges beyond it, and
/// turns cannot be read there.
constexpr double MostTurnedOver = 0.05;

bool foldsBack(const QuadsRef& quads, const PlanePoints& plane)
{
  Index upright = 0;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    const Eigen::RowVector2d d = plane.row(quads(q, 2)) - plane.row(quads(q, 0));
    const Eigen::RowVector2d e = plane.row(quads(q, 3)) - plane.row(quads(q, 1));
    upright += d.x() * e.y() > d.y() * e.x() ? 1 : 0;
  }
  return static_cast<double>(std::min(upright, quads.rows() - upright)) >
    MostTurnedOver * static_cast<double>(quads.rows());
}
}

std::vector<MissedHole> missedHoles(
  const QuadMesh& source, const Points& target, const SweepSections& sections)
{
  std::vector<MissedHole> missed;
  const PlanePoints begin = sections.frames.front().flatten(source.points);
  const PlanePoints end = sections.frames.back().flatten(target);
  if (foldsBack(source.quads, begin) || foldsBack(source.quads, end))
  {
    return missed;
  }
  const std::vector<Index> turns = missedTurns(sections, source.quads, begin, end);
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

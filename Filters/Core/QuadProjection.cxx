// SPDX-License-Identifier: BSD-3-Clause
#include "QuadProjection.h"

#include "AffineMap.h"
#include "Errors.h"
#include "TriangleSearch.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace hexsweep
{
namespace
{
constexpr Index NodesPerReport = 4096;

/// A point of the disk counts as outside all triangles beyond this distance; the disk's size is 1,
/// so this is rounding.
constexpr double OutsideDistance = 1e-9;

Eigen::RowVector3d pointOn(const TriangleMesh& mesh, Index triangle, const TrianglePoint& place)
{
  return place.coordinates[0] * mesh.points.row(mesh.triangles(triangle, 0)) +
    place.coordinates[1] * mesh.points.row(mesh.triangles(triangle, 1)) +
    place.coordinates[2] * mesh.points.row(mesh.triangles(triangle, 2));
}

/// Calls place(i) for each used node that is not fixed, in order, with progress.
template <typename Place>
void forEachInteriorNode(const std::vector<bool>& used, const std::vector<FixedNode>& boundary,
  const Progress& progress, const Place& place)
{
  std::vector<bool> open = used;
  for (const FixedNode& node : boundary)
  {
    open[static_cast<std::size_t>(node.point)] = false;
  }
  const Index n = static_cast<Index>(used.size());
  for (Index i = 0; i < n; ++i)
  {
    if (i % NodesPerReport == 0)
    {
      reportProgress(progress, static_cast<double>(i) / static_cast<double>(n));
    }
    if (open[static_cast<std::size_t>(i)])
    {
      place(i);
    }
  }
}

ProjectedQuads startFrom(const PointsRef& quadPoints, const std::vector<FixedNode>& boundary)
{
  ProjectedQuads result;
  result.points = quadPoints;
  for (const FixedNode& node : boundary)
  {
    result.points.row(node.point) = node.position;
  }
  return result;
}
}

ProjectedQuads projectThroughDisks(const PointsRef& quadPoints, const std::vector<bool>& used,
  const std::vector<FixedNode>& boundary, const CapDisk& source, const CapDisk& target,
  const Progress& progress)
{
  if (source.domain != target.domain)
  {
    throw InvalidInput("the two caps are mapped to different kinds of domain. Map each with the "
                       "other as its partner.");
  }
  ProjectedQuads result = startFrom(quadPoints, boundary);
  const TriangleSearch onSource(source.mesh.points, source.mesh.triangles);
  const DomainTriangles targetTriangles =
    domainTriangles(target.domain, target.disk, target.mesh.triangles);
  if (targetTriangles.triangle.empty())
  {
    throw InvalidInput("the disk map of the target surface has no triangle that is not flipped. "
                       "Use another map, or triangulate the cap again.");
  }
  const TriangleSearch inTarget(targetTriangles.corners);

  Index lastSource = -1;
  Index lastTarget = -1;
  forEachInteriorNode(used, boundary, progress, [&](Index i) {
    const TrianglePoint onCap = onSource.closest(quadPoints.row(i), lastSource);
    lastSource = onCap.triangle;
    result.maximumSourceDistance = std::max(result.maximumSourceDistance, onCap.distance);

    const Eigen::RowVector2d inDisk = wrapDomainPoint(source.domain,
      onCap.coordinates *
        domainCorners(source.domain, source.disk, source.mesh.triangles.row(onCap.triangle)));
    const TrianglePoint place = inTarget.closest({ inDisk.x(), inDisk.y(), 0.0 }, lastTarget);
    lastTarget = place.triangle;
    result.outside += place.distance > OutsideDistance ? 1 : 0;
    result.points.row(i) = pointOn(
      target.mesh, targetTriangles.triangle[static_cast<std::size_t>(place.triangle)], place);
  });
  return result;
}

ProjectedQuads projectAffinely(const PointsRef& quadPoints, const std::vector<bool>& used,
  const std::vector<FixedNode>& boundary, const Loop& outerLoop, const TriangleMesh& target,
  const Progress& progress)
{
  ProjectedQuads result = startFrom(quadPoints, boundary);
  Points from(static_cast<Index>(boundary.size()), 3);
  Points to(from.rows(), 3);
  for (std::size_t b = 0; b < boundary.size(); ++b)
  {
    from.row(static_cast<Index>(b)) = quadPoints.row(boundary[b].point);
    to.row(static_cast<Index>(b)) = boundary[b].position;
  }
  const AffineMap map = fitAffineMap(from, to, areaVector(loopPoints(quadPoints, outerLoop)),
    areaVector(loopPoints(result.points, outerLoop)));
  const Points mapped = map.apply(quadPoints);
  const TriangleSearch onTarget(target.points, target.triangles);
  Index last = -1;
  forEachInteriorNode(used, boundary, progress, [&](Index i) {
    const TrianglePoint place = onTarget.closest(mapped.row(i), last);
    last = place.triangle;
    // Down to the surface along its normal only: a node that the affine map puts into a hole or
    // beyond the outer loop stays there, as in the published method, instead of gathering on the
    // boundary.
    const auto corners = target.triangles.row(last);
    const Eigen::RowVector3d a = target.points.row(corners[0]);
    const Eigen::RowVector3d normal =
      (target.points.row(corners[1]) - a).cross(target.points.row(corners[2]) - a).normalized();
    result.points.row(i) = mapped.row(i) - (mapped.row(i) - a).dot(normal) * normal;
  });
  return result;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "QuadProjection.h"

#include "AffineMap.h"
#include "DomainTriangulation.h"
#include "Errors.h"
#include "TriangleSearch.h"
#include "TriangleWalk.h"

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

/// Finding the nodes on the source surface, of the work of both searches.
constexpr double SourceShare = 0.8;

Eigen::RowVector3d pointOn(
  const TriangleMesh& mesh, Index triangle, const Eigen::RowVector3d& coordinates)
{
  return coordinates[0] * mesh.points.row(mesh.triangles(triangle, 0)) +
    coordinates[1] * mesh.points.row(mesh.triangles(triangle, 1)) +
    coordinates[2] * mesh.points.row(mesh.triangles(triangle, 2));
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

Progress part(const Progress& progress, double from, double to)
{
  return [=](double fraction) { return !progress || progress(from + (to - from) * fraction); };
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
  const DomainTriangulation domain =
    domainTriangulation(target.domain, target.disk, target.mesh.triangles);
  TriangleWalk inTarget(domain.points, domain.triangles);
  if (inTarget.empty())
  {
    throw InvalidInput("the disk map of the target surface has no triangle that is not flipped. "
                       "Use another map, or triangulate the cap again.");
  }

  std::vector<Index> nodes;
  PlanePoints inDisk(quadPoints.rows(), 2);
  Index lastSource = -1;
  forEachInteriorNode(used, boundary, part(progress, 0.0, SourceShare), [&](Index i) {
    const TrianglePoint onCap = onSource.closest(quadPoints.row(i), lastSource);
    lastSource = onCap.triangle;
    result.maximumSourceDistance = std::max(result.maximumSourceDistance, onCap.distance);
    inDisk.row(static_cast<Index>(nodes.size())) = wrapDomainPoint(source.domain,
      onCap.coordinates *
        domainCorners(source.domain, source.disk, source.mesh.triangles.row(onCap.triangle)));
    nodes.push_back(i);
  });

  const LocatedPoints places = inTarget.locate(
    inDisk.topRows(static_cast<Index>(nodes.size())), part(progress, SourceShare, 1.0));
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    result.points.row(nodes[k]) =
      pointOn(target.mesh, domain.origin[static_cast<std::size_t>(places.triangles[k])],
        places.coordinates.row(static_cast<Index>(k)));
  }
  result.outside = std::count_if(places.outside.begin(), places.outside.end(),
    [](const OutsidePoint& point) { return point.distance > OutsideDistance; });
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

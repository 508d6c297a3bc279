// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/QuadProjection.h"

#include "Core/Common/Errors.h"
#include "Core/Common/StoppablePieces.h"
#include "Core/DiskMaps/DomainTriangulation.h"
#include "Core/Geometry/AffineMap.h"
#include "Core/Geometry/HilbertOrder.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Geometry/TriangleWalk.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace hexsweep
{
namespace
{
constexpr std::size_t NodesPerReport = 4096;
constexpr Index NodesPerPiece = 1024;

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

/// Used nodes that are not fixed, near ones one after the other: along Hilbert's curve in the plane
/// of the two longest sides of their box.
std::vector<Index> interiorNodes(
  const PointsRef& points, const std::vector<bool>& used, const std::vector<FixedNode>& boundary)
{
  std::vector<bool> open = used;
  for (const FixedNode& node : boundary)
  {
    open[static_cast<std::size_t>(node.point)] = false;
  }
  std::vector<Index> nodes;
  Eigen::AlignedBox3d box;
  for (Index i = 0; i < points.rows(); ++i)
  {
    if (open[static_cast<std::size_t>(i)])
    {
      nodes.push_back(i);
      box.extend(points.row(i).transpose());
    }
  }
  if (nodes.empty())
  {
    return nodes;
  }
  Index shortest = 0;
  box.sizes().minCoeff(&shortest);
  PlanePoints plane(static_cast<Index>(nodes.size()), 2);
  for (Index k = 0; k < plane.rows(); ++k)
  {
    const auto point = points.row(nodes[static_cast<std::size_t>(k)]);
    plane.row(k) << point[(shortest + 1) % 3], point[(shortest + 2) % 3];
  }
  std::vector<Index> ordered;
  ordered.reserve(nodes.size());
  for (const CurvePlace& place : hilbertOrder(HilbertCurve(plane), plane))
  {
    ordered.push_back(nodes[place.id]);
  }
  return ordered;
}

/// Calls place(k, nodes[k]) for each node, in order, with progress.
template <typename Place>
void forEachNode(const std::vector<Index>& nodes, const Progress& progress, const Place& place)
{
  for (std::size_t k = 0; k < nodes.size(); ++k)
  {
    if (k % NodesPerReport == 0)
    {
      reportProgress(progress, static_cast<double>(k) / static_cast<double>(nodes.size()));
    }
    place(static_cast<Index>(k), nodes[k]);
  }
}

/// The edges that one triangle has, and their ends.
class BoundaryEdges
{
public:
  explicit BoundaryEdges(const TriangleMesh& mesh)
    : Mesh(mesh)
    , Neighbors(triangleNeighbors(mesh.triangles))
    , IsOn(static_cast<std::size_t>(mesh.points.rows()), false)
  {
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      for (Index c = 0; c < 3; ++c)
      {
        if (this->Neighbors(t, c) < 0)
        {
          this->IsOn[static_cast<std::size_t>(mesh.triangles(t, c))] = true;
          this->IsOn[static_cast<std::size_t>(mesh.triangles(t, (c + 1) % 3))] = true;
        }
      }
    }
  }

  /// @param coordinates barycentric, 0 where the place is on an edge.
  bool contain(Index triangle, const Eigen::RowVector3d& coordinates) const
  {
    const Index zeros = (coordinates.array() == 0.0).count();
    for (Index c = 0; c < 3; ++c)
    {
      if (zeros == 2 && coordinates[c] != 0.0)
      {
        return this->IsOn[static_cast<std::size_t>(this->Mesh.triangles(triangle, c))];
      }
      if (zeros == 1 && coordinates[c] == 0.0)
      {
        return this->Neighbors(triangle, (c + 1) % 3) < 0; // the edge against the corner
      }
    }
    return false;
  }

private:
  const TriangleMesh& Mesh;
  Triangles Neighbors;
  std::vector<bool> IsOn;
};

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
  const Progress& progress, const ParallelFor& parallelFor)
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

  const std::vector<Index> nodes = interiorNodes(quadPoints, used, boundary);
  PlanePoints inDisk(static_cast<Index>(nodes.size()), 2);
  Eigen::VectorXd distances(inDisk.rows());
  forStoppablePieces(parallelFor, progressPart(progress, 0.0, SourceShare), inDisk.rows(),
    NodesPerPiece, [&](Index begin, Index end) {
      Index last = -1; // what is near is found faster, and is the same
      for (Index k = begin; k < end; ++k)
      {
        const TrianglePoint onCap =
          onSource.closest(quadPoints.row(nodes[static_cast<std::size_t>(k)]), last);
        last = onCap.triangle;
        distances[k] = onCap.distance;
        inDisk.row(k) = wrapDomainPoint(source.domain,
          onCap.coordinates *
            domainCorners(source.domain, source.disk, source.mesh.triangles.row(onCap.triangle)));
      }
    });
  for (Index k = 0; k < distances.size(); ++k)
  {
    result.maximumSourceDistance = std::max(result.maximumSourceDistance, distances[k]);
  }

  const LocatedPoints places = inTarget.locate(inDisk, progressPart(progress, SourceShare, 1.0));
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
  const BoundaryEdges boundaryEdges(target);
  Index last = -1;
  forEachNode(interiorNodes(mapped, used, boundary), progress, [&](Index, Index i) {
    const TrianglePoint place = onTarget.closest(mapped.row(i), last);
    last = place.triangle;
    // Nearest at an edge inside the surface: the triangle's plane is off the surface beyond it.
    if ((place.coordinates.array() == 0.0).any() && !boundaryEdges.contain(last, place.coordinates))
    {
      result.points.row(i) = pointOn(target, last, place.coordinates);
      return;
    }
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

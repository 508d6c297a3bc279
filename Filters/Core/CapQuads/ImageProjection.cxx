// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/ImageProjection.h"

#include "Core/Geometry/SurfaceSearch.h"
#include "Core/Surfaces/UsedPoints.h"

namespace hexsweep
{
namespace
{
/// Of the target's size: distance from its triangles that is rounding.
constexpr double Rounding = 1e-12;
}

SweepProjection projectToImage(const QuadMesh& source, const AffineMap& map,
  const std::vector<FixedNode>& boundary, const std::vector<FixedNode>& borders,
  const TriangleMesh& target, bool singlePrecision, const ParallelFor& parallelFor)
{
  SweepProjection result;
  Points& points = result.quads.points;
  points = source.points;
  const std::vector<bool> used = usedPoints(source.quads, points.rows());
  const Points image = map.apply(source.points);
  const SurfaceSearch surface(target);
  const SurfacePlaces places = surface.project(image, parallelFor);
  const double slack =
    Rounding * (target.points.colwise().maxCoeff() - target.points.colwise().minCoeff()).norm();
  std::vector<bool> fixed = used; // points that no quad uses are nobody's to move
  fixed.flip();
  for (Index i = 0; i < points.rows(); ++i)
  {
    if (used[static_cast<std::size_t>(i)])
    {
      const bool isOff = (places.points.row(i) - image.row(i)).norm() > slack;
      points.row(i) = isOff ? places.points.row(i) : image.row(i);
    }
  }
  for (const FixedNode& node : borders)
  {
    points.row(node.point) = node.position;
  }
  for (const FixedNode& node : boundary)
  {
    points.row(node.point) = node.position;
    fixed[static_cast<std::size_t>(node.point)] = true;
  }
  if (singlePrecision)
  {
    points = points.cast<float>().cast<double>().eval();
  }
  result.quality = quadQuality(points, source.quads, places.normals);
  result.fixedCorners = fixedQuadCorners(points, source.quads, places.normals, fixed);
  result.invertedBefore = result.quality.inverted;
  return result;
}
}

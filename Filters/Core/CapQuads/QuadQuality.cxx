// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/QuadQuality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hexsweep
{
namespace
{
/// Scaled Jacobians of corners, positive on the side where the mesh's area is.
class CornerMeasure
{
public:
  CornerMeasure(const PointsRef& points, const QuadsRef& quads, const PointsRef& normals)
    : MeshPoints(points)
    , MeshQuads(quads)
    , Normals(normals)
  {
    double whole = 0.0;
    for (Index q = 0; q < quads.rows(); ++q)
    {
      for (Index c = 0; c < 4; ++c)
      {
        whole += this->areaAndLengths(q, c).first;
      }
    }
    this->Side = whole < 0.0 ? -1.0 : 1.0;
  }

  double scaledJacobian(Index q, Index c) const
  {
    const auto [area, lengths] = this->areaAndLengths(q, c);
    return this->Side * area / lengths;
  }

private:
  std::pair<double, double> areaAndLengths(Index q, Index c) const
  {
    const Index i = this->MeshQuads(q, c);
    const Eigen::RowVector3d a =
      this->MeshPoints.row(this->MeshQuads(q, (c + 1) % 4)) - this->MeshPoints.row(i);
    const Eigen::RowVector3d b =
      this->MeshPoints.row(this->MeshQuads(q, (c + 3) % 4)) - this->MeshPoints.row(i);
    return std::make_pair(a.cross(b).dot(this->Normals.row(i)), a.norm() * b.norm());
  }

  const PointsRef& MeshPoints;
  const QuadsRef& MeshQuads;
  const PointsRef& Normals;
  double Side = 1.0;
};
}

QuadQuality quadQuality(const PointsRef& points, const QuadsRef& quads, const PointsRef& normals)
{
  const CornerMeasure measure(points, quads, normals);
  QuadQuality quality;
  quality.scaledJacobian.resize(quads.rows());
  quality.minimum = std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    double least = std::numeric_limits<double>::infinity();
    for (Index c = 0; c < 4; ++c)
    {
      const double jacobian = measure.scaledJacobian(q, c);
      // A comparison with NaN is false: keep the NaN of an edge without length.
      least = std::isnan(least) || jacobian >= least ? least : jacobian;
    }
    quality.scaledJacobian[q] = least;
    quality.inverted += least > 0.0 ? 0 : 1;
    quality.minimum = std::min(quality.minimum, std::isnan(least) ? -1.0 : least);
    sum += std::isnan(least) ? -1.0 : least;
  }
  quality.mean = sum / static_cast<double>(std::max<Index>(1, quads.rows()));
  return quality;
}

FixedQuadCorners fixedQuadCorners(const PointsRef& points, const QuadsRef& quads,
  const PointsRef& normals, const std::vector<bool>& fixed)
{
  const CornerMeasure measure(points, quads, normals);
  const auto isFixed = [&](Index q, Index c) {
    return fixed[static_cast<std::size_t>(quads(q, c % 4))];
  };
  FixedQuadCorners result;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    FixedCorner worst{ q, 0, 1.0 };
    for (Index c = 0; c < 4; ++c)
    {
      if (isFixed(q, c) && isFixed(q, c + 1) && isFixed(q, c + 3))
      {
        const double jacobian = measure.scaledJacobian(q, c);
        const double value = std::isnan(jacobian) ? -1.0 : jacobian;
        worst = value < worst.scaledJacobian ? FixedCorner{ q, c, value } : worst;
      }
    }
    result.floor = std::min(result.floor, worst.scaledJacobian);
    if (!(worst.scaledJacobian > 0.0))
    {
      result.inverted.push_back(worst);
    }
  }
  return result;
}
}

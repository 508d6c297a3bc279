// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/AffineMap.h"

#include "Core/Common/DenseAlgebra.h"
#include "Core/Common/Errors.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
/// A node set about its centroid, scaled to unit root-mean-square radius.
struct Normalized
{
  Eigen::RowVector3d center;
  double radius = 0.0;
  Points points;
};

Normalized normalize(const PointsRef& points)
{
  Normalized result;
  // The first node as a provisional origin: far from the origin a plain sum loses digits.
  const Eigen::RowVector3d origin = points.row(0);
  result.points = points.rowwise() - origin;
  const Eigen::RowVector3d mean = result.points.colwise().mean();
  result.points.rowwise() -= mean;
  result.center = origin + mean;
  result.radius = std::sqrt(result.points.rowwise().squaredNorm().mean());
  if (result.radius > 0.0)
  {
    result.points /= result.radius;
  }
  return result;
}

/// Root-mean-square height over the plane, in units of the radius, from which on a loop itself says
/// where its normal goes.
constexpr double PlanarHeight = 0.05;

using PlaneAxes = Eigen::Matrix<double, 3, 2>;

/// Two unit vectors that complete a unit normal to a right-handed frame.
PlaneAxes axesAround(const Eigen::Vector3d& normal)
{
  PlaneAxes axes;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  return axes;
}

Eigen::Vector3d leastSquaresNormal(const Points& points)
{
  return principalAxes(points.transpose() * points).axes.col(0);
}
}

Points AffineMap::apply(const PointsRef& points) const
{
  Points moved = points.rowwise() - this->sourceCenter;
  moved = moved * this->linear.transpose();
  moved.rowwise() += this->targetCenter;
  return moved;
}

bool isInvertible(const AffineMap& map)
{
  constexpr double Least = 1e-9; // least stretch over the greatest one
  const Eigen::Vector3d stretches = map.linear.jacobiSvd().singularValues();
  return stretches[0] > 0.0 && std::isfinite(stretches[0]) && stretches[2] > Least * stretches[0];
}

AffineMap inverse(const AffineMap& map)
{
  return { map.linear.inverse(), map.targetCenter, map.sourceCenter };
}

Eigen::RowVector3d areaVector(const PointsRef& loop)
{
  Eigen::RowVector3d area = Eigen::RowVector3d::Zero();
  for (Index j = 0; j < loop.rows(); ++j)
  {
    const Eigen::RowVector3d a = loop.row(j) - loop.row(0);
    const Eigen::RowVector3d b = loop.row((j + 1) % loop.rows()) - loop.row(0);
    area += 0.5 * a.cross(b);
  }
  return area;
}

AffineMap fitAffineMap(const PointsRef& source, const PointsRef& target,
  const Eigen::RowVector3d& sourceArea, const Eigen::RowVector3d& targetArea)
{
  const Index n = source.rows();
  if (n < 3 || target.rows() != n)
  {
    throw InvalidInput("an affine map needs two node sets of the same size, at least three nodes.");
  }
  const Normalized from = normalize(source);
  const Normalized to = normalize(target);
  if (!(from.radius > 0.0))
  {
    throw InvalidInput("an affine map cannot be found: all nodes of the loop coincide.");
  }

  // Below this share of the radius squared, an area vector says nothing about the normal.
  constexpr double NegligibleArea = 1e-3;
  const bool useAreas = sourceArea.norm() > NegligibleArea * from.radius * from.radius &&
    targetArea.norm() > NegligibleArea * to.radius * to.radius;
  const Eigen::Vector3d normal = useAreas ? Eigen::Vector3d(sourceArea.normalized().transpose())
                                          : leastSquaresNormal(from.points);
  const PlaneAxes axes = axesAround(normal);

  // Eliminate the two in-plane columns of A, so that its normal column stands alone: a ridge
  // regression in one variable, well conditioned however flat the loop is.
  const Eigen::MatrixXd inPlane = from.points * axes;
  const Eigen::VectorXd height = from.points * normal;
  Eigen::MatrixXd right(n, 4);
  right << to.points, height;
  const Eigen::MatrixXd fit = leastSquares(inPlane, right);
  const auto planeFit = fit.leftCols<3>();
  const auto heightSlope = fit.col(3);
  const Eigen::MatrixXd residual = to.points - inPlane * planeFit;
  const Eigen::VectorXd freeHeight = height - inPlane * heightSlope;

  Eigen::RowVector3d image;
  if (useAreas)
  {
    image = targetArea.normalized() *
      (std::sqrt(targetArea.norm() / sourceArea.norm()) * from.radius / to.radius);
  }
  else
  {
    const Eigen::RowVector3d a = planeFit.row(0);
    const Eigen::RowVector3d b = planeFit.row(1);
    const Eigen::RowVector3d cross = a.cross(b);
    image = cross.norm() > 0.0 ? Eigen::RowVector3d(cross / std::sqrt(cross.norm())) : cross;
  }

  const double height2 = freeHeight.squaredNorm();
  const Eigen::RowVector3d moment = freeHeight.transpose() * residual;
  const double misfit2 =
    std::max(0.0, residual.squaredNorm() - (height2 > 0.0 ? moment.squaredNorm() / height2 : 0.0));
  const double freedom = static_cast<double>(std::max<Index>(n - 4, 1));
  const double flatness = std::max(0.0, PlanarHeight - std::sqrt(height2 / static_cast<double>(n)));
  const double weight = 10.0 * std::sqrt(misfit2 / freedom) + flatness;
  const double prior = static_cast<double>(n) * weight * weight;
  const Eigen::RowVector3d normalColumn = (moment + prior * image) / (height2 + prior);

  // The in-plane columns that go with this normal column.
  const Eigen::MatrixXd planeColumns = planeFit - heightSlope * normalColumn;

  AffineMap map;
  map.sourceCenter = from.center;
  map.targetCenter = to.center;
  map.linear = (to.radius / from.radius) *
    (planeColumns.transpose() * axes.transpose() + normalColumn.transpose() * normal.transpose());
  return map;
}
}

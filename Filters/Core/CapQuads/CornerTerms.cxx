// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CornerTerms.h"

#include "Core/Geometry/FoldoverFreeEnergy.h"

#include <Eigen/Geometry>

#include <cmath>

namespace hexsweep
{
namespace
{
/// Sine of a source corner below which a right angle is wanted instead.
constexpr double SharpestReference = 0.2;

/// Of the quad that a corner came from: a side, counted from the corner on.
Eigen::RowVector3d sideOf(
  const PointsRef& source, const Quads& quads, const QuadCorner& corner, Index k)
{
  return source.row(quads(corner.quad, (corner.corner + k + 1) % 4)) -
    source.row(quads(corner.quad, (corner.corner + k) % 4));
}

Eigen::Matrix2d referenceCorner(
  ReferenceShape shape, const PointsRef& source, const Quads& quads, const QuadCorner& corner)
{
  Eigen::Matrix2d reference = Eigen::Matrix2d::Identity();
  if (shape == ReferenceShape::Square)
  {
    return reference;
  }
  const std::array<double, 2> lengths = rectangleOf(source, quads, corner);
  reference.diagonal() << lengths[0], lengths[1];
  if (shape == ReferenceShape::SourceQuad)
  {
    const Eigen::RowVector3d next = sideOf(source, quads, corner, 0);
    const Eigen::RowVector3d previous = -sideOf(source, quads, corner, 3);
    const double height = next.cross(previous).norm() / next.norm();
    if (height > SharpestReference * previous.norm())
    {
      reference << next.norm(), next.dot(previous) / next.norm(), 0.0, height;
    }
  }
  return reference;
}
}

std::array<double, 2> rectangleOf(
  const PointsRef& source, const Quads& quads, const QuadCorner& corner)
{
  const auto length = [&](Index k) { return sideOf(source, quads, corner, k).norm(); };
  return { 0.5 * (length(0) + length(2)), 0.5 * (length(1) + length(3)) };
}

std::vector<Eigen::Matrix2d> inverseReferences(
  const CapCorners& cap, ReferenceShape shape, const PointsRef& source, const PointsRef& points)
{
  const Points normals = cap.normals(points);
  std::vector<Eigen::Matrix2d> inverse;
  double referenceArea = 0.0;
  double area = 0.0;
  for (const QuadCorner& corner : cap.corners())
  {
    const Eigen::Matrix2d reference = referenceCorner(shape, source, cap.quads(), corner);
    inverse.push_back(reference.inverse());
    if (corner.column < 0)
    {
      const Eigen::RowVector3d a = points.row(corner.node[1]) - points.row(corner.node[0]);
      const Eigen::RowVector3d b = points.row(corner.node[2]) - points.row(corner.node[0]);
      referenceArea += reference.determinant();
      area += a.cross(b).dot(cap.normal(corner, normals));
    }
  }
  const double scale = std::sqrt(referenceArea / std::abs(area));
  for (Eigen::Matrix2d& matrix : inverse)
  {
    matrix *= scale;
  }
  return inverse;
}

CornerTerm distortionTerm(
  const Eigen::Matrix2d& edges, const Eigen::Matrix2d& inverseReference, double epsilon)
{
  const Distortion<2> d = distortion<2>(edges * inverseReference, epsilon, VolumeWeight);
  // The columns of the Jacobian are combinations of the edges: its curvature in blocks of them.
  const Eigen::Matrix2d& r = inverseReference;
  Eigen::Matrix<double, 4, 4> half; // combined on the right
  for (int edge = 0; edge < 2; ++edge)
  {
    half.middleCols<2>(2 * edge) =
      r(edge, 0) * d.curvature.leftCols<2>() + r(edge, 1) * d.curvature.rightCols<2>();
  }
  CornerTerm term{ d.value, d.gradient * r.transpose(), {} };
  for (int edge = 0; edge < 2; ++edge)
  {
    term.curvature.middleRows<2>(2 * edge) =
      r(edge, 0) * half.topRows<2>() + r(edge, 1) * half.bottomRows<2>();
  }
  return term;
}

double distortionValueOf(
  const Eigen::Matrix2d& edges, const Eigen::Matrix2d& inverseReference, double epsilon)
{
  return distortionValue<2>(edges * inverseReference, epsilon, VolumeWeight);
}

CornerTerm jacobianTerm(
  const Eigen::Matrix2d& edges, const std::function<CurvePoint(double)>& function)
{
  const Eigen::Vector2d a = edges.col(0);
  const Eigen::Vector2d b = edges.col(1);
  const double lengths = a.norm() * b.norm();
  const double jacobian = edges.determinant() / lengths;
  const CurvePoint f = function(jacobian);
  Eigen::Matrix2d gradient;
  gradient.col(0) = Eigen::Vector2d(b.y(), -b.x()) / lengths - jacobian * a / a.squaredNorm();
  gradient.col(1) = Eigen::Vector2d(-a.y(), a.x()) / lengths - jacobian * b / b.squaredNorm();
  const Eigen::Map<const Eigen::Vector4d> g(gradient.data());
  CornerTerm term{ f.value, f.slope * gradient, f.curvature * g * g.transpose() };
  if (f.slope < 0.0 && jacobian > 0.0)
  {
    // The sine is concave in the angle between the edges, so that a falling function of it curves
    // upwards; the curvature of the angle itself has no sign and is left out.
    Eigen::Vector4d turn;
    turn << Eigen::Vector2d(-a.y(), a.x()) / a.squaredNorm(),
      Eigen::Vector2d(b.y(), -b.x()) / b.squaredNorm();
    term.curvature -= f.slope * jacobian * turn * turn.transpose();
  }
  return term;
}

ColumnCornerTerm hexJacobianTerm(
  const CornerEdges& edges, const std::function<CurvePoint(double)>& function)
{
  const Eigen::Vector3d a = edges.col(0);
  const Eigen::Vector3d b = edges.col(1);
  const double lengths = a.norm() * b.norm();
  const double jacobian = a.cross(b).z() / lengths;
  const CurvePoint f = function(jacobian);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  CornerEdges gradient;
  gradient.col(0) = b.cross(up) / lengths - jacobian * a / a.squaredNorm();
  gradient.col(1) = up.cross(a) / lengths - jacobian * b / b.squaredNorm();
  const Eigen::Map<const Eigen::Matrix<double, 6, 1>> g(gradient.data());
  ColumnCornerTerm term{ f.value, f.slope * gradient, f.curvature * g * g.transpose() };
  if (f.slope < 0.0 && jacobian > 0.0)
  {
    // Of each edge alone the Jacobian is a linear function on the sphere of its directions.
    for (int e = 0; e < 2; ++e)
    {
      const Eigen::Vector3d edge = edges.col(e);
      const double square = edge.squaredNorm();
      term.curvature.block<3, 3>(3 * e, 3 * e) -= f.slope * jacobian / square *
        (Eigen::Matrix3d::Identity() - edge * edge.transpose() / square);
    }
  }
  return term;
}

CornerTerm sumOfTerms(const CornerTerm& a, const CornerTerm& b, double weight)
{
  return { a.value + weight * b.value, a.gradient + weight * b.gradient,
    a.curvature + weight * b.curvature };
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/GreenCoordinates.h"

#include "Core/Common/Constants.h"
#include "Core/Interior/CageInterior.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace hexsweep
{
GreenCoordinates::GreenCoordinates(Points vertices, Triangles triangles)
  : Vertices(std::move(vertices))
  , Corners(std::move(triangles))
  , Edges(triangleEdges(this->Corners))
  , EdgeLengths(this->Edges.ends.rows())
{
  for (Index e = 0; e < this->EdgeLengths.size(); ++e)
  {
    this->EdgeLengths[e] =
      (this->Vertices.row(this->Edges.ends(e, 1)) - this->Vertices.row(this->Edges.ends(e, 0)))
        .norm();
  }
  this->Faces.resize(static_cast<std::size_t>(this->Corners.rows()));
  for (Index t = 0; t < this->Corners.rows(); ++t)
  {
    Face& face = this->Faces[static_cast<std::size_t>(t)];
    const auto corner = [&](int c) { return this->Vertices.row(this->Corners(t, c % 3)); };
    const Eigen::RowVector3d area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const double doubleArea = area.norm();
    face.normal = doubleArea > 0.0 ? Eigen::RowVector3d(area / doubleArea) : area;
    for (int c = 0; c < 3; ++c)
    {
      const Eigen::RowVector3d edge = corner(c + 2) - corner(c + 1);
      const double length = edge.norm();
      face.outward.row(c) = doubleArea > 0.0
        ? Eigen::RowVector3d((edge / length).cross(face.normal))
        : Eigen::RowVector3d::Zero();
      face.height[c] = doubleArea > 0.0 ? doubleArea / length : 0.0;
    }
  }
}

GreenWeights GreenCoordinates::at(const Eigen::RowVector3d& point) const
{
  const Points toVertex = this->Vertices.rowwise() - point;
  const Eigen::VectorXd distance = toVertex.rowwise().norm();
  // Integral of 1/r along each edge; on the edge itself it would be infinite.
  Eigen::VectorXd alongEdge(this->EdgeLengths.size());
  for (Index e = 0; e < alongEdge.size(); ++e)
  {
    const double length = this->EdgeLengths[e];
    const double beyond =
      distance[this->Edges.ends(e, 0)] + distance[this->Edges.ends(e, 1)] - length;
    alongEdge[e] = length > 0.0
      ? std::log1p(2.0 * length / std::max(beyond, std::numeric_limits<double>::epsilon() * length))
      : 0.0;
  }

  GreenWeights weights{ Eigen::VectorXd::Zero(this->Vertices.rows()),
    Eigen::VectorXd::Zero(this->Corners.rows()) };
  for (Index t = 0; t < this->Corners.rows(); ++t)
  {
    const Face& face = this->Faces[static_cast<std::size_t>(t)];
    if (face.height[0] == 0.0)
    {
      continue;
    }
    const Index ids[3] = { this->Corners(t, 0), this->Corners(t, 1), this->Corners(t, 2) };
    const auto a = toVertex.row(ids[0]);
    const auto b = toVertex.row(ids[1]);
    const auto c = toVertex.row(ids[2]);
    const double ra = distance[ids[0]];
    const double rb = distance[ids[1]];
    const double rc = distance[ids[2]];
    const double solidAngle = 2.0 *
      std::atan2(a.dot(b.cross(c)), ra * rb * rc + a.dot(b) * rc + b.dot(c) * ra + c.dot(a) * rb);
    // Of the plane ahead; and of the edges, from the foot of the point in the plane.
    const double height = face.normal.dot(a);
    const Eigen::RowVector3d reach(
      face.outward.row(0).dot(b), face.outward.row(1).dot(c), face.outward.row(2).dot(a));
    const Eigen::RowVector3d logs(alongEdge[this->Edges.opposite(t, 0)],
      alongEdge[this->Edges.opposite(t, 1)], alongEdge[this->Edges.opposite(t, 2)]);

    weights.faces[t] = (reach.dot(logs) - height * solidAngle) / (4.0 * Pi);
    // The hat function is reach / height linear in the plane: its value at the foot times the
    // solid angle, and its slope against the integral of the distance from the foot over r^3.
    const Eigen::RowVector3d pull = logs * face.outward;
    for (int k = 0; k < 3; ++k)
    {
      weights.vertices[ids[k]] += (reach[k] * solidAngle + height * face.outward.row(k).dot(pull)) /
        (4.0 * Pi * face.height[k]);
    }
  }
  return weights;
}

Points stretchedNormals(
  const PointsRef& rest, const PointsRef& deformed, const TrianglesRef& triangles)
{
  Points normals = Points::Zero(triangles.rows(), 3);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    const auto edge = [&](const PointsRef& points, int c) -> Eigen::RowVector3d {
      return points.row(triangles(t, c)) - points.row(triangles(t, 0));
    };
    const Eigen::RowVector3d u = edge(rest, 1);
    const Eigen::RowVector3d v = edge(rest, 2);
    const Eigen::RowVector3d newU = edge(deformed, 1);
    const Eigen::RowVector3d newV = edge(deformed, 2);
    const double doubleArea = u.cross(v).norm();
    const Eigen::RowVector3d normal = newU.cross(newV);
    const double length = normal.norm();
    if (doubleArea > 0.0 && length > 0.0)
    {
      const double stretch2 = newU.squaredNorm() * v.squaredNorm() -
        2.0 * newU.dot(newV) * u.dot(v) + newV.squaredNorm() * u.squaredNorm();
      normals.row(t) = std::sqrt(std::max(0.5 * stretch2, 0.0)) / doubleArea * (normal / length);
    }
  }
  return normals;
}

Points greenInterior(
  const SweepCage& cage, const Progress& progress, const ParallelFor& parallelFor)
{
  const CageMethod method = [](const PointsRef& rest, const PointsRef& deformed,
                              const TrianglesRef& triangles) -> CageMap {
    const auto coordinates = std::make_shared<const GreenCoordinates>(rest, triangles);
    return [coordinates, vertices = Points(deformed),
             normals = stretchedNormals(rest, deformed, triangles)](
             const Eigen::RowVector3d& point) -> Eigen::RowVector3d {
      const GreenWeights weights = coordinates->at(point);
      return weights.vertices.transpose() * vertices + weights.faces.transpose() * normals;
    };
  };
  return cageInterior(cage, method, progress, parallelFor);
}
}

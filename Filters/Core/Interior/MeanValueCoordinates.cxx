// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/MeanValueCoordinates.h"

#include "Core/Interior/CageInterior.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace hexsweep
{
namespace
{
/// Distance to a vertex, over that to the farthest one, below which a point is at the vertex.
constexpr double AtVertex = 1e-14;
/// det(u) over the squared length of the longest q_i below which a point is in the plane of a
/// triangle: where the rounding of a weight would be as large as what is lost without it.
constexpr double InPlane = 1e-8;

/// Three numbers a row, aligned for speed.
using Vectors = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
}

MeanValueCoordinates::MeanValueCoordinates(Points vertices, Triangles triangles)
  : Vertices(std::move(vertices))
  , Corners(std::move(triangles))
  , Edges(triangleEdges(this->Corners))
{
}

Eigen::VectorXd MeanValueCoordinates::at(const Eigen::RowVector3d& point) const
{
  Vectors unit = this->Vertices.rowwise() - point;
  const Eigen::VectorXd distance = unit.rowwise().norm();
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(distance.size());
  Index nearest = 0;
  if (distance.minCoeff(&nearest) <= AtVertex * distance.maxCoeff())
  {
    weights[nearest] = 1.0;
    return weights;
  }
  unit.array().colwise() /= distance.array();

  // Of each edge: cross product of the unit vectors to its ends, and the angle between these over
  // the length of the product (the sine).
  const Index numberOfEdges = this->Edges.ends.rows();
  Vectors cross(numberOfEdges, 3);
  Eigen::VectorXd angle(numberOfEdges);
  Eigen::VectorXd sine(numberOfEdges);
  for (Index e = 0; e < numberOfEdges; ++e)
  {
    const auto a = unit.row(this->Edges.ends(e, 0));
    const auto b = unit.row(this->Edges.ends(e, 1));
    cross.row(e) = a.cross(b);
    sine[e] = cross.row(e).norm();
    angle[e] = std::atan2(sine[e], a.dot(b));
  }

  for (Index t = 0; t < this->Corners.rows(); ++t)
  {
    Eigen::Matrix3d q;
    Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
    double longest = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const Index e = this->Edges.opposite(t, c);
      q.row(c) = this->Edges.direction(t, c) * cross.row(e);
      if (sine[e] > 0.0)
      {
        mean += (0.5 * angle[e] / sine[e]) * q.row(c);
      }
      longest = std::max(longest, sine[e]);
    }
    const double determinant = q.row(0).dot(unit.row(this->Corners(t, 0)));
    if (std::abs(determinant) > InPlane * longest * longest)
    {
      const Eigen::Vector3d parts = q * mean.transpose() / determinant;
      for (int c = 0; c < 3; ++c)
      {
        weights[this->Corners(t, c)] += parts[c] / distance[this->Corners(t, c)];
      }
    }
    else if (std::min({ q.row(0).dot(q.row(1)), q.row(1).dot(q.row(2)), q.row(2).dot(q.row(0)) }) >=
      -InPlane * longest * longest)
    {
      // On the triangle, which goes round the point: areas of the parts.
      weights.setZero();
      for (int c = 0; c < 3; ++c)
      {
        weights[this->Corners(t, c)] = sine[this->Edges.opposite(t, c)] *
          distance[this->Corners(t, (c + 1) % 3)] * distance[this->Corners(t, (c + 2) % 3)];
      }
      break;
    }
  }
  return weights / weights.sum();
}

Points meanValueInterior(
  const SweepCage& cage, const Progress& progress, const ParallelFor& parallelFor)
{
  const CageMethod method = [](const PointsRef& rest, const PointsRef& deformed,
                              const TrianglesRef& triangles) -> CageMap {
    const auto coordinates = std::make_shared<const MeanValueCoordinates>(rest, triangles);
    return [coordinates, vertices = Points(deformed)](
             const Eigen::RowVector3d& point) -> Eigen::RowVector3d {
      return coordinates->at(point).transpose() * vertices;
    };
  };
  return cageInterior(cage, method, progress, parallelFor);
}
}

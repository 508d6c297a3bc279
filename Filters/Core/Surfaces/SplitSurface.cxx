// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SplitSurface.h"

#include "Core/Common/StandardIndex.h"

#include <Eigen/Geometry>

#include <limits>

namespace hexsweep
{
SplitSurface::SplitSurface(const TriangleMesh& surface)
  : Triangles(surface.triangles)
  , Parts(at(surface.triangles.rows()))
  , HalfOf(at(surface.points.rows()), -1)
{
  for (Index i = 0; i < surface.points.rows(); ++i)
  {
    this->Places.emplace_back(surface.points.row(i));
  }
  for (Index t = 0; t < surface.triangles.rows(); ++t)
  {
    this->append(t);
    this->touch(t);
  }
}

void SplitSurface::append(Index origin)
{
  this->Parts[at(origin)].push_back(static_cast<Index>(this->Origins.size()));
  this->Origins.push_back(origin);
}

void SplitSurface::touch(Index triangle)
{
  for (Index half = 3 * triangle; half < 3 * triangle + 3; ++half)
  {
    this->HalfOf[at(this->Triangles.from(half))] = half;
  }
}

TriangleMesh SplitSurface::mesh() const
{
  TriangleMesh mesh{ Points(this->numberOfPoints(), 3), this->Triangles.triangles() };
  for (Index i = 0; i < this->numberOfPoints(); ++i)
  {
    mesh.points.row(i) = this->point(i);
  }
  return mesh;
}

std::vector<Index> SplitSurface::around(Index v) const
{
  const Index some = this->HalfOf[at(v)];
  Index first = some;
  // Clockwise as far as it goes.
  for (Index twin = this->Triangles.twin(first); twin >= 0; twin = this->Triangles.twin(first))
  {
    first = HalfEdgeTriangles::next(twin);
    if (first == some)
    {
      break;
    }
  }
  std::vector<Index> halves;
  for (Index half = first; half >= 0;)
  {
    halves.push_back(half);
    half = this->Triangles.twin(HalfEdgeTriangles::previous(half));
    if (half == first)
    {
      break;
    }
  }
  return halves;
}

std::vector<Index> SplitSurface::neighbors(Index v) const
{
  std::vector<Index> points;
  const std::vector<Index> halves = this->around(v);
  for (const Index half : halves)
  {
    points.push_back(this->Triangles.to(half));
  }
  const Index last = HalfEdgeTriangles::previous(halves.back());
  if (this->Triangles.twin(last) < 0)
  {
    points.push_back(this->Triangles.from(last));
  }
  return points;
}

Index SplitSurface::edge(Index u, Index v) const
{
  for (const Index half : this->around(u))
  {
    if (this->Triangles.to(half) == v)
    {
      return half;
    }
    if (this->Triangles.apex(half) == v)
    {
      return HalfEdgeTriangles::previous(half);
    }
  }
  return -1;
}

Eigen::RowVector3d SplitSurface::normal(Index v) const
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const Index half : this->around(v))
  {
    const Eigen::RowVector3d a = this->point(this->Triangles.to(half)) - this->point(v);
    const Eigen::RowVector3d b = this->point(this->Triangles.apex(half)) - this->point(v);
    sum += a.cross(b);
  }
  return sum.normalized();
}

TrianglePoint SplitSurface::locate(Index given, const Eigen::RowVector3d& place) const
{
  TrianglePoint best;
  best.distance = std::numeric_limits<double>::infinity();
  for (const Index t : this->Parts[at(given)])
  {
    TrianglePoint found = closestPointOnTriangle(place, this->point(this->Triangles.from(3 * t)),
      this->point(this->Triangles.from(3 * t + 1)), this->point(this->Triangles.from(3 * t + 2)));
    if (found.distance < best.distance)
    {
      best = found;
      best.triangle = t;
    }
  }
  return best;
}

Index SplitSurface::splitEdge(Index half, const Eigen::RowVector3d& place)
{
  const Index vertex = this->numberOfPoints();
  const Index left = half / 3;
  const Index twin = this->Triangles.twin(half);
  const Index appended = this->Triangles.numberOfTriangles();
  this->Places.push_back(place);
  this->HalfOf.push_back(-1);
  this->Triangles.splitEdge(half, vertex);
  this->append(this->Origins[at(left)]);
  this->touch(left);
  this->touch(appended);
  if (twin >= 0)
  {
    this->append(this->Origins[at(twin / 3)]);
    this->touch(twin / 3);
    this->touch(appended + 1);
  }
  return vertex;
}

Index SplitSurface::splitTriangle(Index triangle, const Eigen::RowVector3d& place)
{
  const Index vertex = this->numberOfPoints();
  const Index appended = this->Triangles.numberOfTriangles();
  this->Places.push_back(place);
  this->HalfOf.push_back(-1);
  this->Triangles.splitTriangle(triangle, vertex);
  this->append(this->Origins[at(triangle)]);
  this->append(this->Origins[at(triangle)]);
  for (const Index t : { triangle, appended, appended + 1 })
  {
    this->touch(t);
  }
  return vertex;
}
}

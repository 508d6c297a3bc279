// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/CapHeights.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr double FlatSlope = 1e-6;
constexpr int MostSteps = 20;
constexpr double LeastUpright = 0.05;
constexpr double Reached = 1e-12;  // of the whole
constexpr double FacetRise = 0.25; // of a facet's edge

/// Slope of the plane through three points over u and v.
double slopeOf(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c)
{
  const Eigen::RowVector3d normal =
    Eigen::Vector3d(b - a).cross(Eigen::Vector3d(c - a)).transpose();
  return std::abs(normal.z()) > 0.0 ? normal.head<2>().norm() / std::abs(normal.z()) : 0.0;
}
}

CapHeights::CapHeights(
  const SolidSurface& solid, const PointsRef& framePoints, const CapLikeFaces& faces)
  : Places(framePoints)
{
  this->Extent = (framePoints.colwise().maxCoeff() - framePoints.colwise().minCoeff()).norm();
  std::vector<std::vector<Index>> rows(faces.faces.size());
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    rows[faces.faceOf[static_cast<std::size_t>(t)]].push_back(t);
  }
  this->Caps.resize(faces.faces.size());
  for (std::size_t f = 0; f < faces.faces.size(); ++f)
  {
    const StackFaceKind kind = faces.faces[f].kind;
    if (kind != StackFaceKind::Top && kind != StackFaceKind::Bottom)
    {
      continue;
    }
    Triangles corners(static_cast<Index>(rows[f].size()), 3);
    // Each triangle has points of its own: those of all caps together are many times the solid's.
    Triangles own(corners.rows(), 3);
    PlanePoints plane(3 * corners.rows(), 2);
    double slope = 0.0;
    double longest = 0.0;
    PlaneBox box;
    std::pair<double, double> range{ framePoints(solid.triangles(rows[f].front(), 0), 2),
      framePoints(solid.triangles(rows[f].front(), 0), 2) };
    for (std::size_t i = 0; i < rows[f].size(); ++i)
    {
      const auto t = solid.triangles.row(rows[f][i]);
      const Index row = static_cast<Index>(i);
      corners.row(row) << t[0], t[1], t[2];
      if (kind == StackFaceKind::Bottom)
      {
        std::swap(corners(row, 1), corners(row, 2));
      }
      for (Index c = 0; c < 3; ++c)
      {
        own(row, c) = 3 * row + c;
        plane.row(3 * row + c) = framePoints.row(corners(row, c)).head<2>();
        box.extend(plane(3 * row + c, 0), plane(3 * row + c, 1));
        range.first = std::min(range.first, framePoints(t[c], 2));
        range.second = std::max(range.second, framePoints(t[c], 2));
      }
      slope = std::max(
        slope, slopeOf(framePoints.row(t[0]), framePoints.row(t[1]), framePoints.row(t[2])));
      for (Index c = 0; c < 3; ++c)
      {
        longest =
          std::max(longest, (framePoints.row(t[c]) - framePoints.row(t[(c + 1) % 3])).norm());
      }
    }
    PlaneTriangulation mesh(plane, own);
    BoxTree boxes = triangleBoxes(mesh);
    this->Caps[f].reset(new Cap{ std::move(mesh), std::move(boxes), box, std::move(corners),
      faces.faces[f].id, slope, range, longest });
    this->Numbers.push_back(f);
  }
}

bool CapHeights::isFlat(std::size_t face) const
{
  const Cap& cap = *this->Caps[face];
  return cap.range.second - cap.range.first <= FlatSlope * this->Extent;
}

double CapHeights::height(const Cap& cap, std::uint32_t t, const Eigen::RowVector2d& place) const
{
  const PlaneTriangulation::Triangle& triangle = cap.mesh.triangle(t);
  const TrianglePoint found =
    nearestPointOn(cap.mesh.point(triangle.corners[0]), cap.mesh.point(triangle.corners[1]),
      cap.mesh.point(triangle.corners[2]), { place.x(), place.y() });
  double height = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const Index corner = (static_cast<Index>(triangle.first) + c) % 3;
    height +=
      found.coordinates[c] * this->Places(cap.corners(static_cast<Index>(triangle.id), corner), 2);
  }
  return height;
}

std::optional<double> CapHeights::at(std::size_t face, const Eigen::RowVector2d& place) const
{
  const Cap& cap = *this->Caps[face];
  if (cap.box.squaredDistance(place.x(), place.y()) > 0.0)
  {
    return std::nullopt;
  }
  const std::uint32_t t = lowestTriangleAt(cap.mesh, cap.boxes, { place.x(), place.y() });
  if (t == PlaneTriangulation::None)
  {
    return std::nullopt;
  }
  return this->height(cap, t, place);
}

void CapHeights::setGeometry(const ModelGeometry* geometry, const StackFrame& frame)
{
  this->Geometry = geometry;
  this->Frame = frame;
}

double CapHeights::exact(std::size_t face, const Eigen::RowVector2d& place) const
{
  const double start = this->nearest(face, place);
  if (!this->Geometry || this->isFlat(face))
  {
    return start;
  }
  const Cap& cap = *this->Caps[face];
  double height = start;
  for (int step = 0; step < MostSteps; ++step)
  {
    Points at(1, 3);
    at << place.x(), place.y(), height;
    const Eigen::RowVector3d here = this->Frame->fromFrame(at).row(0);
    const auto nearest = this->Geometry->closestOnFace(cap.faceId, here);
    const auto normal = this->Geometry->normalOnFace(cap.faceId, here);
    const double upright = normal ? normal->dot(this->Frame->direction()) : 0.0;
    if (!nearest || !(std::abs(upright) > LeastUpright))
    {
      return start;
    }
    const double way = (*nearest - here).dot(*normal) / upright;
    height += way;
    if (std::abs(way) <= Reached * this->Extent)
    {
      break;
    }
  }
  // Facets are no further off than this; else it is another part of the surface.
  return std::abs(height - start) <= FacetRise * cap.longest ? height : start;
}

double CapHeights::nearest(std::size_t face, const Eigen::RowVector2d& place) const
{
  const Cap& cap = *this->Caps[face];
  const PlaneTriangulation::Point point{ place.x(), place.y() };
  std::uint32_t t = lowestTriangleAt(cap.mesh, cap.boxes, point);
  if (t == PlaneTriangulation::None)
  {
    t = nearestTriangle(cap.mesh, cap.boxes, point);
  }
  return this->height(cap, t, place);
}
}

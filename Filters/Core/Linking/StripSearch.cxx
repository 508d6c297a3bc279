// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/StripSearch.h"

#include "Core/Geometry/PlaneTriangleSearch.h"

#include <cmath>
#include <limits>

namespace hexsweep
{
StripSearch::StripSearch(const SideStrip& strip)
  : Strip(strip)
  , Plane(strip.plane, strip.planeTriangles)
  , Boxes(triangleBoxes(Plane))
  , Least(static_cast<int>(std::floor(strip.plane.col(0).minCoeff())))
  , Most(static_cast<int>(std::ceil(strip.plane.col(0).maxCoeff())))
{
}

StripPlace StripSearch::onTriangle(std::uint32_t t, const PlaneTriangulation::Point& q) const
{
  const PlaneTriangulation::Triangle& triangle = this->Plane.triangle(t);
  const TrianglePoint near = nearestPointOn(this->Plane.point(triangle.corners[0]),
    this->Plane.point(triangle.corners[1]), this->Plane.point(triangle.corners[2]), q);
  StripPlace place;
  place.triangle = static_cast<Index>(triangle.id);
  for (Index c = 0; c < 3; ++c)
  {
    const Index corner = (c + static_cast<Index>(triangle.first)) % 3;
    place.point += near.coordinates[c] *
      this->Strip.surface.points.row(this->Strip.surface.triangles(place.triangle, corner));
  }
  return place;
}

StripPlace StripSearch::at(double v, double u) const
{
  const double base = v - std::floor(v);
  for (int turn = this->Least; turn <= this->Most; ++turn)
  {
    const PlaneTriangulation::Point q = { base + turn, u };
    const std::uint32_t found = lowestTriangleAt(this->Plane, this->Boxes, q);
    if (found != PlaneTriangulation::None)
    {
      return this->onTriangle(found, q);
    }
  }
  // On a rounded edge, or where triangles are flipped: the nearest one.
  StripPlace best;
  double least = std::numeric_limits<double>::infinity();
  for (int turn = this->Least; turn <= this->Most; ++turn)
  {
    const PlaneTriangulation::Point q = { base + turn, u };
    const std::uint32_t found = nearestTriangle(this->Plane, this->Boxes, q);
    const PlaneTriangulation::Triangle& triangle = this->Plane.triangle(found);
    const double distance = nearestPointOn(this->Plane.point(triangle.corners[0]),
      this->Plane.point(triangle.corners[1]), this->Plane.point(triangle.corners[2]), q)
                              .distance;
    if (distance < least)
    {
      least = distance;
      best = this->onTriangle(found, q);
    }
  }
  return best;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/IntrinsicDelaunay.h"

#include "Core/Common/Errors.h"
#include "Core/Surfaces/HalfEdgeTriangles.h"
#include "Core/Surfaces/TriangleCrossings.h"
#include "Core/Surfaces/TriangleUnfolding.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>

namespace hexsweep
{
namespace
{
using Plane = Eigen::RowVector2d;

/// Sums of two cotangents this small, relative to their size (at least 1, for cocircular right
/// angles), are rounding: a tie, which any flip would only leave a tie.
constexpr double RelativeRounding = 1e-10;

/// Termination is proved for exact numbers only; no triangulation was seen to need a tenth of it.
constexpr Index GreatestFlipsPerEdge = 1000;

/// Triangles that are glued along half-edges and lie each in a plane of its own.
class UnfoldedTriangles
{
public:
  UnfoldedTriangles(const PointsRef& points, const TrianglesRef& triangles)
    : Connectivity(triangles)
    , Places(static_cast<std::size_t>(triangles.size()))
    , Crossings(static_cast<std::size_t>(triangles.size()), 0)
    , OnMeshEdge(static_cast<std::size_t>(triangles.size()), true)
  {
    for (Index t = 0; t < triangles.rows(); ++t)
    {
      const Eigen::RowVector3d u = points.row(triangles(t, 1)) - points.row(triangles(t, 0));
      const Eigen::RowVector3d v = points.row(triangles(t, 2)) - points.row(triangles(t, 0));
      const double length = u.norm();
      const double area = u.cross(v).norm();
      if (!(area > 0.0) || !std::isfinite(area))
      {
        throw InvalidInput("triangle " + std::to_string(t) +
          " has no area, so that no angle is defined. Remove degenerate triangles (in ParaView: "
          "Clean) or triangulate again.");
      }
      this->place(3 * t) = Plane::Zero();
      this->place(3 * t + 1) = Plane(length, 0.0);
      this->place(3 * t + 2) = Plane(u.dot(v) / length, area / length);
    }
  }

  /// Cotangent of the angle across from a half-edge, in its triangle.
  double cotangent(Index half) const
  {
    const Plane& apex = this->place(HalfEdgeTriangles::previous(half));
    const Plane u = this->place(half) - apex;
    const Plane v = this->place(HalfEdgeTriangles::next(half)) - apex;
    return u.dot(v) / cross(u, v);
  }

  double length(Index half) const
  {
    return (this->place(HalfEdgeTriangles::next(half)) - this->place(half)).norm();
  }

  bool isDelaunay(Index half) const
  {
    const Index other = this->Connectivity.twin(half);
    if (other < 0 || other / 3 == half / 3)
    {
      return true;
    }
    const double p = this->cotangent(half);
    const double q = this->cotangent(other);
    return !(p + q < -RelativeRounding * (1.0 + std::abs(p) + std::abs(q)));
  }

  /// False, and nothing changed, where rounding would leave a triangle without area.
  bool flip(Index half)
  {
    const Index other = this->Connectivity.twin(half);
    const Plane a = this->place(half);
    const Plane b = this->place(HalfEdgeTriangles::next(half));
    const Plane c = this->place(HalfEdgeTriangles::previous(half));
    const Plane d = this->movedApex(other, b, a);
    if (!(cross(a - c, d - c) > 0.0) || !(cross(b - d, c - d) > 0.0))
    {
      return false;
    }
    const Index left = half - half % 3;
    const Index right = other - other % 3;
    this->flipCrossings(half, other);
    this->Connectivity.flip(half);
    const Plane leftPlaces[3] = { c, a, d };
    const Plane rightPlaces[3] = { d, b, c };
    for (Index i = 0; i < 3; ++i)
    {
      // Coordinates about a corner keep the digits of small triangles.
      this->place(left + i) = leftPlaces[i] - leftPlaces[0];
      this->place(right + i) = rightPlaces[i] - rightPlaces[0];
    }
    return true;
  }

  const Plane& corner(Index half) const { return this->place(half); }
  Index crossings(Index half) const { return this->Crossings[static_cast<std::size_t>(half)]; }

  HalfEdgeTriangles Connectivity;

private:
  /// Counts for the edge c d instead of a b, from the strands of mesh edges in both triangles.
  void flipCrossings(Index half, Index other)
  {
    const Index sides[4] = { HalfEdgeTriangles::previous(half), HalfEdgeTriangles::next(other),
      HalfEdgeTriangles::previous(other), HalfEdgeTriangles::next(half) };
    const TriangleCrossings left = triangleCrossings(
      this->crossings(half), this->crossings(sides[3]), this->crossings(sides[0]));
    const TriangleCrossings right = triangleCrossings(
      this->crossings(other), this->crossings(sides[1]), this->crossings(sides[2]));
    // The strands across a b in order from a: on the left the first go to c a, then some end in c,
    // the others go to b c; on the right to a d, d, d b.
    const Index leftFirst = left.around[0];
    const Index leftSecond = leftFirst + left.from[2];
    const Index rightFirst = right.around[1];
    const Index rightSecond = rightFirst + right.from[2];
    const Index across = std::max<Index>(0, leftFirst - rightSecond) +
      std::max<Index>(0, rightFirst - leftSecond) + left.around[2] + left.from[0] + left.from[1] +
      right.around[2] + right.from[0] + right.from[1] +
      (this->OnMeshEdge[static_cast<std::size_t>(half)] ? 1 : 0);
    const bool along =
      std::max(leftFirst, rightFirst) < std::min(leftSecond, rightSecond); // from c to d
    const Index leftStart = half - half % 3;
    const Index rightStart = other - other % 3;
    Index counts[4];
    bool flags[4];
    for (int i = 0; i < 4; ++i)
    {
      counts[i] = this->crossings(sides[i]);
      flags[i] = this->OnMeshEdge[static_cast<std::size_t>(sides[i])];
    }
    const Index after[4] = { leftStart, leftStart + 1, rightStart, rightStart + 1 };
    for (int i = 0; i < 4; ++i)
    {
      this->Crossings[static_cast<std::size_t>(after[i])] = counts[i];
      this->OnMeshEdge[static_cast<std::size_t>(after[i])] = flags[i];
    }
    for (const Index start : { leftStart, rightStart })
    {
      this->Crossings[static_cast<std::size_t>(start + 2)] = across;
      this->OnMeshEdge[static_cast<std::size_t>(start + 2)] = along;
    }
  }

  Plane& place(Index half) { return this->Places[static_cast<std::size_t>(half)]; }
  const Plane& place(Index half) const { return this->Places[static_cast<std::size_t>(half)]; }

  /// The apex of a half-edge once its triangle is moved so that the half-edge runs from b to a.
  Plane movedApex(Index half, const Plane& b, const Plane& a) const
  {
    return unfoldedApex({ this->place(half), this->place(HalfEdgeTriangles::next(half)),
                          this->place(HalfEdgeTriangles::previous(half)) },
      b, a);
  }

  std::vector<Plane> Places; // of the corner that each half-edge starts from
  std::vector<Index> Crossings;
  std::vector<bool> OnMeshEdge; // whether the edge is one of the mesh
};
}

IntrinsicTriangulation intrinsicDelaunay(const PointsRef& points, const TrianglesRef& triangles)
{
  UnfoldedTriangles unfolded(points, triangles);
  const Index halves = unfolded.Connectivity.numberOfHalfEdges();
  IntrinsicTriangulation result;
  std::vector<Index> open;
  for (Index start = 0; start < halves; ++start)
  {
    open.push_back(start);
    while (!open.empty() && result.flips < GreatestFlipsPerEdge * halves)
    {
      const Index half = open.back();
      open.pop_back();
      const Index other = unfolded.Connectivity.twin(half);
      if (!unfolded.isDelaunay(half) && unfolded.flip(half))
      {
        ++result.flips;
        const Index left = half - half % 3;
        const Index right = other - other % 3;
        open.insert(open.end(), { left, left + 1, right, right + 1 });
      }
    }
  }
  result.triangles = unfolded.Connectivity.triangles();
  result.edgeLengths.resize(triangles.rows(), 3);
  result.cotangents.resize(triangles.rows(), 3);
  result.twins.resize(triangles.rows(), 3);
  result.crossings.resize(triangles.rows(), 3);
  result.corners.resize(halves, 2);
  for (Index half = 0; half < halves; ++half)
  {
    result.edgeLengths(half / 3, half % 3) = unfolded.length(half);
    result.twins(half / 3, half % 3) = unfolded.Connectivity.twin(half);
    result.crossings(half / 3, half % 3) = unfolded.crossings(half);
    result.corners.row(half) = unfolded.corner(half);
    result.cotangents(half / 3, HalfEdgeTriangles::previous(half) % 3) = unfolded.cotangent(half);
  }
  return result;
}
}

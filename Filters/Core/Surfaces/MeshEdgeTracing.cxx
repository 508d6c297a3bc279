// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/MeshEdgeTracing.h"

#include "Core/Surfaces/HalfEdgeTriangles.h"
#include "Core/Surfaces/TriangleCrossings.h"
#include "Core/Surfaces/TriangleUnfolding.h"

#include <algorithm>
#include <utility>

namespace hexsweep
{
namespace
{
using Plane = Eigen::RowVector2d;

/// Follows mesh edges through intrinsic triangles.
class EdgeTracer
{
public:
  explicit EdgeTracer(const IntrinsicTriangulation& intrinsic)
    : Intrinsic(intrinsic)
  {
  }

  /// All mesh edges that cross an intrinsic one, each from its lower to its higher point id.
  std::vector<TracedEdge> trace() const
  {
    std::vector<TracedEdge> traced;
    for (Index t = 0; t < this->Intrinsic.triangles.rows(); ++t)
    {
      const TriangleCrossings inside = this->inside(t);
      for (Index c = 0; c < 3; ++c)
      {
        for (Index k = 0; k < inside.from[c]; ++k)
        {
          const Index opposite = 3 * t + (c + 1) % 3;
          TracedEdge edge = this->follow(3 * t + c, opposite, inside.around[(c + 1) % 3] + k);
          if (edge.from < edge.to)
          {
            traced.push_back(std::move(edge));
          }
        }
      }
    }
    return traced;
  }

private:
  Index vertex(Index half) const { return this->Intrinsic.triangles(half / 3, half % 3); }
  Index crossings(Index half) const { return this->Intrinsic.crossings(half / 3, half % 3); }
  TriangleCrossings inside(Index t) const
  {
    const auto& n = this->Intrinsic.crossings;
    return triangleCrossings(n(t, 0), n(t, 1), n(t, 2));
  }

  /// From a corner across a half-edge as the one at this position, counted from its start.
  TracedEdge follow(Index corner, Index half, Index position) const
  {
    TracedEdge edge{ this->vertex(corner), -1, {} };
    // Unfolded about the corner that the edge starts from.
    const Plane start = this->Intrinsic.corners.row(corner);
    std::vector<std::pair<Plane, Plane>> gates;
    Plane a = Plane(this->Intrinsic.corners.row(half)) - start;
    Plane b = Plane(this->Intrinsic.corners.row(HalfEdgeTriangles::next(half))) - start;
    Plane end = Plane::Zero();
    for (;;)
    {
      edge.crossings.push_back({ half, 0.0, 0.0 });
      gates.emplace_back(a, b);
      const Index other = this->Intrinsic.twins(half / 3, half % 3);
      const Plane apex = this->movedApex(other, b, a);
      const Index place = this->crossings(other) - 1 - position; // counted from b
      const TriangleCrossings inside = this->inside(other / 3);
      const Index c = other % 3;
      const Index first = inside.around[c];
      const Index second = first + inside.from[(c + 2) % 3];
      if (place >= first && place < second)
      {
        edge.to = this->vertex(HalfEdgeTriangles::previous(other));
        end = apex;
        break;
      }
      if (place < first) // round b, across the half-edge from the apex to b
      {
        half = HalfEdgeTriangles::previous(other);
        position = this->crossings(half) - 1 - place;
        a = apex;
      }
      else // round a, across the half-edge from a to the apex
      {
        half = HalfEdgeTriangles::next(other);
        position = this->crossings(other) - 1 - place;
        b = apex;
      }
    }
    this->intersect(edge, gates, end);
    return edge;
  }

  /// Intersections of the straight line from the origin with the gates, in strict order.
  void intersect(
    TracedEdge& edge, const std::vector<std::pair<Plane, Plane>>& gates, const Plane& end) const
  {
    double last = 0.0;
    for (std::size_t g = 0; g < gates.size(); ++g)
    {
      const auto& [a, b] = gates[g];
      const double left = cross(end, b);
      const double right = cross(end, a);
      const double alongHalf = std::clamp(right / (right - left), 0.0, 1.0);
      const Plane place = a + alongHalf * (b - a);
      double along = place.dot(end) / end.squaredNorm();
      const double remaining = static_cast<double>(gates.size() - g);
      if (!(along > last) || !(along < 1.0))
      {
        along = last + (1.0 - last) / (remaining + 1.0);
      }
      edge.crossings[g].along = last = along;
      edge.crossings[g].alongHalf = alongHalf;
    }
  }

  /// The apex of a half-edge once its triangle is moved so that the half-edge runs from b to a.
  Plane movedApex(Index half, const Plane& b, const Plane& a) const
  {
    const auto& corners = this->Intrinsic.corners;
    return unfoldedApex({ corners.row(half), corners.row(HalfEdgeTriangles::next(half)),
                          corners.row(HalfEdgeTriangles::previous(half)) },
      b, a);
  }

  const IntrinsicTriangulation& Intrinsic;
};
}

std::vector<TracedEdge> traceMeshEdges(const IntrinsicTriangulation& intrinsic)
{
  return EdgeTracer(intrinsic).trace();
}
}

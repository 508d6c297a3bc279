// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A triangulation of the plane, renumbered along Hilbert's curve, with its neighbours.
 */
#ifndef hexsweep_PlaneTriangulation_h
#define hexsweep_PlaneTriangulation_h

#include "Core/Geometry/HilbertOrder.h"

#include <memory>

namespace hexsweep
{
/**
 * The positively oriented triangles of a mesh of the plane, in compact arrays.
 *
 * Vertices lie in the order of the curve, triangles in that of their lowest vertices. A side of a
 * triangle (its corners c and c + 1) has the number 4 triangle + c.
 */
class PlaneTriangulation
{
public:
  struct Point
  {
    double x;
    double y;

    Eigen::RowVector2d row() const { return { this->x, this->y }; }
  };

  /// What the walk reads of one triangle, half a cache line.
  struct alignas(32) Triangle
  {
    std::uint32_t corners[3]; ///< counter-clockwise, the lowest first
    std::uint32_t id;         ///< row of the input
    std::uint32_t across[3];  ///< across[c]: the same edge as a side of the neighbour, or None
    std::uint32_t first;      ///< which corner of the input corners[0] was
  };

  static constexpr std::uint32_t None = 0xffffffffu;

  /**
   * @param points    n x 2.
   * @param triangles m x 3. Triangles that are not positively oriented (by exact signs) are left
   *                  out. No neighbour is known where more than two sides meet or two sides of an
   *                  edge run the same way.
   * @throw InvalidInput when a triangle names a point that does not exist, or for meshes of 2^30
   *        triangles and more.
   */
  PlaneTriangulation(const PlanePointsRef& points, const TrianglesRef& triangles);

  std::uint32_t numberOfTriangles() const { return this->NumberOfTriangles; }
  const Triangle& triangle(std::uint32_t t) const { return this->Cells[t]; }
  const Point& point(std::uint32_t v) const { return this->Places[v]; }

  const HilbertCurve& curve() const { return this->Curve; }
  /// Keys of the vertices, rising.
  const std::vector<CurvePlace>& order() const { return this->Order; }
  /// A triangle near vertex v (v may be the number of vertices); there must be triangles.
  std::uint32_t triangleNear(std::size_t v) const
  {
    const std::uint32_t t = this->FirstTriangle[v];
    return t < this->NumberOfTriangles ? t : this->NumberOfTriangles - 1;
  }

  /// Rows of the input that are flipped (negative, not zero area), in the order of the curve.
  const std::vector<Index>& flipped() const { return this->Flipped; }

private:
  void sortTriangles(const TrianglesRef& triangles);
  void linkPositive();

  HilbertCurve Curve;
  std::vector<CurvePlace> Order;
  // Arrays of this size cost more by being cleared than by being filled.
  std::unique_ptr<Point[]> Places;
  std::unique_ptr<Triangle[]> Cells;
  std::vector<std::uint32_t> FirstTriangle; // by lowest vertex; one more entry than vertices
  std::uint32_t NumberOfTriangles = 0;
  std::vector<Index> Flipped;
};
}

#endif

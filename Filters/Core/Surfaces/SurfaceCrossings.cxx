// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SurfaceCrossings.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace hexsweep
{
namespace
{
using Point = Eigen::RowVector3d;
using Box = Eigen::AlignedBox3d;

/// Of the longest edge: how deep triangles must reach into each other.
constexpr double Clear = 1e-6;

struct Triangle
{
  std::array<Point, 3> corners;
  Point normal; // unit
  double longest;
};

Triangle triangleAt(const TriangleMesh& surface, Index t)
{
  Triangle triangle;
  for (int c = 0; c < 3; ++c)
  {
    triangle.corners[static_cast<std::size_t>(c)] = surface.points.row(surface.triangles(t, c));
  }
  const auto& p = triangle.corners;
  triangle.normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
  triangle.longest = std::max({ (p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm() });
  return triangle;
}

/// The smallest share of a triangle's height over each side at which a point of its plane lies.
double depthInside(const Triangle& triangle, const Point& p)
{
  const auto& c = triangle.corners;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Point edge = c[(i + 1) % 3] - c[i];
    const Point inward = triangle.normal.cross(edge);
    least = std::min(least, (p - c[i]).dot(inward) / (c[(i + 2) % 3] - c[i]).dot(inward));
  }
  return least;
}

/// Where an edge of one triangle goes through the other one.
std::optional<Point> pierced(const Triangle& edges, const Triangle& face)
{
  const double depth = Clear * std::min(edges.longest, face.longest);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Point& a = edges.corners[i];
    const Point& b = edges.corners[(i + 1) % 3];
    const double above = (a - face.corners[0]).dot(face.normal);
    const double below = (b - face.corners[0]).dot(face.normal);
    if (std::min(above, below) < -depth && std::max(above, below) > depth)
    {
      const Point place = a + above / (above - below) * (b - a);
      if (depthInside(face, place) > Clear)
      {
        return place;
      }
    }
  }
  return std::nullopt;
}

/// A common point of triangles in one plane that overlap.
std::optional<Point> overlap(const Triangle& first, const Triangle& second)
{
  const double depth = Clear * std::min(first.longest, second.longest);
  for (const Point& corner : second.corners)
  {
    if (std::abs((corner - first.corners[0]).dot(first.normal)) > depth)
    {
      return std::nullopt;
    }
  }
  // No side of either separates them.
  const auto reach = [](const Triangle& triangle, const Point& axis) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Point& corner : triangle.corners)
    {
      low = std::min(low, corner.dot(axis));
      high = std::max(high, corner.dot(axis));
    }
    return std::make_pair(low, high);
  };
  for (const Triangle* triangle : { &first, &second })
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Point edge = triangle->corners[(i + 1) % 3] - triangle->corners[i];
      const Point axis = first.normal.cross(edge).normalized();
      const auto [low, high] = reach(first, axis);
      const auto [otherLow, otherHigh] = reach(second, axis);
      if (std::min(high, otherHigh) - std::max(low, otherLow) <= depth)
      {
        return std::nullopt;
      }
    }
  }
  const auto middle = [](const Triangle& triangle) -> Point {
    return (triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3.0;
  };
  return 0.5 * (middle(first) + middle(second));
}

std::optional<Point> crossingOf(const Triangle& first, const Triangle& second)
{
  if (std::optional<Point> place = pierced(first, second))
  {
    return place;
  }
  if (std::optional<Point> place = pierced(second, first))
  {
    return place;
  }
  return overlap(first, second);
}

/// Boxes of triangles, halved again and again at the median of the longest side.
class BoxHierarchy
{
public:
  explicit BoxHierarchy(const std::vector<Box>& boxes)
    : Order(boxes.size())
  {
    std::iota(this->Order.begin(), this->Order.end(), Index{ 0 });
    this->build(boxes, 0, this->Order.size());
  }

  /// Calls visit(a, b), a < b, once for each pair of leaves' triangles whose boxes meet.
  template <typename Visit>
  void forEachPair(const Visit& visit) const
  {
    std::vector<std::pair<std::size_t, std::size_t>> open{ { 0, 0 } };
    while (!open.empty())
    {
      const auto [a, b] = open.back();
      open.pop_back();
      const Node& first = this->Nodes[a];
      const Node& second = this->Nodes[b];
      if (!first.box.intersects(second.box))
      {
        continue;
      }
      if (first.right == 0 && second.right == 0)
      {
        this->visitLeaves(a, b, visit);
      }
      else if (a == b)
      {
        open.insert(
          open.end(), { { a + 1, a + 1 }, { first.right, first.right }, { a + 1, first.right } });
      }
      else if (second.right == 0 ||
        (first.right != 0 && first.end - first.begin >= second.end - second.begin))
      {
        open.insert(open.end(), { { a + 1, b }, { first.right, b } });
      }
      else
      {
        open.insert(open.end(), { { a, b + 1 }, { a, second.right } });
      }
    }
  }

private:
  static constexpr std::size_t LeafSize = 4;
  struct Node
  {
    Box box;
    std::size_t begin; // first triangle in Order
    std::size_t end;   // one past the last
    std::size_t right; // right child; the left one follows its parent; 0 in a leaf
  };

  std::size_t build(const std::vector<Box>& boxes, std::size_t begin, std::size_t end)
  {
    const std::size_t self = this->Nodes.size();
    Box box;
    for (std::size_t i = begin; i < end; ++i)
    {
      box.extend(boxes[static_cast<std::size_t>(this->Order[i])]);
    }
    this->Nodes.push_back({ box, begin, end, 0 });
    if (end - begin > LeafSize)
    {
      Eigen::Index axis = 0;
      box.sizes().maxCoeff(&axis);
      const std::size_t middle = begin + (end - begin) / 2;
      const auto at = [&](std::size_t i) {
        return this->Order.begin() + static_cast<std::ptrdiff_t>(i);
      };
      std::nth_element(at(begin), at(middle), at(end), [&](Index a, Index b) {
        const double left = boxes[static_cast<std::size_t>(a)].center()[axis];
        const double right = boxes[static_cast<std::size_t>(b)].center()[axis];
        return left != right ? left < right : a < b;
      });
      this->build(boxes, begin, middle);
      const std::size_t right = this->build(boxes, middle, end);
      this->Nodes[self].right = right;
    }
    return self;
  }

  template <typename Visit>
  void visitLeaves(std::size_t a, std::size_t b, const Visit& visit) const
  {
    for (std::size_t i = this->Nodes[a].begin; i < this->Nodes[a].end; ++i)
    {
      for (std::size_t j = a == b ? i + 1 : this->Nodes[b].begin; j < this->Nodes[b].end; ++j)
      {
        visit(std::min(this->Order[i], this->Order[j]), std::max(this->Order[i], this->Order[j]));
      }
    }
  }

  std::vector<Index> Order;
  std::vector<Node> Nodes;
};
}

std::optional<SurfaceCrossing> findCrossing(const TriangleMesh& surface)
{
  if (surface.triangles.rows() == 0)
  {
    return std::nullopt;
  }
  std::vector<Triangle> triangles;
  std::vector<Box> boxes;
  for (Index t = 0; t < surface.triangles.rows(); ++t)
  {
    triangles.push_back(triangleAt(surface, t));
    Box box;
    for (const Point& corner : triangles.back().corners)
    {
      box.extend(corner.transpose());
    }
    boxes.push_back(box);
  }
  std::optional<SurfaceCrossing> found;
  BoxHierarchy(boxes).forEachPair([&](Index a, Index b) {
    const bool isLower =
      !found || std::make_pair(a, b) < std::make_pair(found->first, found->second);
    if (!isLower ||
      !boxes[static_cast<std::size_t>(a)].intersects(boxes[static_cast<std::size_t>(b)]))
    {
      return;
    }
    if (const std::optional<Point> place = crossingOf(
          triangles[static_cast<std::size_t>(a)], triangles[static_cast<std::size_t>(b)]))
    {
      found = SurfaceCrossing{ a, b, *place };
    }
  });
  return found;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CornerFans.h"

#include "Core/CapQuads/RemeshingMesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace hexsweep
{
namespace
{
/// See triangleShape(): flatter triangles are no improvement.
constexpr double LeastShape = 0.1;

/// A triangle at a node: the other corners follow the node the way the triangle is oriented.
struct FanTriangle
{
  Index row;
  Index first;
  Index second;
  double angle; ///< at the node
};

class Fan
{
public:
  Fan(TriangleMesh& mesh, Index node, const std::vector<std::pair<Index, Index>>& kept,
    const SurfaceSearch& surface)
    : Mesh(mesh)
    , Node(node)
    , Kept(kept)
    , Surface(surface)
  {
    this->collect();
  }

  std::size_t size() const { return this->Fans.size(); }

  /// One triangle more.
  void open()
  {
    const FanTriangle widest = *std::max_element(this->Fans.begin(), this->Fans.end(),
      [](const FanTriangle& a, const FanTriangle& b) { return a.angle < b.angle; });
    const std::pair<Index, Index> edge = std::minmax(widest.first, widest.second);
    const std::optional<Index> beyond = this->neighbor(widest);
    if (!beyond || std::binary_search(this->Kept.begin(), this->Kept.end(), edge))
    {
      this->cutAtCentroid(widest);
    }
    else if (!this->flip(widest, *beyond))
    {
      this->halve(widest, *beyond);
    }
    this->collect();
  }

  /// Edges that part the fan into `faces` of nearly equal angles.
  void part(Index faces, std::vector<std::pair<Index, Index>>& edges) const
  {
    double total = 0.0;
    for (const FanTriangle& triangle : this->Fans)
    {
      total += triangle.angle;
    }
    const std::size_t wanted = static_cast<std::size_t>(faces);
    std::size_t next = 0; // the edge behind triangle `next`
    double reached = this->Fans.empty() ? 0.0 : this->Fans[0].angle;
    for (std::size_t j = 1; j < wanted && next + 1 < this->Fans.size(); ++j)
    {
      const double goal = total * static_cast<double>(j) / static_cast<double>(faces);
      // Enough edges must be left for the faces to come.
      while (next + 1 + (wanted - j) < this->Fans.size() &&
        std::abs(reached + this->Fans[next + 1].angle - goal) < std::abs(reached - goal))
      {
        reached += this->Fans[++next].angle;
      }
      edges.emplace_back(std::minmax(this->Node, this->Fans[next].second));
      reached += this->Fans[++next].angle;
    }
  }

private:
  Eigen::RowVector3d point(Index i) const { return this->Mesh.points.row(i); }

  /// The triangles round the node in their order, from the boundary on.
  void collect()
  {
    std::vector<FanTriangle> found;
    for (Index t = 0; t < this->Mesh.triangles.rows(); ++t)
    {
      for (Index c = 0; c < 3; ++c)
      {
        if (this->Mesh.triangles(t, c) != this->Node)
        {
          continue;
        }
        const Index a = this->Mesh.triangles(t, (c + 1) % 3);
        const Index b = this->Mesh.triangles(t, (c + 2) % 3);
        const Eigen::RowVector3d u = this->point(a) - this->point(this->Node);
        const Eigen::RowVector3d v = this->point(b) - this->point(this->Node);
        found.push_back({ t, a, b, std::atan2(u.cross(v).norm(), u.dot(v)) });
      }
    }
    this->Fans.clear();
    const auto takeFrom = [&](const auto& isNext) {
      const auto next = std::find_if(found.begin(), found.end(), isNext);
      if (next == found.end())
      {
        return false;
      }
      this->Fans.push_back(*next);
      found.erase(next);
      return true;
    };
    takeFrom([&](const FanTriangle& first) {
      return std::none_of(found.begin(), found.end(),
        [&](const FanTriangle& other) { return other.second == first.first; });
    });
    while (!this->Fans.empty() &&
      takeFrom([&](const FanTriangle& next) { return next.first == this->Fans.back().second; }))
    {
    }
  }

  std::optional<Index> neighbor(const FanTriangle& triangle) const
  {
    for (Index t = 0; t < this->Mesh.triangles.rows(); ++t)
    {
      for (Index c = 0; c < 3; ++c)
      {
        if (this->Mesh.triangles(t, c) == triangle.second &&
          this->Mesh.triangles(t, (c + 1) % 3) == triangle.first)
        {
          return t;
        }
      }
    }
    return std::nullopt;
  }

  Index apex(const FanTriangle& triangle, Index beyond) const
  {
    Index c = 0;
    while (this->Mesh.triangles(beyond, c) == triangle.first ||
      this->Mesh.triangles(beyond, c) == triangle.second)
    {
      ++c;
    }
    return this->Mesh.triangles(beyond, c);
  }

  double shape(Index a, Index b, Index c) const
  {
    const Eigen::RowVector3d middle = (this->point(a) + this->point(b) + this->point(c)) / 3.0;
    return triangleShape(
      this->point(a), this->point(b), this->point(c), this->Surface.project(middle).normals.row(0));
  }

  void set(Index row, Index a, Index b, Index c) { this->Mesh.triangles.row(row) << a, b, c; }

  void append(Index a, Index b, Index c)
  {
    const Index row = this->Mesh.triangles.rows();
    this->Mesh.triangles.conservativeResize(row + 1, 3);
    this->set(row, a, b, c);
  }

  Index appendPoint(const Eigen::RowVector3d& place)
  {
    const Index id = this->Mesh.points.rows();
    this->Mesh.points.conservativeResize(id + 1, 3);
    this->Mesh.points.row(id) = this->Surface.project(place).points.row(0);
    return id;
  }

  bool flip(const FanTriangle& triangle, Index beyond)
  {
    const Index far = this->apex(triangle, beyond);
    if (this->shape(this->Node, triangle.first, far) < LeastShape ||
      this->shape(this->Node, far, triangle.second) < LeastShape)
    {
      return false;
    }
    this->set(triangle.row, this->Node, triangle.first, far);
    this->set(beyond, this->Node, far, triangle.second);
    return true;
  }

  void halve(const FanTriangle& triangle, Index beyond)
  {
    const Index far = this->apex(triangle, beyond);
    const Index middle =
      this->appendPoint(0.5 * (this->point(triangle.first) + this->point(triangle.second)));
    this->set(triangle.row, this->Node, triangle.first, middle);
    this->append(this->Node, middle, triangle.second);
    this->set(beyond, far, middle, triangle.first);
    this->append(far, triangle.second, middle);
  }

  void cutAtCentroid(const FanTriangle& triangle)
  {
    const Index middle = this->appendPoint(
      (this->point(this->Node) + this->point(triangle.first) + this->point(triangle.second)) / 3.0);
    this->set(triangle.row, this->Node, triangle.first, middle);
    this->append(this->Node, middle, triangle.second);
    this->append(triangle.first, triangle.second, middle);
  }

  TriangleMesh& Mesh;
  Index Node;
  const std::vector<std::pair<Index, Index>>& Kept;
  const SurfaceSearch& Surface;
  std::vector<FanTriangle> Fans;
};
}

std::vector<std::pair<Index, Index>> openCornerFans(TriangleMesh& mesh,
  const std::vector<CornerFan>& fans, const std::vector<std::pair<Index, Index>>& kept,
  const SurfaceSearch& surface)
{
  std::vector<std::pair<Index, Index>> sorted = kept;
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::pair<Index, Index>> parted;
  for (const CornerFan& wanted : fans)
  {
    Index node = 0;
    while (node < mesh.points.rows() && mesh.points.row(node) != wanted.place)
    {
      ++node;
    }
    if (node == mesh.points.rows())
    {
      continue;
    }
    Fan fan(mesh, node, sorted, surface);
    while (fan.size() > 0 && fan.size() < static_cast<std::size_t>(wanted.faces))
    {
      fan.open();
    }
    fan.part(wanted.faces, parted);
    // What one fan is parted by, another must not flip away.
    sorted.insert(sorted.end(), parted.begin(), parted.end());
    std::sort(sorted.begin(), sorted.end());
  }
  return parted;
}
}

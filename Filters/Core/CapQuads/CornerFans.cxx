// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CornerFans.h"

#include "Core/CapQuads/RemeshingMesh.h"
#include "Core/Surfaces/HalfEdgeTriangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
/// See triangleShape(): flatter triangles are no improvement.
constexpr double LeastShape = 0.1;

/// A triangle at a node, by its half-edge across from it.
struct FanTriangle
{
  Index half;
  double angle; ///< at the node
};

class Fan
{
public:
  Fan(TriangleMesh& mesh, HalfEdgeTriangles& connectivity, Index node,
    const std::vector<std::pair<Index, Index>>& kept, const SurfaceSearch& surface)
    : Mesh(mesh)
    , Connectivity(connectivity)
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
    const Index half = std::max_element(
      this->Fans.begin(), this->Fans.end(), [](const FanTriangle& a, const FanTriangle& b) {
        return a.angle < b.angle;
      })->half;
    const std::pair<Index, Index> edge =
      std::minmax({ this->Connectivity.from(half), this->Connectivity.to(half) });
    if (this->Connectivity.twin(half) < 0 ||
      std::binary_search(this->Kept.begin(), this->Kept.end(), edge))
    {
      this->cutAtCentroid(half);
    }
    else if (!this->flip(half))
    {
      this->Connectivity.splitEdge(
        half, this->appendPoint(0.5 * (this->point(edge.first) + this->point(edge.second))));
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
      edges.emplace_back(std::minmax({ this->Node, this->Connectivity.to(this->Fans[next].half) }));
      reached += this->Fans[++next].angle;
    }
  }

private:
  Eigen::RowVector3d point(Index i) const { return this->Mesh.points.row(i); }

  /// The triangles round the node in their order, from the boundary on.
  void collect()
  {
    this->Fans.clear();
    Index spoke = 0;
    while (spoke < this->Connectivity.numberOfHalfEdges() &&
      (this->Connectivity.from(spoke) != this->Node || this->Connectivity.twin(spoke) >= 0))
    {
      ++spoke;
    }
    if (spoke == this->Connectivity.numberOfHalfEdges())
    {
      return;
    }
    while (spoke >= 0)
    {
      const Index half = HalfEdgeTriangles::next(spoke);
      const Eigen::RowVector3d u =
        this->point(this->Connectivity.from(half)) - this->point(this->Node);
      const Eigen::RowVector3d v =
        this->point(this->Connectivity.to(half)) - this->point(this->Node);
      this->Fans.push_back({ half, std::atan2(u.cross(v).norm(), u.dot(v)) });
      spoke = this->Connectivity.twin(HalfEdgeTriangles::previous(spoke));
    }
  }

  double shape(Index a, Index b, Index c) const
  {
    const Eigen::RowVector3d middle = (this->point(a) + this->point(b) + this->point(c)) / 3.0;
    return triangleShape(
      this->point(a), this->point(b), this->point(c), this->Surface.project(middle).normals.row(0));
  }

  Index appendPoint(const Eigen::RowVector3d& place)
  {
    const Index id = this->Mesh.points.rows();
    this->Mesh.points.conservativeResize(id + 1, 3);
    this->Mesh.points.row(id) = this->Surface.project(place).points.row(0);
    return id;
  }

  bool flip(Index half)
  {
    const Index far = this->Connectivity.apex(this->Connectivity.twin(half));
    if (this->shape(this->Node, this->Connectivity.from(half), far) < LeastShape ||
      this->shape(this->Node, far, this->Connectivity.to(half)) < LeastShape)
    {
      return false;
    }
    this->Connectivity.flip(half);
    return true;
  }

  void cutAtCentroid(Index half)
  {
    const Index middle =
      this->appendPoint((this->point(this->Node) + this->point(this->Connectivity.from(half)) +
                          this->point(this->Connectivity.to(half))) /
        3.0);
    this->Connectivity.splitTriangle(half / 3, middle);
  }

  TriangleMesh& Mesh;
  HalfEdgeTriangles& Connectivity;
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
  std::vector<std::pair<Index, Index>> parted;
  if (fans.empty())
  {
    return parted;
  }
  std::vector<std::pair<Index, Index>> sorted = kept;
  std::sort(sorted.begin(), sorted.end());
  HalfEdgeTriangles connectivity(mesh.triangles);
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
    Fan fan(mesh, connectivity, node, sorted, surface);
    while (fan.size() > 0 && fan.size() < static_cast<std::size_t>(wanted.faces))
    {
      fan.open();
    }
    const std::size_t before = parted.size();
    fan.part(wanted.faces, parted);
    // What one fan is parted by, another must not flip away.
    sorted.insert(sorted.end(), parted.begin() + static_cast<std::ptrdiff_t>(before), parted.end());
    std::sort(sorted.begin(), sorted.end());
  }
  mesh.triangles = connectivity.triangles();
  return parted;
}
}

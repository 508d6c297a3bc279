// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/EdgeHalving.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Surfaces/HalfEdgeTriangles.h"
#include "Core/Surfaces/SurfaceArea.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace hexsweep
{
namespace
{
constexpr double MostTriangles = 50e6;
/// For each triangle of one size that is wanted: more than real sides that are made of slender
/// triangles have, and few enough for some seconds' work.
constexpr double MostSlender = 50.0;
/// A slender triangle becomes three with half its longest edge: the logarithm of 3 to base 2.
constexpr double SlenderPower = 1.584962500721156;

/// Of the triangles with an edge that is longer, those edges to the power of SlenderPower, summed.
double slenderness(const TriangleMesh& mesh, double longest)
{
  double sum = 0.0;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    double length = 0.0;
    for (Index c = 0; c < 3; ++c)
    {
      length = std::max(length,
        (mesh.points.row(mesh.triangles(t, c)) - mesh.points.row(mesh.triangles(t, (c + 1) % 3)))
          .norm());
    }
    sum += length > longest ? std::pow(length, SlenderPower) : 0.0;
  }
  return sum;
}

class Halving
{
public:
  explicit Halving(const TriangleMesh& mesh)
    : Connectivity(mesh.triangles)
  {
    for (Index i = 0; i < mesh.points.rows(); ++i)
    {
      this->Positions.emplace_back(mesh.points.row(i));
    }
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      this->Origin.push_back(t);
    }
  }

  const HalfEdgeTriangles& connectivity() const { return this->Connectivity; }

  double length(Index half) const
  {
    return (this->at(this->Connectivity.to(half)) - this->at(this->Connectivity.from(half))).norm();
  }

  /// Halves an edge. @return the number of half-edges before: later ones are new.
  Index halve(Index half)
  {
    const Index before = this->Connectivity.numberOfHalfEdges();
    const Index twin = this->Connectivity.twin(half);
    const Eigen::RowVector3d from = this->at(this->Connectivity.from(half));
    const Eigen::RowVector3d to = this->at(this->Connectivity.to(half));
    const Eigen::RowVector3d middle = 0.5 * (from + to);
    if (middle == from || middle == to)
    {
      // Its half would be as long, and halved for ever.
      throw InvalidInput("the edge from " + describe(from) + " to " + describe(to) +
        " cannot be halved: there is no number between its coordinates. Move the mesh nearer to "
        "the "
        "origin, or use a smaller unit.");
    }
    const Index vertex = static_cast<Index>(this->Positions.size());
    this->Positions.push_back(middle);
    this->Connectivity.splitEdge(half, vertex);
    this->Origin.push_back(this->Origin[static_cast<std::size_t>(half / 3)]);
    if (twin >= 0)
    {
      this->Origin.push_back(this->Origin[static_cast<std::size_t>(twin / 3)]);
    }
    return before;
  }

  HalvedSurface result() const
  {
    HalvedSurface result;
    result.mesh.points.resize(static_cast<Index>(this->Positions.size()), 3);
    for (std::size_t i = 0; i < this->Positions.size(); ++i)
    {
      result.mesh.points.row(static_cast<Index>(i)) = this->Positions[i];
    }
    result.mesh.triangles = this->Connectivity.triangles();
    result.triangleOrigin = this->Origin;
    return result;
  }

private:
  const Eigen::RowVector3d& at(Index i) const
  {
    return this->Positions[static_cast<std::size_t>(i)];
  }

  HalfEdgeTriangles Connectivity;
  std::vector<Eigen::RowVector3d> Positions;
  std::vector<Index> Origin;
};
}

double longestEdgeFor(const TriangleMesh& mesh, double triangles)
{
  const double area = surfaceArea(mesh);
  if (!(area > 0.0))
  {
    throw InvalidInput("the surface at " + describe(mesh.points.row(0)) +
      " has no area: all its triangles are slivers. Check its points, or mesh it again.");
  }
  const double byArea = std::sqrt(2.0 * area / triangles);
  const double bySlender =
    std::pow(slenderness(mesh, byArea) / (MostSlender * triangles), 1.0 / SlenderPower);
  return std::max(byArea, bySlender);
}

HalvedSurface halveLongEdges(const TriangleMesh& mesh, double longest)
{
  // Triangles with edges up to half as long have an eighth of the square's area or more, or are
  // slender.
  const double triangles = 8.0 * surfaceArea(mesh) / longest / longest +
    slenderness(mesh, longest) / std::pow(longest, SlenderPower);
  if (!(triangles <= MostTriangles))
  {
    throw InvalidInput("edges no longer than " + describe(longest) + " would make about " +
      describe(triangles) + " triangles of a surface with area " + describe(surfaceArea(mesh)) +
      ". Give a greater length.");
  }
  Halving halving(mesh);
  const HalfEdgeTriangles& edges = halving.connectivity();
  // Longest first; of equal ones that between the lowest points.
  using Entry = std::tuple<double, Index, Index, Index>;
  std::priority_queue<Entry> open;
  const auto push = [&](Index half) {
    const Index twin = edges.twin(half);
    const double length = halving.length(half);
    if (length > longest && (twin < 0 || half < twin))
    {
      open.emplace(length, -edges.from(half), -edges.to(half), half);
    }
  };
  for (Index half = 0; half < edges.numberOfHalfEdges(); ++half)
  {
    push(half);
  }
  while (!open.empty())
  {
    const auto [length, from, to, half] = open.top();
    open.pop();
    if (edges.from(half) != -from || edges.to(half) != -to)
    {
      continue; // cut since
    }
    const Index twin = edges.twin(half);
    const Index before = halving.halve(half);
    for (const Index side : { half, twin })
    {
      for (Index h = side < 0 ? 3 : 0; h < 3; ++h)
      {
        push(side / 3 * 3 + h);
        if (const Index other = edges.twin(side / 3 * 3 + h); other >= 0)
        {
          push(other);
        }
      }
    }
    for (Index h = before; h < edges.numberOfHalfEdges(); ++h)
    {
      push(h);
      if (const Index other = edges.twin(h); other >= 0)
      {
        push(other);
      }
    }
  }
  return halving.result();
}

HalvedSurface halveChords(
  const TriangleMesh& mesh, const std::function<bool(Index from, Index to)>& isChord)
{
  Halving halving(mesh);
  const HalfEdgeTriangles& edges = halving.connectivity();
  const Index points = mesh.points.rows();
  for (Index half = 0; half < edges.numberOfHalfEdges(); ++half)
  {
    const Index twin = edges.twin(half);
    const Index from = edges.from(half);
    const Index to = edges.to(half);
    if (twin >= 0 && from < points && to < points && isChord(from, to))
    {
      halving.halve(half);
    }
  }
  return halving.result();
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/PlaneTriangulation.h"

#include "Core/Common/Errors.h"
#include "Core/Common/Predicates.h"

#include <algorithm>
#include <string>
#include <utility>

namespace hexsweep
{
PlaneTriangulation::PlaneTriangulation(const PlanePointsRef& points, const TrianglesRef& triangles)
  : Curve(points)
  , Order(hilbertOrder(this->Curve, points))
  , Places(new Point[this->Order.size()])
{
  if (triangles.rows() >= (Index(1) << 30))
  {
    throw InvalidInput("there are " + std::to_string(triangles.rows()) +
      " triangles; at most 2^30 - 1 can be searched. Coarsen the mesh.");
  }
  for (std::size_t v = 0; v < this->Order.size(); ++v)
  {
    const Index row = static_cast<Index>(this->Order[v].id);
    this->Places[v] = { points(row, 0), points(row, 1) };
  }
  this->NumberOfTriangles = static_cast<std::uint32_t>(triangles.rows());
  this->sortTriangles(triangles);
  this->linkPositive();
}

/// Counting sort by the lowest vertex; the triangles of one keep the order of the input. Leaves in
/// FirstTriangle where the triangles of each vertex end.
void PlaneTriangulation::sortTriangles(const TrianglesRef& triangles)
{
  const std::size_t vertices = this->Order.size();
  const std::unique_ptr<std::uint32_t[]> rank(new std::uint32_t[vertices]);
  for (std::size_t v = 0; v < vertices; ++v)
  {
    rank[this->Order[v].id] = static_cast<std::uint32_t>(v);
  }
  const auto cornerOf = [&](std::uint32_t t, Index c) {
    return rank[static_cast<std::size_t>(triangles(static_cast<Index>(t), c))];
  };

  this->FirstTriangle.assign(vertices + 1, 0);
  for (std::uint32_t t = 0; t < this->NumberOfTriangles; ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index id = triangles(static_cast<Index>(t), c);
      if (id < 0 || id >= static_cast<Index>(vertices))
      {
        throw InvalidInput("triangle " + std::to_string(t) + " names point " + std::to_string(id) +
          ", which does not exist.");
      }
    }
    ++this->FirstTriangle[std::min({ cornerOf(t, 0), cornerOf(t, 1), cornerOf(t, 2) })];
  }
  std::uint32_t start = 0;
  for (std::uint32_t& count : this->FirstTriangle)
  {
    start += std::exchange(count, start);
  }

  this->Cells.reset(new Triangle[this->NumberOfTriangles]);
  for (std::uint32_t t = 0; t < this->NumberOfTriangles; ++t)
  {
    const std::uint32_t v[3] = { cornerOf(t, 0), cornerOf(t, 1), cornerOf(t, 2) };
    const std::uint32_t first = v[0] < v[1] ? (v[0] < v[2] ? 0 : 2) : (v[1] < v[2] ? 1 : 2);
    const std::uint32_t lowest = v[first];
    this->Cells[this->FirstTriangle[lowest]++] = {
      { lowest, v[(first + 1) % 3], v[(first + 2) % 3] }, t, { None, None, None }, first
    };
  }
}

/// Each edge is found at its lower vertex, where all its sides are met one after the other.
void PlaneTriangulation::linkPositive()
{
  const std::size_t vertices = this->Order.size();
  // Sides that join the two higher corners of their triangle wait at the lower of the two, in a
  // list that is chained through `across`.
  std::vector<std::uint32_t> waiting(vertices, None);
  struct Mark
  {
    std::uint32_t low;
    std::uint32_t side;
  };
  std::vector<Mark> marks(vertices, Mark{ None, None }); // by the higher vertex of an edge
  const auto across = [&](std::uint32_t side) -> std::uint32_t& {
    return this->Cells[side >> 2].across[side & 3];
  };
  const auto meet = [&](std::uint32_t low, std::uint32_t high, std::uint32_t side) {
    Mark& mark = marks[high];
    if (mark.low != low)
    {
      mark = { low, side };
      return;
    }
    const std::uint32_t other = mark.side;
    // A third side finds no partner, nor does one that runs the same way.
    if (other != None &&
      this->Cells[side >> 2].corners[side & 3] != this->Cells[other >> 2].corners[other & 3])
    {
      across(side) = other;
      across(other) = side;
      mark.side = None;
    }
  };

  std::uint32_t kept = 0;
  std::uint32_t begin = 0;
  for (std::uint32_t v = 0; v < vertices; ++v)
  {
    const std::uint32_t end = std::exchange(this->FirstTriangle[v], kept);
    for (std::uint32_t t = begin; t < end; ++t)
    {
      const auto& corners = this->Cells[t].corners;
      const int sign = orientation(
        this->Places[v].row(), this->Places[corners[1]].row(), this->Places[corners[2]].row());
      if (sign <= 0)
      {
        if (sign < 0)
        {
          this->Flipped.push_back(static_cast<Index>(this->Cells[t].id));
        }
        continue;
      }
      Triangle& triangle = this->Cells[kept];
      if (kept != t)
      {
        triangle = this->Cells[t];
      }
      meet(v, triangle.corners[1], 4 * kept);
      meet(v, triangle.corners[2], 4 * kept + 2);
      std::uint32_t& list = waiting[std::min(triangle.corners[1], triangle.corners[2])];
      triangle.across[1] = std::exchange(list, 4 * kept + 1);
      ++kept;
    }
    begin = end;
    for (std::uint32_t side = waiting[v]; side != None;)
    {
      const Triangle& triangle = this->Cells[side >> 2];
      const std::uint32_t next = std::exchange(across(side), None);
      meet(v, std::max(triangle.corners[1], triangle.corners[2]), side);
      side = next;
    }
  }
  this->FirstTriangle[vertices] = kept;
  this->NumberOfTriangles = kept;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/HalfEdgeTriangles.h"

#include "Core/Surfaces/SurfaceTopology.h"

namespace hexsweep
{
HalfEdgeTriangles::HalfEdgeTriangles(const TrianglesRef& triangles)
  : From(static_cast<std::size_t>(triangles.size()))
  , Twin(static_cast<std::size_t>(triangles.size()), -1)
{
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      this->From[static_cast<std::size_t>(3 * t + c)] = triangles(t, c);
    }
  }
  const Triangles neighbors = triangleNeighbors(triangles);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index neighbor = neighbors(t, c);
      for (Index half = 3 * neighbor; neighbor >= 0 && half < 3 * neighbor + 3; ++half)
      {
        if (this->from(half) == triangles(t, (c + 1) % 3) && this->to(half) == triangles(t, c))
        {
          this->Twin[static_cast<std::size_t>(3 * t + c)] = half;
        }
      }
    }
  }
}

Triangles HalfEdgeTriangles::triangles() const
{
  return Eigen::Map<const Triangles>(this->From.data(), this->numberOfTriangles(), 3);
}

void HalfEdgeTriangles::glue(Index half, Index other)
{
  this->Twin[static_cast<std::size_t>(half)] = other;
  if (other >= 0)
  {
    this->Twin[static_cast<std::size_t>(other)] = half;
  }
}

Index HalfEdgeTriangles::append(Index a, Index b, Index c)
{
  const Index first = this->numberOfHalfEdges();
  this->From.insert(this->From.end(), { a, b, c });
  this->Twin.insert(this->Twin.end(), 3, -1);
  return first;
}

void HalfEdgeTriangles::flip(Index half)
{
  const Index other = this->twin(half);
  const Index left = half - half % 3;
  const Index right = other - other % 3;
  const Index a = this->from(half);
  const Index b = this->to(half);
  const Index c = this->apex(half);
  const Index d = this->apex(other);
  // Sides of the quadrilateral and where they go; two of them may be twins of each other.
  const Index before[4] = { previous(half), next(other), previous(other), next(half) };
  const Index after[4] = { left, left + 1, right, right + 1 };
  Index outside[4];
  for (int i = 0; i < 4; ++i)
  {
    outside[i] = this->twin(before[i]);
    for (int j = 0; j < 4; ++j)
    {
      if (this->twin(before[i]) == before[j])
      {
        outside[i] = after[j];
      }
    }
  }
  const Index corners[6] = { c, a, d, d, b, c };
  for (Index i = 0; i < 3; ++i)
  {
    this->From[static_cast<std::size_t>(left + i)] = corners[i];
    this->From[static_cast<std::size_t>(right + i)] = corners[3 + i];
  }
  for (int i = 0; i < 4; ++i)
  {
    this->glue(after[i], outside[i]);
  }
  this->glue(left + 2, right + 2);
}

void HalfEdgeTriangles::splitEdge(Index half, Index vertex)
{
  const auto rewrite = [this](Index first, Index a, Index b, Index c) {
    this->From[static_cast<std::size_t>(first)] = a;
    this->From[static_cast<std::size_t>(first + 1)] = b;
    this->From[static_cast<std::size_t>(first + 2)] = c;
  };
  const Index other = this->twin(half);
  const Index a = this->from(half);
  const Index b = this->to(half);
  const Index c = this->apex(half);
  const Index left = half - half % 3;
  const Index bc = this->twin(next(half));
  const Index ca = this->twin(previous(half));
  rewrite(left, a, vertex, c);
  const Index newLeft = this->append(vertex, b, c);
  this->glue(left + 2, ca);
  this->glue(newLeft + 1, bc);
  this->glue(left + 1, newLeft + 2);
  if (other < 0)
  {
    this->glue(left, -1);
    return;
  }
  const Index d = this->apex(other);
  const Index right = other - other % 3;
  const Index ad = this->twin(next(other));
  const Index db = this->twin(previous(other));
  rewrite(right, vertex, a, d);
  const Index newRight = this->append(b, vertex, d);
  this->glue(right + 1, ad);
  this->glue(newRight + 2, db);
  this->glue(right + 2, newRight + 1);
  this->glue(left, right);
  this->glue(newLeft, newRight);
}

void HalfEdgeTriangles::splitTriangle(Index triangle, Index vertex)
{
  const Index first = 3 * triangle;
  const Index a = this->from(first);
  const Index b = this->from(first + 1);
  const Index c = this->from(first + 2);
  const Index bc = this->twin(first + 1);
  const Index ca = this->twin(first + 2);
  const Index second = this->append(b, c, vertex);
  const Index third = this->append(c, a, vertex);
  this->From[static_cast<std::size_t>(first + 2)] = vertex;
  this->glue(second, bc);
  this->glue(third, ca);
  this->glue(first + 1, second + 2);
  this->glue(second + 1, third + 2);
  this->glue(third + 1, first + 2);
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FlatFlips.h"

#include "Core/Common/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace hexsweep
{
namespace
{
/// Sums of two cotangents this small, relative to their size, are rounding.
constexpr double CotangentRounding = 1e-10;

/// Distance of four corners from one plane that counts as none, over the size of the cap.
constexpr double RelativeFlatness = 1e-13;

/// Termination is proved for exact numbers only.
constexpr Index GreatestFlipsPerHalfEdge = 1000;

std::uint64_t keyOf(Index a, Index b)
{
  const auto low = static_cast<std::uint64_t>(std::min(a, b));
  return low << 32 | static_cast<std::uint64_t>(std::max(a, b));
}
}

FlatFlips::FlatFlips(const TriangleMesh& mesh)
  : Connectivity(mesh.triangles)
{
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    this->Positions.emplace_back(mesh.points.row(i));
  }
  this->Outgoing.assign(this->Positions.size(), -1);
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    this->update(t);
  }
  const double size = (mesh.points.colwise().maxCoeff() - mesh.points.colwise().minCoeff()).norm();
  const double rounding =
    std::numeric_limits<double>::epsilon() * mesh.points.cwiseAbs().maxCoeff();
  this->Tolerance = std::max(RelativeFlatness * size, 4.0 * rounding);
}

TriangleMesh FlatFlips::mesh() const
{
  TriangleMesh result{ Points(this->numberOfPoints(), 3), this->Connectivity.triangles() };
  for (Index i = 0; i < this->numberOfPoints(); ++i)
  {
    result.points.row(i) = this->point(i);
  }
  return result;
}

double FlatFlips::cotangent(Index half, const Eigen::RowVector3d& apex) const
{
  const Eigen::RowVector3d u = this->point(this->Connectivity.from(half)) - apex;
  const Eigen::RowVector3d v = this->point(this->Connectivity.to(half)) - apex;
  return u.dot(v) / u.cross(v).norm();
}

double FlatFlips::cotangent(Index half) const
{
  return this->cotangent(half, this->point(this->Connectivity.apex(half)));
}

double FlatFlips::weight(Index half) const
{
  const Index other = this->Connectivity.twin(half);
  return this->cotangent(half) + (other < 0 ? 0.0 : this->cotangent(other));
}

bool FlatFlips::isFlat(Index half) const
{
  return this->isFlat(half, this->point(this->Connectivity.apex(half)));
}

bool FlatFlips::isCoplanar(Index half) const
{
  return this->isCoplanar(half, this->point(this->Connectivity.apex(half)));
}

bool FlatFlips::isCoplanar(Index half, const Eigen::RowVector3d& c) const
{
  const Eigen::RowVector3d& a = this->point(this->Connectivity.from(half));
  const Eigen::RowVector3d& b = this->point(this->Connectivity.to(half));
  const Eigen::RowVector3d& d = this->point(this->Connectivity.apex(this->Connectivity.twin(half)));
  const Eigen::RowVector3d across = (b - a).cross(d - c);
  const double length = across.norm();
  return length > 0.0 && std::abs((c - a).dot(across)) <= this->Tolerance * length;
}

bool FlatFlips::isFlat(Index half, const Eigen::RowVector3d& c) const
{
  const Index other = this->Connectivity.twin(half);
  if (other < 0 || !this->isCoplanar(half, c))
  {
    return false;
  }
  const Eigen::RowVector3d& a = this->point(this->Connectivity.from(half));
  const Eigen::RowVector3d& b = this->point(this->Connectivity.to(half));
  const Eigen::RowVector3d& d = this->point(this->Connectivity.apex(other));
  const Eigen::RowVector3d normals[4] = { (b - a).cross(c - a), (d - a).cross(b - a),
    (a - c).cross(d - c), (b - d).cross(c - d) };
  return normals[0].dot(normals[1]) > 0.0 && normals[2].dot(normals[0]) > 0.0 &&
    normals[2].dot(normals[1]) > 0.0 && normals[3].dot(normals[0]) > 0.0 &&
    normals[3].dot(normals[1]) > 0.0;
}

bool FlatFlips::wouldFlip(Index half, const Eigen::RowVector3d& apex) const
{
  const Index other = this->Connectivity.twin(half);
  if (other < 0 || this->isKept(half))
  {
    return false;
  }
  const double p = this->cotangent(half, apex);
  const double q = this->cotangent(other);
  return p + q < -CotangentRounding * (1.0 + std::abs(p) + std::abs(q)) && this->isFlat(half, apex);
}

bool FlatFlips::existsEdge(Index half, Index to) const
{
  // Round the start of the half-edge, both ways as far as the boundary lets.
  for (Index spoke = half;;)
  {
    if (this->Connectivity.to(spoke) == to || this->Connectivity.apex(spoke) == to)
    {
      return true;
    }
    const Index next = this->Connectivity.twin(HalfEdgeTriangles::previous(spoke));
    if (next == half)
    {
      return false;
    }
    if (next < 0)
    {
      break;
    }
    spoke = next;
  }
  for (Index spoke = this->Connectivity.twin(half); spoke >= 0;
       spoke = this->Connectivity.twin(HalfEdgeTriangles::next(spoke)))
  {
    if (this->Connectivity.apex(spoke) == to)
    {
      return true;
    }
  }
  return false;
}

void FlatFlips::flipFrom(std::vector<Index> open)
{
  while (!open.empty() &&
    this->NumberOfFlips < GreatestFlipsPerHalfEdge * this->Connectivity.numberOfHalfEdges())
  {
    const Index half = open.back();
    open.pop_back();
    const Index other = this->Connectivity.twin(half);
    if (!this->wouldFlip(half, this->point(this->Connectivity.apex(half))) ||
      this->existsEdge(HalfEdgeTriangles::previous(half), this->Connectivity.apex(other)))
    {
      continue;
    }
    this->Connectivity.flip(half);
    ++this->NumberOfFlips;
    this->update(half / 3);
    this->update(other / 3);
    const Index left = half - half % 3;
    const Index right = other - other % 3;
    open.insert(open.end(), { left, left + 1, right, right + 1 });
  }
}

void FlatFlips::flipAll()
{
  for (Index half = 0; half < this->Connectivity.numberOfHalfEdges(); ++half)
  {
    this->flipFrom({ half });
  }
}

Index FlatFlips::add(const Eigen::RowVector3d& position)
{
  this->Positions.push_back(position);
  this->Outgoing.push_back(-1);
  return this->numberOfPoints() - 1;
}

void FlatFlips::update(Index triangle)
{
  for (Index half = 3 * triangle; half < 3 * triangle + 3; ++half)
  {
    this->Outgoing[static_cast<std::size_t>(this->Connectivity.from(half))] = half;
  }
}

void FlatFlips::splitEdge(Index half, Index vertex)
{
  const Index right = this->Connectivity.twin(half);
  const Index before = this->Connectivity.numberOfTriangles();
  std::vector<Index> changed = { half / 3, before };
  if (right >= 0)
  {
    changed = { half / 3, right / 3, before, before + 1 };
  }
  this->Connectivity.splitEdge(half, vertex);
  std::vector<Index> open;
  for (const Index t : changed)
  {
    this->update(t);
    open.insert(open.end(), { 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  this->flipFrom(std::move(open));
}

Index FlatFlips::halve(Index half)
{
  const Index vertex = this->add(
    0.5 * (this->point(this->Connectivity.from(half)) + this->point(this->Connectivity.to(half))));
  this->splitEdge(half, vertex);
  return vertex;
}

void FlatFlips::keep(Index from, Index to)
{
  this->Kept.insert(keyOf(from, to));
}

bool FlatFlips::isKept(Index half) const
{
  return !this->Kept.empty() &&
    this->Kept.count(keyOf(this->Connectivity.from(half), this->Connectivity.to(half))) > 0;
}

Index FlatFlips::halfEdge(Index from, Index to) const
{
  const Index first = this->Outgoing[static_cast<std::size_t>(from)];
  for (Index half = first; half >= 0;)
  {
    if (this->Connectivity.to(half) == to)
    {
      return half;
    }
    half = this->Connectivity.twin(HalfEdgeTriangles::previous(half));
    if (half == first)
    {
      return -1;
    }
  }
  // Beyond the boundary, the other way round.
  for (Index twin = first < 0 ? -1 : this->Connectivity.twin(first); twin >= 0;)
  {
    const Index half = HalfEdgeTriangles::next(twin);
    if (this->Connectivity.to(half) == to)
    {
      return half;
    }
    twin = this->Connectivity.twin(half);
  }
  return -1;
}

Index FlatFlips::insertOn(Index from, Index to, const Eigen::RowVector3d& place)
{
  Index half = this->halfEdge(from, to);
  half = half < 0 ? this->halfEdge(to, from) : half;
  if (half < 0)
  {
    throw InvalidInput("there is no edge from point " + std::to_string(from) + " to point " +
      std::to_string(to) + " into which a point could be put.");
  }
  const Index vertex = this->add(place);
  if (this->isKept(half))
  {
    this->keep(from, vertex);
    this->keep(vertex, to);
  }
  this->splitEdge(half, vertex);
  return vertex;
}

Index FlatFlips::insertCentroid(Index triangle)
{
  const Index before = this->Connectivity.numberOfTriangles();
  const Index first = 3 * triangle;
  const Index vertex = this->add(
    (this->point(this->Connectivity.from(first)) + this->point(this->Connectivity.from(first + 1)) +
      this->point(this->Connectivity.from(first + 2))) /
    3.0);
  this->Connectivity.splitTriangle(triangle, vertex);
  for (const Index t : { triangle, before, before + 1 })
  {
    this->update(t);
  }
  this->flipFrom({ 3 * triangle, 3 * before, 3 * (before + 1) });
  return vertex;
}
}

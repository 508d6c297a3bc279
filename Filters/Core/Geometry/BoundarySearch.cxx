// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/BoundarySearch.h"

#include "Core/Common/Describe.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace hexsweep
{
namespace
{
/// Less than this part of an edge is no mismatch worth a word (points in single precision, say).
constexpr double Negligible = 1e-3;
/// Allowed distance over edge times turning angle: four sagittas.
constexpr double SagittaAllowance = 0.5;
/// A turn that is less than this part of the greatest one has no plane to speak of.
constexpr double WeakTurn = 0.1;

Points boundaryEdges(const PointsRef& points, const std::vector<Loop>& loops)
{
  std::size_t count = 0;
  for (const Loop& loop : loops)
  {
    count += loop.size();
  }
  Points corners(static_cast<Index>(count) * 3, 3);
  Index row = 0;
  for (const Loop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i, row += 3)
    {
      corners.row(row) = points.row(loop[i]);
      corners.row(row + 1) = corners.row(row + 2) = points.row(loop[(i + 1) % loop.size()]);
    }
  }
  return corners;
}

/// Axis of the turn at a node, as long as its angle.
Eigen::RowVector3d turnAt(
  const Eigen::RowVector3d& before, const Eigen::RowVector3d& node, const Eigen::RowVector3d& after)
{
  const Eigen::RowVector3d in = node - before;
  const Eigen::RowVector3d out = after - node;
  const Eigen::RowVector3d axis = in.cross(out);
  return std::atan2(axis.norm(), in.dot(out)) * axis.normalized();
}

/// Whether a node at `offset` from its edge is as far away as the local turns explain.
bool isExplained(const Eigen::RowVector3d& offset, double edge,
  const std::array<Eigen::RowVector3d, 3>& turns, double slack)
{
  const Eigen::RowVector3d greatest = *std::max_element(
    turns.begin(), turns.end(), [](const auto& a, const auto& b) { return a.norm() < b.norm(); });
  const double sagittas = SagittaAllowance * edge * greatest.norm();
  if (offset.norm() > slack + sagittas)
  {
    return false;
  }
  double sine = 0.0;
  for (const Eigen::RowVector3d& turn : turns)
  {
    if (turn.norm() > WeakTurn * greatest.norm())
    {
      sine = std::max(sine, greatest.normalized().cross(turn.normalized()).norm());
    }
  }
  return std::abs(offset.dot(greatest.normalized())) <= slack + sine * sagittas;
}
}

BoundarySearch::BoundarySearch(const PointsRef& points, const std::vector<Loop>& loops)
  : Search(boundaryEdges(points, loops))
{
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    for (std::size_t i = 0; i < loops[l].size(); ++i)
    {
      this->LoopOfEdge.push_back(l);
      this->EdgeInLoop.push_back(static_cast<Index>(i));
      this->EdgeLength.push_back(
        (points.row(loops[l][i]) - points.row(loops[l][(i + 1) % loops[l].size()])).norm());
    }
  }
}

BoundarySearch::Place BoundarySearch::closest(const Eigen::RowVector3d& p) const
{
  const TrianglePoint near = this->Search.closest(p);
  const std::size_t e = static_cast<std::size_t>(near.triangle);
  return { this->LoopOfEdge[e],
    static_cast<double>(this->EdgeInLoop[e]) + 1.0 - near.coordinates[0], near.distance,
    this->EdgeLength[e] };
}

BoundaryMismatch boundaryMismatch(const PointsRef& points, const std::vector<Loop>& loops,
  const std::vector<Points>& rings, double matchTolerance)
{
  BoundaryMismatch mismatch;
  const BoundarySearch boundary(points, loops);
  for (const Points& ring : rings)
  {
    const Index n = ring.rows();
    mismatch.ringNodes += n;
    for (Index i = 0; i < n; ++i)
    {
      const BoundarySearch::Place place = boundary.closest(ring.row(i));
      const Loop& loop = loops[place.loop];
      const std::size_t size = loop.size();
      // The place at the very end of an edge has the number of the next one.
      const std::size_t a = static_cast<std::size_t>(place.position) % size;
      const std::size_t b = (a + 1) % size;
      const auto node = [&](std::size_t k) { return points.row(loop[k % size]); };
      const double along = place.position - std::floor(place.position);
      const Eigen::RowVector3d offset = ring.row(i) - ((1.0 - along) * node(a) + along * node(b));
      const double edge = std::max(place.edgeLength, (node(b) - node(a)).norm());
      const std::array<Eigen::RowVector3d, 3> turns{ turnAt(node(a + size - 1), node(a), node(b)),
        turnAt(node(a), node(b), node(b + 1)),
        turnAt(ring.row((i + n - 1) % n), ring.row(i), ring.row((i + 1) % n)) };
      if (!isExplained(offset, edge, turns, std::max(Negligible, matchTolerance) * edge))
      {
        ++mismatch.nodes;
        if (offset.norm() > mismatch.distance)
        {
          mismatch.distance = offset.norm();
          mismatch.place = ring.row(i);
        }
      }
    }
  }
  return mismatch;
}

std::string describeMismatch(
  const BoundaryMismatch& mismatch, const std::string& cap, const std::string& ring)
{
  if (mismatch.nodes == 0)
  {
    return {};
  }
  return "the boundary of the " + cap + " is not the " + ring + ": " +
    std::to_string(mismatch.nodes) + " of " + std::to_string(mismatch.ringNodes) +
    " nodes are further away than the facets of a curve explain, the worst by " +
    describe(mismatch.distance) + " at " + describe(mismatch.place) +
    ". There the boundary nodes of the quads are on the ring, not on the surface. Check that both "
    "belong to the same model.";
}
}

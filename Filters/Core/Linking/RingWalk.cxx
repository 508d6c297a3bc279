// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/RingWalk.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"

#include <algorithm>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr Index NoNode = -1;

std::string describeRing(std::size_t loop, Index ring)
{
  return "ring " + std::to_string(ring) + " of loop " + std::to_string(loop);
}
}

RingWalk::RingWalk(const PointsRef& points, const Quads& quads, const QuadNeighbors& neighbors)
  : Positions(points)
  , Cells(quads)
  , Neighbors(neighbors)
  , QuadSeen(static_cast<std::size_t>(quads.rows()), 0)
  , PointSeen(static_cast<std::size_t>(points.rows()), 0)
{
}

RingTable RingWalk::walk(const Loop& firstRing, std::size_t loop)
{
  std::vector<Loop> rings;
  this->claim(firstRing, loop, 0);
  rings.push_back(firstRing);
  for (Loop next = this->step(firstRing, loop, 0); !next.empty();
       next = this->step(rings.back(), loop, static_cast<Index>(rings.size()) - 1))
  {
    this->claim(next, loop, static_cast<Index>(rings.size()));
    rings.push_back(std::move(next));
  }

  RingTable table(static_cast<Index>(rings.size()), static_cast<Index>(firstRing.size()));
  for (std::size_t k = 0; k < rings.size(); ++k)
  {
    table.row(static_cast<Index>(k)) =
      Eigen::Map<const Eigen::Matrix<Index, 1, Eigen::Dynamic>>(rings[k].data(), table.cols());
  }
  return table;
}

void RingWalk::checkAllSeen() const
{
  const auto seen = std::count(this->QuadSeen.begin(), this->QuadSeen.end(), 1);
  if (seen == this->Cells.rows())
  {
    return;
  }
  const Index quad =
    std::find(this->QuadSeen.begin(), this->QuadSeen.end(), 0) - this->QuadSeen.begin();
  throw InvalidInput(std::to_string(this->Cells.rows() - seen) +
    " quads of the linking sides are not reached from any loop of the source quads; the first "
    "is quad " +
    std::to_string(quad) + " at " + describe(this->center(quad)) +
    ". The source cap may lack a hole that the linking sides have, or the linking sides contain "
    "cells that are not linking sides (a cap, say): remove them.");
}

Eigen::RowVector3d RingWalk::center(Index quad) const
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (int c = 0; c < 4; ++c)
  {
    sum += 0.25 * this->Positions.row(this->Cells(quad, c));
  }
  return sum;
}

std::string RingWalk::describeEdge(Index a, Index b) const
{
  return "the edge from " + describe(this->Positions.row(a)) + " to " +
    describe(this->Positions.row(b));
}

void RingWalk::claim(const Loop& ring, std::size_t loop, Index number)
{
  for (const Index id : ring)
  {
    if (this->PointSeen[id])
    {
      throw InvalidInput("the linking sides are not structured: " + describeRing(loop, number) +
        " meets itself or another ring at " + describe(this->Positions.row(id)) +
        ". Each loop of the source cap needs its own structured side.");
    }
    this->PointSeen[id] = 1;
  }
}

Index RingWalk::quadAhead(Index a, Index b, std::size_t loop, Index ring) const
{
  const auto range = this->Neighbors.edge(a, b);
  if (range.first == range.second)
  {
    throw InvalidInput("the linking sides have a hole, or other nodes than the source quads: " +
      describeRing(loop, ring) + " has no quad at " + this->describeEdge(a, b) + ".");
  }
  if (ring == 0 && range.second - range.first == 2)
  {
    throw InvalidInput("the linking sides go on beyond loop " + std::to_string(loop) +
      " of the source quads at " + this->describeEdge(a, b) +
      ": they must end there. Remove the cells of the cap from the linking sides.");
  }
  for (const FaceSide* side = range.first; side != range.second; ++side)
  {
    if (!this->QuadSeen[side->face])
    {
      return side->face;
    }
  }
  return NoNode;
}

Index RingWalk::across(Index quad, Index from, Index beside) const
{
  for (int c = 0; c < 4; ++c)
  {
    if (this->Cells(quad, c) == from)
    {
      const Index after = this->Cells(quad, (c + 1) % 4);
      return after == beside ? this->Cells(quad, (c + 3) % 4) : after;
    }
  }
  return NoNode;
}

Loop RingWalk::step(const Loop& ring, std::size_t loop, Index number)
{
  const std::size_t n = ring.size();
  std::vector<Index> ahead(n);
  std::size_t missing = n;
  std::size_t count = 0;
  for (std::size_t j = 0; j < n; ++j)
  {
    ahead[j] = this->quadAhead(ring[j], ring[(j + 1) % n], loop, number);
    if (ahead[j] == NoNode)
    {
      missing = j;
    }
    else
    {
      ++count;
    }
  }
  if (count == 0)
  {
    if (number == 0)
    {
      throw InvalidInput("the linking sides have no layer at loop " + std::to_string(loop) +
        " of the source quads.");
    }
    return {};
  }
  if (count < n)
  {
    throw InvalidInput("the linking sides have a hole, or sides with different numbers of "
                       "layers: " +
      describeRing(loop, number) + " has no quad ahead at " +
      this->describeEdge(ring[missing], ring[(missing + 1) % n]) + " but has one at " +
      std::to_string(count) + " of its " + std::to_string(n) +
      " edges. Give all sides the same number of layers.");
  }
  Loop next(n);
  for (std::size_t j = 0; j < n; ++j)
  {
    const std::size_t before = (j + n - 1) % n;
    next[j] = this->across(ahead[j], ring[j], ring[(j + 1) % n]);
    if (next[j] != this->across(ahead[before], ring[j], ring[before]))
    {
      throw InvalidInput("the linking sides are not structured: the two quads ahead of " +
        describeRing(loop, number) + " at " + describe(this->Positions.row(ring[j])) +
        " do not share an edge. Four quads must meet at each inner node, and seams must have "
        "coincident nodes (or raise MatchTolerance).");
    }
    this->QuadSeen[ahead[j]] = 1;
  }
  return next;
}
}

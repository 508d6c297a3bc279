// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/QuadWinding.h"

#include "Core/Common/Constants.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
using PlanePoint = Eigen::RowVector2d;

double turnAbout(const PlanePoint& center, const PlanePoint& from, const PlanePoint& to)
{
  const PlanePoint a = from - center;
  const PlanePoint b = to - center;
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

/// One loop on one section.
struct HoleRing
{
  const PlanePoints& ring;
  Index begin;
  Index size;

  PlanePoint middle() const
  {
    return this->ring.middleRows(this->begin, this->size).colwise().mean();
  }
  /// Whether it runs round its middle, once.
  bool isAboutMiddle() const
  {
    const PlanePoint center = this->middle();
    double turn = 0.0;
    for (Index j = 0; j < this->size; ++j)
    {
      turn += turnAbout(center, this->ring.row(this->begin + j),
        this->ring.row(this->begin + (j + 1) % this->size));
    }
    return std::abs(turn) > Pi;
  }
};

HoleRing ringOf(const SweepSections& sections, std::size_t layer, std::size_t loop)
{
  return { sections.rings[layer], sections.begins[loop],
    sections.begins[loop + 1] - sections.begins[loop] };
}

std::vector<std::size_t> holesWithMiddle(const SweepSections& sections)
{
  std::vector<std::size_t> holes;
  for (std::size_t l = 0; l < sections.numberOfLoops(); ++l)
  {
    bool always = l != sections.outer;
    for (std::size_t k = 0; always && k < sections.rings.size(); ++k)
    {
      always = ringOf(sections, k, l).isAboutMiddle();
    }
    if (always)
    {
      holes.push_back(l);
    }
  }
  return holes;
}

/// Of each node the one before it on a shortest path from a node of the outer loop; -1: none.
std::vector<Index> pathsFrom(Index start, const QuadsRef& quads, Index numberOfNodes)
{
  std::vector<std::vector<Index>> neighbors(static_cast<std::size_t>(numberOfNodes));
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      neighbors[static_cast<std::size_t>(quads(q, c))].push_back(quads(q, (c + 1) % 4));
      neighbors[static_cast<std::size_t>(quads(q, c))].push_back(quads(q, (c + 3) % 4));
    }
  }
  std::vector<Index> before(neighbors.size(), -1);
  before[static_cast<std::size_t>(start)] = start;
  std::vector<Index> reached{ start };
  for (std::size_t next = 0; next < reached.size(); ++next)
  {
    for (const Index node : neighbors[static_cast<std::size_t>(reached[next])])
    {
      if (before[static_cast<std::size_t>(node)] < 0)
      {
        before[static_cast<std::size_t>(node)] = reached[next];
        reached.push_back(node);
      }
    }
  }
  return before;
}

/// Turn about a place along a path, from its start to its end.
double turnAlong(
  const std::vector<Index>& before, Index end, const PlanePoints& points, const PlanePoint& center)
{
  double turn = 0.0;
  for (Index node = end; before[static_cast<std::size_t>(node)] != node;)
  {
    const Index last = before[static_cast<std::size_t>(node)];
    turn += turnAbout(center, points.row(last), points.row(node));
    node = last;
  }
  return turn;
}

/// By how much a row of the rings turns about the middle of a hole, from the first section on.
double turnOfRow(const SweepSections& sections, Index row, std::size_t hole)
{
  double turn = 0.0;
  for (std::size_t k = 0; k + 1 < sections.rings.size(); ++k)
  {
    const PlanePoint from = sections.rings[k].row(row) - ringOf(sections, k, hole).middle();
    const PlanePoint to = sections.rings[k + 1].row(row) - ringOf(sections, k + 1, hole).middle();
    turn += turnAbout(PlanePoint::Zero(), from, to);
  }
  return turn;
}
}

std::vector<Index> missedTurns(const SweepSections& sections, const QuadsRef& quads,
  const PlanePoints& source, const PlanePoints& target)
{
  const std::vector<std::size_t> holes = holesWithMiddle(sections);
  const Index startRow = sections.begins[sections.outer];
  const std::vector<Index> before =
    pathsFrom(sections.nodes[static_cast<std::size_t>(startRow)], quads, source.rows());
  const std::size_t last = sections.rings.size() - 1;
  std::vector<Index> missed(sections.numberOfLoops(), 0);
  for (std::size_t l = 0; l < sections.numberOfLoops(); ++l)
  {
    const Index endRow = sections.begins[l];
    const Index end = sections.nodes[static_cast<std::size_t>(endRow)];
    if (l == sections.outer || before[static_cast<std::size_t>(end)] < 0)
    {
      continue;
    }
    for (const std::size_t hole : holes)
    {
      const double expected = turnAlong(before, end, source, ringOf(sections, 0, hole).middle()) +
        turnOfRow(sections, endRow, hole) - turnOfRow(sections, startRow, hole);
      const double found = turnAlong(before, end, target, ringOf(sections, last, hole).middle());
      missed[l] += std::abs(std::lround((found - expected) / (2.0 * Pi)));
    }
  }
  return missed;
}
}

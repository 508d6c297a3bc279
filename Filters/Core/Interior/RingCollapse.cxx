// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/RingCollapse.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>

namespace hexsweep
{
namespace
{
using Vector = Eigen::RowVector3d;

/// An edge that is turned round but longer than this share of it on both loops only twists.
constexpr double CollapsedShare = 0.25;
/// A round loop of so many nodes turns by 90 degrees from an edge to the next but one.
constexpr Index CoarseLoop = 8;

/// Whether the quad a, b (an edge of a ring), d over a, c over b turns over on the way up.
bool turnsOver(const Vector& a, const Vector& b, const Vector& c, const Vector& d)
{
  const Vector low = b - a;
  const Vector high = c - d;
  if (high.isZero(0.0))
  {
    return true;
  }
  if (low.dot(high) >= 0.0)
  {
    return false;
  }
  const Vector normal = (c - a).cross(d - b);
  const Vector up = d - a;
  const Vector next = c - b;
  return std::min({ low.cross(up).dot(normal), low.cross(next).dot(normal),
           high.cross(up).dot(normal), high.cross(next).dot(normal) }) <= 0.0;
}

/// Whether the edges a to b and c to d, with an edge between them, run against each other.
bool isSharp(const Points& ring, Index a, Index b, Index c, Index d)
{
  return (ring.row(b) - ring.row(a)).dot(ring.row(d) - ring.row(c)) < 0.0;
}
}

void checkRings(const SweepBoundary& boundary, const std::vector<Loop>& loops)
{
  const auto edge = [&boundary](Index k, Index here, Index next) {
    const Points& ring = boundary.rings[static_cast<std::size_t>(k)];
    return (ring.row(next) - ring.row(here)).norm();
  };
  const Index layers = boundary.numberOfLayers();
  for (Index k = 1; k <= layers; ++k)
  {
    const Points& before = boundary.rings[static_cast<std::size_t>(k - 1)];
    const Points& ring = boundary.rings[static_cast<std::size_t>(k)];
    Index first = 0;
    for (std::size_t l = 0; l < loops.size(); ++l)
    {
      const Index size = static_cast<Index>(loops[l].size());
      const auto node = [&](Index j) { return first + (j + size) % size; };
      // Columns that slide over a sharp ridge turn an edge round there and nowhere else.
      const auto passesRidge = [&](Index j) {
        return size > CoarseLoop &&
          (isSharp(before, node(j - 1), node(j), node(j + 1), node(j + 2)) ||
            isSharp(ring, node(j - 1), node(j), node(j + 1), node(j + 2)));
      };
      const auto hasCollapsed = [&](Index j) {
        const Index here = node(j);
        const Index next = node(j + 1);
        return std::min(edge(k - 1, here, next), edge(k, here, next)) <
          CollapsedShare * std::min(edge(0, here, next), edge(layers, here, next)) &&
          turnsOver(before.row(here), before.row(next), ring.row(next), ring.row(here)) &&
          !passesRidge(j);
      };
      for (Index j = 0; j < size; ++j)
      {
        const Index here = node(j);
        // On the caps' loops it is theirs to say so.
        if ((k < layers && edge(k, here, node(j + 1)) == 0.0) || hasCollapsed(j))
        {
          throw InvalidInput("the linking side of " +
            std::string(first == boundary.outerBegin ? "the outer loop (loop " : "a hole (loop ") +
            std::to_string(l) + ", " + std::to_string(size) + " nodes, the first at " +
            describe(boundary.rings[0].row(first)) + ") collapses: ring " + std::to_string(k) +
            " is turned over against ring " + std::to_string(k - 1) + " at " +
            describe(ring.row(here)) +
            ". Mesh this linking side again so that its columns follow the turn of the loop "
            "instead of cutting across.");
        }
      }
      first += size;
    }
  }
}
}

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
      const auto next = [&](Index j) { return first + (j + 1) % size; };
      const auto hasCollapsed = [&](Index j) {
        const Index here = first + j;
        return std::min(edge(k - 1, here, next(j)), edge(k, here, next(j))) <
          CollapsedShare * std::min(edge(0, here, next(j)), edge(layers, here, next(j))) &&
          turnsOver(before.row(here), before.row(next(j)), ring.row(next(j)), ring.row(here));
      };
      for (Index j = 0; j < size; ++j)
      {
        const Index here = first + j;
        // On the caps' loops it is theirs to say so.
        if ((k < layers && edge(k, here, next(j)) == 0.0) ||
          (hasCollapsed(j) && hasCollapsed((j + 1) % size)))
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

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FaceSides.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace hexsweep
{
std::vector<FaceSide> sortedSides(const FacesRef& faces, Index numberOfPoints)
{
  const Index corners = faces.cols();
  const auto forEachSide = [&](const auto& visit) {
    for (Index f = 0; f < faces.rows(); ++f)
    {
      for (Index c = 0; c < corners; ++c)
      {
        const Index a = faces(f, c);
        const Index b = faces(f, (c + 1) % corners);
        visit(FaceSide{ std::min(a, b), std::max(a, b), f, c, a < b });
      }
    }
  };
  // Buckets by lower point hold a handful of sides each.
  std::vector<std::size_t> begin(static_cast<std::size_t>(numberOfPoints) + 1, 0);
  forEachSide([&](const FaceSide& side) { ++begin[static_cast<std::size_t>(side.low) + 1]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  std::vector<FaceSide> sides(static_cast<std::size_t>(faces.size()));
  forEachSide(
    [&](const FaceSide& side) { sides[next[static_cast<std::size_t>(side.low)]++] = side; });
  for (std::size_t p = 0; p + 1 < begin.size(); ++p)
  {
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin[p]),
      sides.begin() + static_cast<std::ptrdiff_t>(begin[p + 1]),
      [](const FaceSide& x, const FaceSide& y) {
        return std::tie(x.high, x.face, x.corner) < std::tie(y.high, y.face, y.corner);
      });
  }
  return sides;
}

std::vector<Index> boundaryPoints(const std::vector<FaceSide>& sides)
{
  std::vector<Index> ids;
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first == 1)
    {
      ids.push_back(sides[first].low);
      ids.push_back(sides[first].high);
    }
  });
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/CanonicalSolid.h"

#include "Core/Surfaces/UsedPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <tuple>
#include <utility>

namespace hexsweep
{
namespace
{
/// Ids of the points that triangles use, rising.
std::vector<Index> usedIds(const SolidInput& solid)
{
  const std::vector<bool> isUsed = usedPoints(solid.triangles, solid.points.rows());
  std::vector<Index> ids;
  for (std::size_t p = 0; p < isUsed.size(); ++p)
  {
    if (isUsed[p])
    {
      ids.push_back(static_cast<Index>(p));
    }
  }
  return ids;
}

/// Where most points are on one axis: 1 or -1 above or below the middle, 0 in between.
int leaning(const SolidInput& solid, const std::vector<Index>& used, int axis)
{
  constexpr double Steps = 1048576.0; // of half the extent; sums of whole numbers do not depend on
  constexpr std::int64_t Symmetric = 100; // the order of the points
  double low = solid.points(used.front(), axis);
  double high = low;
  for (const Index p : used)
  {
    low = std::min(low, solid.points(p, axis));
    high = std::max(high, solid.points(p, axis));
  }
  const double middle = 0.5 * low + 0.5 * high;
  const double half = 0.5 * high - 0.5 * low;
  if (!(half > 0.0))
  {
    return 0;
  }
  std::int64_t sum = 0;
  for (const Index p : used)
  {
    sum += static_cast<std::int64_t>(std::round(Steps * ((solid.points(p, axis) - middle) / half)));
  }
  const std::int64_t margin = Symmetric * static_cast<std::int64_t>(used.size());
  return sum > margin ? 1 : sum < -margin ? -1 : 0;
}

/// Finalizer of the generator SplitMix64 \cite SteeleLeaFlood2014.
std::uint64_t mixed(std::uint64_t x)
{
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// A number for the triangles' coordinates that depends neither on their order nor on that of their
/// corners.
std::uint64_t fingerprint(
  const SolidInput& solid, const std::vector<Index>& used, const Reflection& reflection)
{
  std::vector<std::uint64_t> ofPoint(static_cast<std::size_t>(solid.points.rows()), 0);
  for (const Index p : used)
  {
    std::uint64_t hash = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = solid.points(p, axis) * reflection.signs[axis] + 0.0;
      std::uint64_t bits = 0;
      std::memcpy(&bits, &x, sizeof(bits));
      hash = mixed(hash + bits);
    }
    ofPoint[static_cast<std::size_t>(p)] = hash;
  }
  std::uint64_t sum = 0;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    std::uint64_t corners = 0;
    for (int c = 0; c < 3; ++c)
    {
      corners += ofPoint[static_cast<std::size_t>(solid.triangles(t, c))];
    }
    sum += mixed(corners);
  }
  return sum;
}

Reflection chooseReflection(const SolidInput& solid, const std::vector<Index>& used)
{
  std::array<int, 3> lean{};
  for (int axis = 0; axis < 3; ++axis)
  {
    lean[static_cast<std::size_t>(axis)] = leaning(solid, used, axis);
  }
  Reflection best;
  std::uint64_t least = 0;
  bool found = false;
  for (unsigned choice = 0; choice < 8; ++choice)
  {
    Reflection reflection;
    bool allowed = true;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      const int sign = (choice >> axis) % 2 == 0 ? 1 : -1;
      allowed = allowed && lean[axis] != -sign;
      reflection.signs[static_cast<Index>(axis)] = sign;
    }
    const bool only = lean[0] != 0 && lean[1] != 0 && lean[2] != 0;
    if (allowed)
    {
      const std::uint64_t print = only ? 0 : fingerprint(solid, used, reflection);
      if (!found || print < least)
      {
        best = reflection;
        least = print;
        found = true;
      }
    }
  }
  return best;
}

using CornerIds = std::array<Index, 3>;

CornerIds rising(CornerIds corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// The same triangle from its lowest corner on.
CornerIds fromLowest(CornerIds corners)
{
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

bool areBefore(const Points& points, Index a, Index b)
{
  return std::tie(points(a, 0), points(a, 1), points(a, 2)) <
    std::tie(points(b, 0), points(b, 1), points(b, 2));
}

/// Used points by their coordinates; those in one place by the triangles that use them, which go by
/// the places of their corners.
std::vector<Index> sortedPoints(
  const Points& points, const Triangles& triangles, std::vector<Index> used)
{
  std::sort(used.begin(), used.end(), [&](Index a, Index b) { return areBefore(points, a, b); });
  std::vector<Index> rank(static_cast<std::size_t>(points.rows()), -1);
  for (std::size_t i = 0, place = 0; i < used.size(); ++i)
  {
    place += i > 0 && areBefore(points, used[i - 1], used[i]) ? 1 : 0;
    rank[static_cast<std::size_t>(used[i])] = static_cast<Index>(place);
  }
  std::vector<std::pair<CornerIds, Index>> order; // ranks, triangle
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    CornerIds ranks{};
    for (int c = 0; c < 3; ++c)
    {
      ranks[static_cast<std::size_t>(c)] = rank[static_cast<std::size_t>(triangles(t, c))];
    }
    order.emplace_back(rising(ranks), t);
  }
  std::sort(order.begin(), order.end());
  std::vector<Index> firstUse(rank.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      Index& first = firstUse[static_cast<std::size_t>(triangles(order[i].second, c))];
      first = first < 0 ? static_cast<Index>(i) : first;
    }
  }
  std::sort(used.begin(), used.end(), [&](Index a, Index b) {
    const auto i = static_cast<std::size_t>(a);
    const auto j = static_cast<std::size_t>(b);
    return std::tie(rank[i], firstUse[i]) < std::tie(rank[j], firstUse[j]);
  });
  return used;
}
}

CanonicalSolid canonicalSolid(const SolidInput& solid, const std::optional<Reflection>& reflection)
{
  checkSolidInput(solid);
  const std::vector<Index> used = usedIds(solid);
  CanonicalSolid result;
  result.reflection = reflection ? *reflection : chooseReflection(solid, used);
  const Points points = reflected(solid.points, result.reflection);
  const std::vector<Index> pointOrder = sortedPoints(points, solid.triangles, used);
  std::vector<Index> number(static_cast<std::size_t>(points.rows()), -1);
  for (std::size_t i = 0; i < pointOrder.size(); ++i)
  {
    number[static_cast<std::size_t>(pointOrder[i])] = static_cast<Index>(i);
  }

  const Index m = solid.triangles.rows();
  std::vector<CornerIds> corners(static_cast<std::size_t>(m));
  for (Index i = 0; i < 3 * m; ++i)
  {
    corners[static_cast<std::size_t>(i / 3)][static_cast<std::size_t>(i % 3)] =
      number[static_cast<std::size_t>(solid.triangles.data()[i])];
  }
  std::vector<Index> order(static_cast<std::size_t>(m));
  std::iota(order.begin(), order.end(), Index{ 0 });
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return rising(corners[static_cast<std::size_t>(a)]) <
      rising(corners[static_cast<std::size_t>(b)]);
  });

  SolidInput& input = result.input;
  input = selectTriangles(solid, order);
  for (Index t = 0; t < m; ++t)
  {
    const CornerIds row =
      fromLowest(corners[static_cast<std::size_t>(order[static_cast<std::size_t>(t)])]);
    input.triangles.row(t) << row[0], row[1], row[2];
  }
  input.points = points(pointOrder, Eigen::all);
  input.pointIds = pointOrder;
  for (std::size_t i = 0; i < pointOrder.size() && !solid.pointIds.empty(); ++i)
  {
    input.pointIds[i] = solid.pointIds[static_cast<std::size_t>(pointOrder[i])];
  }
  for (Index i = 0; i < input.quads.size(); ++i)
  {
    input.quads.data()[i] = number[static_cast<std::size_t>(input.quads.data()[i])];
  }
  return result;
}
}

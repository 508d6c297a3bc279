// SPDX-License-Identifier: BSD-3-Clause

#include "Support/CoarsePlates.h"

namespace test
{
double turnOf(const Points& points, Index a, Index b, Index c)
{
  const Eigen::RowVector3d u = points.row(b) - points.row(a);
  const Eigen::RowVector3d v = points.row(c) - points.row(a);
  return u.x() * v.y() - u.y() * v.x();
}

std::vector<Index> bridged(
  const Points& points, std::vector<Index> polygon, std::vector<std::vector<Index>> holes)
{
  for (std::vector<Index>& hole : holes)
  {
    std::rotate(hole.begin(),
      std::max_element(
        hole.begin(), hole.end(), [&](Index i, Index j) { return points(i, 0) < points(j, 0); }),
      hole.end());
  }
  std::sort(holes.begin(), holes.end(),
    [&](const auto& g, const auto& h) { return points(g[0], 0) > points(h[0], 0); });
  for (const std::vector<Index>& hole : holes)
  {
    const Index from = hole[0];
    const std::size_t n = polygon.size();
    std::size_t best = n;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k)
    {
      const Index to = polygon[k];
      const Index before = polygon[(k + n - 1) % n];
      const Index after = polygon[(k + 1) % n];
      const bool left = turnOf(points, before, to, from) > 0.0;
      const bool right = turnOf(points, to, after, from) > 0.0;
      bool sees = turnOf(points, before, to, after) > 0.0 ? left && right : left || right;
      sees = sees && points(to, 0) > points(from, 0);
      for (std::size_t e = 0; sees && e < n; ++e)
      {
        const Index a = polygon[e];
        const Index b = polygon[(e + 1) % n];
        sees = a == to || b == to || turnOf(points, a, b, from) * turnOf(points, a, b, to) > 0.0 ||
          turnOf(points, from, to, a) * turnOf(points, from, to, b) > 0.0;
      }
      const double distance = (points.row(to) - points.row(from)).norm();
      if (sees && distance < nearest)
      {
        best = k;
        nearest = distance;
      }
    }
    EXPECT_LT(best, n);
    std::vector<Index> detour(hole);
    detour.insert(detour.end(), { from, polygon[best] });
    polygon.insert(
      polygon.begin() + static_cast<std::ptrdiff_t>(best) + 1, detour.begin(), detour.end());
  }
  return polygon;
}

Triangles earsOf(const Points& points, std::vector<Index> polygon)
{
  std::vector<Index> ids;
  while (polygon.size() > 2)
  {
    const std::size_t n = polygon.size();
    std::size_t best = n;
    double shape = 0.0;
    for (std::size_t k = 0; k < n; ++k)
    {
      const Index a = polygon[(k + n - 1) % n];
      const Index b = polygon[k];
      const Index c = polygon[(k + 1) % n];
      const bool empty = std::none_of(polygon.begin(), polygon.end(), [&](Index i) {
        return i != a && i != b && i != c && turnOf(points, a, b, i) >= 0.0 &&
          turnOf(points, b, c, i) >= 0.0 && turnOf(points, c, a, i) >= 0.0;
      });
      const double longest = std::max({ (points.row(a) - points.row(b)).squaredNorm(),
        (points.row(b) - points.row(c)).squaredNorm(),
        (points.row(c) - points.row(a)).squaredNorm() });
      if (empty && a != c && turnOf(points, a, b, c) > shape * longest)
      {
        best = k;
        shape = turnOf(points, a, b, c) / longest;
      }
    }
    if (best == n)
    {
      ADD_FAILURE() << "no ear";
      break;
    }
    ids.insert(ids.end(), { polygon[(best + n - 1) % n], polygon[best], polygon[(best + 1) % n] });
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return facesOf<Triangles>(ids);
}

TriangleMesh coarsePlate(double length, const std::vector<RoundHole>& holes)
{
  std::vector<double> coordinates{ 0, 0, 0, length, 0, 0, length, 1, 0, 0, 1, 0 };
  std::vector<std::vector<Index>> loops;
  for (const RoundHole& hole : holes)
  {
    loops.emplace_back();
    for (Index j = 0; j < hole.nodes; ++j)
    {
      const double angle = -2.0 * Pi * static_cast<double>(j) / static_cast<double>(hole.nodes);
      loops.back().push_back(static_cast<Index>(coordinates.size()) / 3);
      coordinates.insert(coordinates.end(),
        { hole.x + hole.radius * std::cos(angle), hole.y + hole.radius * std::sin(angle), 0.0 });
    }
  }
  TriangleMesh mesh;
  mesh.points =
    Eigen::Map<const Points>(coordinates.data(), static_cast<Index>(coordinates.size()) / 3, 3);
  mesh.triangles = earsOf(mesh.points, bridged(mesh.points, { 0, 1, 2, 3 }, loops));
  return hexsweep::improveTriangulation(mesh, { true, false }).mesh;
}

TriangleMesh randomCoarsePlate(std::mt19937& generator)
{
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(generator()) / 4294967296.0;
  };
  const double number = 1.0 + static_cast<double>(generator() % 3);
  const double length = uniform(1.0, 5.0);
  std::vector<RoundHole> holes;
  for (double h = 0.0; h < number; ++h)
  {
    const double slot = length / number;
    const double most = 0.5 * std::min(1.0, slot);
    const double radius = most * uniform(0.2, 0.93);
    const double x = slot * h + uniform(1.02 * radius, slot - 1.02 * radius);
    const double y = uniform(1.02 * radius, 1.0 - 1.02 * radius);
    holes.push_back({ x, y, radius, 6 + static_cast<Index>(generator() % 34) });
  }
  return coarsePlate(length, holes);
}
}

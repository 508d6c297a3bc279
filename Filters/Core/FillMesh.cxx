// SPDX-License-Identifier: BSD-3-Clause
#include "FillMesh.h"

#include "Constants.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hexsweep
{
namespace
{
/// Share of evenly spaced angles in those that are used.
constexpr double Evenness = 0.05;

/// Distance of two rings over that of their nodes: triangles of about equal sides.
constexpr double RingDistance = 0.7;

/// A ring of no more nodes than this is joined to the one in the middle.
constexpr std::size_t SmallestRing = 5;

struct Ring
{
  std::vector<Index> nodes;
  std::vector<double> angles;
  double radius;
};
}

TriangleMesh fillMesh(const std::vector<double>& angles)
{
  const std::size_t m = angles.size();
  const double direction = angles[1] > angles[0] ? 1.0 : -1.0;
  std::vector<Eigen::RowVector3d> points;
  const auto add = [&](double radius, double angle) {
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    return static_cast<Index>(points.size()) - 1;
  };
  Ring ring{ {}, {}, 1.0 };
  for (std::size_t i = 0; i < m; ++i)
  {
    const double even = 2.0 * Pi * static_cast<double>(i) / static_cast<double>(m);
    ring.angles.push_back((1.0 - Evenness) * direction * (angles[i] - angles[0]) + Evenness * even);
    ring.nodes.push_back(add(1.0, ring.angles.back()));
  }

  std::vector<std::array<Index, 3>> triangles;
  for (bool halve = false; ring.nodes.size() > SmallestRing; halve = !halve)
  {
    const std::size_t count = ring.nodes.size();
    const std::size_t step = halve ? 2 : 1;
    Ring inner{ {}, {},
      ring.radius * std::exp(-RingDistance * 2.0 * Pi / static_cast<double>(count)) };
    for (std::size_t i = 0; i < count; i += step)
    {
      inner.angles.push_back(ring.angles[i]);
      inner.nodes.push_back(add(inner.radius, ring.angles[i]));
    }
    for (std::size_t j = 0; j < inner.nodes.size(); ++j)
    {
      const Index begin = inner.nodes[j];
      const Index end = inner.nodes[(j + 1) % inner.nodes.size()];
      const std::size_t first = j * step;
      const std::size_t last = std::min(first + step, count);
      // The outer nodes up to the middle one see the beginning of the inner edge, then its end.
      std::size_t i = first;
      for (; i + 1 < last; ++i)
      {
        triangles.push_back({ ring.nodes[i], ring.nodes[i + 1], begin });
      }
      triangles.push_back({ ring.nodes[i], end, begin });
      triangles.push_back({ ring.nodes[i], ring.nodes[last % count], end });
    }
    ring = std::move(inner);
  }
  const Index center = add(0.0, 0.0);
  for (std::size_t i = 0; i < ring.nodes.size(); ++i)
  {
    triangles.push_back({ ring.nodes[i], ring.nodes[(i + 1) % ring.nodes.size()], center });
  }

  TriangleMesh mesh{ Points(static_cast<Index>(points.size()), 3),
    Triangles(static_cast<Index>(triangles.size()), 3) };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mesh.points.row(static_cast<Index>(i)) = points[i];
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    mesh.triangles.row(static_cast<Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
  }
  return mesh;
}
}

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Caps of any size for the benchmarks.
 */
#ifndef BenchmarkMeshes_h
#define BenchmarkMeshes_h

#include "Core/Common/Mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace test
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::TriangleMesh;

enum class Numbering
{
  FileOrder, ///< row by row, as mesh generators write
  Random     ///< points, triangles and their first corners by chance
};

/// 0 .. n - 1 by chance.
inline std::vector<Index> shuffledIds(Index n, std::mt19937& generator)
{
  std::vector<Index> ids(static_cast<std::size_t>(n));
  std::iota(ids.begin(), ids.end(), Index(0));
  std::shuffle(ids.begin(), ids.end(), generator);
  return ids;
}

/// Rows of `points` in the order of `ids`.
inline Points rowsOf(const Points& points, const std::vector<Index>& ids)
{
  Points result(points.rows(), 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    result.row(i) = points.row(ids[static_cast<std::size_t>(i)]);
  }
  return result;
}

/// cells x cells nodes over [0, 1]^2, z = 0, inner ones shaken by up to 0.2 of a cell; row by row.
inline Points shakenNodes(Index cells, std::mt19937& generator)
{
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  Points points((cells + 1) * (cells + 1), 3);
  for (Index j = 0; j <= cells; ++j)
  {
    for (Index i = 0; i <= cells; ++i)
    {
      const bool inner = i > 0 && j > 0 && i < cells && j < cells;
      const double dx = uniform(generator);
      const double dy = uniform(generator);
      points.row(j * (cells + 1) + i)
        << (static_cast<double>(i) + (inner ? dx : 0.0)) / static_cast<double>(cells),
        (static_cast<double>(j) + (inner ? dy : 0.0)) / static_cast<double>(cells), 0.0;
    }
  }
  return points;
}

/**
 * A cap of about `triangles` triangles over the unit square: shaken nodes, each cell cut along a
 * diagonal that chance picks (through the corner in the corners of the square: no chords).
 *
 * @param bulge height of the cap over its rim.
 */
inline TriangleMesh cap(Index triangles, Numbering numbering, double bulge = 0.0)
{
  std::mt19937 generator(1);
  const Index cells =
    std::max<Index>(2, std::lround(std::sqrt(static_cast<double>(triangles) / 2.0)));
  TriangleMesh mesh;
  mesh.points = shakenNodes(cells, generator);
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    const double x = mesh.points(i, 0);
    const double y = mesh.points(i, 1);
    mesh.points(i, 2) = bulge * 16.0 * x * (1.0 - x) * y * (1.0 - y);
  }
  mesh.triangles.resize(2 * cells * cells, 3);
  for (Index j = 0; j < cells; ++j)
  {
    for (Index i = 0; i < cells; ++i)
    {
      const Index a = j * (cells + 1) + i;
      const Index corners[4] = { a, a + 1, a + cells + 2, a + cells + 1 };
      const bool left = i == 0;
      const bool right = i == cells - 1;
      const bool bottom = j == 0;
      const bool top = j == cells - 1;
      Index s = static_cast<Index>(generator() % 2);
      s = (left && bottom) || (right && top) ? 0 : s;
      s = (right && bottom) || (left && top) ? 1 : s;
      const Index cell = 2 * (j * cells + i);
      mesh.triangles.row(cell) << corners[s], corners[s + 1], corners[s + 2];
      mesh.triangles.row(cell + 1) << corners[s], corners[s + 2], corners[(s + 3) % 4];
    }
  }
  if (numbering == Numbering::FileOrder)
  {
    return mesh;
  }
  const std::vector<Index> order = shuffledIds(mesh.points.rows(), generator);
  std::vector<Index> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    rank[static_cast<std::size_t>(order[i])] = static_cast<Index>(i);
  }
  const std::vector<Index> triangleOrder = shuffledIds(mesh.triangles.rows(), generator);
  TriangleMesh result{ rowsOf(mesh.points, order), hexsweep::Triangles(mesh.triangles.rows(), 3) };
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const Index turn = static_cast<Index>(generator() % 3);
    for (Index c = 0; c < 3; ++c)
    {
      result.triangles(t, c) = rank[static_cast<std::size_t>(
        mesh.triangles(triangleOrder[static_cast<std::size_t>(t)], (c + turn) % 3))];
    }
  }
  return result;
}
}

#endif

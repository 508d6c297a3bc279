// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Blocks of unit cubes, and ways to spoil them.
 */
#ifndef HexBlocks_h
#define HexBlocks_h

#include "Core/Hexahedra/HexQuality.h"

#include <random>

namespace test
{
using hexsweep::Hexes;
using hexsweep::Index;
using hexsweep::Points;

struct HexBlock
{
  Points points;
  Hexes hexes;
  std::vector<bool> fixed; ///< the boundary
};

/// n x n x n cubes of edge length 1.
inline HexBlock makeBlock(Index n)
{
  HexBlock block;
  const auto id = [n](Index i, Index j, Index k) { return (k * (n + 1) + j) * (n + 1) + i; };
  block.points.resize((n + 1) * (n + 1) * (n + 1), 3);
  block.fixed.resize(static_cast<std::size_t>(block.points.rows()));
  for (Index k = 0; k <= n; ++k)
  {
    for (Index j = 0; j <= n; ++j)
    {
      for (Index i = 0; i <= n; ++i)
      {
        block.points.row(id(i, j, k)) << static_cast<double>(i), static_cast<double>(j),
          static_cast<double>(k);
        block.fixed[static_cast<std::size_t>(id(i, j, k))] = i % n == 0 || j % n == 0 || k % n == 0;
      }
    }
  }
  block.hexes.resize(n * n * n, 8);
  for (Index k = 0; k < n; ++k)
  {
    for (Index j = 0; j < n; ++j)
    {
      for (Index i = 0; i < n; ++i)
      {
        block.hexes.row((k * n + j) * n + i) << id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k),
          id(i, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1),
          id(i, j + 1, k + 1);
      }
    }
  }
  return block;
}

/// Moves the nodes that are not fixed by up to `amount` along each axis.
inline Points shaken(const HexBlock& block, double amount, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> shift(-amount, amount);
  Points points = block.points;
  for (Index i = 0; i < points.rows(); ++i)
  {
    if (!block.fixed[static_cast<std::size_t>(i)])
    {
      points.row(i) += Eigen::RowVector3d(shift(generator), shift(generator), shift(generator));
    }
  }
  return points;
}

inline hexsweep::HexQualitySummary judge(const Points& points, const Hexes& hexes)
{
  return hexsweep::summarize(hexsweep::hexQualities(points, hexes));
}
}

#endif

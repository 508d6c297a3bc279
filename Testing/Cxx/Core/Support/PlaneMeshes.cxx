// SPDX-License-Identifier: BSD-3-Clause

#include "Support/PlaneMeshes.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace test
{
PlanePoints rounded(const PlanePoints& points, double step)
{
  return (points / step).array().round().matrix() * step;
}

PlaneMesh onGrid(const TriangleMesh& mesh)
{
  return { rounded(mesh.points.leftCols<2>(), 2 / GridSteps), mesh.triangles };
}

ShuffledMesh shuffled(const PlaneMesh& mesh, unsigned seed)
{
  std::mt19937 generator(seed);
  std::vector<Index> rank(static_cast<std::size_t>(mesh.points.rows()));
  std::iota(rank.begin(), rank.end(), Index(0));
  std::shuffle(rank.begin(), rank.end(), generator);
  ShuffledMesh result{ mesh, std::vector<Index>(static_cast<std::size_t>(mesh.triangles.rows())) };
  std::iota(result.origin.begin(), result.origin.end(), Index(0));
  std::shuffle(result.origin.begin(), result.origin.end(), generator);
  for (std::size_t v = 0; v < rank.size(); ++v)
  {
    result.mesh.points.row(rank[v]) = mesh.points.row(static_cast<Index>(v));
  }
  for (std::size_t t = 0; t < result.origin.size(); ++t)
  {
    const Index turn = static_cast<Index>(generator() % 3);
    for (Index c = 0; c < 3; ++c)
    {
      result.mesh.triangles(static_cast<Index>(t), c) =
        rank[static_cast<std::size_t>(mesh.triangles(result.origin[t], (c + turn) % 3))];
    }
  }
  return result;
}
}

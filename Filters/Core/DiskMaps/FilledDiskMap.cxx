// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/FilledDiskMap.h"

#include "Core/Common/Constants.h"
#include "Core/Solvers/DirichletSolver.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
using Triplets = std::vector<Eigen::Triplet<double, int>>;

void addEdge(Triplets& entries, Index i, Index j, double w)
{
  const int a = static_cast<int>(i);
  const int b = static_cast<int>(j);
  entries.insert(entries.end(), { { a, b, -w }, { b, a, -w }, { a, a, w }, { b, b, w } });
}

/// The weights of a fan about `center`: cotangents, divided by the loop's mean edge length where
/// the others have the unit 1 / length, as mean value weights do.
void addFan(
  Triplets& entries, const PointsRef& points, const Loop& loop, Index center, Weights weights)
{
  const Points polygon = loopPoints(points, loop);
  const std::vector<double> angles = arcLengthAngles(polygon);
  const double scale =
    weights == Weights::MeanValue ? static_cast<double>(loop.size()) / closedLength(polygon) : 1.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const std::size_t j = (i + 1) % loop.size();
    const double end = j == 0 ? 2.0 * Pi : angles[j];
    // An isosceles triangle with this angle at the centre; wider ones would turn obtuse.
    const double apex = std::min(end - angles[i], 2.0 * Pi / 3.0);
    const double spoke = scale * std::tan(apex / 2.0);
    addEdge(entries, center, loop[i], spoke);
    addEdge(entries, center, loop[j], spoke);
    addEdge(entries, loop[i], loop[j], scale * std::max(0.0, 1.0 / std::tan(apex)));
  }
}

/// Radius of the circle with the polygon's area.
double equivalentRadius(const PlanePoints& disk, const Loop& loop)
{
  double twiceArea = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const auto p = disk.row(loop[i]);
    const auto q = disk.row(loop[(i + 1) % loop.size()]);
    twiceArea += p.x() * q.y() - p.y() * q.x();
  }
  return std::sqrt(std::abs(twiceArea) / (2.0 * Pi));
}

/// The matrix with a row for the centre of each hole's fan.
SparseMatrix withFans(const SparseMatrix& laplacian, const PointsRef& points,
  const std::vector<Loop>& loops, Weights weights)
{
  const Index n = laplacian.rows();
  const Index holes = static_cast<Index>(loops.size()) - 1;
  Triplets entries;
  for (Index column = 0; column < laplacian.outerSize(); ++column)
  {
    for (SparseMatrix::InnerIterator it(laplacian, column); it; ++it)
    {
      entries.emplace_back(static_cast<int>(it.row()), static_cast<int>(column), it.value());
    }
  }
  for (Index h = 0; h < holes; ++h)
  {
    addFan(entries, points, loops[static_cast<std::size_t>(h) + 1], n + h, weights);
  }
  SparseMatrix filled(n + holes, n + holes);
  filled.setFromTriplets(entries.begin(), entries.end());
  return filled;
}
}

FilledDiskMap filledDiskMap(const SparseMatrix& laplacian, const PointsRef& points,
  const std::vector<Loop>& loops, const PlanePointsRef& outer, Weights weights)
{
  const Index n = laplacian.rows();
  const Index holes = static_cast<Index>(loops.size()) - 1;
  SparseMatrix filled = laplacian;
  Points places(n + holes, 3);
  places.topRows(n) = points;
  if (holes > 0)
  {
    for (Index h = 0; h < holes; ++h)
    {
      places.row(n + h) =
        loopPoints(points, loops[static_cast<std::size_t>(h) + 1]).colwise().mean();
    }
    filled = withFans(laplacian, points, loops, weights);
  }

  std::vector<bool> fixed(static_cast<std::size_t>(n + holes), false);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(n + holes, 2);
  for (std::size_t i = 0; i < loops[0].size(); ++i)
  {
    fixed[static_cast<std::size_t>(loops[0][i])] = true;
    values.row(loops[0][i]) = outer.row(static_cast<Index>(i));
  }
  const Eigen::MatrixXd solution = DirichletSolver(filled, fixed, places).solve(values);

  FilledDiskMap map;
  map.disk = solution.topRows(n);
  for (Index h = 0; h < holes; ++h)
  {
    map.holes.push_back(
      { solution.row(n + h), equivalentRadius(map.disk, loops[static_cast<std::size_t>(h) + 1]) });
  }
  return map;
}
}

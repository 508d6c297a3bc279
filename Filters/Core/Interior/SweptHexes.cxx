// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/SweptHexes.h"

#include "Core/Common/Errors.h"
#include "Core/Common/IdRange.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>

namespace hexsweep
{
namespace
{
/// Sum over the eight corners of the hexes with the quad of layer k as bottom.
double sumOfCornerJacobians(const QuadsRef& quads, const PointsRef& points, Index n, Index k)
{
  const double* low = points.data() + 3 * k * n;
  const double* high = low + 3 * n;
  const auto point = [](const double* layer, Index id) {
    return Eigen::Map<const Eigen::Vector3d>(layer + 3 * id);
  };
  double sum = 0.0;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    const Index* ids = quads.data() + 4 * q;
    for (int c = 0; c < 4; ++c)
    {
      const Index corner = ids[c];
      const Index next = ids[(c + 1) % 4];
      const Index previous = ids[(c + 3) % 4];
      const Eigen::Vector3d up = point(high, corner) - point(low, corner);
      for (const double* layer : { low, high })
      {
        const Eigen::Vector3d u = point(layer, next) - point(layer, corner);
        const Eigen::Vector3d v = point(layer, previous) - point(layer, corner);
        sum += u.cross(v).dot(up);
      }
    }
  }
  return sum;
}

void checkLayers(const QuadsRef& quads, const PointsRef& points, Index numberOfLayers)
{
  if (numberOfLayers < 1 || points.rows() % (numberOfLayers + 1) != 0)
  {
    throw InvalidInput(std::to_string(points.rows()) + " points do not make " +
      std::to_string(numberOfLayers) + " layers of hexahedra. Give the same number of points on " +
      "each layer, from the source cap to the target cap, and at least one layer.");
  }
  checkIds(quads, points.rows() / (numberOfLayers + 1), "quad");
}
}

bool sourceIsBottom(const QuadsRef& quads, const PointsRef& points, Index numberOfLayers,
  const ParallelFor& parallelFor)
{
  checkLayers(quads, points, numberOfLayers);
  const Index n = points.rows() / (numberOfLayers + 1);
  constexpr Index LayersAtMost = 8;
  const Index looked = std::min(numberOfLayers, LayersAtMost);
  Eigen::VectorXd sums(looked);
  forPieces(parallelFor, looked, 1, [&](Index i, Index) {
    const Index k = looked > 1 ? i * (numberOfLayers - 1) / (looked - 1) : 0;
    sums[i] = sumOfCornerJacobians(quads, points, n, k);
  });
  return sums.sum() >= 0.0;
}

Hexes sweptHexes(const QuadsRef& quads, const PointsRef& points, Index numberOfLayers,
  const ParallelFor& parallelFor)
{
  const bool upward = sourceIsBottom(quads, points, numberOfLayers, parallelFor);
  const Index n = points.rows() / (numberOfLayers + 1);
  const Index m = quads.rows();
  Hexes hexes(numberOfLayers * m, 8);
  forPieces(parallelFor, numberOfLayers, 1, [&](Index k, Index) {
    const Index bottom = (upward ? k : k + 1) * n;
    const Index top = (upward ? k + 1 : k) * n;
    hexes.block(k * m, 0, m, 4) = quads.array() + bottom;
    hexes.block(k * m, 4, m, 4) = quads.array() + top;
  });
  return hexes;
}

void checkSameQuads(const QuadsRef& source, const QuadsRef& target)
{
  if (source.rows() != target.rows())
  {
    throw InvalidInput("the target quads do not have the connectivity of the source quads: " +
      std::to_string(target.rows()) + " cells instead of " + std::to_string(source.rows()) +
      ". Make them from the source quads (SweepQuadProjector).");
  }
  const auto sameCycle = [&](Index q, int start, int step) {
    for (int c = 0; c < 4; ++c)
    {
      if (source(q, c) != target(q, (start + step * c + 4) % 4))
      {
        return false;
      }
    }
    return true;
  };
  for (Index q = 0; q < source.rows(); ++q)
  {
    bool same = false;
    for (int start = 0; start < 4 && !same; ++start)
    {
      same = sameCycle(q, start, 1) || sameCycle(q, start, -1);
    }
    if (!same)
    {
      throw InvalidInput(
        "the target quads do not have the connectivity of the source quads: quad " +
        std::to_string(q) +
        " has other points. Keep the order of points and cells (SweepQuadProjector does).");
    }
  }
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "SweptHexes.h"

#include "Errors.h"

#include <Eigen/Geometry>

#include <string>

namespace hexsweep
{
namespace
{
/// Sum over the eight corners of all hexes with the quad of layer k as bottom.
double sumOfCornerJacobians(const QuadsRef& quads, const PointsRef& points, Index layers)
{
  const Index n = points.rows() / (layers + 1);
  double sum = 0.0;
  for (Index k = 0; k < layers; ++k)
  {
    for (Index q = 0; q < quads.rows(); ++q)
    {
      for (int c = 0; c < 4; ++c)
      {
        const Index corner = quads(q, c);
        const Index next = quads(q, (c + 1) % 4);
        const Index previous = quads(q, (c + 3) % 4);
        const Index low = k * n;
        const Index high = low + n;
        const Eigen::RowVector3d up = points.row(high + corner) - points.row(low + corner);
        for (const Index layer : { low, high })
        {
          const Eigen::RowVector3d u = points.row(layer + next) - points.row(layer + corner);
          const Eigen::RowVector3d v = points.row(layer + previous) - points.row(layer + corner);
          sum += u.cross(v).dot(up);
        }
      }
    }
  }
  return sum;
}
}

Hexes sweptHexes(const QuadsRef& quads, const PointsRef& points, Index numberOfLayers)
{
  const Index n = points.rows() / (numberOfLayers + 1);
  const Index m = quads.rows();
  const bool sourceIsBottom = sumOfCornerJacobians(quads, points, numberOfLayers) >= 0.0;
  Hexes hexes(numberOfLayers * m, 8);
  for (Index k = 0; k < numberOfLayers; ++k)
  {
    const Index bottom = (sourceIsBottom ? k : k + 1) * n;
    const Index top = (sourceIsBottom ? k + 1 : k) * n;
    hexes.block(k * m, 0, m, 4) = quads.array() + bottom;
    hexes.block(k * m, 4, m, 4) = quads.array() + top;
  }
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

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SweepSize.h"

#include "Core/Common/MemoryBudget.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Surfaces/SurfaceArea.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
double areaOf(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c)
{
  return 0.5 * (b - a).cross(c - a).norm();
}

double areaOf(const SolidSurface& solid, const std::vector<Index>& triangles)
{
  double area = 0.0;
  for (const Index t : triangles)
  {
    area += areaOf(solid.points.row(solid.triangles(t, 0)), solid.points.row(solid.triangles(t, 1)),
      solid.points.row(solid.triangles(t, 2)));
  }
  return area;
}
}

double sideLength(const SolidSurface& solid, const SweepTopology& topology)
{
  double area = 0.0;
  double loops = 0.0;
  for (const SweepSide& side : topology.sides)
  {
    area += areaOf(solid, side.triangles);
    loops += 0.5 *
      (closedLength(loopPoints(solid.points, side.sourceLoop)) +
        closedLength(loopPoints(solid.points, side.targetLoop)));
  }
  return area / loops;
}

double sideLength(const std::vector<SideTube>& sides)
{
  double area = 0.0;
  double loops = 0.0;
  for (const SideTube& side : sides)
  {
    area += surfaceArea(side.surface);
    loops += closedLength(loopPoints(side.surface.points, side.sourceLoop));
  }
  return area / loops;
}

double meanQuadWidth(const QuadMesh& quads)
{
  double area = 0.0;
  for (Index q = 0; q < quads.quads.rows(); ++q)
  {
    const auto corner = [&](int c) -> Eigen::RowVector3d {
      return quads.points.row(quads.quads(q, c));
    };
    area += areaOf(corner(0), corner(1), corner(2)) + areaOf(corner(0), corner(2), corner(3));
  }
  return std::sqrt(area / static_cast<double>(quads.quads.rows()));
}

double meanHexWidth(
  const SolidSurface& solid, const SweepTopology& topology, const QuadMesh& sourceQuads)
{
  const double growth =
    std::sqrt(areaOf(solid, topology.targetTriangles) / areaOf(solid, topology.sourceTriangles));
  return 0.5 * (1.0 + growth) * meanQuadWidth(sourceQuads);
}

double expectedQuads(const SolidSurface& solid, const SweepTopology& topology, double size)
{
  return areaOf(solid, topology.sourceTriangles) / size / size;
}

void checkSweepBudget(double quads, double length, double size, const LayerRequest& layers)
{
  double count = length / (layers.size > 0.0 ? layers.size : size);
  if (!layers.positions.empty())
  {
    count = static_cast<double>(layers.positions.size() + 1);
  }
  else if (layers.size == 0.0 && layers.layers > 0)
  {
    count = static_cast<double>(layers.layers);
  }
  checkHexBudget(std::max(1.0, quads) * std::max(1.0, count),
    "Set Size, QuadSize or LayerSize to larger lengths, or NumberOfLayers to fewer.");
}

double coarseningFor(double length, Index quads, double width, Index most)
{
  const double layers = std::max(1.0, std::round(length / width));
  const double share = static_cast<double>(quads) * layers / static_cast<double>(most);
  return share <= 1.0 ? 1.0 : std::cbrt(share);
}
}

// SPDX-License-Identifier: BSD-3-Clause

#include "Support/TubeMeshes.h"

#include "Core/Geometry/TriangleSearch.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace test
{
Eigen::RowVector3d TwistedBox(double v, double u)
{
  const double side = std::floor(4.0 * v + 1e-9);
  const double along = 4.0 * v - side;
  const Eigen::Rotation2Dd turn(TwoPi / 4.0 * (u - side));
  const Eigen::Vector2d p = turn * Eigen::Vector2d(0.5 - along, -0.5);
  return { -p.x(), -p.y(), 2.0 * u };
}

Points ringOf(Index n, const TubePlace& place, double offset)
{
  Points ring(n, 3);
  for (Index j = 0; j < n; ++j)
  {
    ring.row(j) = place((static_cast<double>(j) + offset) / static_cast<double>(n), 0.0);
  }
  return ring;
}

Loop numbers(Index n)
{
  Loop loop;
  for (Index j = 0; j < n; ++j)
  {
    loop.push_back(j);
  }
  return loop;
}

LinkingMesh meshTube(const SideTube& side, const Points& ring, const LayerRequest& request)
{
  return hexsweep::meshLinkingSides(ring, { numbers(ring.rows()) }, { side }, request);
}

LayerRequest layerRequest(Index count)
{
  LayerRequest request;
  request.layers = count;
  return request;
}

Eigen::RowVector3d node(const LinkingMesh& mesh, Index n, Index k, Index j)
{
  return mesh.rings.points.row(k * n + j);
}

double leastCorner(const LinkingMesh& mesh)
{
  double least = 1.0;
  for (Index q = 0; q < mesh.quads.rows(); ++q)
  {
    Eigen::RowVector3d p[4];
    for (int c = 0; c < 4; ++c)
    {
      p[c] = mesh.rings.points.row(mesh.quads(q, c));
    }
    const Eigen::RowVector3d normal = (p[2] - p[0]).cross(p[3] - p[1]).normalized();
    for (int c = 0; c < 4; ++c)
    {
      const Eigen::RowVector3d a = (p[(c + 1) % 4] - p[c]).normalized();
      const Eigen::RowVector3d b = (p[(c + 3) % 4] - p[c]).normalized();
      least = std::min(least, a.cross(b).dot(normal));
    }
  }
  return least;
}

double greatestDistance(const SideTube& side, const Points& nodes)
{
  const hexsweep::TriangleSearch search(side.surface.points, side.surface.triangles);
  double greatest = 0.0;
  for (Index i = 0; i < nodes.rows(); ++i)
  {
    greatest = std::max(greatest, search.closest(nodes.row(i)).distance);
  }
  return greatest;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/CageMesh.h"

#include "Core/Surfaces/SurfaceTopology.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace hexsweep
{
namespace
{
/// By how much, relatively, the second diagonal must be better.
constexpr double DiagonalPreference = 1e-6;

double tripleProduct(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c)
{
  return a.cross(b).dot(c);
}

double triangleQuality(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c, const Eigen::RowVector3d& normal)
{
  const double lengths = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return lengths > 0.0 ? (b - a).cross(c - a).dot(normal) / lengths : 0.0;
}

/// Quality of the worse triangle when the quad is cut from its corner `first`.
double cutQuality(const Eigen::Matrix<double, 4, 3>& corners, int first)
{
  const auto corner = [&](int c) -> Eigen::RowVector3d { return corners.row((first + c) % 4); };
  const Eigen::RowVector3d normal =
    (corner(2) - corner(0)).cross(corner(3) - corner(1)).normalized();
  return std::min(triangleQuality(corner(0), corner(1), corner(2), normal),
    triangleQuality(corner(0), corner(2), corner(3), normal));
}

template <typename Ids>
Eigen::Matrix<double, 4, 3> cornersOf(const Ids& ids, const PointsRef& points)
{
  Eigen::Matrix<double, 4, 3> corners;
  for (int c = 0; c < 4; ++c)
  {
    corners.row(c) = points.row(ids[c]);
  }
  return corners;
}
}

Points physicalModel(const PointsRef& sourcePoints, const PointsRef& targetPoints,
  const QuadsRef& quads, const SweepBoundary& boundary)
{
  Points physical = Points::Zero((boundary.numberOfLayers() + 1) * sourcePoints.rows(), 3);
  setGivenPoints(sourcePoints, targetPoints, quads, boundary, physical);
  return physical;
}

Quads cageQuads(const QuadsRef& quads, const PointsRef& physical, Index numberOfLayers)
{
  const Index m = quads.rows();
  const Index n = physical.rows() / (numberOfLayers + 1);
  const std::vector<Loop> loops = checkSurface(quads, n, "source quads").loops;
  Index loopEdges = 0;
  for (const Loop& loop : loops)
  {
    loopEdges += static_cast<Index>(loop.size());
  }

  // Outward if the quads' normals lead from the source to the target.
  Quads cage(2 * m + loopEdges * numberOfLayers, 4);
  cage.topRows(m) = quads.rowwise().reverse();
  cage.middleRows(m, m) = quads.array() + numberOfLayers * n;
  Index side = 2 * m;
  for (const Loop& loop : loops)
  {
    for (std::size_t j = 0; j < loop.size(); ++j)
    {
      const Index a = loop[j];
      const Index b = loop[(j + 1) % loop.size()];
      for (Index k = 0; k < numberOfLayers; ++k)
      {
        cage.row(side++) << k * n + a, k * n + b, (k + 1) * n + b, (k + 1) * n + a;
      }
    }
  }
  if (enclosedVolume(cage, physical) < 0.0)
  {
    cage = cage.rowwise().reverse().eval();
  }
  return cage;
}

double enclosedVolume(const QuadsRef& quads, const PointsRef& points)
{
  // About a point of the cage: no digits are lost far from the origin.
  const Eigen::RowVector3d origin = points.row(quads(0, 0));
  double volume = 0.0;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    const auto corners = cornersOf(quads.row(q), points);
    const Eigen::RowVector3d a = corners.row(0) - origin;
    const Eigen::RowVector3d b = corners.row(1) - origin;
    const Eigen::RowVector3d c = corners.row(2) - origin;
    const Eigen::RowVector3d d = corners.row(3) - origin;
    volume += tripleProduct(a, b, c) + tripleProduct(a, c, d) + tripleProduct(b, c, d) +
      tripleProduct(a, b, d);
  }
  return volume / 12.0;
}

CageMesh triangulateCage(const QuadsRef& cage, const PointsRef& physical, const PointsRef& model)
{
  CageMesh mesh;
  mesh.nodes.assign(cage.data(), cage.data() + cage.size());
  std::sort(mesh.nodes.begin(), mesh.nodes.end());
  mesh.nodes.erase(std::unique(mesh.nodes.begin(), mesh.nodes.end()), mesh.nodes.end());
  const auto placeOf = [&](Index row) {
    return std::lower_bound(mesh.nodes.begin(), mesh.nodes.end(), row) - mesh.nodes.begin();
  };

  mesh.triangles.resize(2 * cage.rows(), 3);
  for (Index q = 0; q < cage.rows(); ++q)
  {
    const auto inPhysical = cornersOf(cage.row(q), physical);
    const auto inModel = cornersOf(cage.row(q), model);
    const auto quality = [&](int first) {
      return std::min(cutQuality(inPhysical, first), cutQuality(inModel, first));
    };
    const double from0 = quality(0);
    const double from1 = quality(1);
    const int first = from1 > from0 + DiagonalPreference * std::abs(from0) ? 1 : 0;
    const auto corner = [&](int c) { return placeOf(cage(q, (first + c) % 4)); };
    mesh.triangles.row(2 * q) << corner(0), corner(1), corner(2);
    mesh.triangles.row(2 * q + 1) << corner(0), corner(2), corner(3);
  }
  return mesh;
}

Points cageVertices(const CageMesh& cage, const PointsRef& sweptPoints)
{
  Points vertices(static_cast<Index>(cage.nodes.size()), 3);
  for (std::size_t i = 0; i < cage.nodes.size(); ++i)
  {
    vertices.row(static_cast<Index>(i)) = sweptPoints.row(cage.nodes[i]);
  }
  return vertices;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "CapDisk.h"

#include "DirichletSolver.h"
#include "Errors.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
std::vector<bool> boundaryFlags(Index n, const std::vector<Loop>& loops)
{
  std::vector<bool> flags(static_cast<std::size_t>(n), false);
  for (const Loop& loop : loops)
  {
    for (const Index v : loop)
    {
      flags[static_cast<std::size_t>(v)] = true;
    }
  }
  return flags;
}

PlanePoints mapToPlane(const TriangleMesh& mesh, const std::vector<Loop>& loops,
  const std::vector<PlanePoints>& places, Weights weights)
{
  const Index n = mesh.points.rows();
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(n, 2);
  for (std::size_t p = 0; p < loops.size(); ++p)
  {
    for (std::size_t k = 0; k < loops[p].size(); ++k)
    {
      values.row(loops[p][k]) = places[p].row(static_cast<Index>(k));
    }
  }
  const DirichletSolver solver(
    surfaceLaplacian(mesh.points, mesh.triangles, weights), boundaryFlags(n, loops));
  return solver.solve(values);
}

void separateCircles(std::vector<Circle>& circles)
{
  for (std::size_t i = 0; i < circles.size(); ++i)
  {
    double room = 0.5 * (1.0 - circles[i].center.norm());
    for (std::size_t j = 0; j < circles.size(); ++j)
    {
      if (j != i)
      {
        room = std::min(room, 0.4 * (circles[i].center - circles[j].center).norm());
      }
    }
    if (!(room > 0.0))
    {
      throw InvalidInput("two holes fall on one point of the disk: the triangulation between them "
                         "is too coarse or too distorted. Refine it, or smooth it first.");
    }
    circles[i].radius = std::min(circles[i].radius, room);
  }
}

std::vector<double> holeAngles(
  const std::vector<double>& lengths, const PlanePoints& disk, const Loop& loop, const Circle& hole)
{
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t k = 0; k < lengths.size(); ++k)
  {
    const Eigen::RowVector2d arm = disk.row(loop[k]) - hole.center;
    const double turn = std::atan2(arm.y(), arm.x()) + lengths[k];
    cosine += std::cos(turn);
    sine += std::sin(turn);
  }
  const double turn = std::atan2(sine, cosine);
  std::vector<double> angles;
  for (const double length : lengths)
  {
    angles.push_back(turn - length);
  }
  return angles;
}

void mapWithFallback(
  CapDisk& result, Weights weights, const std::function<PlanePoints(Weights)>& map)
{
  result.weights = weights;
  result.disk = map(weights);
  result.flipped = domainTriangles(result.domain, result.disk, result.mesh.triangles).flipped;
  result.flipsBefore = static_cast<Index>(result.flipped.size());
  if (result.flipped.empty() || weights == Weights::MeanValue)
  {
    return;
  }
  PlanePoints disk = map(Weights::MeanValue);
  std::vector<Index> flipped = domainTriangles(result.domain, disk, result.mesh.triangles).flipped;
  if (flipped.size() < result.flipped.size())
  {
    result.disk = std::move(disk);
    result.flipped = std::move(flipped);
    result.weights = Weights::MeanValue;
  }
}
}

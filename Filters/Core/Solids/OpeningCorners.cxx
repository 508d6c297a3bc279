// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/OpeningCorners.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Errors.h"
#include "Core/Linking/LinkingSides.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace hexsweep
{
namespace
{
constexpr double WidestSingle = 145.0 * Pi / 180.0; // of corners that one quad may fill
constexpr double GoodSine = 0.5;                    // 150 degrees
constexpr double WorthIt = 1.25;                    // of the sine that a node has
constexpr Index MostFurther = 2;                    // quads that a node gets

/// What the quads have at each of their points.
struct QuadCorners
{
  std::vector<Index> count;
  std::vector<double> angle; ///< sum over the quads
};

QuadCorners quadCorners(const QuadMesh& mesh)
{
  QuadCorners corners{ std::vector<Index>(static_cast<std::size_t>(mesh.points.rows()), 0),
    std::vector<double>(static_cast<std::size_t>(mesh.points.rows()), 0.0) };
  for (Index q = 0; q < mesh.quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      const auto here = static_cast<std::size_t>(mesh.quads(q, c));
      const Eigen::RowVector3d p = mesh.points.row(mesh.quads(q, c));
      const Eigen::RowVector3d u = mesh.points.row(mesh.quads(q, (c + 1) % 4)) - p;
      const Eigen::RowVector3d v = mesh.points.row(mesh.quads(q, (c + 3) % 4)) - p;
      ++corners.count[here];
      corners.angle[here] += std::atan2(u.cross(v).norm(), u.dot(v));
    }
  }
  return corners;
}

/// Angles from the edge to the next node to that to the node before, about the column: one row a
/// ring, one column a node, in [0, 2 pi).
Eigen::MatrixXd ringAngles(const RingStack& rings, std::size_t loop)
{
  const RingTable& table = rings.tables[loop];
  const Index last = table.rows() - 1;
  const Index n = table.cols();
  Eigen::MatrixXd angles(table.rows(), n);
  for (Index k = 0; k <= last; ++k)
  {
    for (Index j = 0; j < n; ++j)
    {
      const Eigen::RowVector3d here = rings.points.row(table(k, j));
      const Eigen::RowVector3d way = (rings.points.row(table(std::min(k + 1, last), j)) -
        rings.points.row(table(std::max<Index>(k - 1, 0), j)))
                                       .normalized();
      Eigen::RowVector3d u = rings.points.row(table(k, (j + 1) % n)) - here;
      Eigen::RowVector3d v = rings.points.row(table(k, (j + n - 1) % n)) - here;
      u -= u.dot(way) * way;
      v -= v.dot(way) * way;
      const double angle = std::atan2(way.dot(u.cross(v)), u.dot(v));
      angles(k, j) = angle < 0.0 ? angle + 2.0 * Pi : angle;
    }
  }
  return angles;
}

/// Least sine of an m-th of the angles.
double leastSine(const Eigen::VectorXd& angles, Index m)
{
  double least = 1.0;
  for (const double angle : angles)
  {
    least = std::min(least, std::sin(angle / static_cast<double>(m)));
  }
  return least;
}

/// How many quads share these angles best, at least as many as there are.
Index bestCount(const Eigen::VectorXd& angles, Index count)
{
  Index best = count;
  double sine = leastSine(angles, count);
  if (sine >= GoodSine)
  {
    return count;
  }
  for (Index m = count + 1; m <= count + MostFurther; ++m)
  {
    const double other = leastSine(angles, m);
    if (other > WorthIt * std::max(sine, 0.0))
    {
      best = m;
      sine = other;
    }
  }
  return best;
}

std::optional<LinkingMesh> columnsOf(const QuadMesh& quads, const std::vector<Loop>& loops,
  const std::vector<SideTube>& sides, Index layers, const Progress& progress)
{
  LayerRequest request;
  request.layers = layers;
  try
  {
    return meshLinkingSides(quads.points, loops, sides, request, 1e-6, progress);
  }
  catch (const InvalidInput&)
  {
    return std::nullopt;
  }
  catch (const SolverFailure&)
  {
    return std::nullopt;
  }
}
}

std::vector<CornerFan> openingCorners(const QuadMesh& quads, const std::vector<Loop>& loops,
  const std::vector<SideTube>& sides, Index layers, const Progress& progress)
{
  std::vector<CornerFan> fans;
  bool isWanting = false;
  const std::optional<LinkingMesh> columns = columnsOf(quads, loops, sides, layers, progress);
  if (!columns)
  {
    return fans;
  }
  const QuadCorners corners = quadCorners(quads);
  std::vector<Eigen::MatrixXd> angles;
  // Quads may be oriented either way: as it fits their own angles.
  double asGiven = 0.0;
  double turned = 0.0;
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    angles.push_back(ringAngles(columns->rings, l));
    for (std::size_t j = 0; j < loops[l].size(); ++j)
    {
      const double own = corners.angle[static_cast<std::size_t>(loops[l][j])];
      const double seen = angles.back()(0, static_cast<Index>(j));
      asGiven += std::abs(seen - own);
      turned += std::abs(2.0 * Pi - seen - own);
    }
  }
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    for (std::size_t j = 0; j < loops[l].size(); ++j)
    {
      Eigen::VectorXd own = angles[l].col(static_cast<Index>(j));
      if (turned < asGiven)
      {
        own = 2.0 * Pi - own.array();
      }
      const auto node = static_cast<std::size_t>(loops[l][j]);
      const Index count = corners.count[node];
      // Other quads may leave a single one where there are more now.
      const Index best = bestCount(own, corners.angle[node] < WidestSingle ? 1 : count);
      if (best > count || (best > 1 && corners.angle[node] < WidestSingle))
      {
        fans.push_back({ quads.points.row(loops[l][j]), best });
        isWanting = isWanting || best > count;
      }
    }
  }
  return isWanting ? fans : std::vector<CornerFan>{};
}
}

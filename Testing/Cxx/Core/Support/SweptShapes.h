// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tessellated solids that a section draws on its way.
 */
#ifndef SweptShapes_h
#define SweptShapes_h

#include "Support/CapMeshes.h"

#include "Core/Common/Constants.h"
#include "Core/Solids/SolidInput.h"

#include <cmath>
#include <functional>
#include <vector>

namespace test
{
constexpr Index BottomFace = 1;
constexpr Index TopFace = 2;

/// Where the point (x, y) of the section is after the share t, in [0, 1], of the way.
using Path = std::function<Eigen::RowVector3d(double x, double y, double t)>;
/// Face of the side quad from corner j of the section to the next, between rings k and k + 1.
using SideFace = std::function<Index(int j, int k)>;

/// The section must be star-shaped about (0, 0), counter-clockwise; the caps are fans, BottomFace
/// at t = 0 and TopFace at t = 1.
inline hexsweep::SolidInput sweptSolid(const std::vector<Eigen::RowVector2d>& section, int rings,
  const Path& path, const SideFace& sideFace)
{
  const auto n = static_cast<int>(section.size());
  hexsweep::SolidInput solid;
  solid.points.resize((rings + 1) * n + 2, 3);
  for (int k = 0; k <= rings; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      const Eigen::RowVector2d& p = section[static_cast<std::size_t>(j)];
      solid.points.row(k * n + j) = path(p.x(), p.y(), static_cast<double>(k) / rings);
    }
  }
  const Index bottom = (rings + 1) * n;
  solid.points.row(bottom) = path(0.0, 0.0, 0.0);
  solid.points.row(bottom + 1) = path(0.0, 0.0, 1.0);
  std::vector<Index> corners;
  const auto add = [&](Index a, Index b, Index c, Index face) {
    corners.insert(corners.end(), { a, b, c });
    solid.faceIds.push_back(face);
  };
  for (int j = 0; j < n; ++j)
  {
    const int next = (j + 1) % n;
    add(bottom, next, j, BottomFace);
    add(bottom + 1, rings * n + j, rings * n + next, TopFace);
    for (int k = 0; k < rings; ++k)
    {
      add(k * n + j, k * n + next, (k + 1) * n + next, sideFace(j, k));
      add(k * n + j, (k + 1) * n + next, (k + 1) * n + j, sideFace(j, k));
    }
  }
  solid.triangles = facesOf<hexsweep::Triangles>(corners);
  return solid;
}

/// Corners of radius radius(j).
inline std::vector<Eigen::RowVector2d> polygon(int n, const std::function<double(int)>& radius)
{
  std::vector<Eigen::RowVector2d> corners;
  for (int j = 0; j < n; ++j)
  {
    const double angle = 2.0 * hexsweep::Pi * j / n;
    corners.emplace_back(radius(j) * std::cos(angle), radius(j) * std::sin(angle));
  }
  return corners;
}

inline std::vector<Eigen::RowVector2d> circle(int n, double radius)
{
  return polygon(n, [=](int) { return radius; });
}

/// a x b, its corners at (+-a / 2, +-b / 2).
inline std::vector<Eigen::RowVector2d> rectangle(double a, double b)
{
  const double x = 0.5 * a;
  const double y = 0.5 * b;
  return { { -x, -y }, { x, -y }, { x, y }, { -x, y } };
}

/// Straight up, with the size of the section at t.
inline Path upward(double height, const std::function<double(double)>& size)
{
  return [=](double x, double y, double t) {
    return Eigen::RowVector3d(size(t) * x, size(t) * y, height * t);
  };
}

inline Path upward(double height)
{
  return upward(height, [](double) { return 1.0; });
}

/// Round an axis at x = -radius, by an angle.
inline Path roundBend(double radius, double angle)
{
  return [=](double x, double y, double t) {
    const double r = radius + x;
    return Eigen::RowVector3d(r * std::cos(angle * t), -y, r * std::sin(angle * t));
  };
}
}

#endif

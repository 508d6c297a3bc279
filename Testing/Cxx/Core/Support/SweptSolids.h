// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Solids swept from a plane section with holes, tessellated as a CAD system would.
 */
#ifndef SweptSolids_h
#define SweptSolids_h

#include "Support/CoarsePlates.h"

#include "Core/Solids/SolidInput.h"

#include <functional>

namespace test
{
/// A closed polygon of the plane, counter-clockwise for an outline, clockwise for a hole.
using Section = std::vector<Eigen::RowVector2d>;

inline Section circleSection(double x, double y, double radius, Index nodes, double start = 0.0)
{
  Section section;
  for (Index j = 0; j < nodes; ++j)
  {
    const double angle = start + 2.0 * Pi * static_cast<double>(j) / static_cast<double>(nodes);
    section.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  return section;
}

inline Section holeSection(double x, double y, double radius, Index nodes)
{
  Section section = circleSection(x, y, radius, nodes);
  std::reverse(section.begin(), section.end());
  return section;
}

/**
 * The caps are cut into ears of the loops' nodes, the target cap from another node on, so that the
 * two triangulations differ; the sides are quads in two triangles. Face 1 is the source cap, 2 the
 * target cap, 10 + loop the sides.
 *
 * @param sections outline first, then holes.
 * @param place    of (x, y, height in [0, 1]).
 */
inline hexsweep::SolidInput sweptSolid(const std::vector<Section>& sections,
  const std::function<Eigen::RowVector3d(double, double, double)>& place, Index levels = 1)
{
  std::vector<Eigen::RowVector2d> nodes;
  std::vector<std::vector<Index>> loops;
  for (const Section& section : sections)
  {
    loops.emplace_back();
    for (const Eigen::RowVector2d& node : section)
    {
      loops.back().push_back(static_cast<Index>(nodes.size()));
      nodes.push_back(node);
    }
  }
  const Index n = static_cast<Index>(nodes.size());
  Points plane = Points::Zero(n, 3);
  hexsweep::SolidInput solid;
  solid.points.resize(n * (levels + 1), 3);
  for (Index i = 0; i < n; ++i)
  {
    plane.row(i).head<2>() = nodes[static_cast<std::size_t>(i)];
    for (Index k = 0; k <= levels; ++k)
    {
      solid.points.row(k * n + i) =
        place(plane(i, 0), plane(i, 1), static_cast<double>(k) / static_cast<double>(levels));
    }
  }
  std::vector<Index> corners;
  const auto add = [&](Index a, Index b, Index c, Index face) {
    corners.insert(corners.end(), { a, b, c });
    solid.faceIds.push_back(face);
  };
  const std::vector<std::vector<Index>> holes(loops.begin() + 1, loops.end());
  const Triangles bottom = earsOf(plane, bridged(plane, loops[0], holes));
  std::vector<Index> turned = loops[0];
  std::rotate(
    turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(turned.size() / 2), turned.end());
  const Triangles top = earsOf(plane, bridged(plane, turned, holes));
  for (Index t = 0; t < bottom.rows(); ++t)
  {
    add(bottom(t, 0), bottom(t, 2), bottom(t, 1), 1);
    add(levels * n + top(t, 0), levels * n + top(t, 1), levels * n + top(t, 2), 2);
  }
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    for (std::size_t j = 0; j < loops[l].size(); ++j)
    {
      for (Index k = 0; k < levels; ++k)
      {
        const Index a = k * n + loops[l][j];
        const Index b = k * n + loops[l][(j + 1) % loops[l].size()];
        add(a, b, b + n, 10 + static_cast<Index>(l));
        add(a, b + n, a + n, 10 + static_cast<Index>(l));
      }
    }
  }
  solid.triangles = facesOf<Triangles>(corners);
  return solid;
}
}

#endif

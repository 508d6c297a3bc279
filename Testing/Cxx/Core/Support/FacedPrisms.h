// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Solids swept from a plane outline whose caps consist of several faces.
 */
#ifndef FacedPrisms_h
#define FacedPrisms_h

#include "Support/SweptSolids.h"

#include <Eigen/Geometry>

#include <map>

namespace test
{
/// A face of a cap: its outline, counter-clockwise, and its holes, clockwise, which other faces
/// fill. Corners of one face on an edge of another must be corners of both.
struct CapFace
{
  Index id;
  Section outline;
  std::vector<Section> holes;
};

using Place3 = std::function<Eigen::RowVector3d(double, double, double)>;

/// Area of a face where the sweep takes it, of an affine image of the plane.
inline double areaOfFace(const CapFace& face, const Place3& place, double height)
{
  std::vector<Section> loops = face.holes;
  loops.push_back(face.outline);
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const Section& loop : loops)
  {
    const Eigen::RowVector3d first = place(loop[0].x(), loop[0].y(), height);
    for (std::size_t j = 0; j < loop.size(); ++j)
    {
      const Eigen::RowVector2d& a = loop[j];
      const Eigen::RowVector2d& b = loop[(j + 1) % loop.size()];
      sum += 0.5 * (place(a.x(), a.y(), height) - first).cross(place(b.x(), b.y(), height) - first);
    }
  }
  return sum.norm();
}

/// The triangles of a cap over points of its own.
struct PlaneCap
{
  std::vector<Eigen::RowVector2d> nodes;
  std::vector<std::array<Index, 3>> triangles; ///< counter-clockwise
  std::vector<Index> faceIds;
  std::vector<Index> loop; ///< counter-clockwise, from the node nearest to the first one given
};

inline PlaneCap planeCap(const std::vector<CapFace>& faces, const Eigen::RowVector2d& start)
{
  PlaneCap cap;
  std::map<std::pair<double, double>, Index> ids;
  std::map<Index, Index> next; // along the boundary
  std::map<std::pair<Index, Index>, int> sides;
  for (const CapFace& face : faces)
  {
    std::vector<std::vector<Index>> loops;
    std::vector<Section> sections{ face.outline };
    sections.insert(sections.end(), face.holes.begin(), face.holes.end());
    for (const Section& section : sections)
    {
      loops.emplace_back();
      for (const Eigen::RowVector2d& node : section)
      {
        const auto known =
          ids.emplace(std::make_pair(node.x(), node.y()), static_cast<Index>(cap.nodes.size()));
        if (known.second)
        {
          cap.nodes.push_back(node);
        }
        loops.back().push_back(known.first->second);
      }
    }
    Points plane = Points::Zero(static_cast<Index>(cap.nodes.size()), 3);
    for (std::size_t i = 0; i < cap.nodes.size(); ++i)
    {
      plane.row(static_cast<Index>(i)).head<2>() = cap.nodes[i];
    }
    const Triangles ears =
      earsOf(plane, bridged(plane, loops[0], { loops.begin() + 1, loops.end() }));
    for (Index t = 0; t < ears.rows(); ++t)
    {
      cap.triangles.push_back({ ears(t, 0), ears(t, 1), ears(t, 2) });
      cap.faceIds.push_back(face.id);
      for (Index c = 0; c < 3; ++c)
      {
        ++sides[{ ears(t, c), ears(t, (c + 1) % 3) }];
      }
    }
  }
  for (const auto& side : sides)
  {
    if (sides.count({ side.first.second, side.first.first }) == 0)
    {
      next[side.first.first] = side.first.second;
    }
  }
  Index first = next.begin()->first;
  for (const auto& edge : next)
  {
    const auto apart = [&](Index i) {
      return (cap.nodes[static_cast<std::size_t>(i)] - start).norm();
    };
    first = apart(edge.first) < apart(first) ? edge.first : first;
  }
  for (Index node = first; cap.loop.empty() || node != first; node = next.at(node))
  {
    cap.loop.push_back(node);
  }
  return cap;
}

/// Where the loop of a cap turns by more than 60 degrees. @param reached length up to each node.
inline std::vector<double> cornersOf(const PlaneCap& cap, const std::vector<double>& reached)
{
  std::vector<double> corners;
  const std::size_t n = cap.loop.size();
  const auto node = [&](std::size_t j) -> Eigen::RowVector2d {
    return cap.nodes[static_cast<std::size_t>(cap.loop[j % n])];
  };
  for (std::size_t j = 0; j < n; ++j)
  {
    const Eigen::RowVector2d in = node(j) - node(j + n - 1);
    const Eigen::RowVector2d out = node(j + 1) - node(j);
    if (in.dot(out) < 0.5 * in.norm() * out.norm())
    {
      corners.push_back(reached[j]);
    }
  }
  return corners;
}

/**
 * A solid between two caps over the same outline. The side has the nodes of both loops and a face
 * for each stretch between corners of the bottom (more than 60 degrees), numbered from 100.
 *
 * @param bottom, top the caps' faces. @param start a corner of the outline.
 * @param place       of (x, y, height in [0, 1]).
 */
inline hexsweep::SolidInput facedPrism(const std::vector<CapFace>& bottom,
  const std::vector<CapFace>& top, const Eigen::RowVector2d& start, const Place3& place)
{
  const PlaneCap caps[2] = { planeCap(bottom, start), planeCap(top, start) };
  const Index n = static_cast<Index>(caps[0].nodes.size());
  hexsweep::SolidInput solid;
  solid.points.resize(n + static_cast<Index>(caps[1].nodes.size()), 3);
  std::vector<Index> corners;
  std::vector<double> reached[2];
  for (Index k = 0; k < 2; ++k)
  {
    const PlaneCap& cap = caps[k];
    for (std::size_t i = 0; i < cap.nodes.size(); ++i)
    {
      solid.points.row(k * n + static_cast<Index>(i)) =
        place(cap.nodes[i].x(), cap.nodes[i].y(), static_cast<double>(k));
    }
    for (std::size_t t = 0; t < cap.triangles.size(); ++t)
    {
      const auto& [a, b, c] = cap.triangles[t];
      corners.insert(
        corners.end(), { k * n + a, k * n + (k == 0 ? c : b), k * n + (k == 0 ? b : c) });
      solid.faceIds.push_back(cap.faceIds[t]);
    }
    reached[k].push_back(0.0);
    for (std::size_t j = 0; j < cap.loop.size(); ++j)
    {
      reached[k].push_back(reached[k].back() +
        (cap.nodes[static_cast<std::size_t>(cap.loop[(j + 1) % cap.loop.size()])] -
          cap.nodes[static_cast<std::size_t>(cap.loop[j])])
          .norm());
    }
  }
  const std::vector<double> turns = cornersOf(caps[0], reached[0]);
  // Up the side, always to the node that comes next on either loop.
  std::size_t at[2] = { 0, 0 };
  const auto node = [&](std::size_t k) {
    return static_cast<Index>(k) * n + caps[k].loop[at[k] % caps[k].loop.size()];
  };
  while (at[0] < caps[0].loop.size() || at[1] < caps[1].loop.size())
  {
    const bool below = at[1] == caps[1].loop.size() ||
      (at[0] < caps[0].loop.size() &&
        reached[0][at[0] + 1] <= reached[1][at[1] + 1] * (1.0 + 1e-12));
    const Index a = node(0);
    const Index b = node(1);
    const std::size_t k = below ? 0 : 1;
    const double middle = 0.5 * (reached[k][at[k]] + reached[k][at[k] + 1]);
    ++at[below ? 0 : 1];
    corners.insert(corners.end(), { a, node(below ? 0 : 1), b });
    solid.faceIds.push_back(
      100 + (std::lower_bound(turns.begin(), turns.end(), middle) - turns.begin()));
  }
  solid.triangles = facesOf<Triangles>(corners);
  return solid;
}
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/CapSections.h"

#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/PlaneTriangleSearch.h"
#include "Core/Geometry/SolidAngle.h"
#include "Core/Stacks/ConstrainedTriangulation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace hexsweep
{
namespace
{
using PlacePoint = PlaneTriangulation::Point;
using FlatTriangle = std::array<PlacePoint, 3>;

PlacePoint pointAt(const Eigen::RowVector2d& place)
{
  return { place.x(), place.y() };
}

/// What of a solid lies in a plane: a graph whose nodes are points on it and crossed edges.
class PlaneTrace
{
public:
  PlaneTrace(const PointsRef& points, const TrianglesRef& triangles, double level, double tolerance)
    : Places(points)
    , Level(level)
  {
    for (Index i = 0; i < points.rows(); ++i)
    {
      const double above = points(i, 2) - level;
      this->Sides.push_back(std::abs(above) <= tolerance ? 0 : above > 0.0 ? 1 : -1);
    }
    for (Index t = 0; t < triangles.rows(); ++t)
    {
      this->add(triangles.row(t));
    }
  }

  const std::vector<FlatTriangle>& flat() const { return this->Flat; }

  /// The graph of the borders; node i of it is point `Nodes[i]`, or crossing ~Nodes[i].
  PlaneGraph graph() const
  {
    PlaneGraph graph;
    graph.points.resize(static_cast<Index>(this->Nodes.size()), 2);
    for (std::size_t i = 0; i < this->Nodes.size(); ++i)
    {
      graph.points.row(static_cast<Index>(i)) = this->placeOf(this->Nodes[i]);
    }
    graph.edges = this->Edges;
    std::sort(graph.edges.begin(), graph.edges.end());
    graph.edges.erase(std::unique(graph.edges.begin(), graph.edges.end()), graph.edges.end());
    graph.tolerance.assign(graph.edges.size(), 0.0);
    graph.corner.assign(this->Nodes.size(), false);
    return graph;
  }

  const std::vector<Index>& nodes() const { return this->Nodes; }
  const std::vector<EdgeCrossing>& crossings() const { return this->Crossings; }

private:
  template <typename Corners>
  void add(const Corners& corners)
  {
    std::vector<Index> on;
    std::vector<Index> crossed;
    for (Index c = 0; c < 3; ++c)
    {
      const Index a = corners[c];
      const Index b = corners[(c + 1) % 3];
      if (this->Sides[at(a)] == 0)
      {
        on.push_back(a);
      }
      if (this->Sides[at(a)] * this->Sides[at(b)] < 0)
      {
        crossed.push_back(this->crossingOf(a, b));
      }
    }
    if (on.size() == 3)
    {
      this->Flat.push_back({ pointAt(this->placeOf(on[0])), pointAt(this->placeOf(on[1])),
        pointAt(this->placeOf(on[2])) });
      return;
    }
    std::vector<Index> ends = on;
    ends.insert(ends.end(), crossed.begin(), crossed.end());
    if (ends.size() == 2)
    {
      this->Edges.push_back(std::minmax({ this->nodeOf(ends[0]), this->nodeOf(ends[1]) }));
    }
  }

  /// Its number, as ~number.
  Index crossingOf(Index a, Index b)
  {
    const std::pair<Index, Index> edge = std::minmax({ a, b });
    const auto [known, isNew] =
      this->CrossingOf.try_emplace(edge, static_cast<Index>(this->Crossings.size()));
    if (isNew)
    {
      const double low = this->Places(edge.first, 2);
      const double high = this->Places(edge.second, 2);
      this->Crossings.push_back({ edge.first, edge.second, (this->Level - low) / (high - low) });
    }
    return ~known->second;
  }

  Index nodeOf(Index name)
  {
    const auto [known, isNew] =
      this->NodeOf.try_emplace(name, static_cast<Index>(this->Nodes.size()));
    if (isNew)
    {
      this->Nodes.push_back(name);
    }
    return known->second;
  }

  Eigen::RowVector2d placeOf(Index name) const
  {
    if (name >= 0)
    {
      return this->Places.row(name).head<2>();
    }
    const EdgeCrossing& crossing = this->Crossings[at(~name)];
    return (1.0 - crossing.fraction) * this->Places.row(crossing.low).head<2>() +
      crossing.fraction * this->Places.row(crossing.high).head<2>();
  }

  const PointsRef Places;
  double Level;
  std::vector<int> Sides;
  std::vector<FlatTriangle> Flat;
  std::vector<EdgeCrossing> Crossings;
  std::map<std::pair<Index, Index>, Index> CrossingOf;
  std::vector<Index> Nodes;
  std::map<Index, Index> NodeOf;
  Segments Edges;
};

enum class RegionKind
{
  Outside,
  Cap,
  Inside
};

/// Tells what the regions of a plane are to a solid.
class RegionKinds
{
public:
  RegionKinds(const PointsRef& points, const TrianglesRef& triangles, double level,
    const std::vector<FlatTriangle>& flat)
    : Places(points)
    , Corners(triangles)
    , Level(level)
    , Flat(flat)
  {
  }

  RegionKind kindAt(const Eigen::RowVector2d& place) const
  {
    const PlacePoint q = pointAt(place);
    const auto holds = [&](const FlatTriangle& t) {
      return holdsPoint(t[0], t[1], t[2], q) || holdsPoint(t[0], t[2], t[1], q);
    };
    if (std::any_of(this->Flat.begin(), this->Flat.end(), holds))
    {
      return RegionKind::Cap;
    }
    const Eigen::RowVector3d eye(place[0], place[1], this->Level);
    double angle = 0.0;
    for (Index t = 0; t < this->Corners.rows(); ++t)
    {
      angle += solidAngle(this->Places.row(this->Corners(t, 0)),
        this->Places.row(this->Corners(t, 1)), this->Places.row(this->Corners(t, 2)), eye);
    }
    return std::abs(angle) > InsideAngle ? RegionKind::Inside : RegionKind::Outside;
  }

private:
  const PointsRef Places;
  const TrianglesRef Corners;
  double Level;
  const std::vector<FlatTriangle>& Flat;
};

/// The middle of the largest triangle of each region.
std::vector<Eigen::RowVector2d> middlesOf(
  const ConstrainedTriangles& mesh, const PlanePointsRef& points)
{
  std::vector<Eigen::RowVector2d> middles(at(mesh.regions), Eigen::RowVector2d::Zero());
  std::vector<double> areas(at(mesh.regions), -1.0);
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const Eigen::RowVector2d a = points.row(mesh.triangles(t, 0));
    const Eigen::RowVector2d b = points.row(mesh.triangles(t, 1));
    const Eigen::RowVector2d c = points.row(mesh.triangles(t, 2));
    const double area = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
    const std::size_t region = at(mesh.regionOf[at(t)]);
    if (area > areas[region])
    {
      areas[region] = area;
      middles[region] = (a + b + c) / 3.0;
    }
  }
  return middles;
}

/// Which regions are inside and border on a cap.
std::vector<bool> sheets(const ConstrainedTriangles& mesh, const std::vector<RegionKind>& kinds)
{
  std::vector<bool> result(kinds.size(), false);
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const std::size_t own = at(mesh.regionOf[at(t)]);
    for (Index c = 0; c < 3 && kinds[own] == RegionKind::Inside; ++c)
    {
      const Index across = mesh.neighbors(t, c);
      if (across >= 0 && kinds[at(mesh.regionOf[at(across)])] == RegionKind::Cap)
      {
        result[own] = true;
      }
    }
  }
  return result;
}
}

std::vector<double> capLevels(const SolidSurface& solid, const CapLikeFaces& faces,
  const Eigen::VectorXd& heights, double tolerance)
{
  struct Range
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
  };
  std::vector<Range> ranges(faces.faces.size());
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    Range& own = ranges[faces.faceOf[at(t)]];
    for (Index c = 0; c < 3; ++c)
    {
      own.low = std::min(own.low, heights[solid.triangles(t, c)]);
      own.high = std::max(own.high, heights[solid.triangles(t, c)]);
    }
  }
  std::vector<double> all;
  for (std::size_t f = 0; f < ranges.size(); ++f)
  {
    const StackFaceKind kind = faces.faces[f].kind;
    if (kind != StackFaceKind::Side && ranges[f].high - ranges[f].low <= tolerance)
    {
      all.push_back(0.5 * (ranges[f].low + ranges[f].high));
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<double> levels;
  for (const double level : all)
  {
    const bool isEnd =
      level <= heights.minCoeff() + tolerance || level >= heights.maxCoeff() - tolerance;
    if (!isEnd && (levels.empty() || level > levels.back() + tolerance))
    {
      levels.push_back(level);
    }
  }
  return levels;
}

CapSection sectionAt(
  const PointsRef& framePoints, const TrianglesRef& triangles, double level, double tolerance)
{
  CapSection section;
  const PlaneTrace trace(framePoints, triangles, level, tolerance);
  if (trace.flat().empty())
  {
    return section;
  }
  const PlaneGraph graph = trace.graph();
  const ConstrainedTriangles mesh = triangulateGraph(graph);
  const RegionKinds judge(framePoints, triangles, level, trace.flat());
  std::vector<RegionKind> kinds;
  for (const Eigen::RowVector2d& middle : middlesOf(mesh, graph.points))
  {
    kinds.push_back(judge.kindAt(middle));
  }
  const std::vector<bool> isSheet = sheets(mesh, kinds);
  std::map<Index, Index> crossingOf; // its number in the section, by that in the trace
  std::map<Index, Index> sheetOf;
  std::vector<std::array<Index, 3>> rows;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const Index region = mesh.regionOf[at(t)];
    if (!isSheet[at(region)])
    {
      continue;
    }
    section.sheetOf.push_back(
      sheetOf.try_emplace(region, static_cast<Index>(sheetOf.size())).first->second);
    std::array<Index, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      const Index name = trace.nodes()[at(mesh.triangles(t, static_cast<Index>(c)))];
      corners[c] = name;
      if (name < 0)
      {
        const auto [known, isNew] =
          crossingOf.try_emplace(~name, static_cast<Index>(section.crossings.size()));
        if (isNew)
        {
          section.crossings.push_back(trace.crossings()[at(~name)]);
        }
        corners[c] = framePoints.rows() + known->second;
      }
    }
    rows.push_back(corners);
  }
  section.triangles.resize(static_cast<Index>(rows.size()), 3);
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    section.triangles.row(static_cast<Index>(r)) << rows[r][0], rows[r][1], rows[r][2];
  }
  return section;
}
}

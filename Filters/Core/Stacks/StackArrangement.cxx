// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/StackArrangement.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Describe.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Surfaces/HalfEdgeTriangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace hexsweep
{
namespace
{
constexpr double PartOfFeature = 0.04; // of the greater extent of what hangs together
constexpr double SmoothTurn = 40.0 * Pi / 180.0;
constexpr double RiseSlack = 1.5;
constexpr double SliverWidth = 0.6; // of the tolerance
constexpr std::size_t MostSamples = 8;

bool isCapKind(StackFaceKind kind)
{
  return kind == StackFaceKind::Top || kind == StackFaceKind::Bottom;
}

/// Points of the solid where three faces or more meet.
std::vector<bool> modelCorners(const SolidSurface& solid, const CapLikeFaces& faces)
{
  std::vector<std::set<std::size_t>> at(static_cast<std::size_t>(solid.points.rows()));
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      at[static_cast<std::size_t>(solid.triangles(t, c))].insert(
        faces.faceOf[static_cast<std::size_t>(t)]);
    }
  }
  std::vector<bool> corner;
  for (const std::set<std::size_t>& all : at)
  {
    corner.push_back(all.size() > 2);
  }
  return corner;
}

/// How high a curve rises over chords that turn by an angle at their ends.
double riseOf(double length, double turn)
{
  return turn < SmoothTurn ? 0.5 * length * std::tan(0.25 * turn) : 0.0;
}

/// Tolerances and rises of the borders, see PlaneSegments.
void limitSegments(double tolerance, PlaneSegments& result)
{
  const std::size_t n = static_cast<std::size_t>(result.points.rows());
  std::vector<std::vector<Index>> neighbors(n);
  DisjointSets sets(static_cast<Index>(n));
  for (const auto& [a, b] : result.segments)
  {
    neighbors[static_cast<std::size_t>(a)].push_back(b);
    neighbors[static_cast<std::size_t>(b)].push_back(a);
    sets.join(a, b);
  }
  std::map<Index, PlaneBox> boxes;
  for (const auto& [a, b] : result.segments)
  {
    boxes[sets.find(a)].extend(result.points(a, 0), result.points(a, 1));
    boxes[sets.find(a)].extend(result.points(b, 0), result.points(b, 1));
  }
  const auto turnAt = [&](Index i) {
    const std::vector<Index>& all = neighbors[static_cast<std::size_t>(i)];
    if (all.size() != 2 || result.corner[static_cast<std::size_t>(i)])
    {
      return 0.0;
    }
    const Eigen::RowVector2d in = result.points.row(i) - result.points.row(all[0]);
    const Eigen::RowVector2d out = result.points.row(all[1]) - result.points.row(i);
    return std::atan2(std::abs(in.x() * out.y() - in.y() * out.x()), in.dot(out));
  };
  for (const auto& [a, b] : result.segments)
  {
    const PlaneBox& box = boxes[sets.find(a)];
    const double extent = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
    result.tolerance.push_back(std::min(tolerance, PartOfFeature * extent));
    const double length = (result.points.row(b) - result.points.row(a)).norm();
    result.rise.push_back(
      RiseSlack * std::max(riseOf(length, turnAt(a)), riseOf(length, turnAt(b))));
  }
}

PlaneSegments bordersOf(const SolidSurface& solid, const CapLikeFaces& faces,
  const PointsRef& framePoints, double tolerance)
{
  const HalfEdgeTriangles halfEdges(solid.triangles);
  PlaneSegments result;
  result.points = framePoints.leftCols<2>();
  result.corner = modelCorners(solid, faces);
  for (Index h = 0; h < halfEdges.numberOfHalfEdges(); ++h)
  {
    const std::size_t own = faces.faceOf[static_cast<std::size_t>(h / 3)];
    const std::size_t other = faces.faceOf[static_cast<std::size_t>(halfEdges.twin(h) / 3)];
    const bool isFirst = isCapKind(faces.faces[own].kind) &&
      (!isCapKind(faces.faces[other].kind) || halfEdges.twin(h) > h);
    if (own != other && isFirst)
    {
      result.segments.push_back(std::minmax(halfEdges.from(h), halfEdges.to(h)));
    }
  }
  std::sort(result.segments.begin(), result.segments.end());
  result.segments.erase(
    std::unique(result.segments.begin(), result.segments.end()), result.segments.end());
  limitSegments(tolerance, result);
  return result;
}

/// Triangles of each region, those first that hold the largest circles, with these circles'
/// centres.
struct RegionSamples
{
  std::vector<std::vector<std::pair<double, Eigen::RowVector2d>>> of;
};

RegionSamples samplesOf(const PlaneGraph& graph, const ConstrainedTriangles& triangles)
{
  RegionSamples result;
  result.of.resize(static_cast<std::size_t>(triangles.regions));
  for (Index t = 0; t < triangles.triangles.rows(); ++t)
  {
    Eigen::RowVector2d p[3];
    for (Index c = 0; c < 3; ++c)
    {
      p[c] = graph.points.row(triangles.triangles(t, c));
    }
    const double a = (p[1] - p[2]).norm();
    const double b = (p[2] - p[0]).norm();
    const double c = (p[0] - p[1]).norm();
    const Eigen::RowVector2d u = p[1] - p[0];
    const Eigen::RowVector2d v = p[2] - p[0];
    const double perimeter = a + b + c;
    const double radius = (u.x() * v.y() - u.y() * v.x()) / perimeter;
    result.of[static_cast<std::size_t>(triangles.regionOf[static_cast<std::size_t>(t)])]
      .emplace_back(radius, (a * p[0] + b * p[1] + c * p[2]) / perimeter);
  }
  for (auto& samples : result.of)
  {
    std::stable_sort(samples.begin(), samples.end(),
      [](const auto& first, const auto& second) { return first.first > second.first; });
    samples.resize(std::min(samples.size(), MostSamples));
  }
  return result;
}

/// The caps over a place from below, and whether bottoms and tops alternate.
bool stackAt(const CapLikeFaces& faces, const CapHeights& heights, const Eigen::RowVector2d& place,
  std::vector<std::size_t>& stack)
{
  std::vector<std::pair<double, std::size_t>> found;
  for (const std::size_t f : heights.caps())
  {
    if (const std::optional<double> height = heights.at(f, place))
    {
      found.emplace_back(*height, f);
    }
  }
  std::sort(found.begin(), found.end());
  stack.clear();
  bool alternates = found.size() % 2 == 0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const StackFaceKind wanted = i % 2 == 0 ? StackFaceKind::Bottom : StackFaceKind::Top;
    alternates = alternates && faces.faces[found[i].second].kind == wanted;
    stack.push_back(found[i].second);
  }
  return alternates;
}

[[noreturn]] void refusePlace(const CapLikeFaces& faces, const StackFrame& frame,
  const Eigen::RowVector2d& place, const std::vector<std::size_t>& stack)
{
  std::vector<Index> ids;
  for (const std::size_t f : stack)
  {
    ids.push_back(faces.faces[f].id);
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  Points at(1, 3);
  at << place.x(), place.y(), 0.0;
  const Eigen::RowVector3d where = frame.fromFrame(at).row(0);
  throw InvalidInput("along " + describe(frame.direction()) + " through " + describe(where) +
    " the caps do not alternate between the solid's lower and upper sides" +
    (ids.empty() ? std::string() : " (" + listFaces(ids) + ")") +
    ". Mend the solid there, or set ImprintTolerance to a smaller value.");
}

/// What decides whether regions are slivers, and where they go then.
struct RegionBorders
{
  /// Lengths of the borders with other regions, and with the outside (-1).
  std::vector<std::map<Index, double>> lengths;
  std::vector<double> widths;    ///< mean
  std::vector<double> tolerance; ///< the least of the edges round a region
};

RegionBorders bordersOfRegions(const PlaneGraph& graph, const ConstrainedTriangles& triangles)
{
  const auto regions = static_cast<std::size_t>(triangles.regions);
  RegionBorders result;
  result.lengths.resize(regions);
  result.tolerance.assign(regions, std::numeric_limits<double>::infinity());
  std::vector<double> areas(regions, 0.0);
  std::vector<double> perimeters(regions, 0.0);
  for (Index t = 0; t < triangles.triangles.rows(); ++t)
  {
    const auto own = static_cast<std::size_t>(triangles.regionOf[static_cast<std::size_t>(t)]);
    const auto corner = [&](Index c) -> Eigen::RowVector2d {
      return graph.points.row(triangles.triangles(t, c % 3));
    };
    const Eigen::RowVector2d u = corner(1) - corner(0);
    const Eigen::RowVector2d v = corner(2) - corner(0);
    areas[own] += 0.5 * (u.x() * v.y() - u.y() * v.x());
    for (Index c = 0; c < 3; ++c)
    {
      const Index beside = triangles.neighbors(t, c);
      const Index other = beside < 0 ? -1 : triangles.regionOf[static_cast<std::size_t>(beside)];
      if (other == static_cast<Index>(own))
      {
        continue;
      }
      const double length = (corner(c + 1) - corner(c)).norm();
      result.lengths[own][other] += length;
      perimeters[own] += length;
      const std::pair<Index, Index> ends =
        std::minmax<Index>(triangles.triangles(t, c), triangles.triangles(t, (c + 1) % 3));
      const auto edge = std::lower_bound(graph.edges.begin(), graph.edges.end(), ends);
      result.tolerance[own] = std::min(result.tolerance[own],
        graph.tolerance[static_cast<std::size_t>(edge - graph.edges.begin())]);
    }
  }
  for (std::size_t r = 0; r < regions; ++r)
  {
    result.widths.push_back(2.0 * areas[r] / perimeters[r]);
  }
  return result;
}

/// Gives slivers, over which merged curves have no stack of their own, that of the neighbour with
/// the longest border.
void fillSlivers(const RegionBorders& borders, std::vector<bool>& known,
  std::vector<std::vector<std::size_t>>& stacks)
{
  for (bool any = true; any;)
  {
    any = false;
    for (std::size_t r = 0; r < known.size(); ++r)
    {
      Index best = -2;
      double longest = 0.0;
      for (const auto& [other, length] : borders.lengths[r])
      {
        const bool isKnown = other < 0 || known[static_cast<std::size_t>(other)];
        if (!known[r] && isKnown && length > longest)
        {
          best = other;
          longest = length;
        }
      }
      if (best >= -1)
      {
        stacks[r] = best < 0 ? std::vector<std::size_t>() : stacks[static_cast<std::size_t>(best)];
        known[r] = true;
        any = true;
      }
    }
  }
}

std::vector<std::vector<std::size_t>> stacksOf(const PlaneGraph& graph,
  const ConstrainedTriangles& triangles, const CapLikeFaces& faces, const CapHeights& heights,
  const StackFrame& frame, double sliver)
{
  const RegionSamples samples = samplesOf(graph, triangles);
  const RegionBorders borders = bordersOfRegions(graph, triangles);
  std::vector<std::vector<std::size_t>> stacks(samples.of.size());
  std::vector<bool> known(samples.of.size(), false);
  for (std::size_t r = 0; r < samples.of.size(); ++r)
  {
    // What merged curves leave between them is no feature.
    const bool isSliver = borders.widths[r] < SliverWidth * borders.tolerance[r];
    for (std::size_t i = 0; i < samples.of[r].size() && !known[r] && !isSliver; ++i)
    {
      known[r] = stackAt(faces, heights, samples.of[r][i].second, stacks[r]);
    }
    const auto& [radius, place] = samples.of[r].front();
    if (!known[r] && !isSliver && radius > sliver)
    {
      stackAt(faces, heights, place, stacks[r]);
      refusePlace(faces, frame, place, stacks[r]);
    }
  }
  fillSlivers(borders, known, stacks);
  return stacks;
}

/// Numbers regions anew: those with the same caps that touch are one, those without caps -1.
std::vector<Index> joinRegions(
  const ConstrainedTriangles& triangles, std::vector<std::vector<std::size_t>>& stacks)
{
  DisjointSets sets(triangles.regions);
  for (Index t = 0; t < triangles.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index u = triangles.neighbors(t, c);
      if (u >= 0)
      {
        const Index r = triangles.regionOf[static_cast<std::size_t>(t)];
        const Index s = triangles.regionOf[static_cast<std::size_t>(u)];
        if (stacks[static_cast<std::size_t>(r)] == stacks[static_cast<std::size_t>(s)])
        {
          sets.join(r, s);
        }
      }
    }
  }
  std::vector<Index> number(stacks.size(), -1);
  std::vector<std::vector<std::size_t>> kept;
  for (std::size_t r = 0; r < stacks.size(); ++r)
  {
    const auto root = static_cast<std::size_t>(sets.find(static_cast<Index>(r)));
    if (root == r && !stacks[r].empty())
    {
      number[r] = static_cast<Index>(kept.size());
      kept.push_back(stacks[r]);
    }
    number[r] = number[root];
  }
  stacks = std::move(kept);
  return number;
}

/// Gives each fan of triangles round a point a point of its own.
void partTouchingPoints(StackArrangement& result, const PlaneGraph& graph)
{
  Triangles& triangles = result.mesh.triangles;
  DisjointSets corners(3 * triangles.rows());
  std::map<std::pair<Index, Index>, Index> seen;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index a = triangles(t, c);
      const Index b = triangles(t, (c + 1) % 3);
      seen[{ a, b }] = 3 * t + c;
      const auto twin = seen.find({ b, a });
      if (twin != seen.end())
      {
        const Index other = twin->second;
        const Index otherNext = other % 3 == 2 ? other - 2 : other + 1;
        corners.join(3 * t + c, otherNext);
        corners.join(3 * t + (c + 1) % 3, other);
      }
    }
  }
  std::map<Index, Index> pointOf;
  std::vector<Index> origin;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const auto known =
        pointOf.emplace(corners.find(3 * t + c), static_cast<Index>(origin.size()));
      if (known.second)
      {
        origin.push_back(triangles(t, c));
      }
    }
  }
  Triangles parted(triangles.rows(), 3);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      parted(t, c) = pointOf[corners.find(3 * t + c)];
    }
  }
  triangles = std::move(parted);
  result.mesh.points = Points::Zero(static_cast<Index>(origin.size()), 3);
  result.corner.clear();
  for (std::size_t i = 0; i < origin.size(); ++i)
  {
    result.mesh.points.row(static_cast<Index>(i)).head<2>() = graph.points.row(origin[i]);
    result.corner.push_back(graph.corner[static_cast<std::size_t>(origin[i])]);
  }
}

std::vector<RegionEdge> regionEdges(const StackArrangement& arrangement)
{
  std::map<std::pair<Index, Index>, Index> leftOf;
  const Triangles& triangles = arrangement.mesh.triangles;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      leftOf[{ triangles(t, c), triangles(t, (c + 1) % 3) }] =
        arrangement.regionOf[static_cast<std::size_t>(t)];
    }
  }
  std::vector<RegionEdge> edges;
  for (const auto& [ends, left] : leftOf)
  {
    const auto twin = leftOf.find({ ends.second, ends.first });
    const Index right = twin == leftOf.end() ? -1 : twin->second;
    if (right < 0 || left < right)
    {
      edges.push_back({ ends.first, ends.second, left, right });
    }
  }
  return edges;
}
}

namespace
{
/// Caps of which nothing is left.
std::vector<Index> lostFaces(
  const CapLikeFaces& faces, const CapHeights& heights, const StackArrangement& arrangement)
{
  std::set<std::size_t> found;
  for (const auto& stack : arrangement.stacks)
  {
    found.insert(stack.begin(), stack.end());
  }
  std::vector<Index> lost;
  for (const std::size_t face : heights.caps())
  {
    if (found.count(face) == 0)
    {
      lost.push_back(faces.faces[face].id);
    }
  }
  return lost;
}
}

StackArrangement arrangeStack(const SolidSurface& solid, const CapLikeFaces& faces,
  const StackFrame& frame, const PointsRef& framePoints, const CapHeights& heights,
  double tolerance)
{
  const PlaneGraph graph = imprintSegments(bordersOf(solid, faces, framePoints, tolerance));
  const ConstrainedTriangles triangles = triangulateGraph(graph);
  StackArrangement result;
  result.stacks =
    stacksOf(graph, triangles, faces, heights, frame, std::max(graph.greatestMove, tolerance));
  const std::vector<Index> number = joinRegions(triangles, result.stacks);
  std::vector<Index> rows;
  for (Index t = 0; t < triangles.triangles.rows(); ++t)
  {
    const Index region =
      number[static_cast<std::size_t>(triangles.regionOf[static_cast<std::size_t>(t)])];
    if (region >= 0)
    {
      rows.push_back(t);
      result.regionOf.push_back(region);
    }
  }
  result.mesh.triangles.resize(static_cast<Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    result.mesh.triangles.row(static_cast<Index>(i)) = triangles.triangles.row(rows[i]);
  }
  partTouchingPoints(result, graph);
  result.edges = regionEdges(result);
  result.merged = graph.merged;
  result.greatestMove = graph.greatestMove;
  result.greatestGap = graph.greatestGap;
  result.slivers = lostFaces(faces, heights, result);
  return result;
}
}

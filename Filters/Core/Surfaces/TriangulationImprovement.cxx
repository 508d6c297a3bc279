// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/TriangulationImprovement.h"

#include "Core/Geometry/TriangleSearch.h"
#include "Core/Surfaces/FlatFlips.h"
#include "Core/Surfaces/TriangleAngles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace hexsweep
{
namespace
{
/// Inner edges below this weight make a triangulation bad.
constexpr double LeastWeight = -10.0;

/// Part of the cap's area without inner nodes from which on it is refined.
constexpr double GreatestCoarsePart = 0.5;

/// How much the wanted size grows over a distance inwards.
constexpr double Grading = 0.3;

/// Liepa's density factor: a triangle is split if its centroid is further than size / factor from
/// all corners.
constexpr double Density = 1.4142135623730951;

/// A bent edge longer than this many sizes is halved.
constexpr double LongestBentEdge = 1.5;

/// Points that refinement adds at most, for each point there is.
constexpr Index MostPointsPerPoint = 10;

/// Least height over longest edge of a triangle that refinement may always make.
constexpr double GoodShape = 0.1;

/// Comparisons that symmetry makes ties must not hang on rounding.
constexpr double RelativeSlack = 1e-9;

double twiceArea(const TriangleMesh& mesh, Index t)
{
  const Eigen::RowVector3d a = mesh.points.row(mesh.triangles(t, 0));
  const Eigen::RowVector3d u = mesh.points.row(mesh.triangles(t, 1)) - a;
  const Eigen::RowVector3d v = mesh.points.row(mesh.triangles(t, 2)) - a;
  return u.cross(v).norm();
}

bool lacksInnerNodes(const TriangleMesh& cap)
{
  // The corners after a node, over its triangles, are those before it exactly if they go all round.
  std::vector<Index> open(static_cast<std::size_t>(cap.points.rows()), 0);
  for (Index t = 0; t < cap.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      open[static_cast<std::size_t>(cap.triangles(t, c))] +=
        cap.triangles(t, (c + 1) % 3) - cap.triangles(t, (c + 2) % 3);
    }
  }
  const auto onLoop = [&open](Index i) { return open[static_cast<std::size_t>(i)] != 0; };
  double whole = 0.0;
  double coarse = 0.0;
  for (Index t = 0; t < cap.triangles.rows(); ++t)
  {
    const double area = twiceArea(cap, t);
    whole += area;
    const bool all =
      onLoop(cap.triangles(t, 0)) && onLoop(cap.triangles(t, 1)) && onLoop(cap.triangles(t, 2));
    coarse += all ? area : 0.0;
  }
  return coarse > GreatestCoarsePart * whole;
}

/// Sizes at the points: on loops the mean of the edges beside them, elsewhere growing from there.
std::vector<double> loopSizes(const FlatFlips& surface)
{
  const HalfEdgeTriangles& mesh = surface.connectivity();
  const auto length = [&](Index half) {
    return (surface.point(mesh.to(half)) - surface.point(mesh.from(half))).norm();
  };
  std::vector<double> sizes(
    static_cast<std::size_t>(surface.numberOfPoints()), std::numeric_limits<double>::infinity());
  std::vector<double> sums(sizes.size(), 0.0);
  std::vector<std::vector<Index>> spokes(sizes.size());
  for (Index half = 0; half < mesh.numberOfHalfEdges(); ++half)
  {
    const auto from = static_cast<std::size_t>(mesh.from(half));
    const auto to = static_cast<std::size_t>(mesh.to(half));
    spokes[from].push_back(half);
    if (mesh.twin(half) < 0)
    {
      sizes[from] = sums[from] += 0.5 * length(half);
      sizes[to] = sums[to] += 0.5 * length(half);
    }
  }
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    if (std::isfinite(sizes[i]))
    {
      open.emplace(sizes[i], static_cast<Index>(i));
    }
  }
  while (!open.empty())
  {
    const auto [size, i] = open.top();
    open.pop();
    if (size > sizes[static_cast<std::size_t>(i)])
    {
      continue;
    }
    for (const Index half : spokes[static_cast<std::size_t>(i)])
    {
      const double next = size + Grading * length(half);
      double& known = sizes[static_cast<std::size_t>(mesh.to(half))];
      if (next < known)
      {
        known = next;
        open.emplace(next, mesh.to(half));
      }
    }
  }
  return sizes;
}

/// Least height over longest edge.
double shapeOf(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c)
{
  const double longest =
    std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() });
  return (b - a).cross(c - a).norm() / longest;
}

double shapeOf(const FlatFlips& surface, Index triangle)
{
  const HalfEdgeTriangles& mesh = surface.connectivity();
  return shapeOf(surface.point(mesh.from(3 * triangle)), surface.point(mesh.from(3 * triangle + 1)),
    surface.point(mesh.from(3 * triangle + 2)));
}

double leastShape(const FlatFlips& surface)
{
  double least = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < surface.connectivity().numberOfTriangles(); ++t)
  {
    least = std::min(least, shapeOf(surface, t));
  }
  return least;
}

/// Whether a triangle keeps its distance from the points and boundary edges that it would be
/// joined to, and no triangle gets thinner than the thinnest one replaced, or than GoodShape.
bool allowsPoint(
  const FlatFlips& surface, Index triangle, const Eigen::RowVector3d& place, double distance)
{
  const HalfEdgeTriangles& mesh = surface.connectivity();
  double before = shapeOf(surface, triangle);
  double after = std::numeric_limits<double>::infinity();
  std::vector<Index> open{ 3 * triangle, 3 * triangle + 1, 3 * triangle + 2 };
  while (!open.empty())
  {
    const Index half = open.back();
    open.pop_back();
    if (surface.wouldFlip(half, place))
    {
      const Index other = mesh.twin(half);
      before = std::min(before, shapeOf(surface, other / 3));
      open.push_back(HalfEdgeTriangles::next(other));
      open.push_back(HalfEdgeTriangles::previous(other));
      continue;
    }
    const Eigen::RowVector3d& a = surface.point(mesh.from(half));
    const Eigen::RowVector3d& b = surface.point(mesh.to(half));
    // A boundary edge is not split, so the circle over it must stay empty (Ruppert).
    if ((a - place).norm() < distance ||
      (mesh.twin(half) < 0 && (a - place).dot(b - place) < -RelativeSlack * (b - a).squaredNorm()))
    {
      return false;
    }
    after = std::min(after, shapeOf(a, b, place));
  }
  return after >= (1.0 - RelativeSlack) * std::min(before, GoodShape);
}

/// Whether halving an inner edge makes no triangle thinner than those beside it, or GoodShape.
bool allowsHalving(const FlatFlips& surface, Index half)
{
  const HalfEdgeTriangles& mesh = surface.connectivity();
  const Eigen::RowVector3d& a = surface.point(mesh.from(half));
  const Eigen::RowVector3d& b = surface.point(mesh.to(half));
  const Eigen::RowVector3d middle = 0.5 * (a + b);
  double before = std::numeric_limits<double>::infinity();
  double after = before;
  for (const Index side : { half, mesh.twin(half) })
  {
    const Eigen::RowVector3d& apex = surface.point(mesh.apex(side));
    before = std::min(before, shapeOf(surface, side / 3));
    after = std::min({ after, shapeOf(a, middle, apex), shapeOf(middle, b, apex) });
  }
  return after >= (1.0 - RelativeSlack) * std::min(before, GoodShape);
}

void refine(FlatFlips& surface)
{
  const HalfEdgeTriangles& mesh = surface.connectivity();
  std::vector<double> sizes = loopSizes(surface);
  const Index most = (1 + MostPointsPerPoint) * surface.numberOfPoints();
  const auto size = [&](Index i) { return sizes[static_cast<std::size_t>(i)]; };
  const auto grownSize = [&](const Eigen::RowVector3d& place, std::initializer_list<Index> from) {
    double least = std::numeric_limits<double>::infinity();
    for (const Index i : from)
    {
      least = std::min(least, size(i) + Grading * (surface.point(i) - place).norm());
    }
    return least;
  };
  for (bool changed = true; changed;)
  {
    changed = false;
    const Index halves = mesh.numberOfHalfEdges();
    for (Index half = 0; half < halves && surface.numberOfPoints() < most; ++half)
    {
      const Index a = mesh.from(half);
      const Index b = mesh.to(half);
      const double length = (surface.point(b) - surface.point(a)).norm();
      const Eigen::RowVector3d middle = 0.5 * (surface.point(a) + surface.point(b));
      const double wanted = grownSize(middle, { a, b });
      if (mesh.twin(half) > half && length > (1.0 + RelativeSlack) * LongestBentEdge * wanted &&
        !surface.isCoplanar(half) && allowsHalving(surface, half))
      {
        surface.halve(half);
        sizes.push_back(wanted);
        changed = true;
      }
    }
    const Index triangles = mesh.numberOfTriangles();
    for (Index t = 0; t < triangles && surface.numberOfPoints() < most; ++t)
    {
      const Index ids[3] = { mesh.from(3 * t), mesh.from(3 * t + 1), mesh.from(3 * t + 2) };
      const Eigen::RowVector3d centroid =
        (surface.point(ids[0]) + surface.point(ids[1]) + surface.point(ids[2])) / 3.0;
      const double wanted = grownSize(centroid, { ids[0], ids[1], ids[2] });
      const bool tooLarge = std::all_of(std::begin(ids), std::end(ids), [&](Index i) {
        const double distance = Density * (surface.point(i) - centroid).norm();
        return distance > (1.0 + RelativeSlack) * std::max(wanted, size(i));
      });
      if (tooLarge && allowsPoint(surface, t, centroid, wanted / Density))
      {
        surface.insertCentroid(t);
        sizes.push_back(wanted);
        changed = true;
      }
    }
  }
}

/// Rows of `before` at the middles of the triangles of `after`.
std::vector<Index> origins(const TriangleMesh& before, const TriangleMesh& after)
{
  const TriangleSearch search(before.points, before.triangles);
  std::vector<Index> result;
  for (Index t = 0; t < after.triangles.rows(); ++t)
  {
    if (t < before.triangles.rows() && after.triangles.row(t) == before.triangles.row(t))
    {
      result.push_back(t);
      continue;
    }
    const Eigen::RowVector3d middle =
      (after.points.row(after.triangles(t, 0)) + after.points.row(after.triangles(t, 1)) +
        after.points.row(after.triangles(t, 2))) /
      3.0;
    result.push_back(search.closest(middle, result.empty() ? -1 : result.back()).triangle);
  }
  return result;
}
}

bool isStretched(const TriangleMesh& cap)
{
  // One of the two cotangents must be half as bad: without such, which is the rule, no edges.
  const Points all = cotangents(cap.points, cap.triangles);
  if (!(all.size() > 0 && all.minCoeff() < 0.5 * LeastWeight))
  {
    return false;
  }
  const FlatFlips surface(cap);
  for (Index half = 0; half < surface.connectivity().numberOfHalfEdges(); ++half)
  {
    if (surface.connectivity().twin(half) > half && surface.weight(half) < LeastWeight)
    {
      return true;
    }
  }
  return false;
}

ImprovementPlan planImprovement(const TriangleMesh& cap, TriangulationImprovement improvement)
{
  if (improvement == TriangulationImprovement::Off)
  {
    return {};
  }
  ImprovementPlan plan;
  plan.refine = lacksInnerNodes(cap);
  plan.flip = plan.refine || improvement == TriangulationImprovement::On || isStretched(cap);
  return plan;
}

ImprovedTriangulation improveTriangulation(const TriangleMesh& mesh, const ImprovementPlan& plan)
{
  ImprovedTriangulation result;
  if (!plan.flip && !plan.refine)
  {
    result.mesh = mesh;
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      result.triangleOrigin.push_back(t);
    }
    return result;
  }
  FlatFlips surface(mesh);
  surface.flipAll();
  result.flips = surface.flips();
  if (plan.refine)
  {
    const double before = leastShape(surface);
    FlatFlips refined = surface;
    refine(refined);
    // Each step keeps this by itself; that is proved for Delaunay neighbourhoods only.
    if (leastShape(refined) >= 0.5 * std::min(before, GoodShape))
    {
      surface = std::move(refined);
    }
  }
  result.mesh = surface.mesh();
  result.triangleOrigin = origins(mesh, result.mesh);
  result.addedPoints = result.mesh.points.rows() - mesh.points.rows();
  return result;
}
}

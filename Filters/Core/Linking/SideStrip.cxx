// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/SideStrip.h"

#include "Core/Common/Errors.h"
#include "Core/Common/Predicates.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Linking/RuledShape.h"
#include "Core/Linking/SideCut.h"
#include "Core/Linking/SideFeatures.h"
#include "Core/Linking/SteadyColumns.h"
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Solvers/SurfaceLaplacian.h"
#include "Core/Surfaces/EdgeHalving.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
/// Which line of the strip's frame each point lies on: 1 source, 2 target, 3 + c column c.
/// Points at the ends of columns lie on two.
class FrameLines
{
public:
  explicit FrameLines(const SideStrip& strip)
    : Loop(at(strip.surface.points.rows()), 0)
    , Column(at(strip.surface.points.rows()), -1)
    , Position(at(strip.surface.points.rows()), -1)
  {
    for (const Index i : strip.source)
    {
      this->Loop[at(i)] = 1;
    }
    for (const Index i : strip.target)
    {
      this->Loop[at(i)] = 2;
    }
    for (std::size_t c = 0; c < strip.columns.size(); ++c)
    {
      const std::vector<Index>& points = strip.columns[c].points;
      for (std::size_t k = 0; k < points.size(); ++k)
      {
        this->Column[at(points[k])] = static_cast<Index>(c);
        this->Position[at(points[k])] = static_cast<Index>(k);
      }
    }
  }

  /// Whether an inner edge joins two points of one line without being part of it.
  bool isChord(Index a, Index b) const
  {
    const bool sameLoop = this->Loop[at(a)] != 0 && this->Loop[at(a)] == this->Loop[at(b)];
    const bool sameColumn = this->Column[at(a)] >= 0 &&
      this->Column[at(a)] == this->Column[at(b)] &&
      std::abs(this->Position[at(a)] - this->Position[at(b)]) != 1;
    return sameLoop || sameColumn;
  }

private:
  std::vector<int> Loop;
  std::vector<Index> Column;
  std::vector<Index> Position;
};

void setTubeLoops(SideStrip& strip, Index pointOnSource)
{
  const SurfaceTopology topology =
    checkSurface(strip.surface.triangles, strip.surface.points.rows(), "linking side");
  const auto holds = [&](const Loop& loop) {
    return std::find(loop.begin(), loop.end(), pointOnSource) != loop.end();
  };
  if (topology.numberOfComponents != 1 || topology.loops.size() != 2 ||
    topology.eulerCharacteristic != 0)
  {
    throw InvalidInput("a linking side is no tube: it has " +
      std::to_string(topology.numberOfComponents) + " pieces, " +
      std::to_string(topology.loops.size()) + " boundary loops and Euler characteristic " +
      std::to_string(topology.eulerCharacteristic) +
      " (a tube has 1, 2 and 0). Select faces that join one loop of the source cap to one loop of "
      "the target cap.");
  }
  const bool firstIsSource = holds(topology.loops[0]);
  if (!firstIsSource && !holds(topology.loops[1]))
  {
    throw InvalidInput("the source loop is no boundary of its linking side.");
  }
  strip.source = topology.loops[firstIsSource ? 0 : 1];
  strip.target = topology.loops[firstIsSource ? 1 : 0];
  std::reverse(strip.target.begin(), strip.target.end());
}

void beginAt(Loop& loop, Index point)
{
  std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), point), loop.end());
}

StripColumn columnOf(std::vector<Index> path, const PointsRef& points)
{
  StripColumn column;
  double length = 0.0;
  for (std::size_t k = 0; k < path.size(); ++k)
  {
    length += k == 0 ? 0.0 : (points.row(path[k]) - points.row(path[k - 1])).norm();
    column.u.push_back(length);
  }
  for (double& u : column.u)
  {
    u /= length;
  }
  column.u.back() = 1.0;
  column.points = std::move(path);
  return column;
}

/// v of the target loop: by length between the ends of columns.
std::vector<double> targetPlaces(const SideStrip& strip)
{
  const std::vector<double> reached =
    reachedLengths(loopPoints(strip.surface.points, strip.target));
  const std::size_t n = strip.target.size();
  std::vector<double> v(n, 0.0);
  const std::size_t count = strip.columns.size();
  std::vector<std::size_t> ends;
  for (const StripColumn& column : strip.columns)
  {
    ends.push_back(at(std::find(strip.target.begin(), strip.target.end(), column.points.back()) -
      strip.target.begin()));
  }
  for (std::size_t c = 0; c < count; ++c)
  {
    const std::size_t end = c + 1 < count ? ends[c + 1] : n;
    const double from = strip.columns[c].v;
    const double to = c + 1 < count ? strip.columns[c + 1].v : 1.0;
    for (std::size_t i = ends[c]; i < end; ++i)
    {
      const double along = (reached[i] - reached[ends[c]]) / (reached[end] - reached[ends[c]]);
      v[i] = from + along * (to - from);
    }
  }
  return v;
}

Index countFlips(const PlanePoints& plane, const Triangles& triangles)
{
  Index flips = 0;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    flips += orientation(plane.row(triangles(t, 0)), plane.row(triangles(t, 1)),
               plane.row(triangles(t, 2))) > 0
      ? 0
      : 1;
  }
  return flips;
}

/// The tube's own unknowns: copies along path 0 are one, v of the left one is 1 more.
struct PeriodicSystem
{
  SparseMatrix matrix;
  Eigen::VectorXd jump; ///< right-hand side for v
};

PeriodicSystem periodicSystem(const CutTube& cut, const SparseMatrix& laplacian, Index points)
{
  SparseMatrix glue(laplacian.rows(), points);
  std::vector<Eigen::Triplet<double, int>> entries;
  Eigen::VectorXd offset(laplacian.rows());
  for (Index i = 0; i < laplacian.rows(); ++i)
  {
    entries.emplace_back(static_cast<int>(i), static_cast<int>(cut.original[at(i)]), 1.0);
    offset[i] = cut.onLeft[at(i)] ? 1.0 : 0.0;
  }
  glue.setFromTriplets(entries.begin(), entries.end());
  const SparseMatrix transposed = glue.transpose();
  return { transposed * laplacian * glue, -(transposed * (laplacian * offset)) };
}

/// How far the target loop is to be turned so that it fits the conjugate of u.
double conjugateTurn(const SideStrip& strip, const CutTube& cut, const std::vector<double>& targetV)
{
  const Index n = strip.surface.points.rows();
  const PeriodicSystem system = periodicSystem(
    cut, symmetricLaplacian(cut.mesh.points, cut.mesh.triangles, Weights::Intrinsic), n);
  std::vector<bool> fixed(at(n), false);
  fixed[at(strip.source.front())] = true;
  const Eigen::VectorXd v = DirichletSolver(system.matrix, fixed, strip.surface.points)
                              .solve(Eigen::VectorXd::Zero(n), system.jump);
  // Mean difference, weighted by the length that belongs to each node.
  const auto meanDifference = [&](const Loop& loop, const std::vector<double>& own) {
    const Points places = loopPoints(strip.surface.points, loop);
    double sum = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Index before = static_cast<Index>((i + loop.size() - 1) % loop.size());
      const Index after = static_cast<Index>((i + 1) % loop.size());
      const Index here = static_cast<Index>(i);
      const double weight = (places.row(here) - places.row(before)).norm() +
        (places.row(after) - places.row(here)).norm();
      sum += weight * (v[loop[i]] - own[i]);
      weights += weight;
    }
    return sum / weights;
  };
  return meanDifference(strip.target, targetV) - meanDifference(strip.source, strip.sourceV);
}

PlanePoints solveStrip(const SideStrip& strip, const CutTube& cut, Weights weights)
{
  const Index n = cut.mesh.points.rows();
  const Index points = strip.surface.points.rows();
  const SparseMatrix laplacian = surfaceLaplacian(cut.mesh.points, cut.mesh.triangles, weights);
  // Per copy: v and u where they are given.
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(n, 2);
  std::vector<bool> fixed(at(n), false);
  std::vector<Eigen::Vector2d> given(at(points), Eigen::Vector2d::Constant(-1.0));
  std::vector<bool> isGiven(at(points), false);
  const auto give = [&](Index i, double v, double u) {
    given[at(i)] = { v, u };
    isGiven[at(i)] = true;
  };
  for (std::size_t i = 0; i < strip.source.size(); ++i)
  {
    give(strip.source[i], strip.sourceV[i], 0.0);
  }
  for (std::size_t i = 0; i < strip.target.size(); ++i)
  {
    give(strip.target[i], strip.targetV[i], 1.0);
  }
  for (const StripColumn& column : strip.columns)
  {
    for (std::size_t k = 0; k < column.points.size(); ++k)
    {
      give(column.points[k], column.v, column.u[k]);
    }
  }
  PlanePoints plane(n, 2);
  if (!strip.columns.empty())
  {
    for (Index i = 0; i < n; ++i)
    {
      fixed[at(i)] = isGiven[at(cut.original[at(i)])];
      values.row(i) = given[at(cut.original[at(i)])].transpose();
      values(i, 0) += cut.onLeft[at(i)] ? 1.0 : 0.0;
    }
    return DirichletSolver(laplacian, fixed, cut.mesh.points).solve(values);
  }
  const PeriodicSystem system = periodicSystem(cut, laplacian, points);
  Eigen::MatrixXd boundary(points, 2);
  for (Index i = 0; i < points; ++i)
  {
    boundary.row(i) = given[at(i)].transpose();
  }
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(points, 2);
  right.col(0) = system.jump;
  const Eigen::MatrixXd solved =
    DirichletSolver(system.matrix, isGiven, strip.surface.points).solve(boundary, right);
  for (Index i = 0; i < n; ++i)
  {
    plane.row(i) = solved.row(cut.original[at(i)]);
    plane(i, 0) += cut.onLeft[at(i)] ? 1.0 : 0.0;
  }
  return plane;
}

std::vector<Index> originsThrough(const std::vector<Index>& outer, const std::vector<Index>& inner)
{
  std::vector<Index> origins;
  origins.reserve(outer.size());
  for (const Index t : outer)
  {
    origins.push_back(inner[at(t)]);
  }
  return origins;
}

/// The side's triangles, loops and CAD edges, long edges and chords halved.
SideStrip refinedSide(const SideTube& side, double longestEdge)
{
  SideStrip strip;
  HalvedSurface halved = halveLongEdges(side.surface, longestEdge);
  strip.surface = std::move(halved.mesh);
  strip.triangleOrigin = std::move(halved.triangleOrigin);
  setTubeLoops(strip, side.sourceLoop.front());
  if (!side.faceIds.empty())
  {
    for (std::vector<Index>& path : crossingFeatures(strip.surface,
           originsThrough(strip.triangleOrigin, side.faceIds), strip.source, strip.target))
    {
      strip.columns.push_back(columnOf(std::move(path), strip.surface.points));
    }
  }
  const FrameLines lines(strip);
  halved = halveChords(strip.surface, [&](Index a, Index b) { return lines.isChord(a, b); });
  strip.surface = std::move(halved.mesh);
  strip.triangleOrigin = originsThrough(halved.triangleOrigin, strip.triangleOrigin);
  strip.shape = strip.surface.points;
  return strip;
}

/// The shape cut along the CAD edges, or where there are none along the shortest path; the loops
/// begin at the first cut from now on.
CutTube cutOpen(SideStrip& strip)
{
  std::vector<std::vector<Index>> paths;
  for (const StripColumn& column : strip.columns)
  {
    paths.push_back(column.points);
  }
  if (paths.empty())
  {
    paths.push_back(shortestCrossing(strip.surface, strip.source, strip.target));
  }
  beginAt(strip.source, paths.front().front());
  beginAt(strip.target, paths.front().back());
  return cutTube({ strip.shape, strip.surface.triangles }, paths);
}

/// Fractions of a loop's length at its points, the first 0.
std::vector<double> placesByLength(const PointsRef& points, const Loop& loop)
{
  const std::vector<double> reached = reachedLengths(loopPoints(points, loop));
  std::vector<double> places;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    places.push_back(reached[i] / reached.back());
  }
  return places;
}

/// v on the loops and the CAD edges.
void placeFrame(SideStrip& strip, const CutTube& cut)
{
  strip.sourceV = placesByLength(strip.surface.points, strip.source);
  for (StripColumn& column : strip.columns)
  {
    column.v =
      strip.sourceV[at(std::find(strip.source.begin(), strip.source.end(), column.points.front()) -
        strip.source.begin())];
  }
  if (!strip.columns.empty())
  {
    strip.targetV = targetPlaces(strip);
    return;
  }
  strip.targetV = placesByLength(strip.surface.points, strip.target);
  const double turn = conjugateTurn(strip, cut, strip.targetV);
  for (double& v : strip.targetV)
  {
    v += turn;
  }
}
}

namespace
{
/// Maps the side with the columns that it has. @return the tube that was cut open.
CutTube fillStrip(SideStrip& strip)
{
  CutTube cut = cutOpen(strip);
  placeFrame(strip, cut);
  strip.planeTriangles = cut.mesh.triangles;
  strip.flipped = std::numeric_limits<Index>::max();
  for (const Weights weights : { Weights::Cotangent, Weights::MeanValue, Weights::Intrinsic })
  {
    PlanePoints plane = solveStrip(strip, cut, weights);
    const Index flips = countFlips(plane, strip.planeTriangles);
    if (flips < strip.flipped)
    {
      strip.plane = std::move(plane);
      strip.flipped = flips;
    }
    if (strip.flipped == 0)
    {
      break;
    }
  }
  return cut;
}

constexpr double Negligible = 0.1; // of the edges that the map is made of

/// @param framed the strip with v on its loops, without CAD edges.
std::optional<RuledShape> shapeWithFlatterSteps(
  const SideStrip& framed, double longestEdge, double stepDepth)
{
  return ruledShape(framed.surface,
    { loopPoints(framed.surface.points, framed.source), framed.sourceV },
    { loopPoints(framed.surface.points, framed.target), framed.targetV }, Negligible * longestEdge,
    stepDepth);
}

SideStrip withoutEdges(SideStrip strip)
{
  strip.columns.clear();
  return strip;
}

/// Makes the steps of a side that is ruled otherwise flatter in the metric.
void flattenSteps(SideStrip& strip, double longestEdge, double stepDepth)
{
  SideStrip free = withoutEdges(strip);
  const CutTube cut = cutOpen(free);
  placeFrame(free, cut);
  std::optional<RuledShape> shape = shapeWithFlatterSteps(free, longestEdge, stepDepth);
  strip.hasSteps = shape.has_value();
  if (!shape)
  {
    return;
  }
  strip.shape = std::move(shape->points);
  // An edge that goes round a step, or over it, is what columns are not to follow.
  const double aside =
    Negligible * longestEdge / closedLength(loopPoints(strip.surface.points, strip.source));
  const auto leavesItsLine = [&](const StripColumn& column) {
    const double line = shape->v[at(column.points.front())];
    return std::any_of(column.points.begin(), column.points.end(), [&](Index point) {
      const double off = shape->v[at(point)] - line;
      return shape->onStep[at(point)] || std::abs(off - std::round(off)) > aside;
    });
  };
  strip.columns.erase(
    std::remove_if(strip.columns.begin(), strip.columns.end(), leavesItsLine), strip.columns.end());
  for (StripColumn& column : strip.columns)
  {
    column = columnOf(std::move(column.points), strip.shape);
  }
}

/// (v, u) of each point of a side that was filled.
PlanePoints placesOf(const SideStrip& strip, const CutTube& cut)
{
  PlanePoints places(strip.surface.points.rows(), 2);
  for (Index i = 0; i < strip.plane.rows(); ++i)
  {
    places.row(cut.original[at(i)]) = strip.plane.row(i);
  }
  return places;
}
}

SideStrip mapSideToStrip(const SideTube& side, double longestEdge, EdgeHeights heights)
{
  SideStrip strip = refinedSide(side, longestEdge);
  const bool isFlattened = side.stepDepth < 1.0;
  if (isFlattened)
  {
    flattenSteps(strip, longestEdge, side.stepDepth);
  }
  SideStrip free = withoutEdges(strip);
  const CutTube cut = fillStrip(free);
  if (!isFlattened)
  {
    free.hasSteps = shapeWithFlatterSteps(free, longestEdge, 1.0).has_value();
    strip.hasSteps = free.hasSteps;
  }
  if (strip.columns.empty())
  {
    return free;
  }
  const PlanePoints places = placesOf(free, cut);
  strip.columns = steadyColumns(strip.columns, places);
  for (StripColumn& column : strip.columns)
  {
    if (heights == EdgeHeights::OfNeighborhood)
    {
      column.u = risingHeights(column, places);
    }
  }
  fillStrip(strip);
  return strip;
}

Eigen::RowVector3d pointOnTarget(const SideStrip& strip, double v)
{
  const LoopPlace place = placeOnLoop(strip.targetV, v);
  return place.between(strip.surface.points.row(strip.target[place.edge]),
    strip.surface.points.row(strip.target[(place.edge + 1) % strip.target.size()]));
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/LinkingSideColumns.h"

#include "Core/Common/Errors.h"
#include "Core/Common/Predicates.h"
#include "Core/Geometry/ClosedPolygon.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Linking/ColumnEnds.h"
#include "Core/Linking/LayerSpacing.h"
#include "Core/Linking/PlacedLoop.h"
#include "Core/Linking/RingParameter.h"
#include "Core/Linking/RingQuads.h"
#include "Core/Linking/SteadyColumns.h"
#include "Core/Surfaces/EdgeHalving.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
constexpr Index Samples = 64;            // of a column's length
constexpr double TrianglesOfRing = 32.0; // a side of n columns is cut as finely as n n / this
/// Of the least sine of a corner, or of what sines lack in the mean: rings are levelled where that
/// gains so much.
constexpr double LevelGain = 1.25;
constexpr Index LayersLookedAt = 16;
constexpr double MostRise = 0.2; // of a ring, over its way

double longestEdge(const SideTube& side, Index columns)
{
  const double n = static_cast<double>(columns);
  return longestEdgeFor(side.surface, std::max(side.leastTriangles, n * n / TrianglesOfRing));
}
}

LinkingSideColumns::LinkingSideColumns(
  const SideTube& side, const PointsRef& ring, double matchTolerance)
  : Side(side)
  , Given(ring)
  , MatchTolerance(matchTolerance)
{
  this->map(EdgeHeights::ByLength);
  // An edge round a ledge is longer than its neighbourhood: rings would leap where they meet it.
  if (this->keptEdges() > 0 && this->Meshed.layers == 0 &&
    this->isSteep(this->heightsByLength(layerFractions(LayersLookedAt), false)))
  {
    this->map(EdgeHeights::OfNeighborhood);
  }
}

void LinkingSideColumns::map(EdgeHeights heights)
{
  this->Heights = heights;
  this->LostEdges.clear();
  this->LostCorners.clear();
  this->Courses.aside.resize(0, 0);
  this->Levels.clear();
  this->Strip = std::make_shared<const SideStrip>(
    mapSideToStrip(this->Side, longestEdge(this->Side, this->Given.rows()), heights));
  this->Search = std::make_shared<const StripSearch>(*this->Strip);
  this->placeRing();
  this->Meshed = tracePatches(this->Side.get().patches, this->Ring,
    loopPoints(this->Strip->surface.points, this->Strip->target), this->MatchTolerance);
  this->findEnds();
  this->measure();
}

void LinkingSideColumns::placeRing()
{
  const Index n = this->Given.rows();
  this->Reversed = !runsAlong(this->Given, this->Strip->surface.points, this->Strip->source);
  const Points turned = this->Reversed ? Points(this->Given.colwise().reverse()) : this->Given;
  const std::vector<double> places = ringParameters(
    turned, loopPoints(this->Strip->surface.points, this->Strip->source), this->MatchTolerance);
  std::vector<double> v;
  for (const double place : places)
  {
    v.push_back(wrappedV(valueAt(this->Strip->sourceV, place)));
  }
  this->Begin = static_cast<std::size_t>(std::min_element(v.begin(), v.end()) - v.begin());
  std::rotate(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(this->Begin), v.end());
  this->Courses.begin = std::move(v);
  this->Ring.resize(n, 3);
  for (Index j = 0; j < n; ++j)
  {
    this->Ring.row(j) = turned.row((j + static_cast<Index>(this->Begin)) % n);
  }
}

void LinkingSideColumns::findEnds()
{
  const std::size_t n = this->Courses.begin.size();
  this->Edge.assign(n, -1);
  std::vector<ColumnAnchor> anchors;
  for (std::size_t c = 0; c < this->Strip->columns.size(); ++c)
  {
    const StripColumn& column = this->Strip->columns[c];
    const auto found = std::find(this->Courses.begin.begin(), this->Courses.begin.end(), column.v);
    if (found == this->Courses.begin.end())
    {
      this->LostEdges.emplace_back(this->Strip->surface.points.row(column.points.front()));
      continue;
    }
    const std::size_t j = static_cast<std::size_t>(found - this->Courses.begin.begin());
    this->Edge[j] = static_cast<Index>(c);
    anchors.push_back({ j, column.v });
  }
  const ClosedPolygon loop(loopPoints(this->Strip->surface.points, this->Strip->target));
  const std::vector<Index> corners = loopCorners(loop);
  std::vector<double> cornerV;
  for (const Index corner : corners)
  {
    cornerV.push_back(this->Strip->targetV[static_cast<std::size_t>(corner)]);
  }
  ColumnEnds found = columnEnds(this->Courses.begin, loopCorners(ClosedPolygon(this->Ring)),
    std::move(anchors), this->Turn, cornerV);
  this->Courses.end = std::move(found.ends);
  for (const std::size_t corner : found.lostCorners)
  {
    this->LostCorners.emplace_back(loop.nodes().row(corners[corner]));
  }
}

StripPlace LinkingSideColumns::inside(std::size_t column, double u) const
{
  return this->Search->at(this->Courses.at(column, u), u);
}

Points LinkingSideColumns::nodesAt(const std::vector<Index>& columns, double u, double turn) const
{
  Points nodes(static_cast<Index>(columns.size()), 3);
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    const auto j = static_cast<std::size_t>(columns[i]);
    nodes.row(static_cast<Index>(i)) = this->Search->at(this->Courses.at(j, u) + turn, u).point;
  }
  return nodes;
}

void LinkingSideColumns::turnEnds(double turn)
{
  if (!this->isFree() || turn == 0.0)
  {
    return;
  }
  this->Turn += turn;
  this->Courses.aside.resize(0, 0);
  this->LostEdges.clear();
  this->LostCorners.clear();
  this->findEnds();
  this->measure();
}

void LinkingSideColumns::measure()
{
  const std::size_t n = this->Courses.begin.size();
  this->Reached.resize(static_cast<Index>(n), Samples + 1);
  for (std::size_t j = 0; j < n; ++j)
  {
    const Index row = static_cast<Index>(j);
    this->Reached(row, 0) = 0.0;
    if (this->Edge[j] >= 0)
    {
      const StripColumn& column = this->Strip->columns[static_cast<std::size_t>(this->Edge[j])];
      const std::vector<double> lengths =
        reachedLengths(loopPoints(this->Strip->surface.points, column.points));
      for (Index s = 1; s <= Samples; ++s)
      {
        const double u = static_cast<double>(s) / static_cast<double>(Samples);
        const auto [after, along] = placeOn(column, u);
        this->Reached(row, s) = lengths[after - 1] + along * (lengths[after] - lengths[after - 1]);
      }
      continue;
    }
    Eigen::RowVector3d last = this->Ring.row(row);
    for (Index s = 1; s <= Samples; ++s)
    {
      const double u = static_cast<double>(s) / static_cast<double>(Samples);
      const Eigen::RowVector3d here =
        s == Samples ? pointOnTarget(*this->Strip, this->Courses.end[j]) : this->inside(j, u).point;
      this->Reached(row, s) = this->Reached(row, s - 1) + (here - last).norm();
      last = here;
    }
  }
}

void LinkingSideColumns::shareRings()
{
  if (this->Meshed.layers == 0)
  {
    this->Courses.aside = asideByLength(*this->Search, this->Courses, this->heldByEdges());
    this->measure();
  }
}

bool LinkingSideColumns::freeHeights()
{
  // Round a ledge there are to be as many nodes as its length asks for.
  const SideStrip& strip = *this->Strip;
  if (std::any_of(this->Edge.begin(), this->Edge.end(), [&](Index edge) {
        return edge >= 0 &&
          !isSmooth(strip.surface.points, strip.columns[static_cast<std::size_t>(edge)]);
      }))
  {
    return false;
  }
  if (this->keptEdges() > 0 && this->Heights == EdgeHeights::ByLength && this->Meshed.layers == 0)
  {
    this->map(EdgeHeights::OfNeighborhood);
  }
  return this->Meshed.layers == 0;
}

std::vector<double> LinkingSideColumns::meanHeights(Index layers) const
{
  const Eigen::RowVectorXd mean =
    this->heightsByLength(layerFractions(layers), false).colwise().mean();
  return { mean.data(), mean.data() + mean.size() };
}

std::vector<Points> LinkingSideColumns::sections(
  const std::vector<Index>& columns, Index layers) const
{
  const Eigen::MatrixXd u = this->heights(layerFractions(layers), false);
  std::vector<Points> sections;
  for (Index k = 0; k <= layers; ++k)
  {
    Points& section = sections.emplace_back(static_cast<Index>(columns.size()), 3);
    for (std::size_t i = 0; i < columns.size(); ++i)
    {
      section.row(static_cast<Index>(i)) =
        this->nodeOn(static_cast<std::size_t>(columns[i]), u(columns[i], k));
    }
  }
  return sections;
}

CornerSines LinkingSideColumns::cornerSines() const
{
  return this->cornerSines(this->heights(layerFractions(LayersLookedAt), false));
}

double LinkingSideColumns::meanLength() const
{
  return this->Reached.col(Samples).mean();
}

Index LinkingSideColumns::keptEdges() const
{
  return static_cast<Index>(
    std::count_if(this->Edge.begin(), this->Edge.end(), [](Index edge) { return edge >= 0; }));
}

std::vector<bool> LinkingSideColumns::heldByEdges() const
{
  std::vector<bool> isHeld(this->Edge.size());
  std::transform(
    this->Edge.begin(), this->Edge.end(), isHeld.begin(), [](Index e) { return e >= 0; });
  return isHeld;
}

double LinkingSideColumns::uAt(std::size_t column, double fraction) const
{
  const auto reached = this->Reached.row(static_cast<Index>(column));
  const double length = fraction * reached[Samples];
  const auto after = std::upper_bound(reached.begin() + 1, reached.end() - 1, length);
  const Index high = static_cast<Index>(after - reached.begin());
  const Index low = high - 1;
  const double step = reached[high] - reached[low];
  const double along = step > 0.0 ? (length - reached[low]) / step : 0.0;
  return (static_cast<double>(low) + std::min(1.0, along)) / static_cast<double>(Samples);
}

Eigen::MatrixXd LinkingSideColumns::heightsByLength(
  const std::vector<double>& fractions, bool keepsPatches) const
{
  const Index n = this->size();
  const Index layers = static_cast<Index>(fractions.size()) - 1;
  const std::vector<bool> isHeld = this->heldByEdges();
  Eigen::MatrixXd u(n, layers + 1);
  for (Index j = 0; j < n; ++j)
  {
    const std::vector<double> own = keepsPatches
      ? fractionsBeside(this->Meshed, isHeld, static_cast<std::size_t>(j), fractions)
      : fractions;
    for (Index k = 0; k <= layers; ++k)
    {
      u(j, k) = k == 0 ? 0.0
        : k == layers  ? 1.0
                       : this->uAt(static_cast<std::size_t>(j), own[static_cast<std::size_t>(k)]);
    }
  }
  return u;
}

Eigen::MatrixXd LinkingSideColumns::heights(
  const std::vector<double>& fractions, bool keepsPatches) const
{
  const Index n = this->size();
  if (!this->Levels.empty() && !keepsPatches)
  {
    Eigen::RowVectorXd level(static_cast<Index>(fractions.size()));
    for (std::size_t k = 0; k < fractions.size(); ++k)
    {
      level[static_cast<Index>(k)] = evenlySampled(this->Levels, fractions[k]);
    }
    return level.replicate(n, 1);
  }
  // Neighbouring columns of very different length can turn a quad over in the strip. Rings of one
  // height never do: go towards them as far as it takes.
  const Eigen::MatrixXd byLength = this->heightsByLength(fractions, keepsPatches);
  Eigen::MatrixXd u = byLength;
  const Eigen::RowVectorXd mean = u.colwise().mean();
  for (const double weight : { 0.25, 0.5, 0.75, 1.0 })
  {
    if (this->isStraight(u))
    {
      break;
    }
    u = (1.0 - weight) * byLength + weight * mean.replicate(n, 1);
  }
  if (keepsPatches || !this->isSteep(u))
  {
    return u;
  }
  const Eigen::MatrixXd steep = u;
  CornerSines best = this->cornerSines(u);
  for (const double weight : { 0.5, 1.0 })
  {
    const Eigen::MatrixXd level = (1.0 - weight) * steep + weight * mean.replicate(n, 1);
    const CornerSines sines = this->isStraight(level) ? this->cornerSines(level) : best;
    if (sines.least > LevelGain * best.least ||
      (sines.least >= best.least && LevelGain * (1.0 - sines.mean()) < 1.0 - best.mean()))
    {
      u = level;
      best = sines;
    }
  }
  return u;
}

/// Whether a ring leaps up somewhere.
bool LinkingSideColumns::isSteep(const Eigen::MatrixXd& u) const
{
  const Index n = this->size();
  for (Index j = 0; j < n; ++j)
  {
    const Index next = (j + 1) % n;
    const double step = (this->Ring.row(next) - this->Ring.row(j)).norm();
    if ((u.row(next) - u.row(j)).cwiseAbs().maxCoeff() * this->meanLength() > MostRise * step)
    {
      return true;
    }
  }
  return false;
}

/// Of the corners of all quads with nodes at these heights.
CornerSines LinkingSideColumns::cornerSines(const Eigen::MatrixXd& u) const
{
  const Index n = this->size();
  const auto ringAt = [&](Index k) {
    Points ring(n, 3);
    for (Index j = 0; j < n; ++j)
    {
      ring.row(j) = this->nodeOn(static_cast<std::size_t>(j), u(j, k));
    }
    return ring;
  };
  CornerSines sines;
  Points below = ringAt(0);
  for (Index k = 1; k < u.cols(); ++k)
  {
    Points above = ringAt(k);
    sines.add(hexsweep::cornerSines(below, above));
    below = std::move(above);
  }
  return sines;
}

Eigen::RowVector2d LinkingSideColumns::planePlace(const Eigen::MatrixXd& u, Index j, Index k) const
{
  const Index n = this->size();
  const std::size_t column = static_cast<std::size_t>(j % n);
  const double turn = j >= n ? 1.0 : 0.0;
  const double height = u(j % n, k);
  return { this->Courses.at(column, height) + turn, height };
}

bool LinkingSideColumns::isStraight(const Eigen::MatrixXd& u) const
{
  for (Index j = 0; j < this->size(); ++j)
  {
    for (Index k = 0; k + 1 < u.cols(); ++k)
    {
      const Eigen::RowVector2d q[4] = { this->planePlace(u, j, k), this->planePlace(u, j + 1, k),
        this->planePlace(u, j + 1, k + 1), this->planePlace(u, j, k + 1) };
      for (int c = 0; c < 4; ++c)
      {
        if (orientation(q[c], q[(c + 1) % 4], q[(c + 3) % 4]) <= 0)
        {
          return false;
        }
      }
    }
  }
  return true;
}

Eigen::RowVector3d LinkingSideColumns::nodeOn(std::size_t column, double u) const
{
  if (this->Edge[column] < 0)
  {
    return this->inside(column, u).point;
  }
  const StripColumn& edge = this->Strip->columns[static_cast<std::size_t>(this->Edge[column])];
  const auto [after, along] = placeOn(edge, u);
  const Eigen::RowVector3d a = this->Strip->surface.points.row(edge.points[after - 1]);
  return a + along * (this->Strip->surface.points.row(edge.points[after]) - a);
}

SideTubeMesh LinkingSideColumns::mesh(const std::vector<double>& fractions) const
{
  const Index n = this->size();
  const Index layers = static_cast<Index>(fractions.size()) - 1;
  if (this->Meshed.layers > 1 && this->Meshed.layers != layers)
  {
    throw InvalidInput("the part of a linking side that is meshed already has " +
      std::to_string(this->Meshed.layers) + " layers, and " + std::to_string(layers) +
      " are asked for. Set the number of layers to " + std::to_string(this->Meshed.layers) + ".");
  }
  // Quads of one layer are how walls of an extrusion are given, rather than a mesh to keep.
  const bool keepsPatches = this->Meshed.layers == layers;
  const Eigen::MatrixXd u = this->heights(fractions, keepsPatches);
  SideTubeMesh result;
  result.nodes.resize((layers + 1) * n, 3);
  result.quadTriangle.resize(static_cast<std::size_t>(layers * n));
  // Back to the order of the ring as it was given.
  const auto given = [&](Index j) {
    const Index place = (j + static_cast<Index>(this->Begin)) % n;
    return this->Reversed ? n - 1 - place : place;
  };
  result.edges.resize(static_cast<std::size_t>(n));
  for (Index j = 0; j < n; ++j)
  {
    const std::size_t column = static_cast<std::size_t>(j);
    if (this->Edge[column] >= 0)
    {
      result.edges[static_cast<std::size_t>(given(j))] = loopPoints(this->Strip->surface.points,
        this->Strip->columns[static_cast<std::size_t>(this->Edge[column])].points);
    }
    const bool isMeshed = keepsPatches && this->Meshed.columns[column].rows() > 0;
    for (Index k = 0; k <= layers; ++k)
    {
      auto node = result.nodes.row(k * n + given(j));
      if (k == 0)
      {
        node = this->Ring.row(j);
      }
      else if (isMeshed)
      {
        node = this->Meshed.columns[column].row(k);
      }
      else
      {
        node = k == layers ? pointOnTarget(*this->Strip, this->Courses.end[column])
                           : this->nodeOn(column, u(j, k));
      }
    }
    const Index next = (j + 1) % n;
    // The quad between two columns goes by the one that comes first in the given order.
    const Index quad = this->Reversed ? given(next) : given(j);
    for (Index k = 0; k < layers; ++k)
    {
      const Eigen::RowVector2d middle = 0.25 *
        (this->planePlace(u, j, k) + this->planePlace(u, j + 1, k) +
          this->planePlace(u, j + 1, k + 1) + this->planePlace(u, j, k + 1));
      const Index triangle = this->Search->at(middle[0], middle[1]).triangle;
      result.quadTriangle[static_cast<std::size_t>(k * n + quad)] =
        this->Strip->triangleOrigin[static_cast<std::size_t>(triangle)];
    }
  }
  return result;
}
}

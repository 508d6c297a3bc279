// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/RingAlignment.h"

#include "Core/Geometry/AffineMap.h"
#include "Core/Geometry/LoopGeometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr Index SectionsLookedAt = 16;
constexpr Index MostLookedAt = 48; // columns of a side
constexpr int Halvings = 30;       // of the strip's height, to find a plane
/// Root mean square misfit of sections, of the source's radius: less is not worth a look.
constexpr double LeastMisfit = 0.02;
/// What sines of corners lack to 1 in the mean: less is not worth a look.
constexpr double LeastLean = 0.01;
/// Of a misfit or a lean: something else if no more than this is left. Bends leave 0.01 to 0.14,
/// whatever else makes sections differ (ribs, caps of other shapes, tilted ones) 0.5 and more.
constexpr double FarLess = 0.25;
/// Of a misfit: no more than sections may lose when they lean less.
constexpr double LittleMore = 1.25;

std::vector<Index> columnsLookedAt(const LinkingSideColumns& side)
{
  const Index count = std::min(side.size(), MostLookedAt);
  std::vector<Index> columns;
  for (Index i = 0; i < count; ++i)
  {
    columns.push_back(i * side.size() / count);
  }
  return columns;
}

std::size_t sideWithTheLongestLoop(const std::deque<LinkingSideColumns>& sides)
{
  std::size_t longest = 0;
  for (std::size_t s = 1; s < sides.size(); ++s)
  {
    longest = closedLength(sides[s].ring()) > closedLength(sides[longest].ring()) ? s : longest;
  }
  return longest;
}

/// Root mean square distance of the nodes of sections from where affine maps take those at the
/// source, of the radius of these.
double sectionMisfit(const std::deque<LinkingSideColumns>& sides)
{
  std::vector<std::vector<Points>> sections;
  Index nodes = 0;
  for (const LinkingSideColumns& side : sides)
  {
    sections.push_back(side.sections(columnsLookedAt(side), SectionsLookedAt));
    nodes += sections.back().front().rows();
  }
  const auto all = [&](std::size_t k) {
    Points points(nodes, 3);
    Index row = 0;
    for (const std::vector<Points>& own : sections)
    {
      points.middleRows(row, own[k].rows()) = own[k];
      row += own[k].rows();
    }
    return points;
  };
  const std::vector<Points>& main = sections[sideWithTheLongestLoop(sides)];
  const Points begins = all(0);
  double misfit = 0.0;
  for (std::size_t k = 1; k < main.size(); ++k)
  {
    const Points here = all(k);
    const AffineMap map = fitAffineMap(begins, here, areaVector(main.front()), areaVector(main[k]));
    misfit += (map.apply(begins) - here).squaredNorm();
  }
  const double radius = (begins.rowwise() - begins.colwise().mean()).squaredNorm();
  return std::sqrt(misfit / (static_cast<double>(SectionsLookedAt) * radius));
}

CornerSines cornerSinesOf(const std::deque<LinkingSideColumns>& sides)
{
  CornerSines sines;
  for (const LinkingSideColumns& side : sides)
  {
    sines.add(side.cornerSines());
  }
  return sines;
}

/// The plane of a ring.
struct RingPlane
{
  Eigen::RowVector3d center;
  Eigen::RowVector3d normal;

  double above(const Points& ring) const
  {
    return (ring.colwise().mean() - this->center).dot(this->normal);
  }
};

RingPlane planeOf(const Points& ring)
{
  return { ring.colwise().mean(), areaVector(ring).normalized() };
}

/// Heights of a side whose rings lie in planes, as far above them as the loops do at the caps.
std::vector<double> heightsInPlanes(
  const LinkingSideColumns& side, const std::vector<RingPlane>& planes)
{
  const std::vector<Index> columns = columnsLookedAt(side);
  const double first = planes.front().above(side.nodesAt(columns, 0.0, 0.0));
  const double last = planes.back().above(side.nodesAt(columns, 1.0, 0.0));
  const double layers = static_cast<double>(planes.size() - 1);
  std::vector<double> heights(1, 0.0);
  for (std::size_t k = 1; k + 1 < planes.size(); ++k)
  {
    const double along = static_cast<double>(k) / layers;
    const double wanted = (1.0 - along) * first + along * last;
    double low = heights.back();
    double high = 1.0;
    for (int halving = 0; halving < Halvings; ++halving)
    {
      const double middle = 0.5 * (low + high);
      (planes[k].above(side.nodesAt(columns, middle, 0.0)) < wanted ? low : high) = middle;
    }
    heights.push_back(0.5 * (low + high));
  }
  heights.push_back(1.0);
  return heights;
}

/// Whether heights rise enough for rings to keep apart: by a good part of their even share.
bool areApart(const std::vector<double>& heights)
{
  constexpr double Share = 0.1;
  const double least = Share / static_cast<double>(heights.size() - 1);
  for (std::size_t k = 1; k < heights.size(); ++k)
  {
    if (heights[k] - heights[k - 1] < least)
    {
      return false;
    }
  }
  return true;
}

/// @return whether all sides have rings in planes then.
bool levelRings(std::deque<LinkingSideColumns>& sides)
{
  for (LinkingSideColumns& side : sides)
  {
    if (!side.freeHeights())
    {
      return false;
    }
  }
  LinkingSideColumns& main = sides[sideWithTheLongestLoop(sides)];
  const std::vector<double> heights = main.meanHeights(SectionsLookedAt);
  std::vector<RingPlane> planes;
  for (const double height : heights)
  {
    planes.push_back(planeOf(main.nodesAt(columnsLookedAt(main), height, 0.0)));
  }
  if (planes.back().normal.dot(main.nodesAt({ 0 }, 1.0, 0.0).row(0) -
        main.nodesAt({ 0 }, heights[SectionsLookedAt - 1], 0.0).row(0)) < 0.0)
  {
    for (RingPlane& plane : planes)
    {
      plane.normal = -plane.normal;
    }
  }
  for (LinkingSideColumns& side : sides)
  {
    const std::vector<double> own = &side == &main ? heights : heightsInPlanes(side, planes);
    if (!areApart(own))
    {
      return false;
    }
    side.levelRings(own);
  }
  return true;
}
}

void levelRingsWhereBetter(std::deque<LinkingSideColumns>& sides)
{
  const CornerSines byLength = cornerSinesOf(sides);
  if (1.0 - byLength.mean() < LeastLean)
  {
    return;
  }
  std::deque<LinkingSideColumns> level = sides;
  if (!levelRings(level))
  {
    return;
  }
  const CornerSines sines = cornerSinesOf(level);
  if (1.0 - sines.mean() < FarLess * (1.0 - byLength.mean()) && sines.least >= byLength.least &&
    sectionMisfit(level) < std::max(LeastMisfit, LittleMore * sectionMisfit(sides)))
  {
    sides = std::move(level);
  }
}

void shareRingsWhereBetter(std::deque<LinkingSideColumns>& sides)
{
  const double straight = sectionMisfit(sides);
  if (straight < LeastMisfit)
  {
    return;
  }
  std::deque<LinkingSideColumns> shared = sides;
  for (LinkingSideColumns& side : shared)
  {
    side.shareRings();
  }
  if (sectionMisfit(shared) < FarLess * straight)
  {
    sides = std::move(shared);
  }
}
}

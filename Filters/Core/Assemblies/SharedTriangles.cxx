// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/SharedTriangles.h"

#include "Core/Common/Describe.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/PointGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace hexsweep
{
namespace
{
using Place = std::array<double, 3>;

/// Numbers the places of points, each once.
class PlaceNumbers
{
public:
  Index numberOf(const Eigen::RowVector3d& place)
  {
    const auto [known, isNew] = this->Numbers.try_emplace(
      Place{ place[0], place[1], place[2] }, static_cast<Index>(this->Numbers.size()));
    if (isNew)
    {
      this->Places.push_back(place);
    }
    return known->second;
  }

  Points points() const
  {
    Points result(static_cast<Index>(this->Places.size()), 3);
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      result.row(static_cast<Index>(i)) = this->Places[i];
    }
    return result;
  }

private:
  std::map<Place, Index> Numbers;
  std::vector<Eigen::RowVector3d> Places;
};

/// A triangle of a solid in the numbers of the complex.
struct SolidTriangle
{
  TriangleCorners key; ///< the corners, rising
  Index volume;
  Index row;
  bool isEven; ///< whether the corners run as they rise, or turned round from there
};

SolidTriangle solidTriangle(const TriangleCorners& corners, Index volume, Index row)
{
  TriangleCorners key = corners;
  std::sort(key.begin(), key.end());
  const std::size_t first =
    static_cast<std::size_t>(std::find(corners.begin(), corners.end(), key[0]) - corners.begin());
  return { key, volume, row, corners[(first + 1) % 3] == key[1] };
}

std::vector<std::vector<Partner>> partnersOf(
  const std::vector<const SolidSurface*>& solids, std::vector<SolidTriangle> all)
{
  std::vector<std::vector<Partner>> partners;
  for (const SolidSurface* solid : solids)
  {
    partners.emplace_back(at(solid->triangles.rows()));
  }
  std::sort(all.begin(), all.end(), [](const SolidTriangle& a, const SolidTriangle& b) {
    return std::tie(a.key, a.volume, a.row) < std::tie(b.key, b.volume, b.row);
  });
  for (std::size_t i = 0; i + 1 < all.size(); ++i)
  {
    const SolidTriangle& one = all[i];
    const SolidTriangle& other = all[i + 1];
    if (one.key != other.key)
    {
      continue;
    }
    if (i + 2 < all.size() && all[i + 2].key == one.key)
    {
      const SolidSurface& solid = *solids[at(one.volume)];
      throw InvalidInput("face " + std::to_string(solid.faceIds[at(one.row)]) + " at " +
        describe(solid.points.row(solid.triangles(one.row, 0))) +
        " belongs to more than two volumes. Check that no body is there twice.");
    }
    // Two that face the same way are the same body twice, and nothing that both share.
    if (one.isEven != other.isEven)
    {
      partners[at(one.volume)][at(one.row)] = { other.volume, other.row };
      partners[at(other.volume)][at(other.row)] = { one.volume, one.row };
    }
  }
  return partners;
}

double shortestEdge(
  const Points& points, const std::vector<std::vector<TriangleCorners>>& triangles)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (const std::vector<TriangleCorners>& solid : triangles)
  {
    for (const TriangleCorners& corners : solid)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        shortest =
          std::min(shortest, (points.row(corners[c]) - points.row(corners[(c + 1) % 3])).norm());
      }
    }
  }
  return shortest;
}

/// For each point the lowest one that is near it, itself or by others.
std::vector<Index> nearPoints(const Points& points, double radius)
{
  std::vector<Index> ids(at(points.rows()));
  std::iota(ids.begin(), ids.end(), Index(0));
  if (!(radius > 0.0) || !std::isfinite(radius))
  {
    return ids;
  }
  const PointGrid grid(points, ids, radius);
  DisjointSets sets(points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    grid.forEachNear(points.row(i), radius, [&](Index other, double) { sets.join(i, other); });
  }
  for (Index& id : ids)
  {
    id = sets.find(id);
  }
  return ids;
}
}

SharedTriangles shareTriangles(
  const std::vector<const SolidSurface*>& solids, double matchTolerance)
{
  SharedTriangles result;
  PlaceNumbers places;
  std::vector<SolidTriangle> all;
  for (const SolidSurface* const given : solids)
  {
    const SolidSurface& solid = *given;
    result.corners.emplace_back(at(solid.triangles.rows()));
    for (Index t = 0; t < solid.triangles.rows(); ++t)
    {
      TriangleCorners& own = result.corners.back()[at(t)];
      for (int c = 0; c < 3; ++c)
      {
        own[static_cast<std::size_t>(c)] = places.numberOf(solid.points.row(solid.triangles(t, c)));
      }
    }
  }
  result.points = places.points();
  const std::vector<Index> merged =
    nearPoints(result.points, matchTolerance * shortestEdge(result.points, result.corners));
  for (std::size_t v = 0; v < solids.size(); ++v)
  {
    for (std::size_t t = 0; t < result.corners[v].size(); ++t)
    {
      for (Index& corner : result.corners[v][t])
      {
        corner = merged[at(corner)];
      }
      all.push_back(
        solidTriangle(result.corners[v][t], static_cast<Index>(v), static_cast<Index>(t)));
    }
  }
  result.partners = partnersOf(solids, std::move(all));
  return result;
}
}

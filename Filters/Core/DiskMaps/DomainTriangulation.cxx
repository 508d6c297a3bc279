// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/DomainTriangulation.h"

#include "Core/Common/Constants.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace hexsweep
{
namespace
{
/// Points of the strip and their copies, one or more turns higher or lower.
class StripPoints
{
public:
  explicit StripPoints(const PlanePointsRef& disk)
  {
    this->Coordinates.reserve(static_cast<std::size_t>(2 * disk.rows()));
    for (Index v = 0; v < disk.rows(); ++v)
    {
      const Eigen::RowVector2d place = wrapDomainPoint(
        DiskDomain::Annulus, { std::log(disk.row(v).norm()), std::atan2(disk(v, 1), disk(v, 0)) });
      this->Coordinates.insert(this->Coordinates.end(), { place.x(), place.y() });
    }
  }
  double angle(Index point) const
  {
    return this->Coordinates[static_cast<std::size_t>(2 * point + 1)];
  }
  /// The point of that number `turns` turns higher. All triangles get the same copy: edges match.
  Index copy(Index point, int turns)
  {
    if (turns == 0)
    {
      return point;
    }
    const Index next = static_cast<Index>(this->Coordinates.size()) / 2;
    const auto known = this->Copies[turns].emplace(point, next);
    if (known.second)
    {
      const double x = this->Coordinates[static_cast<std::size_t>(2 * point)];
      this->Coordinates.insert(
        this->Coordinates.end(), { x, this->angle(point) + 2.0 * Pi * turns });
    }
    return known.first->second;
  }
  PlanePoints points() const
  {
    return Eigen::Map<const PlanePoints>(
      this->Coordinates.data(), static_cast<Index>(this->Coordinates.size()) / 2, 2);
  }

private:
  std::vector<double> Coordinates;
  std::unordered_map<int, std::unordered_map<Index, Index>> Copies;
};
}

DomainTriangulation domainTriangulation(
  DiskDomain domain, const PlanePointsRef& disk, const TrianglesRef& triangles)
{
  DomainTriangulation result;
  if (domain != DiskDomain::Annulus)
  {
    result.points = disk;
    result.triangles = triangles;
    result.origin.resize(static_cast<std::size_t>(triangles.rows()));
    std::iota(result.origin.begin(), result.origin.end(), Index(0));
    return result;
  }

  StripPoints points(disk);
  std::vector<Index> corners;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    // Corners within half a turn of the first one.
    int turns[3] = { 0, 0, 0 };
    for (Index c = 1; c < 3; ++c)
    {
      const double ahead = points.angle(triangles(t, c)) - points.angle(triangles(t, 0));
      turns[c] = ahead > Pi ? -1 : (ahead < -Pi ? 1 : 0);
    }
    const auto range = std::minmax({ turns[0], turns[1], turns[2] });
    // Once with each of its levels between 0 and 2 pi.
    for (int level = range.first; level <= range.second; ++level)
    {
      for (Index c = 0; c < 3; ++c)
      {
        corners.push_back(points.copy(triangles(t, c), turns[c] - level));
      }
      result.origin.push_back(t);
    }
  }
  result.points = points.points();
  result.triangles =
    Eigen::Map<const Triangles>(corners.data(), static_cast<Index>(corners.size()) / 3, 3);
  return result;
}
}

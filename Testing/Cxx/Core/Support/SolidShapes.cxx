// SPDX-License-Identifier: BSD-3-Clause

#include "Support/SolidShapes.h"

namespace test
{
Index planeLabel(const Cell& cell, int direction)
{
  const int axis = (direction - 1) / 2;
  const int level = cell[static_cast<std::size_t>(axis)] + (direction % 2 == 0 ? 1 : 0);
  return 10 * level + direction;
}

SolidInput cubes(
  const Cell& size, const std::function<bool(int, int, int)>& filled, const SideLabel& label)
{
  const auto solidAt = [&](const Cell& cell) {
    for (std::size_t a = 0; a < 3; ++a)
    {
      if (cell[a] < 0 || cell[a] >= size[a])
      {
        return false;
      }
    }
    return filled(cell[0], cell[1], cell[2]);
  };
  std::map<Cell, Index> numbers;
  std::vector<double> coordinates;
  const auto point = [&](const Cell& place) {
    const auto known = numbers.emplace(place, static_cast<Index>(numbers.size()));
    if (known.second)
    {
      coordinates.insert(coordinates.end(), place.begin(), place.end());
    }
    return known.first->second;
  };
  SolidInput solid;
  std::vector<Index> corners;
  Cell cell;
  for (cell[2] = 0; cell[2] < size[2]; ++cell[2])
  {
    for (cell[1] = 0; cell[1] < size[1]; ++cell[1])
    {
      for (cell[0] = 0; cell[0] < size[0]; ++cell[0])
      {
        for (int direction = 1; direction <= 6 && solidAt(cell); ++direction)
        {
          const auto axis = static_cast<std::size_t>((direction - 1) / 2);
          const bool up = direction % 2 == 0;
          Cell beyond = cell;
          beyond[axis] += up ? 1 : -1;
          if (solidAt(beyond))
          {
            continue;
          }
          // The four corners, counter-clockwise about +axis.
          std::array<Index, 4> side;
          for (int i = 0; i < 4; ++i)
          {
            Cell corner = cell;
            corner[axis] += up ? 1 : 0;
            corner[(axis + 1) % 3] += i == 1 || i == 2 ? 1 : 0;
            corner[(axis + 2) % 3] += i >= 2 ? 1 : 0;
            side[static_cast<std::size_t>(i)] = point(corner);
          }
          if (!up)
          {
            std::swap(side[1], side[3]);
          }
          corners.insert(corners.end(), { side[0], side[1], side[2], side[0], side[2], side[3] });
          const Index id = label(cell, direction);
          solid.faceIds.insert(solid.faceIds.end(), { id, id });
        }
      }
    }
  }
  solid.points =
    Eigen::Map<const Points>(coordinates.data(), static_cast<Index>(coordinates.size()) / 3, 3);
  solid.triangles = facesOf<Triangles>(corners);
  return solid;
}

SolidInput box(int x, int y, int z, const SideLabel& label)
{
  return cubes(
    { x, y, z }, [](int, int, int) { return true; }, label);
}

SolidInput soup(const SolidInput& solid)
{
  SolidInput result = solid;
  result.points.resize(solid.triangles.size(), 3);
  for (Index i = 0; i < solid.triangles.size(); ++i)
  {
    result.points.row(i) = solid.points.row(solid.triangles.data()[i]);
    result.triangles.data()[i] = i;
  }
  return result;
}

SolidInput withTriangles(const SolidInput& solid, const std::function<bool(Index triangle)>& keep)
{
  SolidInput result;
  result.points = solid.points;
  std::vector<Index> corners;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    if (keep(t))
    {
      corners.insert(
        corners.end(), { solid.triangles(t, 0), solid.triangles(t, 1), solid.triangles(t, 2) });
      result.faceIds.push_back(solid.faceIds[static_cast<std::size_t>(t)]);
    }
  }
  result.triangles = facesOf<Triangles>(corners);
  return result;
}

SolidInput withTriangle(SolidInput solid, Index a, Index b, Index c, Index faceId)
{
  solid.triangles.conservativeResize(solid.triangles.rows() + 1, 3);
  solid.triangles.bottomRows<1>() << a, b, c;
  solid.faceIds.push_back(faceId);
  return solid;
}

double volumeOf(const hexsweep::SolidSurface& solid)
{
  double volume = 0.0;
  const Eigen::RowVector3d origin = solid.points.row(0);
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    Eigen::Matrix3d edges;
    for (int c = 0; c < 3; ++c)
    {
      edges.row(c) = solid.points.row(solid.triangles(t, c)) - origin;
    }
    volume += edges.determinant() / 6.0;
  }
  return volume;
}
}

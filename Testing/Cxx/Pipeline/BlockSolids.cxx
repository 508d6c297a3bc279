// SPDX-License-Identifier: BSD-3-Clause

#include "BlockSolids.h"

namespace test
{
SolidBlock blockOf(std::array<int, 3> n, const std::function<Point(double, double, double)>& map)
{
  return { n, [=](int i, int j, int k) {
            return map(static_cast<double>(i) / n[0], static_cast<double>(j) / n[1],
              static_cast<double>(k) / n[2]);
          } };
}

Grid blockFaces(const SolidBlock& block, const std::set<int>& faces, const std::set<int>& asQuads)
{
  std::vector<Point> points;
  auto grid = Grid::New();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(hexsweep::arrays::FaceId);
  std::vector<std::pair<int, Corners>> cells;
  for (const int face : faces)
  {
    const int axis = face <= Top ? 2 : face <= Right ? 0 : 1;
    const bool high = face % 2 == 0;
    const int a = (axis + 1) % 3; // a, b and the axis are right-handed
    const int b = (axis + 2) % 3;
    const vtkIdType first = static_cast<vtkIdType>(points.size());
    for (int q = 0; q <= block.n[b]; ++q)
    {
      for (int p = 0; p <= block.n[a]; ++p)
      {
        int index[3];
        index[axis] = high ? block.n[axis] : 0;
        index[a] = p;
        index[b] = q;
        points.push_back(block.at(index[0], index[1], index[2]));
      }
    }
    const vtkIdType row = block.n[a] + 1;
    for (int q = 0; q < block.n[b]; ++q)
    {
      for (int p = 0; p < block.n[a]; ++p)
      {
        const vtkIdType c = first + q * row + p;
        Corners quad = { c, c + 1, c + row + 1, c + row };
        if (!high)
        {
          std::reverse(quad.begin(), quad.end());
        }
        if (asQuads.count(face) > 0)
        {
          cells.emplace_back(face, quad);
        }
        else
        {
          cells.emplace_back(face, Corners{ quad[0], quad[1], quad[2] });
          cells.emplace_back(face, Corners{ quad[0], quad[2], quad[3] });
        }
      }
    }
  }
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  for (const Point& point : points)
  {
    coordinates->InsertNextPoint(point.data());
  }
  grid->SetPoints(coordinates);
  for (const auto& [face, cell] : cells)
  {
    grid->InsertNextCell(
      cell.size() == 4 ? VTK_QUAD : VTK_TRIANGLE, static_cast<vtkIdType>(cell.size()), cell.data());
    ids->InsertNextValue(face);
  }
  grid->GetCellData()->AddArray(ids);
  return grid;
}

std::set<int> allFaces()
{
  return { Bottom, Top, Left, Right, Front, Back };
}

Grid cellsWith(vtkUnstructuredGrid* boundary, const char* array, double value)
{
  std::vector<Point> points;
  std::vector<Corners> cells;
  std::map<vtkIdType, vtkIdType> newId;
  for (vtkIdType c = 0; c < boundary->GetNumberOfCells(); ++c)
  {
    if (boundary->GetCellData()->GetArray(array)->GetTuple1(c) != value)
    {
      continue;
    }
    Corners cell = cornersOf(boundary, c);
    for (vtkIdType& corner : cell)
    {
      const auto [known, isNew] = newId.emplace(corner, static_cast<vtkIdType>(points.size()));
      if (isNew)
      {
        points.push_back(pointOf(boundary, corner));
      }
      corner = known->second;
    }
    cells.push_back(cell);
  }
  const bool areQuads = cells.empty() || cells.front().size() == 4;
  return gridOf(points, cells, areQuads ? VTK_QUAD : VTK_TRIANGLE);
}

void addFace(vtkUnstructuredGrid* solid, vtkUnstructuredGrid* cells, int face)
{
  const vtkIdType first = solid->GetNumberOfPoints();
  for (vtkIdType i = 0; i < cells->GetNumberOfPoints(); ++i)
  {
    solid->GetPoints()->InsertNextPoint(cells->GetPoint(i));
  }
  auto* ids =
    vtkIdTypeArray::SafeDownCast(solid->GetCellData()->GetArray(hexsweep::arrays::FaceId));
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
  {
    Corners cell = cornersOf(cells, c);
    for (vtkIdType& corner : cell)
    {
      corner += first;
    }
    solid->InsertNextCell(cells->GetCellType(c), static_cast<vtkIdType>(cell.size()), cell.data());
    ids->InsertNextValue(face);
  }
}

MergedHexes merged(const std::vector<vtkUnstructuredGrid*>& grids)
{
  MergedHexes result;
  std::map<Point, vtkIdType> ids;
  for (vtkUnstructuredGrid* grid : grids)
  {
    for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
    {
      Corners hex = cornersOf(grid, c);
      for (vtkIdType& corner : hex)
      {
        const Point place = pointOf(grid, corner);
        const auto [known, isNew] = ids.emplace(place, static_cast<vtkIdType>(ids.size()));
        if (isNew)
        {
          result.points.push_back(place);
        }
        corner = known->second;
      }
      result.hexes.push_back(hex);
      static constexpr int Sides[6][4] = { { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
        { 0, 4, 7, 3 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
      for (const auto& side : Sides)
      {
        Corners face;
        for (const int corner : side)
        {
          face.push_back(hex[static_cast<std::size_t>(corner)]);
        }
        std::sort(face.begin(), face.end());
        ++result.faces[face];
      }
    }
  }
  return result;
}
}

// SPDX-License-Identifier: BSD-3-Clause

#include "SolidGrids.h"

namespace test
{
void PrintTo(const CadSolid& solid, std::ostream* os)
{
  *os << solid.name;
}

const std::vector<CadSolid>& cadSolids()
{
  static const std::vector<CadSolid> solids = {
    { "flange", { 3 }, { 2 }, 6, 0, 104 + 34 + 6 * 14, 3.0 },
    { "elbow", { 1 }, { 4 }, 30, 0, 42 + 28, 3.0 },
    { "loft", { 9 }, { 11 }, 16, 4, 64 + 22, 2.5 },
    { "bracket", { 26 }, { 36 }, 14, 8, 114 + 16 + 16, 2.0 },
    { "wing", { 3 }, { 4 }, 40, 2, 82, 2.5 },
  };
  return solids;
}

Grid solidGrid(const std::string& name)
{
  return readGrid("../solids/" + name + "/solid");
}

Grid solidQuads(const std::string& name)
{
  return readGrid("../solids/" + name + "/source_quads");
}

std::map<vtkIdType, double> areasById(vtkDataSet* surface, const char* array)
{
  std::map<vtkIdType, double> areas;
  vtkDataArray* ids = surface->GetCellData()->GetArray(array);
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    vtkCell* cell = surface->GetCell(c);
    double area = 0.0;
    for (int i = 2; i < cell->GetNumberOfPoints(); ++i)
    {
      double p[3][3];
      cell->GetPoints()->GetPoint(0, p[0]);
      cell->GetPoints()->GetPoint(i - 1, p[1]);
      cell->GetPoints()->GetPoint(i, p[2]);
      area += vtkTriangle::TriangleArea(p[0], p[1], p[2]);
    }
    areas[static_cast<vtkIdType>(ids->GetTuple1(c))] += area;
  }
  return areas;
}

double enclosedVolume(vtkDataSet* surface)
{
  double volume = 0.0;
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    vtkCell* cell = surface->GetCell(c);
    double p[4][3];
    cell->GetPoints()->GetPoint(0, p[0]);
    for (int i = 2; i < cell->GetNumberOfPoints(); ++i)
    {
      cell->GetPoints()->GetPoint(i - 1, p[1]);
      cell->GetPoints()->GetPoint(i, p[2]);
      double cross[3];
      vtkMath::Cross(p[1], p[2], cross);
      volume += vtkMath::Dot(p[0], cross) / 6.0;
    }
  }
  return volume;
}
}

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief CAD solids for the tests of whole sweeps, and what is known of them.
 */
#ifndef SolidGrids_h
#define SolidGrids_h

#include "CapGrids.h"

#include <vtkMath.h>
#include <vtkOneToOneSweep.h>
#include <vtkTriangle.h>

namespace test
{
/// A tessellated CAD solid of Data/solids.
struct CadSolid
{
  const char* name;
  std::vector<vtkIdType> source;
  std::vector<vtkIdType> target;
  vtkIdType layers;
  vtkIdType columnEdges; ///< CAD edges that run from the source to the target cap
  vtkIdType loopNodes;   ///< of the given source quads, on all loops
  double quadSize;       ///< of the given source quads
};

inline void PrintTo(const CadSolid& solid, std::ostream* os)
{
  *os << solid.name;
}

inline const std::vector<CadSolid>& cadSolids()
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

inline Grid solidGrid(const std::string& name)
{
  return readGrid("../solids/" + name + "/solid");
}

inline Grid solidQuads(const std::string& name)
{
  return readGrid("../solids/" + name + "/source_quads");
}

/// The filter with its messages.
struct SolidSweep
{
  vtkNew<vtkOneToOneSweep> filter;
  Events events;

  explicit SolidSweep(vtkDataObject* solid, vtkDataObject* quads = nullptr)
    : events(filter)
  {
    this->filter->SetSolidData(solid);
    if (quads)
    {
      this->filter->SetSourceQuadsData(quads);
    }
  }

  void name(const std::vector<vtkIdType>& source, const std::vector<vtkIdType>& target)
  {
    for (const vtkIdType id : source)
    {
      this->filter->AddSourceFaceId(id);
    }
    for (const vtkIdType id : target)
    {
      this->filter->AddTargetFaceId(id);
    }
  }

  vtkUnstructuredGrid* hexes()
  {
    return vtkUnstructuredGrid::SafeDownCast(this->filter->GetOutputDataObject(0));
  }
  vtkUnstructuredGrid* boundary()
  {
    return vtkUnstructuredGrid::SafeDownCast(this->filter->GetOutputDataObject(1));
  }

  std::string messages() const
  {
    std::string text;
    for (const std::string& message : this->events.errors)
    {
      text += message;
    }
    for (const std::string& message : this->events.warnings)
    {
      text += message;
    }
    return text;
  }
};

/// Area of the cells of a surface by the value of a cell array.
inline std::map<vtkIdType, double> areasById(vtkDataSet* surface, const char* array)
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

/// By the divergence theorem, with each cell as a fan of triangles about its first point.
inline double enclosedVolume(vtkDataSet* surface)
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

#endif

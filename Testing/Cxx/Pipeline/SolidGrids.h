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

void PrintTo(const CadSolid& solid, std::ostream* os);

const std::vector<CadSolid>& cadSolids();

Grid solidGrid(const std::string& name);

Grid solidQuads(const std::string& name);

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
std::map<vtkIdType, double> areasById(vtkDataSet* surface, const char* array);

/// By the divergence theorem, with each cell as a fan of triangles about its first point.
double enclosedVolume(vtkDataSet* surface);
}

#endif

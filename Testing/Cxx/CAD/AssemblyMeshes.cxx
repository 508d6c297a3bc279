// SPDX-License-Identifier: BSD-3-Clause
#include "AssemblyMeshes.h"

#include "CADMeshes.h"
#include "CADParts.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Pnt.hxx>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkHexahedron.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkPartitionedDataSetCollection.h>

#include <algorithm>
#include <cmath>

namespace assemblymeshes
{
namespace
{
double areaOf(vtkUnstructuredGrid* grid, const std::array<vtkIdType, 4>& corners)
{
  double p[4][3];
  for (std::size_t i = 0; i < 4; ++i)
  {
    grid->GetPoint(corners[i], p[i]);
  }
  double d[3];
  double e[3];
  double normal[3];
  vtkMath::Subtract(p[2], p[0], d);
  vtkMath::Subtract(p[3], p[1], e);
  vtkMath::Cross(d, e, normal);
  return 0.5 * vtkMath::Norm(normal);
}

TopoDS_Shape together(const std::vector<TopoDS_Shape>& shapes)
{
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes)
  {
    builder.Add(all, shape);
  }
  return all;
}
}

HexFaces::HexFaces(vtkUnstructuredGrid* grid)
{
  std::map<std::array<vtkIdType, 4>, std::array<vtkIdType, 4>> corners;
  vtkNew<vtkIdList> points;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCellPoints(c, points);
    for (int f = 0; f < 6; ++f)
    {
      const vtkIdType* face = vtkHexahedron::GetFaceArray(f);
      std::array<vtkIdType, 4> own{};
      for (std::size_t i = 0; i < 4; ++i)
      {
        own[i] = points->GetId(face[i]);
      }
      std::array<vtkIdType, 4> key = own;
      std::sort(key.begin(), key.end());
      corners[key] = own;
      this->most = std::max(this->most, ++this->uses[key]);
    }
  }
  for (const auto& [key, count] : this->uses)
  {
    this->skinArea += count == 1 ? areaOf(grid, corners[key]) : 0.0;
  }
}

std::set<int> volumesIn(vtkUnstructuredGrid* grid)
{
  std::set<int> ids;
  vtkDataArray* array = grid->GetCellData()->GetArray("VolumeId");
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    ids.insert(static_cast<int>(array->GetTuple1(c)));
  }
  return ids;
}

double report(vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkDataArray* array = grid->GetFieldData()->GetArray(("SweepReport" + name).c_str());
  return array ? array->GetTuple1(0) : HUGE_VAL;
}

vtkUnstructuredGrid* gridOf(vtkAssemblySweep* sweep, unsigned int place)
{
  return vtkUnstructuredGrid::SafeDownCast(sweep->GetOutput()->GetPartition(place, 0));
}

Swept::Swept(const std::string& file, double size)
{
  this->reader->SetFileName(file.c_str());
  this->sweep->SetInputConnection(this->reader->GetOutputPort());
  this->sweep->MergedOn();
  this->sweep->SetSize(size);
  this->sweep->Update();
}

std::string dataFile(const std::string& name)
{
  return std::string(HEXSWEEP_DATA_DIR) + "/cad/" + name + ".step";
}

TopoDS_Shape block(double x, double y, double z, double dx, double dy, double dz)
{
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

std::string fileOf(const std::string& name, const std::vector<TopoDS_Shape>& shapes)
{
  const std::string file = cadmeshes::temporaryFile(name + ".step");
  cadparts::writeSTEP(together(shapes), file);
  return file;
}
}

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Assemblies made or read, swept, and what their meshes are made of.
 */
#ifndef AssemblyMeshes_h
#define AssemblyMeshes_h

#include "TestEvents.h"
#include "vtkAssemblySweep.h"
#include "vtkCADReader.h"

#include <TopoDS_Shape.hxx>

#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace assemblymeshes
{
/// The faces of a mesh's hexahedra, and how often each is used.
struct HexFaces
{
  std::map<std::array<vtkIdType, 4>, int> uses;
  double skinArea = 0.0;
  int most = 0;

  explicit HexFaces(vtkUnstructuredGrid* grid);
};

/// The different values of `VolumeId`.
std::set<int> volumesIn(vtkUnstructuredGrid* grid);

/// First value of `SweepReport...`, infinity where there is none.
double report(vtkUnstructuredGrid* grid, const std::string& name);

vtkUnstructuredGrid* gridOf(vtkAssemblySweep* sweep, unsigned int place = 0);

/// A file read and swept, merged.
struct Swept
{
  vtkNew<vtkCADReader> reader;
  vtkNew<vtkAssemblySweep> sweep;
  test::Events events{ sweep };

  explicit Swept(const std::string& file, double size = 0.0);
  vtkUnstructuredGrid* grid() { return gridOf(this->sweep); }
  vtkUnstructuredGrid* quads()
  {
    return vtkUnstructuredGrid::SafeDownCast(this->sweep->GetOutputDataObject(1));
  }
};

/// A file of Data/cad.
std::string dataFile(const std::string& name);

TopoDS_Shape block(double x, double y, double z, double dx, double dy, double dz);

/// A STEP file of solids.
std::string fileOf(const std::string& name, const std::vector<TopoDS_Shape>& shapes);
}

#endif

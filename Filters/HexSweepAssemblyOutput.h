// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From the mesh of an assembly to collections and grids. Private to the module.
 */
#ifndef HexSweepAssemblyOutput_h
#define HexSweepAssemblyOutput_h

#include "Core/Assemblies/AssemblySweep.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkPartitionedDataSetCollection;
class vtkUnstructuredGrid;

namespace hexsweep
{
/// What the volumes are called.
struct VolumeLabels
{
  std::vector<Index> ids;
  std::vector<std::string> names;
};

/// Writes output 0 of vtkAssemblySweep. @param fields of the solids, handed on to all grids.
void writeAssembly(const AssemblySweep& sweep, const VolumeLabels& labels, bool merged,
  vtkFieldData* fields, vtkPartitionedDataSetCollection* output);

/// Writes output 1, without quads that have no hexahedron. @return how often a quad has none where
/// there is a volume.
Index writeAssemblyBoundary(
  const AssemblySweep& sweep, const VolumeLabels& labels, vtkUnstructuredGrid* output);
}

#endif

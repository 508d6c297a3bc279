// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From the mesh of an assembly to collections and grids. Private to the module.
 */
#ifndef HexSweepAssemblyOutput_h
#define HexSweepAssemblyOutput_h

#include "Core/Assemblies/AssemblyNumbers.h"

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

/// A mesh with the numbers and names that it has in the output.
struct NumberedAssembly
{
  const AssemblySweep& sweep;
  const AssemblyNumbers& numbers;
  const VolumeLabels& labels;
};

/// Writes output 0 of vtkAssemblySweep. @param fields of the solids, handed on to all grids.
void writeAssembly(const NumberedAssembly& assembly, bool merged, vtkFieldData* fields,
  vtkPartitionedDataSetCollection* output);

/// Writes output 1, without quads that have no hexahedron.
void writeAssemblyBoundary(const NumberedAssembly& assembly, vtkUnstructuredGrid* output);
}

#endif

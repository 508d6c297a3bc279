// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The output of vtkSweepSets as writers need it. Private to the module.
 */
#ifndef HexSweepMeshSets_h
#define HexSweepMeshSets_h

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;
class vtkUnstructuredGrid;

namespace hexsweep
{
/// Sides of a hexahedron as vtkHexahedron numbers its faces.
struct MeshSide
{
  vtkIdType hex; ///< from 0 on
  int side;      ///< from 0 to 5
};

/// A face of the solid or a part of its surface.
struct MeshSet
{
  std::string name;
  vtkIdType id;
  std::vector<MeshSide> sides;
  std::vector<vtkIdType> nodes; ///< from 0 on, ascending
};

struct MeshVolume
{
  std::string name;
  vtkIdType id;
  std::vector<vtkIdType> hexes; ///< from 0 on, ascending
};

/// Nodes and hexahedra are numbered from 0 on, one below their ids in a file.
struct MeshSets
{
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  std::vector<vtkIdType> cells; ///< of the grid, by hexahedron
  std::vector<MeshVolume> volumes;
  std::vector<MeshSet> faces; ///< sets of faces of the solid; no two share a side
  std::vector<MeshSet> parts; ///< source, target, sides

  vtkIdType hexCount() const { return static_cast<vtkIdType>(this->cells.size()); }
  vtkIdType nodeCount() const;
  std::array<double, 3> node(vtkIdType node) const;
  std::array<vtkIdType, 8> hex(vtkIdType hex) const;
  /// Facing outward.
  std::array<vtkIdType, 4> quad(const MeshSide& side) const;

  /// Faces, then parts.
  std::vector<const MeshSet*> sets() const;
};

/// @throw InvalidInput where it is not the output of vtkSweepSets, or empty.
MeshSets meshSets(vtkDataObject* input);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The hexahedra of any data set, read from several threads. Private to the module.
 */
#ifndef HexSweepHexReader_h
#define HexSweepHexReader_h

#include "Core/Hexahedra/HexCertificate.h"

#include <vtkSMPThreadLocalObject.h>
#include <vtkType.h>

class vtkCellArray;
class vtkDataSet;
class vtkIdList;

namespace hexsweep
{
/**
 * Reads the corners of hexahedra and voxels: straight from the arrays where these hold ids and
 * coordinates as usual, through the interface of the data set otherwise.
 */
class HexReader
{
public:
  /// @param data must have cells; not to be changed while it is read.
  explicit HexReader(vtkDataSet* data);

  /// Whether this is a VTK_HEXAHEDRON or VTK_VOXEL.
  bool isHex(vtkIdType cell) const;

  /// The corners in VTK_HEXAHEDRON order. @param cell isHex().
  HexCorners corners(vtkIdType cell);

private:
  Eigen::RowVector3d point(vtkIdType id) const;

  vtkDataSet* Data;
  vtkCellArray* Cells = nullptr;
  const double* Doubles = nullptr;
  const float* Floats = nullptr;
  vtkSMPThreadLocalObject<vtkIdList> Ids;
};
}

#endif

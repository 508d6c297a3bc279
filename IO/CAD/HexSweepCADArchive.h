// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A solid's true geometry in field data, and back. Private to the module.
 */
#ifndef HexSweepCADArchive_h
#define HexSweepCADArchive_h

#include "HexSweepCADGeometry.h"
#include "vtkModelGeometry.h"

#include <string>

class vtkDataObject;
class vtkFieldData;

namespace hexsweep
{
/// Where a solid came from, for geometries that are not written themselves.
struct CADOrigin
{
  std::string file;
  std::string checksum;
  std::string settings;
  Index solid = 0;
};

/// The solid in the kernel's binary format, without triangles.
std::string binaryOf(const NumberedSolid& solid);

/// @param binary see binaryOf(); empty: `origin` is written in its place.
void writeGeometry(
  const NumberedSolid& solid, const std::string& binary, const CADOrigin& origin, vtkFieldData* to);

/// As vtkModelGeometry::Restorer.
vtkModelGeometry::Geometry restoreGeometry(vtkDataObject* data, std::string& problem);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The solid on an input port: one data set, or a collection with a solid a data set. Private
 * to the module.
 */
#ifndef HexSweepSolidPort_h
#define HexSweepSolidPort_h

#include "HexSweepBodies.h"
#include "vtkModelGeometry.h"

#include <vtkSmartPointer.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkFieldData;
class vtkInformation;
class vtkInformationVector;

namespace hexsweep
{
struct SolidPort
{
  /// All solids; of several, each has the `VolumeId` that is its number in the collection, from 1
  /// on, and the field array `VolumeNames` has their names by that. nullptr: none.
  vtkSmartPointer<vtkDataSet> data;
  /// By volume id; of a single solid by 0.
  std::map<Index, vtkModelGeometry::Geometry> geometries;
  std::vector<std::string> problems; ///< why a geometry that comes along cannot be had
};

/// Declares that a port takes surfaces, volume meshes and collections of them.
void acceptSolids(vtkInformation* portInformation);

/// @param withGeometry whether the true surfaces are wanted.
SolidPort readSolidPort(vtkInformationVector** inputs, int port, bool withGeometry);

/// The same of data; nullptr: none.
SolidPort readSolids(vtkDataObject* given, bool withGeometry);

/// Hands on the field data of a solid that are for a mesh too: the geometry is the solid's alone.
void passSolidFields(vtkDataSet* solid, vtkFieldData* fields);

/**
 * Gives bodies their true surfaces.
 *
 * @param tell takes what the user should know: which geometry cannot be used and why.
 */
void attachGeometry(const SolidPort& port, const std::function<void(const std::string&)>& tell,
  std::vector<ReadBody>& bodies);
}

#endif

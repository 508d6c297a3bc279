// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From a cage to the grid of hexahedra that filters put out. Private to the module.
 */
#ifndef HexSweepHexOutput_h
#define HexSweepHexOutput_h

#include "Core/Geometry/Reflection.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Interior/SweepInterior.h"
#include "HexSweepInteriorReport.h"

#include <string>
#include <vector>

class vtkDataSet;
class vtkUnstructuredGrid;

namespace hexsweep
{
/// An interior to go on with.
struct BegunInterior
{
  const Points* points = nullptr; ///< see SweepInterior; nullptr: there is none
  std::string method;             ///< the same
};

struct HexOutputSettings
{
  int method = 0; ///< a vtkCageHexInterior::MethodType
  bool ensureValid = true;
  bool improveQuality = true;
  bool certify = true;
  bool failIfInvalid = false;
  bool isTrial = false;  ///< to be compared: polished a little, though nothing is untangled
  int precision = 0;     ///< a vtkAlgorithm::DesiredOutputPrecision
  BegunInterior begun;   ///< counts in place of a method
  Reflection reflection; ///< of the cage, undone in the output
};

/// Where the attributes of a cage's points and quads come from.
struct SourceAttributes
{
  vtkDataSet* data = nullptr;  ///< carried to every layer; nullptr: there are none
  std::vector<Index> pointIds; ///< of `data`, one a source point of the cage
  std::vector<Index> cellIds;  ///< of `data`, one a source quad of the cage
};

struct HexOutput
{
  bool sourceIsBottom = true;        ///< see SweepInterior; of the output
  std::vector<std::string> warnings; ///< what to tell the user
};

/// How writeHexes() fills a cage.
std::vector<InteriorStart> startsOf(const SweepCage& cage, const HexOutputSettings& settings);
InteriorOptions interiorOptions(const HexOutputSettings& settings, const Progress& progress);

/**
 * Fills a cage and writes points, hexahedra, their attributes, quality and report. Messages have
 * places of the cage.
 *
 * @param stages is told of every stage but the last one, the output.
 * @throw InvalidInput for a method that does not exist, and for bad hexahedra with failIfInvalid.
 */
HexOutput writeHexes(const SweepCage& cage, const SourceAttributes& source,
  const HexOutputSettings& settings, StageClock& stages, const Progress& progress,
  vtkUnstructuredGrid* output);

/// Writes hexahedra between layers of points that are known, without quality.
/// @param points (L + 1) n x 3, see sweptHexes().
void writeSweptGrid(const PointsRef& points, const SweepCage& cage, const SourceAttributes& source,
  int precision, const Progress& progress, vtkUnstructuredGrid* output);
}

#endif

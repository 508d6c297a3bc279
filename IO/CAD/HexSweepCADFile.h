// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reads the solids of a CAD file. Private to the module.
 */
#ifndef HexSweepCADFile_h
#define HexSweepCADFile_h

#include "HexSweepCADModel.h"

#include <string>

namespace hexsweep
{
enum class CADFormat
{
  STEP,
  IGES,
  BREP
};

/// By the name's extension: .step .stp, .iges .igs, .brep .brp, in any case.
/// @return nothing for others.
std::optional<CADFormat> cadFormatOf(const std::string& fileName);

struct CADFileOptions
{
  /// "millimetre" and so on, see cadLengthUnits(); empty: that of the file.
  std::string lengthUnit;
  bool heal = false; ///< repair shapes (ShapeFix)
};

/// The names of units that coordinates can be had in.
const std::vector<std::string>& cadLengthUnits();

/**
 * Reads a file: its solids where they are in their assemblies, their names and colours.
 *
 * Surfaces that bound a closed volume together become a solid where the file has no solids (as
 * those of IGES). What else is no solid is listed in CADModel::leftOut. Nothing is numbered yet.
 *
 * @throw InvalidInput when the file cannot be read, is damaged, or has no solid: what it has
 *        instead; Aborted. The kernel cannot be stopped while it parses.
 */
CADModel readCADFile(
  const std::string& fileName, const CADFileOptions& options, const Progress& progress = {});
}

#endif

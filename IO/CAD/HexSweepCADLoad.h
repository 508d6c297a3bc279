// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A CAD file from disk to numbered solids, by settings that can be written down. Private to
 * the module.
 */
#ifndef HexSweepCADLoad_h
#define HexSweepCADLoad_h

#include "HexSweepCADGeometry.h"
#include "HexSweepCADModel.h"

#include <string>

namespace hexsweep
{
struct CADSettings
{
  std::string lengthUnit; ///< see CADFileOptions
  bool imprint = true;
  double imprintTolerance = 1e-6;
  bool heal = false;
};

/// In one line, every bit of it.
std::string writtenSettings(const CADSettings& settings);

/// @throw InvalidInput for text that is none of the above.
CADSettings settingsFrom(const std::string& text);

/// Reads, repairs, imprints, numbers. @throw as readCADFile().
CADModel loadCADModel(
  const std::string& fileName, const CADSettings& settings, const Progress& progress = {});

/// Ids of the faces and edges of one solid.
NumberedSolid numberedSolid(const CADModel& model, std::size_t solid);

/// Of a file's content, as text. @throw InvalidInput when it cannot be read.
std::string checksumOf(const std::string& fileName);
}

#endif

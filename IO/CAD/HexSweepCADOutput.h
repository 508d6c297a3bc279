// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The solids of a CAD model as data sets. Private to the module.
 */
#ifndef HexSweepCADOutput_h
#define HexSweepCADOutput_h

#include "HexSweepCADModel.h"

#include <string>

class vtkPartitionedDataSetCollection;

namespace hexsweep
{
struct CADOutputSettings
{
  std::string file;        ///< that the model was read from
  std::string settings;    ///< see writtenSettings()
  double deflection = 0.0; ///< see divideShape()
  double angle = 0.0;
  bool structureOnly = false; ///< data sets without points
};

/**
 * Writes the outputs of vtkCADReader.
 *
 * @param model complaints are added to it: faces that could not be divided.
 * @throw Aborted.
 */
void writeCADModel(CADModel& model, const CADOutputSettings& settings, const Progress& progress,
  vtkPartitionedDataSetCollection* solids, vtkPartitionedDataSetCollection* edges);
}

#endif

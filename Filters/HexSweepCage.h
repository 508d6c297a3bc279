// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The inputs of vtkCageHexInterior, read and checked against each other. Private to the
 * module.
 */
#ifndef HexSweepCage_h
#define HexSweepCage_h

#include "Core/Interior/SweepInterior.h"

#include <vector>

class vtkDataSet;

namespace hexsweep
{
struct CageInput : SweepCage
{
  /// Input cell that each source quad came from.
  std::vector<Index> sourceCellIds;
};

/**
 * @param matchTolerance see traceLinkingRings().
 * @throw InvalidInput for inputs that are missing, are no caps, do not fit together or collapse;
 *        Aborted.
 */
CageInput readCage(vtkDataSet* sourceQuads, vtkDataSet* targetQuads, vtkDataSet* linkingSides,
  double matchTolerance, const Progress& progress = {});
}

#endif

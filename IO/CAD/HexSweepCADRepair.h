// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes the solids of a CAD file fit for work, or says what is wrong with them. Private to
 * the module.
 */
#ifndef HexSweepCADRepair_h
#define HexSweepCADRepair_h

#include "Core/Common/Mesh.h"
#include "HexSweepCADModel.h"

namespace hexsweep
{
/// "a", "a and b", "a, b and c"; of many the first ones.
std::string listWords(const std::vector<std::string>& words);

/**
 * Sews sheets into solids where there are no solids, repairs solids where this is asked for, and
 * complains of those that are not sound.
 *
 * @param heal ShapeFix_Shape; what it changed is among the complaints.
 * @throw Aborted.
 */
void repairSolids(CADModel& model, bool heal, const Progress& progress = {});
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Solids that touch are made to share faces and edges. Private to the module.
 */
#ifndef HexSweepCADImprint_h
#define HexSweepCADImprint_h

#include "HexSweepCADModel.h"

namespace hexsweep
{
/**
 * The general fuse of each group of solids that can touch: where two touch, their faces are divided
 * along each other's borders and become one. Names and colours go on to the pieces of a face.
 *
 * Where solids overlap, or the kernel fails, the solids of the group stay as they are and a
 * complaint says so.
 *
 * @param tolerance of the size of the model: what is nearer touches.
 * @throw Aborted.
 */
void imprintAndMerge(CADModel& model, double tolerance, const Progress& progress = {});
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Caps that cross themselves cannot be swept: found before the work.
 */
#ifndef hexsweep_CapCrossings_h
#define hexsweep_CapCrossings_h

#include "Core/Solids/SolidSurface.h"

#include <string>

namespace hexsweep
{
/**
 * @param triangles rows of the solid's triangles that form the cap.
 * @param name      for the message, e.g. "source cap".
 * @throw InvalidInput naming the two cells and the place where the cap goes through itself, as it
 *        does where its loops cross (findCrossing()), or is folded onto itself (findFold()).
 */
void checkCapCrossings(
  const SolidSurface& solid, const std::vector<Index>& triangles, const std::string& name);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkCageHexInterior's methods by number. Private to the module.
 */
#ifndef HexSweepMethods_h
#define HexSweepMethods_h

#include "Core/Interior/SweepInterior.h"

namespace hexsweep
{
/**
 * The starts of the cascade that a vtkCageHexInterior::MethodType stands for.
 *
 * @throw InvalidInput for a number that is no method's.
 */
std::vector<InteriorStart> interiorStarts(int method);
}

#endif

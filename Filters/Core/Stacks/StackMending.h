// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Certifies the hexahedra of a stack, and moves inner nodes where that helps.
 */
#ifndef hexsweep_StackMending_h
#define hexsweep_StackMending_h

#include "Core/Common/ParallelFor.h"
#include "Core/Hexahedra/HexQuality.h"

#include <string>

namespace hexsweep
{
struct StackMendingOptions
{
  bool ensureValid = true;    ///< untangle what is not certified
  bool improveQuality = true; ///< raise low scaled Jacobians up to 0.4
  ParallelFor parallelFor;
};

struct MendedStack
{
  Points points;
  std::vector<HexQuality> qualities; ///< of the hexahedra, certified
  std::string method;                ///< " + untangling", ...; empty: nothing was to be done
};

/// @param fixed one a point: those that stay. @throw Aborted.
MendedStack mendStack(Points points, const HexesRef& hexes, const std::vector<bool>& fixed,
  const StackMendingOptions& options, const Progress& progress = {});
}

#endif

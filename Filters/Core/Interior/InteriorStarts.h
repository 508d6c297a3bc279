// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The methods for the interior by name, as starts of sweepInterior().
 */
#ifndef hexsweep_InteriorStarts_h
#define hexsweep_InteriorStarts_h

#include "Core/Interior/SweepInterior.h"

#include <string>
#include <vector>

namespace hexsweep
{
/// The numbers are those of the filters' property Method. A method is added here and to the table
/// in the .cxx, with the same name; Documentation/Architecture.md, "Where to add", has all other
/// places.
enum class InteriorKind : int
{
  Automatic = 0, ///< Blend or a rival of it where caps bulge apart; then LayerMarch
  Blend = 1,
  HarmonicCoordinates = 2,
  MeanValueCoordinates = 3,
  GreenCoordinates = 4,
  LayerMarch = 5,
  AffineBoundaryError = 6
};

/// The names of the methods, by number.
std::vector<std::string> interiorMethodNames();

/// @param isRuled whether the cage is (SweepCage::isRuled): Automatic begins with its straight
/// lines.
/// @param winding how far loops turn (windingOf()): Automatic ends with sectionInterior() where
/// they turn by more than 30 degrees, and begins with it beyond 135, where the others fold.
/// @throw InvalidInput for a number that is no method's.
std::vector<InteriorStart> interiorStarts(
  InteriorKind kind, bool isRuled = false, double winding = 0.0);
}

#endif

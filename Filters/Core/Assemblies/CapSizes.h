// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Lengths of edges on caps: shorter ones where a cap's face runs out into a tip.
 */
#ifndef hexsweep_CapSizes_h
#define hexsweep_CapSizes_h

#include "Core/Assemblies/AssemblyPlan.h"

#include <map>

namespace hexsweep
{
/**
 * The length of edges for a face: `size`, but for a face that is narrower and has a corner of less
 * than 60 degrees its mean width, at least a tenth of `size`. There quads with edges of `size`
 * along the borders have no room.
 */
double capSize(const AssemblyComplex& complex, Index face, double size);

/// The same by curve, of all that faces of caps have: the least of their sizes.
std::map<Index, double> capCurveSizes(
  const AssemblyComplex& complex, const AssemblyPlan& plan, double size);
}

#endif

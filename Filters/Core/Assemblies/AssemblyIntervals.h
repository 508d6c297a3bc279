// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The number of edges on each curve of an assembly, from sizes and from what sweeps ask.
 */
#ifndef hexsweep_AssemblyIntervals_h
#define hexsweep_AssemblyIntervals_h

#include "Core/Assemblies/AssemblyPlan.h"

#include <array>

namespace hexsweep
{
struct AssemblyIntervals
{
  std::vector<Index> curves;     ///< edges, one a curve
  std::vector<Index> tubeLayers; ///< one a face: layers of a side face that is a tube; else 0
  /// One a face: rows left of, and layers below, the patch inside it; else 0.
  std::vector<std::array<Index, 2>> inside;
  std::vector<Index> layers; ///< one a volume
};

/**
 * Opposite chains of side faces have as many edges; all ways from the source to the target cap of a
 * volume have as many layers; curves round caps have even numbers, because quads of caps come from
 * triangles by halving their edges.
 *
 * @param size   wanted length of edges, > 0.
 * @param layers one a volume: how many it is to have; 0: by size.
 * @throw InvalidInput as solveIntervals(), with the faces and volumes that contradict each other.
 */
AssemblyIntervals assemblyIntervals(const AssemblyComplex& complex, const AssemblyPlan& plan,
  double size, const std::vector<Index>& layers);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Volumes that overlap, lie in one another, are there twice, or almost touch.
 */
#ifndef hexsweep_AssemblyChecks_h
#define hexsweep_AssemblyChecks_h

#include "Core/Assemblies/AssemblyComplex.h"

#include <string>

namespace hexsweep
{
/**
 * What is wrong with how volumes lie, a sentence a pair of volumes: they go through each other or
 * lie upon each other without sharing the face; one lies in the other; they are the same; or a gap
 * between them is less than a thousandth of the smaller one.
 *
 * Costs O(n log n) for the triangles, and a comparison of boxes for each pair of volumes.
 *
 * @param solids one a volume. @param names the same, for the sentences.
 */
std::vector<std::string> describeNeighbours(const AssemblyComplex& complex,
  const std::vector<const SolidSurface*>& solids, const std::vector<std::string>& names);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Quads of the plane across a sweep, with edges along all borders of its caps.
 */
#ifndef hexsweep_StackPlaneMesh_h
#define hexsweep_StackPlaneMesh_h

#include "Core/Common/ParallelFor.h"
#include "Core/Stacks/StackSheets.h"

namespace hexsweep
{
struct StackPlaneMesh
{
  StackPlane plane;
  std::vector<bool> onBorder; ///< one a node
  std::vector<bool> corner;   ///< one a node: where three faces of the solid meet, or borders cross
  Index inverted = 0;         ///< quads
  double least = 0.0;         ///< scaled Jacobian of the quads
};

/// A size for the quads where none is asked for: see defaultQuadSize(), for the borders inside too.
double defaultStackSize(const StackArrangement& arrangement);

/**
 * @param size, chordTolerance see CapQuadOptions.
 * @throw InvalidInput as meshCapWithQuads(); Aborted.
 */
StackPlaneMesh meshStackPlane(const StackArrangement& arrangement, double size,
  double chordTolerance, const ParallelFor& parallelFor = {}, const Progress& progress = {});
}

#endif

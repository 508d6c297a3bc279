// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sweeps of bodies with several caps, from the facets to grids. Private to the module.
 */
#ifndef HexSweepStackSweep_h
#define HexSweepStackSweep_h

#include "Core/Stacks/CapLikeFaces.h"
#include "Core/Stacks/RevolvedSpace.h"
#include "HexSweepAppend.h"
#include "HexSweepSolidSweep.h"

#include <optional>
#include <string>
#include <vector>

namespace hexsweep
{
/// A way to sweep a body between several caps.
struct StackWay
{
  CapLikeFaces faces;                     ///< of the body, or of `revolved`
  std::optional<RevolutionAxis> revolved; ///< the sweep goes round this
};

/**
 * How a body is to be swept between several caps.
 *
 * @return nothing where the body has one source cap and one target cap along some direction, or
 *         none along which (nor an axis round which) all faces are caps and sides, and neither is
 *         given.
 * @throw InvalidInput where a direction or an axis is given and faces are in its way.
 */
std::optional<StackWay> severalCaps(const ReadBody& body, const StackSweepSettings& settings);

/// The way between one cap and one other along a straight direction, where the body has one:
/// another way to make the mesh that vtkOneToOneSweep makes.
std::optional<StackWay> plainWay(const ReadBody& body, const StackSweepSettings& settings);

/// What is in the way of a sweep between several caps, in words, with faces; empty: nothing.
std::string whyNoSeveralCaps(const ReadBody& body, const StackSweepSettings& settings);

/**
 * Meshes a body between several caps. Field data of the solid and the report come with the grids,
 * which lie where the body was given; messages lie where it was put.
 *
 * @return what to tell the user.
 * @throw InvalidInput as sweepStack(), and for bad hexahedra with failIfInvalid; Aborted.
 */
std::vector<std::string> sweepSeveralCaps(const SolidToSweep& solid, const StackWay& way,
  const SolidSweepSettings& settings, StageClock& stages, const Progress& progress, BodyMesh& mesh);
}

#endif

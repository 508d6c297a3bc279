// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The best of several sweeps of one body, by meshes. Private to the module.
 */
#ifndef HexSweepBestSweep_h
#define HexSweepBestSweep_h

#include "Core/Solids/SweepChoice.h"
#include "HexSweepAppend.h"
#include "HexSweepSolidSweep.h"

#include <functional>
#include <string>
#include <vector>

namespace hexsweep
{
/// A sweep whose least scaled Jacobian is below this is not the last word.
constexpr double LowScaledJacobian = 0.2;

/// Hexahedra that are not certified; where nobody asked for certificates, those that are inverted
/// or degenerate.
double badHexes(const BodyMesh& mesh);
/// The least scaled Jacobian.
double leastOf(const BodyMesh& mesh);
/// Whether fewer hexahedra are bad, or as many and the scaled Jacobians are higher.
bool isBetter(const BodyMesh& mesh, const BodyMesh& other);

/// Of a mesh that tells what a sweep is worth: as fine as asked for up to some thousand hexahedra.
SolidSweepSettings roughSettings(
  const SolidSurface& surface, const SweepTopology& topology, const SolidSweepSettings& settings);

using Sweep = std::function<SolidSweepResult(const SweepTopology& topology, BodyMesh& mesh)>;

/**
 * Tries one sweep after the other until one gives a valid mesh; where its least scaled Jacobian is
 * low, those that may have a higher one as well. The best is taken.
 *
 * @return what to tell the user.
 * @throw InvalidInput when none gives a mesh.
 */
std::vector<std::string> bestOfSweeps(const SolidSurface& surface, const SweepChoice& choice,
  const Sweep& sweep, const Sweep& roughly, BodyMesh& best);
}

#endif

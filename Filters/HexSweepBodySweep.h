// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief All bodies of a solid, each with the sweep that was named or suits it best. Private to the
 * module.
 */
#ifndef HexSweepBodySweep_h
#define HexSweepBodySweep_h

#include "HexSweepBodies.h"
#include "HexSweepSolidSweep.h"

#include <string>
#include <vector>

namespace hexsweep
{
/// Ids of faces as the user named them; of several bodies, each has its own among them.
struct NamedCaps
{
  std::vector<Index> sourceFaceIds; ///< empty: the sweep is found
  std::vector<Index> targetFaceIds; ///< empty: the target is found
};

struct BodiesToSweep
{
  vtkDataSet* data;
  vtkDataSet* sourceQuads; ///< nullptr: none are given
  const std::vector<ReadBody>& bodies;
};

/**
 * Sweeps body after body. Of the sweeps that are found for a body those that look best are meshed
 * roughly, and tried in the order of what these meshes are worth until all hexahedra are certified.
 *
 * @param stages is told of every stage.
 * @return what to tell the user.
 * @throw InvalidInput when a named face is on no body, when source quads are given and there are
 *        several bodies, and when a body cannot be swept, after all have been tried; Aborted.
 */
std::vector<std::string> sweepBodies(const BodiesToSweep& solid, const NamedCaps& named,
  const SolidSweepSettings& settings, StageClock& stages, const Progress& progress,
  vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary);
}

#endif

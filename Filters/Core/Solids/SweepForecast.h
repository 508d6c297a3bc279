// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What can be told of a sweep before any meshing: where its hexahedra cannot be good.
 */
#ifndef hexsweep_SweepForecast_h
#define hexsweep_SweepForecast_h

#include "Core/Solids/SolidSurface.h"
#include "Core/Solids/SweepTopology.h"

#include <string>

namespace hexsweep
{
struct SweepForecast
{
  // What to tell the user, with ids of faces and what to do; empty where all is well.
  std::string shoulder;
  std::string tangentRims;
};

/**
 * Shoulders, faces of the sides that run across the sweep all round, where they are so wide that
 * layers cannot follow them (see SweepMeasure::hasWideShoulder()); and borders between cap and side
 * where the two go on into each other (less than 15 degrees), so that hexahedra there have no
 * corner.
 *
 * Costs O(n log n).
 */
SweepForecast forecastSweep(const SolidSurface& solid, const SweepTopology& topology);
}

#endif

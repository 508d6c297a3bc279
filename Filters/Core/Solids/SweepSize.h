// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How thick the layers of a sweep are to be where nobody says so.
 */
#ifndef hexsweep_SweepSize_h
#define hexsweep_SweepSize_h

#include "Core/Linking/LinkingSides.h"
#include "Core/Solids/SweepTopology.h"

namespace hexsweep
{
/// Hexahedra that a sweep may have where nobody asks for a size.
constexpr Index MostChosenHexes = 250000;

/// Length of the sides from source to target: their area over the mean length of their loops.
double sideLength(const SolidSurface& solid, const SweepTopology& topology);
/// The same over the length of their source loops.
double sideLength(const std::vector<SideTube>& sides);

/// Edge of a square with the mean area of the quads, cut into triangles.
double meanQuadWidth(const QuadMesh& quads);

/// Edge of the hexahedra on their mean way: meanQuadWidth() where source and target are of one
/// area, else the mean of that and its share on the target.
double meanHexWidth(
  const SolidSurface& solid, const SweepTopology& topology, const QuadMesh& sourceQuads);

/// How many quads of one edge length fit on the source cap.
double expectedQuads(const SolidSurface& solid, const SweepTopology& topology, double size);

/**
 * Refuses layers that give more hexahedra than there is memory for, before anything is made of
 * them; see checkHexBudget().
 *
 * @param quads of the cap. @param length of the sides.
 * @param size  of layers where `layers` has none of its own and no number; > 0.
 */
void checkSweepBudget(double quads, double length, double size, const LayerRequest& layers);

/**
 * By how much quads and layers must be longer to stay within a number of hexahedra.
 *
 * @param length of the sides. @param quads how many. @param width of the quads, and height of the
 *        layers.
 * @return 1 where quads times layers (at least one) are no more than `most`, else > 1.
 */
double coarseningFor(double length, Index quads, double width, Index most = MostChosenHexes);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the layers of a sweep lie along its columns.
 *
 * All fractions are of a column's arc length: 0 at the source cap, 1 at the target cap.
 */
#ifndef hexsweep_LayerSpacing_h
#define hexsweep_LayerSpacing_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/**
 * Layers whose thickness grows in a geometric series.
 *
 * @param layers >= 1.
 * @param growth thickness of each layer over that of the one before it, > 0; 1 makes all alike.
 * @param bothEnds the series runs from both caps to the middle, so that layers at both caps are
 *        thin (growth > 1) or thick (growth < 1).
 * @return layers + 1 strictly rising values, the first 0, the last 1.
 * @throw InvalidInput on numbers out of range, or a growth so strong that a layer has no thickness
 *        in double precision.
 */
std::vector<double> layerFractions(Index layers, double growth = 1.0, bool bothEnds = false);

/**
 * Layers between given positions.
 *
 * @param positions strictly rising in (0, 1).
 * @return the same between 0 and 1.
 * @throw InvalidInput naming the first position that is out of order or out of range.
 */
std::vector<double> layerFractions(const std::vector<double>& positions);

/**
 * The number of layers whose mean thickness is nearest to a wanted one, at least 1.
 *
 * @param length of the columns, > 0. @param size > 0, in the same unit.
 * @throw InvalidInput on a size that is not positive, or would make more than a million layers.
 */
Index layersOfSize(double length, double size);

/// @param values at evenly spaced places from 0 to 1, two or more. @param place in [0, 1].
/// @return the value there, linearly between them.
double evenlySampled(const std::vector<double>& values, double place);
}

#endif

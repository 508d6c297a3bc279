// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Coordinates that can be computed with.
 */
#ifndef hexsweep_CoordinateRange_h
#define hexsweep_CoordinateRange_h

#include "Core/Common/Mesh.h"

#include <string>

namespace hexsweep
{
/// Lengths up to here, and down to its inverse: products of six of them, such as squared volumes,
/// are normal numbers.
constexpr double GreatestLength = 1e50;

/// A mesh is larger than so much of its coordinates: of its size some four thousand places can be
/// told apart then.
constexpr double LeastOfCoordinates = 1e-12;

/**
 * Refuses coordinates with which lengths, areas or volumes cannot be computed: those that are not
 * finite or greater than GreatestLength, and meshes that are smaller than its inverse or than
 * LeastOfCoordinates of their coordinates.
 *
 * @param faces whose corners are looked at, all of them rows of `points`; other points may be
 * anything.
 * @param what  name for the error text, e.g. "target surface".
 * @throw InvalidInput naming what is wrong and where.
 */
void checkCoordinates(const PointsRef& points, const FacesRef& faces, const std::string& what);

/// The same with the corners one after the other.
void checkCoordinates(
  const PointsRef& points, const std::vector<Index>& corners, const std::string& what);

/// @throw InvalidInput where a finite coordinate would become infinite in single precision.
void checkFitsSinglePrecision(const PointsRef& points);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A round bar whose holes turn about each other on the way, and what a path in it winds.
 */
#ifndef WindingSweeps_h
#define WindingSweeps_h

#include "Support/CapMeshes.h"
#include "Support/SweepMeshes.h"

namespace test
{
enum class Holes
{
  One, ///< a square one in the middle
  Two  ///< square ones on either side of it
};

struct WindingShape
{
  Holes holes = Holes::Two;
  double degrees =
    180.0;        ///< of the holes about the middle of the bar; a multiple of 360 / (4 cells)
  int cells = 18; ///< across the square in the middle of the disk; a multiple of 6
  int layers = 24;
  double height = 2.0; ///< the radius being 1
  double bend = 0.0;   ///< angle of the arc that the bar follows, in radians
  double bulge = 0.0;  ///< height of both caps in their middle
};

/// The rim stays, the holes turn as a whole; layers hold the loop nodes at their true places, the
/// others where the whole disk would have turned.
struct WindingSweep
{
  Sweep sweep;
  /// The source cap turned as a whole: the same set of points as the true target cap, and the
  /// rim's nodes on each other.
  TriangleMesh target;
};

WindingSweep windingSweep(const WindingShape& shape);

/**
 * By how much edges from the rim to each hole turn about the middle of the bar, beyond what they do
 * in `from`: along a path of quad edges, in radians.
 *
 * @param from, to n x 2, the same quads in the plane about the middle.
 */
std::vector<double> turnOfPaths(const Quads& quads, const PlanePoints& from, const PlanePoints& to);
}

#endif

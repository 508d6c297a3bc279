// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What interior methods are held to: a contract for all, exactness for those that have it.
 */
#ifndef InteriorTests_h
#define InteriorTests_h

#include "Core/Interior/SweepCage.h"
#include "Core/Linking/LinkingRings.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "Support/SweepMeshes.h"

#include <gtest/gtest.h>

namespace test
{
using InteriorFill = Points (*)(
  const hexsweep::SweepCage&, const hexsweep::Progress&, const hexsweep::ParallelFor&);

hexsweep::SweepBoundary boundaryOf(const Sweep& sweep);

hexsweep::SweepCage cageOf(const Sweep& sweep);

Points run(InteriorFill interior, const Sweep& sweep);

/// Diagonal of the sweep's box.
double sizeOf(const Sweep& sweep);

/// A regular grid of cubes with edges 2 / nx = 1 / ny; needs nx = 2 ny < 20 and L = layers.
Motion cubesMotion(int nx, int layers);

/// What every method keeps to: boundary bit for bit, points that no quad uses on straight lines,
/// the same bits in any order of the work, progress that rises, aborts, no interior at all.
/// @param rounding how far points that no quad uses may move the others.
void expectInteriorContract(InteriorFill interior, double rounding = 0.0);

/// For methods that follow rings which turn. A planar cap, turned, sheared and stretched along an
/// arc, with even and graded layers.
void expectAffineSweepsExact(InteriorFill interior);

void expectAnySizeAnywhere(InteriorFill interior);

/// A curved cap that is turned and scaled as a whole.
void expectSimilaritySweepOfACurvedCapExact(InteriorFill interior);

/// Everything that bends: rings are no affine images of the loops.
Eigen::RowVector3d bendingMotion(double x, double y, double t);

void expectBoundaryBitForBit(InteriorFill interior);

/// Noise in the plane of the loops must not be blown up by a bulging cap.
void expectNearlyPlanarLoopsTame(InteriorFill interior);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Harmonic map to the unit disk with every hole filled by a fan (paper 3.1.2, step 1).
 */
#ifndef hexsweep_FilledDiskMap_h
#define hexsweep_FilledDiskMap_h

#include "Core/Geometry/Circle.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Solvers/SurfaceLaplacian.h"

namespace hexsweep
{
struct FilledDiskMap
{
  /// n x 2. Points that no triangle uses get the origin.
  PlanePoints disk;
  /// One circle a hole: where its fan's centre lies, and the radius of a circle of its area.
  std::vector<Circle> holes;
};

/**
 * Maps a cap to the unit disk: outer loop to given places, the rest harmonic.
 *
 * Each hole is closed by a fan of triangles about one new centre. The fan's shape is that of a
 * regular fan: a loop of this length wound round a circle; only its angles enter, so that a
 * crooked or folded hole gives positive weights too.
 *
 * @param laplacian of the cap without the fans, n x n (see surfaceLaplacian()).
 * @param loops     the outer one first, each with the surface on its left.
 * @param outer     places of the nodes of loops[0], usually on the unit circle (see circlePoints(),
 *                  arcLengthAngles()).
 * @param weights   that the matrix is made of.
 * @throw SolverFailure.
 */
FilledDiskMap filledDiskMap(const SparseMatrix& laplacian, const PointsRef& points,
  const std::vector<Loop>& loops, const PlanePointsRef& outer,
  Weights weights = Weights::Cotangent);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Interior nodes that follow the cage, node by node, by any cage method.
 */
#ifndef hexsweep_CageInterior_h
#define hexsweep_CageInterior_h

#include "Core/Interior/SweepCage.h"

#include <functional>

namespace hexsweep
{
/// Where a point inside the cage at rest goes when the cage is deformed. Called from any thread.
using CageMap = std::function<Eigen::RowVector3d(const Eigen::RowVector3d& point)>;

/// Binds to a cage at rest (v x 3 vertices, m x 3 triangles that face outwards), and takes its
/// deformed vertices (v x 3): steps 3 and 4 of section 4.2.
using CageMethod = std::function<CageMap(
  const PointsRef& rest, const PointsRef& deformed, const TrianglesRef& triangles)>;

/**
 * Places the nodes of a swept volume by the four steps of section 4.2 of Cai and Tautges
 * (\cite CaiTautges2013): topological model, shared triangulation of the boundary quads, binding of
 * each interior node of the topological model to its cage, interpolation with the cage of the
 * physical model.
 *
 * Visits every triangle of the cage for every interior node, in memory that does not depend on
 * the number of interior nodes but for the result and the model. The result does not depend on
 * the threads.
 *
 * Result and errors as InteriorMethod says.
 */
Points cageInterior(const SweepCage& cage, const CageMethod& method, const Progress& progress = {},
  const ParallelFor& parallelFor = {});
}

#endif

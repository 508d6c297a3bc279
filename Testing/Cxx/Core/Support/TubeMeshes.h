// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Linking sides meshed on tubes of known shape, and what is measured of them.
 */
#ifndef TubeMeshes_h
#define TubeMeshes_h

#include "Support/SideTubes.h"

#include "Core/Linking/LinkingSides.h"

namespace test
{
using hexsweep::LayerRequest;
using hexsweep::LinkingMesh;
using hexsweep::Loop;
using hexsweep::Points;

/// A box of 1 x 1 x 2 whose corner edges wind by a quarter turn, four faces.
Eigen::RowVector3d TwistedBox(double v, double u);

/// Nodes of the source loop, evenly spaced in v; `offset` in units of their distance.
Points ringOf(Index n, const TubePlace& place, double offset = 0.0);

/// The loop 0, 1, .., n - 1.
Loop numbers(Index n);

/// One side from one ring.
LinkingMesh meshTube(const SideTube& side, const Points& ring, const LayerRequest& request);

LayerRequest layerRequest(Index count);

/// Node j of ring k, of n nodes a ring.
Eigen::RowVector3d node(const LinkingMesh& mesh, Index n, Index k, Index j);

/// Least sine at a corner of a quad, about the mean normal of the quad.
double leastCorner(const LinkingMesh& mesh);

/// Of nodes from the triangles of a side.
double greatestDistance(const SideTube& side, const Points& nodes);
}

#endif

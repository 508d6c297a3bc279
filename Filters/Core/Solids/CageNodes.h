// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The nodes on the boundary of a solid's cage, and the faces that they lie on.
 */
#ifndef hexsweep_CageNodes_h
#define hexsweep_CageNodes_h

#include "Core/Solids/SolidCage.h"

#include <array>
#include <vector>

namespace hexsweep
{
/// A boundary quad on a face of the solid.
struct FacedQuad
{
  std::array<Index, 4> nodes; ///< rows of CageNodes::places
  Index faceId;
  bool isCap;
  Eigen::RowVector3d normal; ///< of its triangle; no unit vector
};

/// The boundary nodes of a cage, each once.
struct CageNodes
{
  std::vector<Index> points; ///< of the swept mesh, see SweepInterior::points
  Points places;
  std::vector<FacedQuad> quads;            ///< see boundaryQuads()
  std::vector<std::vector<Index>> quadsOf; ///< by node
};

CageNodes cageNodes(
  const SolidCage& cage, const SolidSurface& solid, const SweepTopology& topology);

/// Of the boundary quads' edges at a node.
double shortestEdge(const CageNodes& nodes, Index node);

/// Moves the boundary of a cage, which is gathered anew. @param places of its nodes.
/// @throw InvalidInput as gatherSweepBoundary().
void setPlaces(const CageNodes& nodes, const Points& places, SolidCage& cage);
}

#endif

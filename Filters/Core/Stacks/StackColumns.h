// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Hexahedra in columns over the quads of the plane, between the levels of a stack.
 */
#ifndef hexsweep_StackColumns_h
#define hexsweep_StackColumns_h

#include "Core/Stacks/StackSheets.h"

#include <array>
#include <map>
#include <utility>

namespace hexsweep
{
/// How many layers there are between two levels that follow each other.
using LayerCounts = std::map<std::pair<Index, Index>, Index>;

/**
 * Layers by size: as many between two levels as fit their mean distance, at least one.
 *
 * @param layerSize length, > 0; without effect where `layers` is not 0.
 * @param layers    sum over all pairs of levels from the lowest to the highest, shared out by
 *                  distance; 0: by size.
 */
LayerCounts countLayers(const StackPlane& plane, const StackLevels& levels,
  const StackSheets& sheets, double layerSize, Index layers = 0);

/// How many hexahedra makeColumns() will make.
double countHexes(const StackPlane& plane, const StackLevels& levels, const LayerCounts& layers);

/// A node of the columns: a part of the way between two levels over a node of the plane.
struct ColumnNode
{
  Index node;      ///< of the plane
  Index below;     ///< entry of StackSheets at the node
  Index above;     ///< the same for a node on a level
  double fraction; ///< of the way, 0 on `below`
};

/// An outer quad.
struct StackQuad
{
  std::array<Index, 4> points; ///< outward
  Index hex;
  int side;  ///< of the hexahedron: 0 to 3 over the edges of its quad, 4 the bottom, 5 the top
  Index cap; ///< place in CapLikeFaces::faces; -1: on a side
};

struct StackColumns
{
  std::vector<ColumnNode> nodes;
  Hexes hexes{ 0, 8 };
  std::vector<Index> quadOf;  ///< one a hexahedron: quad of the plane
  std::vector<Index> layerOf; ///< one a hexahedron: from the bottom of its column
  std::vector<StackQuad> boundary;
};

/// Columns over all quads. Each node is shared by all hexahedra that meet there.
StackColumns makeColumns(const StackPlane& plane, const StackArrangement& arrangement,
  const StackLevels& levels, const StackSheets& sheets, const LayerCounts& layers);

/// Places of the columns' nodes, in the frame. @param plane may have been moved since.
Points columnPoints(
  const StackPlane& plane, const StackSheets& sheets, const StackColumns& columns);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Pieces of a hexahedral mesh around chosen cells.
 */
#ifndef hexsweep_HexPatches_h
#define hexsweep_HexPatches_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// The hexahedra at each node, one row after the other.
class HexesAtNodes
{
public:
  /// @param hexes m x 8 ids in [0, numberOfPoints). @throw InvalidInput for 2^32 or more.
  HexesAtNodes(const HexesRef& hexes, Index numberOfPoints);

  /// Iterable: ids of the hexahedra with that node, rising.
  struct Range
  {
    const std::uint32_t* first;
    const std::uint32_t* last;
    const std::uint32_t* begin() const { return this->first; }
    const std::uint32_t* end() const { return this->last; }
  };
  Range operator[](Index node) const
  {
    return { this->Cells.data() + this->Begin[static_cast<std::size_t>(node)],
      this->Cells.data() + this->Begin[static_cast<std::size_t>(node) + 1] };
  }

private:
  std::vector<Index> Begin;
  std::vector<std::uint32_t> Cells; ///< eight a hexahedron: half the memory of a mesh otherwise
};

/// A piece of a mesh with node numbers of its own.
struct HexPatch
{
  std::vector<Index> cells; ///< numbers in the whole mesh, rising
  std::vector<Index> nodes; ///< rising
  Hexes hexes;              ///< in the piece's node numbers
  /// Nodes that may move: not fixed, and all of their hexahedra are in the piece.
  std::vector<bool> free;
};

/**
 * The cells with `rings` rings of neighbours (cells that share a node), in connected pieces:
 * pieces that touch are one.
 *
 * @param cells numbers of hexahedra.
 * @param fixed one entry a node of the mesh.
 */
std::vector<HexPatch> hexPatches(const HexesRef& hexes, const HexesAtNodes& atNodes,
  const std::vector<Index>& cells, int rings, const std::vector<bool>& fixed);
}

#endif

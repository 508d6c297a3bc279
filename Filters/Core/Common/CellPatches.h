// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Pieces of a mesh of quads or hexahedra around chosen cells.
 */
#ifndef hexsweep_CellPatches_h
#define hexsweep_CellPatches_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// The cells at each node, one row after the other.
class CellsAtNodes
{
public:
  /// @param mesh m x k ids in [0, numberOfPoints), a cell a row. @throw InvalidInput for 2^32 cells
  /// or more.
  CellsAtNodes(const FacesRef& mesh, Index numberOfPoints);

  /// Iterable: ids of the cells with that node, rising.
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
  /// Of hexahedra eight a cell: half the memory of a mesh otherwise.
  std::vector<std::uint32_t> Cells;
};

/// A piece of a mesh with node numbers of its own.
struct CellPatch
{
  std::vector<Index> cells; ///< numbers in the whole mesh, rising
  std::vector<Index> nodes; ///< rising
  Faces corners;            ///< of the cells, in the piece's node numbers
  /// Nodes that may move: not fixed, and all of their cells are in the piece.
  std::vector<bool> free;
};

/**
 * The cells with `rings` rings of neighbours (cells that share a node), in connected pieces:
 * pieces that touch are one.
 *
 * @param cells numbers of cells.
 * @param fixed one entry a node of the mesh.
 */
std::vector<CellPatch> cellPatches(const FacesRef& mesh, const CellsAtNodes& atNodes,
  const std::vector<Index>& cells, int rings, const std::vector<bool>& fixed);
}

#endif

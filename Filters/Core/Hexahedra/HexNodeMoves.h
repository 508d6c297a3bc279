// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Moves single nodes of a hexahedral mesh for the better of the hexahedra around them.
 */
#ifndef hexsweep_HexNodeMoves_h
#define hexsweep_HexNodeMoves_h

#include "Core/Common/CellPatches.h"
#include "Core/Common/ParallelFor.h"
#include "Core/Hexahedra/HexLoss.h"
#include "Core/Hexahedra/HexQuality.h"

namespace hexsweep
{
/// Whether hexahedra must keep theirs.
enum class Certificates
{
  Stay,
  MayGo
};

/**
 * A mesh, its qualities, and steps of single nodes that keep both in agreement.
 *
 * Nodes of one group share no hexahedron: they may be moved side by side, and the result does not
 * depend on their order.
 */
class HexNodeMoves
{
public:
  /// @param points must stay, and as they are. @param fixed n entries: nodes that stay.
  /// @throw Aborted when progress returns false.
  HexNodeMoves(const PointsRef& points, const HexesRef& hexes, const std::vector<bool>& fixed,
    const ParallelFor& parallelFor, const Progress& progress);
  /// @param verdicts of the hexahedra. @param enough nodes whose hexahedra all have a scaled
  ///        Jacobian of that are in no group.
  HexNodeMoves(const PointsRef& points, const HexesRef& hexes, const std::vector<bool>& fixed,
    std::vector<HexQuality> verdicts, double enough, const Progress& progress);

  /// The free nodes with a hexahedron.
  const std::vector<std::vector<Index>>& groups() const { return this->Groups; }
  /// See hexVerdicts() for the bounds.
  const std::vector<HexQuality>& qualities() const { return this->Qualities; }
  const HexesRef& hexes() const { return this->Cells; }
  const CellsAtNodes& atNodes() const { return this->AtNodes; }

  /// Least scaled Jacobian of the hexahedra at a node; 1 at the most.
  double leastAt(Index node) const;

  /// Asks for what a visit of a node reads first: meshes are larger than a processor's caches.
  void prefetch(Index node) const;

  struct Step
  {
    bool moved = false;
    /// Part by which the sum fell.
    double gain = 0.0;
  };

  /**
   * One Gauss-Newton step with backtracking down the sum over the corners at the node. It is taken
   * only if every hexahedron at the node that was Certified still is, unless certificates may go,
   * none has a scaled Jacobian below the floor, and no edge at the node is shorter than a quarter
   * of what it was at first: a scaled Jacobian says nothing about lengths, and hexahedra that are
   * low for the turn of their edges would be drawn together to a point.
   */
  Step move(
    Index node, const HexLoss& loss, double floor, Certificates certificates = Certificates::Stay);

  Points take() { return std::move(this->Places); }

private:
  class Visit;

  void color(const std::vector<bool>& fixed, double enough, const Progress& progress);

  PointsRef Start;
  Points Places;
  HexesRef Cells;
  CellsAtNodes AtNodes;
  std::vector<HexQuality> Qualities;
  std::vector<std::vector<Index>> Groups;
};
}

#endif

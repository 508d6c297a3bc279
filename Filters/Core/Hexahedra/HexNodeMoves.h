// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Moves single nodes of a hexahedral mesh for the better of the hexahedra around them.
 */
#ifndef hexsweep_HexNodeMoves_h
#define hexsweep_HexNodeMoves_h

#include "Core/Common/ParallelFor.h"
#include "Core/Common/CellPatches.h"
#include "Core/Hexahedra/HexQuality.h"

#include <optional>

namespace hexsweep
{
/// Whether hexahedra must keep theirs.
enum class Certificates
{
  Stay,
  MayGo
};

/// A falling convex function of a corner's scaled Jacobian.
struct HexLoss
{
  /// 0: (1 - x)^2. Else exp(sharpness (middle - x)), continued as a parabola below the middle.
  double sharpness = 0.0;
  double middle = 0.0;

  struct Place
  {
    double value;
    double slope;     ///< <= 0 for x <= 1
    double curvature; ///< >= 0
  };
  Place at(double scaledJacobian) const;
};

/// Sum, gradient and Gauss-Newton matrix of a loss with respect to one node.
struct HexNodeSum
{
  double value = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();

  /// Adds the corners of a hexahedron that depend on its corner `moving`.
  void add(const HexCorners& corners, int moving, const HexLoss& loss);
  /// What add() adds to the value.
  static double valueOf(const HexCorners& corners, int moving, const HexLoss& loss);
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
  /// @param fixed n entries: nodes that stay. @throw Aborted when progress returns false.
  HexNodeMoves(const PointsRef& points, const HexesRef& hexes, const std::vector<bool>& fixed,
    const ParallelFor& parallelFor, const Progress& progress);

  /// The free nodes with a hexahedron.
  const std::vector<std::vector<Index>>& groups() const { return this->Groups; }
  const std::vector<HexQuality>& qualities() const { return this->Qualities; }
  const HexesRef& hexes() const { return this->Cells; }
  const CellsAtNodes& atNodes() const { return this->AtNodes; }

  /// Least scaled Jacobian of the hexahedra at a node; 1 at the most.
  double leastAt(Index node) const;

  struct Step
  {
    bool moved = false;
    /// Part by which the sum fell.
    double gain = 0.0;
  };

  /**
   * One Gauss-Newton step with backtracking down the sum over the corners at the node. It is taken
   * only if every hexahedron at the node that was Certified still is, unless certificates may go,
   * and none has a scaled Jacobian below the floor.
   */
  Step move(
    Index node, const HexLoss& loss, double floor, Certificates certificates = Certificates::Stay);

  Points take() { return std::move(this->Places); }

private:
  void color(const std::vector<bool>& fixed, const Progress& progress);
  HexNodeSum sum(Index node, const HexLoss& loss) const;
  std::optional<double> accept(
    Index node, const HexLoss& loss, double floor, double greatestSum, Certificates certificates);

  Points Places;
  HexesRef Cells;
  CellsAtNodes AtNodes;
  std::vector<HexQuality> Qualities;
  std::vector<std::vector<Index>> Groups;
};
}

#endif

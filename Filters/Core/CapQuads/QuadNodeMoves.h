// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Moves single nodes of a cap's quads for the better of the corners around them.
 */
#ifndef hexsweep_QuadNodeMoves_h
#define hexsweep_QuadNodeMoves_h

#include "Core/CapQuads/CapCorners.h"
#include "Core/CapQuads/CornerTerms.h"

#include <array>

namespace hexsweep
{
/**
 * A falling convex function of a corner's scaled Jacobian x.
 *
 * A soft minimum, exp(sharpness (least - x)) and a parabola below `least`, or with sharpness 0 the
 * loss (1 - x)^2 with a logarithmic barrier at `least`.
 */
struct CornerLoss
{
  double sharpness = 0.0;
  double least = 0.0;

  CurvePoint at(double scaledJacobian) const;
};

/**
 * The corners of a mesh and steps of its single nodes over the surface.
 *
 * A step is one of Newton's, in the tangent plane at the node, down the sum of a loss over the
 * corners that the node is part of, with a little distortion() of the quads against rectangles of
 * the source's proportions. Nodes of one group share no quad: moved side by side they give the same
 * result as in any order.
 */
class QuadNodeMoves
{
public:
  /// Of distortion() in the sums. Less of it gives higher scaled Jacobians and long thin quads that
  /// twist the hexes on them.
  static constexpr double DistortionWeight = 0.05;

  /// @param points n x 3, on the surface, without inverted movable corners.
  /// @param source n x 3: proportions of the quads. @param cap must stay.
  QuadNodeMoves(const CapCorners& cap, const Points& points, const PointsRef& source);

  /// Begins anew from other points of the same mesh. All nodes are awake.
  void reset(const Points& points);

  /// What the corners are to gain.
  struct Losses
  {
    CornerLoss onSurface;
    std::vector<CornerLoss> atColumns; ///< one a column of the cap
    double floor;                      ///< scaled Jacobian that no corner at a moved node is below
  };

  /// A sweep over the nodes that are awake, on the threads of the corners. @return how many moved.
  Index sweep(const Losses& losses);

  /// Has the nodes with a corner below `enough` at them looked at again, lets the others sleep,
  /// even when a neighbour moves.
  void wake(double enough);

  /// Least scaled Jacobian of the corners that can move, 1 at the most.
  double least() const;

  const Points& points() const { return this->Places; }

private:
  struct Corner
  {
    Index node[3];
    Index column;
    Eigen::Vector3d normal; ///< of column, or of the surface at the node
    double wanted[2];       ///< inverse lengths of the edges
  };
  struct Arms;
  struct Sum
  {
    double value = 0.0;
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
    Eigen::Matrix2d curvature = Eigen::Matrix2d::Zero();
  };
  struct Incidence
  {
    Index corner;
    int role; ///< which of its nodes
  };
  using Frame = Eigen::Matrix<double, 2, 3>;

  void makeCorners(const PointsRef& source);
  void color();
  void sort();
  void add(const Incidence& incidence, const Frame& frame, const Losses& losses, Sum& sum) const;
  Arms armsOf(const Corner& corner) const;
  bool isWanting(std::size_t k) const;
  void wakeAround(const std::vector<Index>& moved);
  const Corner& cornerAt(Index i) const
  {
    return this
      ->Corners[static_cast<std::size_t>(this->Incidences[static_cast<std::size_t>(i)].corner)];
  }
  const CornerLoss& lossOf(const Corner& corner, const Losses& losses) const;
  double valueAt(Index node, const Eigen::RowVector3d& place, const Eigen::Vector3d& normal,
    const Losses& losses) const;
  bool move(Index node, const Losses& losses);

  const CapCorners& Cap;
  Points Places;
  std::vector<Corner> Corners;
  std::vector<std::array<double, 2>> InverseLengths; // of the source's edges at each corner
  std::vector<Index> FirstIncidence;                 // of each free node, by its number among them
  std::vector<Incidence> Incidences;
  std::vector<Index> FreeNumber; // of each node, or -1
  std::vector<Index> Triangle;   // last known of each free node
  std::vector<Eigen::Vector3d> Normals;
  std::vector<std::vector<Index>> Groups; // of numbers of free nodes
  std::vector<char> Awake;
  double Enough = 2.0;
};
}

#endif

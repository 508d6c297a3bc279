// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The corners of a quad mesh on a surface, and descent of sums over them.
 */
#ifndef hexsweep_CapCorners_h
#define hexsweep_CapCorners_h

#include "Core/Common/CellPatches.h"
#include "Core/Common/ParallelFor.h"
#include "Core/Geometry/SurfaceSearch.h"

#include <memory>

namespace hexsweep
{
/// A direction in which a hex leaves a boundary node of the cap.
struct ColumnDirection
{
  Index point;
  Eigen::RowVector3d direction; ///< any length but zero
};

/// Columns that lean so far over the surface that their corners may be beyond what quads can mend.
enum class LeaningColumns
{
  PassedOver,
  WhereUpright ///< at corners that are not turned over at the start
};

/// Corner of a quad: its node, the next one of the quad and the previous one.
struct QuadCorner
{
  Index node[3];
  Index quad;
  Index corner; ///< 0 to 3
  Index column; ///< number of the column direction that it is projected along, or -1: the surface
  bool movable; ///< one of the three nodes is free
};

/// Scaled Jacobian of a corner with edges a, b about a unit normal.
double cornerScaledJacobian(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& normal);

/// How good a mesh is: fewer inverted corners first, then the higher minimum. Corners whose three
/// nodes are fixed are what they are; they do not count here.
struct CornerQuality
{
  Index inverted = 0;      ///< movable corners <= 0 or without a value
  Index fixedInverted = 0; ///< those that are not movable: no inner node cures them
  double minimum = 1.0;    ///< least scaled Jacobian of the movable corners
  double mean = 0.0;       ///< over all quads, of the least corner of each

  bool betterThan(const CornerQuality& other) const
  {
    return inverted != other.inverted ? inverted < other.inverted : minimum > other.minimum;
  }
};

/// A mesh that was worked on.
struct ImprovedQuads
{
  Points points;
  CornerQuality quality;
  int rounds = 0; ///< descents
};

/**
 * All corners of a cap's quads, those at boundary nodes with a column twice: on the surface, and
 * as the corner of the hex on it sees them, along the column.
 */
class CapCorners
{
public:
  /**
   * @param quads   m x 4, consistently oriented.
   * @param fixed   n entries: nodes that stay.
   * @param surface consistently oriented, on either side.
   * @param start   n x 3: on or near the surface; decides which side of it is up.
   * @param parallelFor lends threads to all work over the corners; the bits do not depend on them.
   */
  CapCorners(const QuadsRef& quads, const std::vector<bool>& fixed,
    std::shared_ptr<const SurfaceSearch> surface, const std::vector<ColumnDirection>& columns,
    const PointsRef& start, LeaningColumns leaning = LeaningColumns::PassedOver,
    const ParallelFor& parallelFor = {});
  CapCorners(const QuadsRef& quads, const std::vector<bool>& fixed, const TriangleMesh& surface,
    const std::vector<ColumnDirection>& columns, const PointsRef& start,
    LeaningColumns leaning = LeaningColumns::PassedOver, const ParallelFor& parallelFor = {})
    : CapCorners(quads, fixed, std::make_shared<const SurfaceSearch>(surface), columns, start,
        leaning, parallelFor)
  {
  }

  /**
   * Those of some of the quads, in the patch's node numbers: on the same surface, with the same
   * side up and the same columns.
   */
  CapCorners(const CapCorners& whole, const CellPatch& patch, const ParallelFor& parallelFor = {});

  const std::vector<QuadCorner>& corners() const { return this->Corners; }
  const std::vector<Index>& freeNodes() const { return this->FreeNodes; }
  const Quads& quads() const { return this->CapQuads; }
  const ParallelFor& parallelFor() const { return this->Threads; }

  /// The points of the surface nearest to these, and its upward unit normals there.
  SurfacePlaces place(const PointsRef& points) const;
  /// The same of one point. @param start a triangle near it if one is known, or -1.
  SurfacePlace place(const Eigen::RowVector3d& point, Index start) const;
  /// The normals alone.
  Points normals(const PointsRef& points) const;

  /// The normal that a corner is measured against.
  Eigen::RowVector3d normal(const QuadCorner& corner, const PointsRef& normals) const
  {
    if (corner.column >= 0)
    {
      return this->ColumnNormals.row(corner.column);
    }
    return normals.row(corner.node[0]);
  }

  /// Sine of the angle between a column and the surface where it stands, in [0, 1].
  double columnHeight(Index column) const { return this->ColumnHeights[column]; }

  Index numberOfColumns() const { return this->ColumnHeights.size(); }

  CornerQuality measure(const PointsRef& points) const;

  /// Quads with a movable corner whose scaled Jacobian is not above the floor, rising.
  std::vector<Index> quadsBelow(double floor, const PointsRef& points) const;

private:
  double scaledJacobian(
    const QuadCorner& corner, const PointsRef& points, const PointsRef& normals) const;
  /// One a corner.
  std::vector<double> scaledJacobians(const PointsRef& points) const;
  /// @param normals n x 3, upward. @return the column of each node, or -1.
  std::vector<Index> setColumns(
    const std::vector<ColumnDirection>& columns, const PointsRef& normals);

  Quads CapQuads;
  std::shared_ptr<const SurfaceSearch> Surface;
  double Side = 1.0;
  std::vector<QuadCorner> Corners;
  std::vector<Index> FreeNodes;
  Points ColumnNormals;
  Eigen::VectorXd ColumnHeights;
  ParallelFor Threads;
};
}

#endif

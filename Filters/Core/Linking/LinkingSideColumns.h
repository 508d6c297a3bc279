// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Structured quads on a linking side: step (3) of the introduction of Cai and Tautges
 * (2013), by transfinite interpolation in the strip that the side is mapped to.
 */
#ifndef hexsweep_LinkingSideColumns_h
#define hexsweep_LinkingSideColumns_h

#include "Core/Linking/ColumnCourses.h"
#include "Core/Linking/RingQuads.h"
#include "Core/Linking/SidePatches.h"
#include "Core/Linking/SideStrip.h"

#include <functional>
#include <memory>

namespace hexsweep
{
struct SideTubeMesh
{
  /// (L + 1) n x 3: row k n + j is node k of the column that begins at ring node j. Row j (k = 0)
  /// is ring node j, bit for bit; all others lie on the side's triangles.
  Points nodes;
  /// L n values: entry k n + j is the row of SideTube::surface.triangles that the middle of the
  /// quad between columns j and j + 1, rings k and k + 1 lies on.
  std::vector<Index> quadTriangle;
  /// One a ring node: the CAD edge that the column is, from source to target; no rows: none.
  std::vector<Points> edges;
};

/**
 * The columns of a linking side: where each begins, where it ends, and how long it is.
 *
 * CAD edges that begin at a ring node and lead to the target loop are columns themselves. The
 * corners of the target loop are ends of columns. In between, columns share the target loop as
 * their beginnings share the source loop. They run straight through the strip or share each ring
 * by length (see shareRings()); nodes are laid by arc length along them. Parts of the side that are
 * meshed already keep their nodes; from there the layers pass over to the wanted ones as far as the
 * next CAD edge.
 */
class LinkingSideColumns
{
public:
  /**
   * @param side  see SideTube; must outlive the columns.
   * @param ring  n x 3, n >= 3: nodes of the quads of the source cap along the source loop, in
   *              either direction.
   * @param matchTolerance relative to the shorter edge of the source loop at a point: a ring node
   *              within it is that point.
   * @throw InvalidInput when the side is no tube, the ring runs in another order than the loop, or
   *        patches have different numbers of layers; SolverFailure.
   */
  LinkingSideColumns(const SideTube& side, const PointsRef& ring, double matchTolerance = 1e-6);

  /// Layers of the parts that are meshed already; 0 where there are none.
  Index meshedLayers() const { return this->Meshed.layers; }
  /// Why parts that are meshed already lose their nodes.
  const std::vector<std::string>& refusedPatches() const { return this->Meshed.refused; }

  Index size() const { return static_cast<Index>(this->Courses.size()); }

  /// Mean length of the columns.
  double meanLength() const;

  /**
   * Lays the rings.
   *
   * @param fractions of the columns' lengths, 0 ... 1, see layerFractions().
   * @throw InvalidInput when parts that are meshed already have another number of layers. Parts of
   * one layer, as walls of an extrusion are given, then count as tessellation.
   */
  SideTubeMesh mesh(const std::vector<double>& fractions) const;

  /// Nodes of the source loop, the way v rises.
  const Points& ring() const { return this->Ring; }
  /// v where a column (of ring()) begins.
  double beginOf(Index column) const
  {
    return this->Courses.begin[static_cast<std::size_t>(column)];
  }
  /// Whether no CAD edge and no part that is meshed already holds the columns, so that they can
  /// turn.
  bool isFree() const { return this->Strip->columns.empty() && this->Meshed.layers == 0; }
  /// Places of some columns at a height u in [0, 1], moved on by `turn` in v.
  Points nodesAt(const std::vector<Index>& columns, double u, double turn) const;
  /// Moves the ends of the columns on by `turn` in v, if isFree(). At the corners of the target
  /// loop columns end as before.
  void turnEnds(double turn);
  /// Has columns share all rings by length, see asideByLength(). Beside parts that are meshed
  /// already nothing changes. Undone by turnEnds() and freeHeights().
  void shareRings();
  /// Has CAD edges go by the strip's heights. @return false, and nothing is done, where parts are
  /// meshed already, or a CAD edge has corners: round a ledge there are to be nodes by its length.
  bool freeHeights();
  /// Heights u of evenly spaced layers, those of the columns by length in the mean.
  std::vector<double> meanHeights(Index layers) const;
  /// Has each ring lie at one height of the strip, where else each column has its own by length.
  /// @param heights rising from 0 to 1, of evenly spaced layers; linearly in between.
  void levelRings(std::vector<double> heights) { this->Levels = std::move(heights); }
  /// Nodes of some columns in evenly spaced layers.
  std::vector<Points> sections(const std::vector<Index>& columns, Index layers) const;
  /// How square the quads are, looked at in some layers.
  CornerSines cornerSines() const;

  /// Columns that are CAD edges.
  Index keptEdges() const;
  /// CAD edges from the source to the target loop that no ring node begins at (places of their
  /// first points): columns pass beside them.
  const std::vector<Eigen::RowVector3d>& lostEdges() const { return this->LostEdges; }
  /// Corners of the target loop for which there is no column left.
  const std::vector<Eigen::RowVector3d>& lostCorners() const { return this->LostCorners; }
  /// Whether the side is ruled but for some steps, see ruledShape().
  bool hasSteps() const { return this->Strip->hasSteps; }
  /// Triangles of the side that the map to the strip flips; places near them may be inexact.
  Index flipped() const { return this->Strip->flipped; }

private:
  void map(EdgeHeights heights);
  void placeRing();
  void findEnds();
  void measure();
  std::vector<bool> heldByEdges() const; ///< one a column
  double uAt(std::size_t column, double fraction) const;
  StripPlace inside(std::size_t column, double u) const;
  Eigen::MatrixXd heightsByLength(const std::vector<double>& fractions, bool keepsPatches) const;
  /// Of column j at layer k: u, by length along the columns unless that turns quads over.
  Eigen::MatrixXd heights(const std::vector<double>& fractions, bool keepsPatches) const;
  /// (v, u) of a node; columns go on round the tube. @param u see heights().
  Eigen::RowVector2d planePlace(const Eigen::MatrixXd& u, Index j, Index k) const;
  /// Whether all quads are convex in the strip, the right way round.
  bool isStraight(const Eigen::MatrixXd& u) const;
  bool isSteep(const Eigen::MatrixXd& u) const;
  CornerSines cornerSines(const Eigen::MatrixXd& u) const;
  /// Inside a column, on its CAD edge if it is one.
  Eigen::RowVector3d nodeOn(std::size_t column, double u) const;

  std::reference_wrapper<const SideTube> Side;
  Points Given; ///< the ring as it was given
  double MatchTolerance;
  EdgeHeights Heights = EdgeHeights::ByLength;
  std::vector<double> Levels;                ///< see levelRings(); empty: by length
  std::shared_ptr<const SideStrip> Strip;    ///< shared by copies
  std::shared_ptr<const StripSearch> Search; ///< refers to Strip
  Points Ring;                               ///< the way v rises
  std::size_t Begin = 0;                     ///< which given node the first one of Ring is
  bool Reversed = false;                     ///< whether the given ring runs the other way
  ColumnCourses Courses;
  double Turn = 0.0;       ///< what all ends are ahead of begins, see turnEnds()
  std::vector<Index> Edge; ///< CAD edge that it is (Strip.columns), or -1
  MeshedColumns Meshed;    ///< by column
  Eigen::MatrixXd Reached; ///< row: column; length up to each sample of u
  std::vector<Eigen::RowVector3d> LostEdges;
  std::vector<Eigen::RowVector3d> LostCorners;
};
}

#endif

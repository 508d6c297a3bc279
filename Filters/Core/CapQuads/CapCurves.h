// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The curves that a mesh of a cap is to keep: its loops and the borders between its faces,
 * cut at their corners.
 */
#ifndef hexsweep_CapCurves_h
#define hexsweep_CapCurves_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// A chain of edges.
struct CapCurve
{
  std::vector<Index> points; ///< two or more; a closed curve ends with its first point
  Index loop = -1;           ///< number of the boundary loop, run in its direction; -1: inside

  bool closed() const { return this->points.front() == this->points.back(); }
};

/**
 * Cuts the loops and the edges between different faces into curves.
 *
 * Curves end where more or fewer than two of these edges meet, at corners (turns of more than 30
 * degrees, and the middle of fillets: 50 degrees within twice `reach` or a quarter of the curve)
 * and at the points to keep. A curve without any of these is closed and starts at its first point.
 *
 * @param loops   as checkSurface() gives them.
 * @param faceIds one a triangle, or empty.
 * @param keep    ids of points; those on no curve do not matter.
 * @param reach   half the length of what counts as a fillet.
 */
std::vector<CapCurve> traceCapCurves(const TriangleMesh& cap, const std::vector<Loop>& loops,
  const std::vector<Index>& faceIds, const std::vector<Index>& keep, double reach);

/// A chain of points in space that is asked for places by arc length.
class ArcLengthChain
{
public:
  explicit ArcLengthChain(Points nodes);

  struct Place
  {
    Index edge;   ///< from node `edge` to the next one
    double along; ///< fraction of it, in [0, 1]
  };

  const Points& nodes() const { return this->Nodes; }
  double length() const { return this->Reached.back(); }
  /// Length from the first node to this one.
  double reached(Index node) const { return this->Reached[static_cast<std::size_t>(node)]; }
  /// @param length from the first node; places beyond the ends are the ends.
  Place locate(double length) const;
  Eigen::RowVector3d at(double length) const;

private:
  Points Nodes;
  std::vector<double> Reached;
};

/// The points of a curve.
ArcLengthChain chainOf(const PointsRef& points, const CapCurve& curve);
}

#endif

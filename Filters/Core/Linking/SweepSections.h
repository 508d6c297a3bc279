// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The rings of a sweep in the planes of its sections, and how far loops wind round each
 * other on the way.
 */
#ifndef hexsweep_SweepSections_h
#define hexsweep_SweepSections_h

#include "Core/Linking/RingStack.h"

#include <optional>

namespace hexsweep
{
/// The plane of a section: about the middle of the outer ring, across its vector area.
struct SectionFrame
{
  Eigen::RowVector3d center;
  Eigen::Matrix<double, 2, 3, Eigen::RowMajor> axes; ///< unit vectors, the first and the second
  Eigen::RowVector3d normal;                         ///< the outer ring runs counter-clockwise

  PlanePoints flatten(const PointsRef& points) const;
  Eigen::VectorXd heights(const PointsRef& points) const;
  /// @param heights over the plane, one a point.
  Points lift(const PlanePoints& points, const Eigen::VectorXd& heights) const;
};

/**
 * All rings, each in the plane of its section.
 *
 * The axes go from section to section by the least rotation that takes one normal to the next (as
 * rotation minimising frames do), and then turn about the normal with the outer ring, so that what
 * still turns turns against the outer loop.
 */
struct SweepSections
{
  std::vector<Index> nodes;  ///< source point of each loop node, loop after loop
  std::vector<Index> begins; ///< first row of each loop, then the number of rows
  std::size_t outer = 0;     ///< the loop whose vector area on the source is largest
  std::vector<SectionFrame> frames;
  std::vector<PlanePoints> rings; ///< rows as nodes; one a layer

  std::size_t numberOfLoops() const { return this->begins.size() - 1; }
};

/**
 * @param nodes  source point of each loop node, loop after loop.
 * @param begins first row of each loop, then the number of rows.
 * @param rings  rings[k], row j: where node j is on layer k.
 * @return nothing where an outer ring has hardly a vector area, or a normal turns over in one step:
 *         there is no plane to go by.
 */
std::optional<SweepSections> sweepSections(
  std::vector<Index> nodes, std::vector<Index> begins, const std::vector<Points>& rings);

std::optional<SweepSections> sweepSections(const RingStack& rings);

/// How far loops turn on their way, in radians, whole turns counted; counter-clockwise is positive.
struct LoopWinding
{
  /// By loop: how far its edges turn against those of the outer loop, on the mean.
  std::vector<double> own;
  /// How far the middle of hole `second` turns about that of hole `first`.
  struct Pair
  {
    std::size_t first;
    std::size_t second;
    double turn;
  };
  std::vector<Pair> pairs;

  /// Of all, whichever way round.
  double greatest() const;
};

/**
 * Adds up what turns from each section to the next. Exact as long as nothing turns by more than
 * half a turn from one section to the next.
 */
LoopWinding loopWinding(const SweepSections& sections);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Segments of the plane, made a graph whose edges meet at its points only.
 */
#ifndef hexsweep_PlaneImprint_h
#define hexsweep_PlaneImprint_h

#include "Core/Stacks/SegmentGrid.h"

#include <vector>

namespace hexsweep
{
/// Segments that may cross, touch and lie on each other.
struct PlaneSegments
{
  PlanePoints points{ 0, 2 };
  Segments segments;
  /// One a segment: what is nearer to it than this and belongs to a segment with no less is on it.
  std::vector<double> tolerance;
  /// One a segment: how far the curve that it stands for may be from it.
  std::vector<double> rise;
  std::vector<bool> corner; ///< one a point: others move to it
};

/// Edges that share nothing but their ends.
struct PlaneGraph
{
  PlanePoints points{ 0, 2 };
  Segments edges;                ///< lower end first, sorted, each once
  std::vector<double> tolerance; ///< one an edge, see PlaneSegments
  std::vector<bool> corner;      ///< one a point
  std::vector<Index> pointOf;    ///< point of the graph, one a given point
  Index merged = 0;          ///< points that moved to another one's place or onto another's edge
  double greatestMove = 0.0; ///< of these
  /// Greatest distance of curves that became one, but for what their rises explain.
  double greatestGap = 0.0;
};

/**
 * Merges points that are near, puts points on segments that they are near, and cuts segments where
 * they cross (by exact signs), until nothing is left to do.
 *
 * A point is near a segment where its distance is within the smaller of both tolerances or the
 * larger of both rises. So two chains of chords of one curve become one chain with the nodes of
 * both. Ends of one segment are merged where it is much shorter than its tolerance. Where two
 * chains of short segments leave a point at less than 11 degrees they are merged up to three times
 * as far, as tangent curves do: what lies between them there has no room for quads.
 *
 * Costs about O(n log n) for n segments that are evenly spread.
 *
 * @throw InvalidInput where it does not come to an end.
 */
PlaneGraph imprintSegments(const PlaneSegments& segments);
}

#endif

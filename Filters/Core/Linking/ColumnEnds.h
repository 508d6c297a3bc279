// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the columns of a linking side end on the target loop.
 *
 * Places are values v round the tube, of period 1, see SideStrip.
 */
#ifndef hexsweep_ColumnEnds_h
#define hexsweep_ColumnEnds_h

#include "Core/Common/Mesh.h"

#include <cmath>

namespace hexsweep
{
/// In [0, 1).
inline double wrappedV(double v)
{
  return v - std::floor(v);
}

/// A column whose end is known.
struct ColumnAnchor
{
  std::size_t column;
  double end;
};

struct ColumnEnds
{
  std::vector<double> ends; ///< one a column
  /// Corners of the target loop, by number, at which no column can end.
  std::vector<std::size_t> lostCorners;
};

/**
 * Corners of the target loop that are not at an anchor get a column: one that begins at a corner of
 * the source loop, where that need not go more than 0.08 of the loop out of its way, nearest pairs
 * first; else the nearest one that is free. The ends follow each other as the columns do. Between
 * anchors columns end as far from each other as they begin, in proportion.
 *
 * @param begins        of the columns, rising within less than 1.
 * @param cornerColumns columns that begin at corners of the source loop.
 * @param anchors       columns whose ends are fixed, by column.
 * @param turn          what ends are ahead of begins where nothing else is known.
 * @param corners       of the target loop.
 */
ColumnEnds columnEnds(const std::vector<double>& begins, const std::vector<Index>& cornerColumns,
  std::vector<ColumnAnchor> anchors, double turn, const std::vector<double>& corners);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Elimination orders for sparse systems on surfaces.
 */
#ifndef hexsweep_NestedDissection_h
#define hexsweep_NestedDissection_h

#include "Core/Common/Mesh.h"
#include "Core/Solvers/SparseMatrix.h"

namespace hexsweep
{
/**
 * An elimination order with its tree. Parts are contiguous in the order; children come before
 * their parents, and rows of different branches have no entry in common.
 */
struct Dissection
{
  struct Part
  {
    int begin = 0;   ///< first place in `order`
    int end = 0;     ///< one past the last
    int parent = -1; ///< a later part; -1 at a root
  };
  std::vector<int> order; ///< order[k]: the row that is eliminated as k-th
  std::vector<Part> parts;
};

/**
 * Nested dissection \cite George1973 of the graph of a matrix.
 *
 * Each connected component is a tree of its own. Parts are halved across their longest side until
 * they are small. Where the rows' places in space are not known, breadth-first distances from two
 * pairs of far-apart rows serve as coordinates in the plane; the separators are then about a tenth
 * longer.
 *
 * @param matrix n x n with a symmetric pattern.
 * @param places n x 3: where each row lies, or no rows at all.
 */
Dissection dissect(const SparseMatrix& matrix, const PointsRef& places = Points(0, 3));

/**
 * The same where consecutive rows have one pattern, as those of the unknowns of a node: one of each
 * `width` rows is looked at, and they stay together.
 *
 * @param places one row a block of rows, or no rows at all.
 */
Dissection dissectBlocks(
  const SparseMatrix& matrix, int width, const PointsRef& places = Points(0, 3));
}

#endif

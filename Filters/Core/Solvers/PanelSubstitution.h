// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangular solves with the dense blocks of a sparse factor, for two right-hand sides.
 */
#ifndef hexsweep_PanelSubstitution_h
#define hexsweep_PanelSubstitution_h

#include "Core/Common/Mesh.h"

#include <algorithm>

namespace hexsweep
{
/// A row of two right-hand sides: what both do with an entry of the factor fits one instruction.
using RowPair = Eigen::Array2d;

/// y -= A x. @param a column-major, `stride` entries from column to column.
inline void subtractProduct(
  const double* a, Index stride, Index rows, Index columns, const RowPair* x, RowPair* y)
{
  Index k = 0;
  for (; k + 4 <= columns; k += 4) // four columns to a load and store of y
  {
    const double* a0 = a + k * stride;
    const double* a1 = a0 + stride;
    const double* a2 = a1 + stride;
    const double* a3 = a2 + stride;
    const RowPair x0 = x[k];
    const RowPair x1 = x[k + 1];
    const RowPair x2 = x[k + 2];
    const RowPair x3 = x[k + 3];
    for (Index i = 0; i < rows; ++i)
    {
      y[i] -= (a0[i] * x0 + a1[i] * x1) + (a2[i] * x2 + a3[i] * x3);
    }
  }
  for (; k < columns; ++k)
  {
    const RowPair xk = x[k];
    const double* column = a + k * stride;
    for (Index i = 0; i < rows; ++i)
    {
      y[i] -= column[i] * xk;
    }
  }
}

/// y -= A^T x. @param a column-major, `stride` entries from column to column.
inline void subtractTransposedProduct(
  const double* a, Index stride, Index rows, Index columns, const RowPair* x, RowPair* y)
{
  Index k = 0;
  for (; k + 4 <= columns; k += 4) // four sums that do not wait for each other
  {
    const double* a0 = a + k * stride;
    const double* a1 = a0 + stride;
    const double* a2 = a1 + stride;
    const double* a3 = a2 + stride;
    RowPair s0(0.0, 0.0);
    RowPair s1(0.0, 0.0);
    RowPair s2(0.0, 0.0);
    RowPair s3(0.0, 0.0);
    for (Index i = 0; i < rows; ++i)
    {
      const RowPair xi = x[i];
      s0 += a0[i] * xi;
      s1 += a1[i] * xi;
      s2 += a2[i] * xi;
      s3 += a3[i] * xi;
    }
    y[k] -= s0;
    y[k + 1] -= s1;
    y[k + 2] -= s2;
    y[k + 3] -= s3;
  }
  for (; k < columns; ++k)
  {
    const double* column = a + k * stride;
    RowPair sum(0.0, 0.0);
    for (Index i = 0; i < rows; ++i)
    {
      sum += column[i] * x[i];
    }
    y[k] -= sum;
  }
}

/**
 * Solves with the lower triangle on top of a panel and subtracts from what lies below.
 *
 * @param panel  rows x pivots, column-major. @param hasUnitDiagonal the triangle's is not read.
 * @param y      one entry a row.
 */
inline void substituteForward(
  const double* panel, Index rows, Index pivots, bool hasUnitDiagonal, RowPair* y)
{
  constexpr Index Block = 4;
  for (Index k = 0; k < pivots; k += Block)
  {
    const Index end = std::min(k + Block, pivots);
    for (Index j = k; j < end; ++j)
    {
      const double* column = panel + j * rows;
      if (!hasUnitDiagonal)
      {
        y[j] /= column[j];
      }
      for (Index i = j + 1; i < end; ++i)
      {
        y[i] -= column[i] * y[j];
      }
    }
    subtractProduct(panel + k * rows + end, rows, rows - end, end - k, y + k, y + end);
  }
}

/// Subtracts what lies below the triangle and solves with the triangle's transpose: backwards.
inline void substituteTransposed(const double* panel, Index rows, Index pivots, RowPair* y)
{
  constexpr Index Block = 4;
  for (Index k = (pivots - 1) / Block * Block; k >= 0; k -= Block)
  {
    const Index end = std::min(k + Block, pivots);
    subtractTransposedProduct(panel + k * rows + end, rows, rows - end, end - k, y + end, y + k);
    for (Index j = end; j-- > k;)
    {
      const double* column = panel + j * rows;
      for (Index i = j + 1; i < end; ++i)
      {
        y[j] -= column[i] * y[i];
      }
      y[j] /= column[j];
    }
  }
}

/// Solves with the upper triangle on top of a panel.
inline void substituteBackward(const double* panel, Index rows, Index pivots, RowPair* y)
{
  for (Index k = pivots; k-- > 0;)
  {
    const double* column = panel + k * rows;
    y[k] /= column[k];
    for (Index i = 0; i < k; ++i)
    {
      y[i] -= column[i] * y[k];
    }
  }
}
}

#endif

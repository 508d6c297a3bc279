// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The product from modes to layers, in blocks that stay in registers; for PrismKernelsBody.h
 * only.
 */
#ifndef hexsweep_PrismKernelsProduct_h
#define hexsweep_PrismKernelsProduct_h

#include "Core/Solvers/PrismKernelsPack.h"

namespace hexsweep
{
namespace
{
constexpr int DoublesPerVector = sizeof(Simd<double>::Vector) / sizeof(double);
/// Columns whose sums stay in registers.
constexpr int VectorsAtOnce = DoublesPerVector == 2 ? 2 : 3;
constexpr int ColumnsAtOnce = VectorsAtOnce * DoublesPerVector;
static_assert(PanelWidth % ColumnsAtOnce == 0, "");

template <int Rows>
inline void multiplyBlock(
  Size inner, const double* a, Size strideOfA, const double* b, Size strideOfB, double* c)
{
  using Vector = Simd<double>::Vector;
  Vector sum[Rows][VectorsAtOnce] = {};
  for (Size j = 0; j < inner; ++j)
  {
    Vector row[VectorsAtOnce];
    for (int v = 0; v < VectorsAtOnce; ++v)
    {
      row[v] = loadVector<Vector>(b + j * strideOfB + v * DoublesPerVector);
    }
    for (int i = 0; i < Rows; ++i)
    {
      const double factor = a[i * strideOfA + j];
      for (int v = 0; v < VectorsAtOnce; ++v)
      {
        sum[i][v] = sum[i][v] + factor * row[v];
      }
    }
  }
  for (int i = 0; i < Rows; ++i)
  {
    for (int v = 0; v < VectorsAtOnce; ++v)
    {
      storeVector(c + i * PanelWidth + v * DoublesPerVector, sum[i][v]);
    }
  }
}

void multiply(Size rows, Size inner, const double* a, Size strideOfA, const double* b,
  Size strideOfB, double* c)
{
  for (int column = 0; column < PanelWidth; column += ColumnsAtOnce)
  {
    Size row = 0;
    for (; row + 4 <= rows; row += 4)
    {
      multiplyBlock<4>(inner, a + row * strideOfA, strideOfA, b + column, strideOfB,
        c + row * PanelWidth + column);
    }
    const double* restA = a + row * strideOfA;
    double* restC = c + row * PanelWidth + column;
    switch (rows - row)
    {
      case 3:
        multiplyBlock<3>(inner, restA, strideOfA, b + column, strideOfB, restC);
        break;
      case 2:
        multiplyBlock<2>(inner, restA, strideOfA, b + column, strideOfB, restC);
        break;
      case 1:
        multiplyBlock<1>(inner, restA, strideOfA, b + column, strideOfB, restC);
        break;
      default:
        break;
    }
  }
}
}
}

#endif

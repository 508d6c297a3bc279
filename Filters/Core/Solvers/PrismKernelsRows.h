// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Nodes of a batch, sums over them, and rows of its matrices; for PrismKernelsBody.h only.
 */
#ifndef hexsweep_PrismKernelsRows_h
#define hexsweep_PrismKernelsRows_h

#include "Core/Solvers/PrismKernelsPack.h"

namespace hexsweep
{
namespace
{
/// Sums over nodes: partial sums of 64 nodes, so that single precision keeps its digits.
template <typename Real>
struct Sums
{
  Pack<Real> part[3];
  double total[BatchWidth];

  Sums()
  {
    for (Pack<Real>& sum : part)
    {
      sum = zero<Real>();
    }
    for (double& sum : total)
    {
      sum = 0.0;
    }
  }

  void add(Size node, int component, const Pack<Real>& value)
  {
    part[component] = part[component] + value;
    if (node % 64 == 0)
    {
      flush(component);
    }
  }

  void flush(int component)
  {
    Real values[LanesPerBatch];
    store(values, part[component]);
    for (int i = 0; i < LanesPerBatch; ++i)
    {
      total[component * LanesPerBatch + i] += static_cast<double>(values[i]);
    }
    part[component] = zero<Real>();
  }

  void get(double* sums)
  {
    for (int c = 0; c < 3; ++c)
    {
      flush(c);
    }
    for (int i = 0; i < BatchWidth; ++i)
    {
      sums[i] = total[i];
    }
  }
};

template <typename Real>
struct Node
{
  Pack<Real> v[3];
};

template <typename Real>
inline Node<Real> loadNode(const Real* from, Size node)
{
  Node<Real> result;
  for (int c = 0; c < 3; ++c)
  {
    result.v[c] = load(from + node * BatchWidth + c * LanesPerBatch);
  }
  return result;
}

template <typename Real>
inline void storeNode(Real* to, Size node, const Node<Real>& value)
{
  // No loop: GCC would take the values through memory.
  store(to + node * BatchWidth, value.v[0]);
  store(to + node * BatchWidth + LanesPerBatch, value.v[1]);
  store(to + node * BatchWidth + 2 * LanesPerBatch, value.v[2]);
}

/// sum - (a part of a row) x
template <typename Real>
inline void subtractRow(const Size* begin, const int* column, const Real* stiffness,
  const Real* mass, Size row, const Pack<Real>& lambda, const Real* x, Node<Real>& sum)
{
  for (Size e = begin[row]; e < begin[row + 1]; ++e)
  {
    const Pack<Real> weight = entry(stiffness[e], mass[e], lambda);
    const Node<Real> other = loadNode(x, column[e]);
    for (int c = 0; c < 3; ++c)
    {
      sum.v[c] = sum.v[c] - weight * other.v[c];
    }
  }
}

template <typename Real>
inline void subtractLower(const HelmholtzSystem<Real>& a, Size row, const Pack<Real>& lambda,
  const Real* x, Node<Real>& sum)
{
  subtractRow(a.lowerBegin, a.lowerColumn, a.lowerStiffness, a.lowerMass, row, lambda, x, sum);
}

template <typename Real>
inline void subtractUpper(const HelmholtzSystem<Real>& a, Size row, const Pack<Real>& lambda,
  const Real* x, Node<Real>& sum)
{
  subtractRow(a.upperBegin, a.upperColumn, a.upperStiffness, a.upperMass, row, lambda, x, sum);
}
}
}

#endif

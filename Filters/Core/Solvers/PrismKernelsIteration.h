// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Passes over the nodes of a batch: the bodies of HelmholtzKernels, and the residual; for
 * PrismKernelsBody.h only.
 */
#ifndef hexsweep_PrismKernelsIteration_h
#define hexsweep_PrismKernelsIteration_h

#include "Core/Solvers/PrismKernelsRows.h"

namespace hexsweep
{
namespace
{
template <typename Real>
void factorize(
  const HelmholtzSystem<Real>& a, Real relaxation, Real least, Real* pivot, Real* inverse)
{
  const Pack<Real> lambda = load(a.lambda);
  const Pack<Real> one = spread(Real(1));
  const Pack<Real> kept = spread(Real(1) - relaxation);
  const Pack<Real> moved = spread(relaxation);
  const Pack<Real> floor = spread(least);
  for (Size i = 0; i < a.size; ++i)
  {
    const Pack<Real> diagonal = entry(a.stiffness[i], a.mass[i], lambda);
    Pack<Real> value = diagonal;
    for (Size e = a.lowerBegin[i]; e < a.lowerBegin[i + 1]; ++e)
    {
      const Size k = a.lowerColumn[e];
      const Pack<Real> weight = entry(a.lowerStiffness[e], a.lowerMass[e], lambda);
      const Pack<Real> row = entry(a.upperStiffnessSum[k], a.upperMassSum[k], lambda);
      // Fill is moved where entries are negative only: where the mass matrix prevails, all are
      // positive, and moving it makes the triangular solves unstable.
      const Pack<Real> square = weight * weight;
      const Pack<Real> fill = kept * square + moved * negative(weight) * negative(row);
      value = value - load(inverse + k * LanesPerBatch) * greater(square, fill);
    }
    value = greater(value, floor * diagonal);
    store(pivot + i * LanesPerBatch, value);
    store(inverse + i * LanesPerBatch, one / value);
  }
}

template <typename Real>
void start(const HelmholtzSystem<Real>& a, const Real* inverse, const Real* pivot, const Real* b,
  Real* r, double* rho)
{
  const Pack<Real> lambda = load(a.lambda);
  Sums<Real> sums;
  for (Size i = 0; i < a.size; ++i)
  {
    Node<Real> value = loadNode(b, i);
    subtractLower(a, i, lambda, r, value);
    const Pack<Real> scale = load(inverse + i * LanesPerBatch);
    const Pack<Real> weight = load(pivot + i * LanesPerBatch);
    for (int c = 0; c < 3; ++c)
    {
      value.v[c] = value.v[c] * scale;
      sums.add(i, c, weight * value.v[c] * value.v[c]);
    }
    storeNode(r, i, value);
  }
  sums.get(rho);
}

template <typename Real>
void backward(const HelmholtzSystem<Real>& a, const Real* inverse, const Real* r,
  const double* beta, Real* p, Real* t)
{
  const Pack<Real> lambda = load(a.lambda);
  Node<Real> factor;
  for (int c = 0; c < 3; ++c)
  {
    factor.v[c] = narrow<Real>(beta + c * LanesPerBatch);
  }
  for (Size i = a.size - 1; i >= 0; --i)
  {
    Node<Real> direction = loadNode(p, i);
    const Node<Real> residual = loadNode(r, i);
    Node<Real> sum;
    for (int c = 0; c < 3; ++c)
    {
      direction.v[c] = residual.v[c] + factor.v[c] * direction.v[c];
      sum.v[c] = zero<Real>();
    }
    storeNode(p, i, direction);
    subtractUpper(a, i, lambda, t, sum);
    const Pack<Real> scale = load(inverse + i * LanesPerBatch);
    for (int c = 0; c < 3; ++c)
    {
      sum.v[c] = direction.v[c] + scale * sum.v[c];
    }
    storeNode(t, i, sum);
  }
}

template <typename Real>
void forward(const HelmholtzSystem<Real>& a, const Real* inverse, const Real* pivot, const Real* p,
  const Real* t, Real* s, double* curvature)
{
  const Pack<Real> lambda = load(a.lambda);
  Sums<Real> sums;
  for (Size i = 0; i < a.size; ++i)
  {
    const Pack<Real> diagonal = entry(a.stiffness[i], a.mass[i], lambda);
    const Node<Real> solved = loadNode(t, i);
    Node<Real> sum;
    for (int c = 0; c < 3; ++c)
    {
      sum.v[c] = diagonal * solved.v[c];
    }
    subtractLower(a, i, lambda, s, sum);
    const Pack<Real> scale = load(inverse + i * LanesPerBatch);
    const Pack<Real> weight = load(pivot + i * LanesPerBatch);
    const Node<Real> direction = loadNode(p, i);
    for (int c = 0; c < 3; ++c)
    {
      const Pack<Real> rest = direction.v[c] - solved.v[c];
      // s + t first: it is what counts.
      const Pack<Real> product = rest + scale * sum.v[c];
      sums.add(i, c, weight * direction.v[c] * product);
      sum.v[c] = product - solved.v[c];
    }
    storeNode(s, i, sum);
  }
  sums.get(curvature);
}

template <typename Real>
void update(const HelmholtzSystem<Real>& a, const Real* pivot, const Real* t, const Real* s,
  const double* alpha, Real* x, Real* r, double* rho)
{
  Sums<Real> sums;
  Node<Real> factor;
  for (int c = 0; c < 3; ++c)
  {
    factor.v[c] = narrow<Real>(alpha + c * LanesPerBatch);
  }
  for (Size i = 0; i < a.size; ++i)
  {
    Node<Real> place = loadNode(x, i);
    Node<Real> residual = loadNode(r, i);
    const Node<Real> solved = loadNode(t, i);
    const Node<Real> rest = loadNode(s, i);
    const Pack<Real> weight = load(pivot + i * LanesPerBatch);
    for (int c = 0; c < 3; ++c)
    {
      place.v[c] = place.v[c] + factor.v[c] * solved.v[c];
      residual.v[c] = residual.v[c] - factor.v[c] * (solved.v[c] + rest.v[c]);
      sums.add(i, c, weight * residual.v[c] * residual.v[c]);
    }
    storeNode(x, i, place);
    storeNode(r, i, residual);
  }
  sums.get(rho);
}

void residual(const HelmholtzSystem<double>& a, const double* x, double* r)
{
  const Pack<double> lambda = load(a.lambda);
  for (Size i = 0; i < a.size; ++i)
  {
    const Pack<double> diagonal = entry(a.stiffness[i], a.mass[i], lambda);
    Node<double> sum = loadNode(r, i);
    const Node<double> own = loadNode(x, i);
    for (int c = 0; c < 3; ++c)
    {
      sum.v[c] = sum.v[c] - diagonal * own.v[c];
    }
    subtractLower(a, i, lambda, x, sum);
    subtractUpper(a, i, lambda, x, sum);
    storeNode(r, i, sum);
  }
}
}
}

#endif

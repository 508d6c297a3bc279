// SPDX-License-Identifier: BSD-3-Clause
#include "HelmholtzBatch.h"

#include "Errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
using Scalars = std::array<double, BatchWidth>;

std::size_t at(Index i)
{
  return static_cast<std::size_t>(i);
}

double levelDecay(double lambda, double decay)
{
  return std::acosh(1.0 + 0.5 * lambda * decay);
}

/// How many levels are needed for the solution to fall below the tolerance inside.
std::size_t reachedLevels(const HelmholtzMesh& mesh, const HelmholtzProblems& problems)
{
  const std::size_t all = mesh.levels.size() - 1;
  std::size_t reached = 1;
  for (std::size_t l = 0; l < LanesPerBatch; ++l)
  {
    // A level more: the estimate is a mean over the nodes of a level.
    double left = std::log(problems.amplitude[l] / problems.tolerance[l]) + 3.0;
    std::size_t level = 1;
    for (; level < all && left > 0.0; ++level)
    {
      left -= levelDecay(problems.lambda[l], mesh.decay[level]);
    }
    reached = problems.amplitude[l] > 0.0 ? std::max(reached, level) : reached;
  }
  while (mesh.levels[reached] < problems.loadEnd)
  {
    ++reached;
  }
  return reached;
}

/// Greatest value in the last level over the tolerance.
double excess(const HelmholtzMesh& mesh, const HelmholtzProblems& problems, std::size_t reached,
  const std::vector<double>& x)
{
  double greatest = 0.0;
  for (Index i = mesh.levels[reached - 1]; i < mesh.levels[reached]; ++i)
  {
    for (int c = 0; c < BatchWidth; ++c)
    {
      greatest = std::max(
        greatest, std::abs(x[at(i * BatchWidth + c)]) / problems.tolerance[at(c % LanesPerBatch)]);
    }
  }
  return greatest;
}

template <typename Real>
struct Precision;

template <>
struct Precision<double>
{
  static const HelmholtzKernels<double>& kernels(const PrismKernels& all) { return all.inDouble; }
  static HelmholtzSystem<double> system(const HelmholtzMesh& mesh, Index n, const double* lambda)
  {
    return mesh.system(n, lambda);
  }
  static constexpr double reduction = 1e-13;
  // Symmetric Gauss-Seidel, which nothing makes unstable: double precision is for hard cases.
  static constexpr double relaxation = 0.0;
  static constexpr double leastPivot = 1.0;
};

template <>
struct Precision<float>
{
  static const HelmholtzKernels<float>& kernels(const PrismKernels& all) { return all.inSingle; }
  static HelmholtzSystem<float> system(const HelmholtzMesh& mesh, Index n, const double* lambda)
  {
    return mesh.systemInSingle(n, lambda);
  }
  /// Of the residual, before it has to be computed anew in double precision.
  static constexpr double reduction = 1e-5;
  // Iterations on 10k and 42k quads, 100 and 215 layers: 18 for 0, 14 for 0.9, 13 for 0.98.
  static constexpr float relaxation = 0.98f;
  static constexpr float leastPivot = 0.1f;
};
}

/// Conjugate gradients in one precision inside iterative refinement, on the first `size` nodes.
template <typename Real>
class HelmholtzBatchSolver::Iteration
{
public:
  /// @param allocated nodes that rows of the first `size` point to; vectors stay zero there.
  Iteration(const HelmholtzMesh& mesh, const PrismKernels& kernels,
    const HelmholtzProblems& problems, Index size, Index allocated, Vectors<Real>& vectors)
    : Problems(problems)
    , Kernels(kernels)
    , Steps(Precision<Real>::kernels(kernels))
    , InDouble(mesh.system(size, problems.lambda.data()))
    , System(Precision<Real>::system(mesh, size, problems.lambda.data()))
    , Size(size)
    , V(vectors)
  {
    V.pivot.resize(at(size * LanesPerBatch));
    V.inverse.resize(V.pivot.size());
    for (std::vector<Real>* vector : { &V.x, &V.r, &V.p, &V.s })
    {
      vector->resize(at(size * BatchWidth));
    }
    V.t.resize(at(allocated * BatchWidth));
    std::fill(V.t.begin() + size * BatchWidth, V.t.end(), Real(0));
    Steps.factorize(System, Precision<Real>::relaxation, Precision<Real>::leastPivot,
      V.pivot.data(), V.inverse.data());
    double stiffness = 0.0;
    double mass = 0.0;
    for (Index i = 0; i < size; ++i)
    {
      stiffness += InDouble.stiffness[i];
      mass += InDouble.mass[i];
    }
    for (std::size_t l = 0; l < LanesPerBatch; ++l)
    {
      const double diagonal = (stiffness + problems.lambda[l] * mass) / static_cast<double>(size);
      Target[l] = problems.tolerance[l] * problems.tolerance[l] * diagonal;
    }
  }

  /// Improves x, which may be zero so far, until the tolerance is met; false when it is not.
  bool refine(bool isZero, std::vector<double>& x, std::vector<double>& residual)
  {
    constexpr int roundsAllowed = 12;
    double lastWorst = std::numeric_limits<double>::infinity();
    for (int round = 0; round < roundsAllowed; ++round)
    {
      residual.resize(at(Size * BatchWidth));
      const auto loadEnd = std::copy(Problems.load.begin(), Problems.load.end(), residual.begin());
      std::fill(loadEnd, residual.end(), 0.0);
      if (!isZero || round > 0)
      {
        Kernels.residual(InDouble, x.data(), residual.data());
      }
      const Scalars scale = this->scales(residual);
      this->setRightHandSide(residual, scale);
      const double worst = this->iterate(scale);
      for (Index i = 0; i < Size; ++i)
      {
        for (std::size_t c = 0; c < BatchWidth; ++c)
        {
          const std::size_t entry = at(i * BatchWidth) + c;
          x[entry] += scale[c] * static_cast<double>(V.x[entry]);
        }
      }
      if (worst <= 1.0)
      {
        return true;
      }
      if (!(worst < 0.5 * lastWorst))
      {
        return false;
      }
      lastWorst = worst;
    }
    return false;
  }

  int iterations() const { return Iterations; }

private:
  /// Greatest residual of each lane, so that single precision neither under- nor overflows.
  Scalars scales(const std::vector<double>& residual) const
  {
    Scalars scale{};
    for (Index i = 0; i < Size; ++i)
    {
      for (std::size_t c = 0; c < BatchWidth; ++c)
      {
        scale[c] = std::max(scale[c], std::abs(residual[at(i * BatchWidth) + c]));
      }
    }
    for (double& value : scale)
    {
      value = value > 0.0 ? value : 1.0;
    }
    return scale;
  }

  void setRightHandSide(const std::vector<double>& residual, const Scalars& scale)
  {
    Scalars inverse{};
    for (std::size_t c = 0; c < BatchWidth; ++c)
    {
      inverse[c] = 1.0 / scale[c];
    }
    for (Index i = 0; i < Size; ++i)
    {
      for (std::size_t c = 0; c < BatchWidth; ++c)
      {
        const std::size_t entry = at(i * BatchWidth) + c;
        V.s[entry] = static_cast<Real>(residual[entry] * inverse[c]);
      }
    }
  }

  /// Solves for V.s; returns the worst lane's preconditioned residual over its target.
  double iterate(const Scalars& scale)
  {
    Scalars rho{};
    Scalars alpha{};
    Scalars beta{};
    Scalars curvature{};
    const auto over = [&](std::size_t c) {
      return scale[c] * std::sqrt(rho[c] / Target[c % LanesPerBatch]);
    };
    Steps.start(System, V.inverse.data(), V.pivot.data(), V.s.data(), V.r.data(), rho.data());
    std::fill(V.x.begin(), V.x.end(), Real(0));
    std::fill(V.p.begin(), V.p.end(), Real(0));
    const Scalars first = rho;
    const double reduction = Precision<Real>::reduction * Precision<Real>::reduction;
    const int allowed = 1000 + static_cast<int>(10.0 * std::sqrt(static_cast<double>(Size)));
    for (int step = 0; step < allowed; ++step)
    {
      bool done = true;
      for (std::size_t c = 0; c < BatchWidth; ++c)
      {
        if (!std::isfinite(rho[c]))
        {
          return std::numeric_limits<double>::infinity();
        }
        done = done && (over(c) <= 1.0 || rho[c] <= reduction * first[c]);
      }
      if (done)
      {
        break;
      }
      ++Iterations;
      Steps.backward(System, V.inverse.data(), V.r.data(), beta.data(), V.p.data(), V.t.data());
      Steps.forward(System, V.inverse.data(), V.pivot.data(), V.p.data(), V.t.data(), V.s.data(),
        curvature.data());
      for (std::size_t c = 0; c < BatchWidth; ++c)
      {
        alpha[c] = curvature[c] > 0.0 ? rho[c] / curvature[c] : 0.0;
      }
      beta = rho;
      Steps.update(System, V.pivot.data(), V.t.data(), V.s.data(), alpha.data(), V.x.data(),
        V.r.data(), rho.data());
      for (std::size_t c = 0; c < BatchWidth; ++c)
      {
        beta[c] = beta[c] > 0.0 ? rho[c] / beta[c] : 0.0;
      }
    }
    double worst = 0.0;
    for (std::size_t c = 0; c < BatchWidth; ++c)
    {
      worst = std::max(worst, over(c));
    }
    return worst;
  }

  const HelmholtzProblems& Problems;
  const PrismKernels& Kernels;
  const HelmholtzKernels<Real>& Steps;
  HelmholtzSystem<double> InDouble;
  HelmholtzSystem<Real> System;
  Index Size;
  Vectors<Real>& V;
  std::array<double, LanesPerBatch> Target{};
  int Iterations = 0;
};

HelmholtzBatchSolver::HelmholtzBatchSolver(const HelmholtzMesh& mesh, const PrismKernels& kernels)
  : Mesh(mesh)
  , Kernels(kernels)
{
}

const HelmholtzSolution& HelmholtzBatchSolver::solve(const HelmholtzProblems& problems)
{
  const std::size_t all = this->Mesh.levels.size() - 1;
  this->Solution.values.clear();
  this->Solution.iterations = 0;
  for (std::size_t reached = reachedLevels(this->Mesh, problems);;)
  {
    const Index size = this->Mesh.levels[reached];
    const Index allocated = this->Mesh.levels[std::min(reached + 1, all)];
    const bool isZero = this->Solution.values.empty();
    this->Solution.values.resize(at(allocated * BatchWidth), 0.0);
    Iteration<float> inSingle(this->Mesh, this->Kernels, problems, size, allocated, this->InSingle);
    bool converged = inSingle.refine(isZero, this->Solution.values, this->Residual);
    this->Solution.iterations += inSingle.iterations();
    if (!converged)
    {
      Iteration<double> inDouble(
        this->Mesh, this->Kernels, problems, size, allocated, this->InDouble);
      std::fill(this->Solution.values.begin(), this->Solution.values.end(), 0.0);
      converged = inDouble.refine(true, this->Solution.values, this->Residual);
      this->Solution.iterations += inDouble.iterations();
    }
    if (!converged)
    {
      throw SolverFailure("the prism's Laplace equation could not be solved: the target quads may "
                          "be collapsed.");
    }
    this->Solution.size = size;
    if (reached == all || excess(this->Mesh, problems, reached, this->Solution.values) <= 1.0)
    {
      return this->Solution;
    }
    reached = std::min(all, reached + 1 + reached / 2);
  }
}
}

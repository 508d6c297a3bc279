// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/HelmholtzBatch.h"

#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace hexsweep
{
namespace
{
using Scalars = std::array<double, BatchWidth>;
using Lanes = std::array<bool, LanesPerBatch>;

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

/// Greatest value of a solved lane in the last level over the tolerance.
double excess(const HelmholtzMesh& mesh, const HelmholtzProblems& problems, std::size_t reached,
  const HelmholtzSolution& solution)
{
  double greatest = 0.0;
  for (Index i = mesh.levels[reached - 1]; i < mesh.levels[reached]; ++i)
  {
    for (std::size_t c = 0; c < BatchWidth; ++c)
    {
      const std::size_t l = c % LanesPerBatch;
      const double value = std::abs(solution.values[at(i * BatchWidth) + c]);
      greatest =
        solution.isSolved[l] ? std::max(greatest, value / problems.tolerance[l]) : greatest;
    }
  }
  return greatest;
}

/// Of the residual, before it has to be computed anew in double precision.
constexpr double Reduction = 1e-5;
/// What makes the preconditioner, see HelmholtzKernels::factorize.
struct Preconditioner
{
  float relaxation;
  float leastPivot;
};
// Incomplete Cholesky, modified: iterations on 10k and 42k good quads, 100 and 215 layers: 18 for
// 0, 14 for 0.9, 13 for 0.98. Quads that are far from squares bring positive entries, and its
// triangular solves blow up; symmetric Gauss-Seidel is always stable, and no floor on the pivots in
// between did better on them.
constexpr Preconditioner Preconditioners[] = { { 0.98f, 0.1f }, { 0.0f, 1.0f } };

/// Iterations of a batch that cost as much as HelmholtzDirectSolver takes for one mode: 25 to 60 on
/// 600 to 100k nodes.
constexpr double IterationsPerDirectMode = 40.0;
/// How often it is decided which modes are not worth more iterations.
constexpr int IterationsPerDecision = 16;
constexpr int IterationsAllowed = 1000;
}

/// Conjugate gradients in single precision inside refinement, on the first `size` nodes.
class HelmholtzBatchSolver::Iteration
{
public:
  /// @param allocated nodes that rows of the first `size` point to; vectors stay zero there.
  Iteration(const HelmholtzMesh& mesh, const PrismKernels& kernels,
    const HelmholtzProblems& problems, const Preconditioner& preconditioner, Index size,
    Index allocated, Vectors& vectors, const std::function<void()>& check)
    : Problems(problems)
    , Check(check)
    , Kernels(kernels)
    , Steps(kernels.iteration)
    , InDouble(mesh.system(size, problems.lambda.data()))
    , System(mesh.systemInSingle(size, problems.lambda.data()))
    , Size(size)
    , V(vectors)
  {
    V.pivot.resize(at(size * LanesPerBatch));
    V.inverse.resize(V.pivot.size());
    for (std::vector<float>* vector : { &V.x, &V.r, &V.p, &V.s })
    {
      vector->resize(at(size * BatchWidth));
    }
    V.t.resize(at(allocated * BatchWidth));
    std::fill(V.t.begin() + size * BatchWidth, V.t.end(), 0.0f);
    Steps.factorize(System, preconditioner.relaxation, preconditioner.leastPivot, V.pivot.data(),
      V.inverse.data());
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

  /**
   * Improves x, which may be zero so far, until the tolerance is met in all lanes but those that
   * are given up.
   *
   * @param isSolved lanes that were not given up before.
   * @return lanes that are not given up.
   */
  Lanes refine(Lanes isSolved, bool isZero, std::vector<double>& x, std::vector<double>& residual)
  {
    constexpr int RoundsAllowed = 12;
    IsSolved = isSolved;
    std::array<double, LanesPerBatch> lastOver;
    lastOver.fill(std::numeric_limits<double>::infinity());
    for (int round = 0; round < RoundsAllowed; ++round)
    {
      this->check();
      residual.resize(at(Size * BatchWidth));
      const auto loadEnd = std::copy(Problems.load.begin(), Problems.load.end(), residual.begin());
      std::fill(loadEnd, residual.end(), 0.0);
      if (!isZero || round > 0)
      {
        Kernels.residual(InDouble, x.data(), residual.data());
      }
      const Scalars scale = this->scales(residual);
      this->setRightHandSide(residual, scale);
      this->iterate(scale);
      for (Index i = 0; i < Size; ++i)
      {
        for (std::size_t c = 0; c < BatchWidth; ++c)
        {
          const std::size_t entry = at(i * BatchWidth) + c;
          x[entry] += scale[c] * static_cast<double>(V.x[entry]);
        }
      }
      bool done = true;
      for (std::size_t l = 0; l < LanesPerBatch; ++l)
      {
        const bool isLast = round + 1 == RoundsAllowed;
        IsSolved[l] = IsSolved[l] && (Over[l] <= 1.0 || (Over[l] < 0.5 * lastOver[l] && !isLast));
        done = done && (!IsSolved[l] || Over[l] <= 1.0);
      }
      if (done)
      {
        break;
      }
      lastOver = Over;
    }
    return IsSolved;
  }

  int iterations() const { return Iterations; }

private:
  void check() const
  {
    if (Check)
    {
      Check();
    }
  }

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
        V.s[entry] = static_cast<float>(residual[entry] * inverse[c]);
      }
    }
  }

  /// Sets Over, the preconditioned residual of each mode over its target; gives up modes whose
  /// residual is not finite.
  void look(const Scalars& scale, const Scalars& rho)
  {
    Over.fill(0.0);
    for (std::size_t c = 0; c < BatchWidth; ++c)
    {
      const std::size_t l = c % LanesPerBatch;
      IsSolved[l] = IsSolved[l] && std::isfinite(rho[c]);
      Over[l] = std::max(Over[l], scale[c] * std::sqrt(rho[c] / Target[l]));
    }
  }

  /// Gives up the modes whose direct solution costs less than the iterations that they alone need,
  /// if all go on as they did from `first`, `steps` iterations ago.
  void giveUp(const std::array<double, LanesPerBatch>& first, int steps)
  {
    std::array<double, LanesPerBatch> left{};
    std::array<std::size_t, LanesPerBatch> slowest{};
    for (std::size_t l = 0; l < LanesPerBatch; ++l)
    {
      slowest[l] = l;
      if (IsSolved[l] && Over[l] > 1.0)
      {
        left[l] = Over[l] < first[l] ? steps * std::log(Over[l]) / std::log(first[l] / Over[l])
                                     : std::numeric_limits<double>::infinity();
      }
    }
    std::stable_sort(slowest.begin(), slowest.end(),
      [&](std::size_t a, std::size_t b) { return left[a] > left[b]; });
    std::size_t best = 0;
    double leastCost = left[slowest[0]];
    for (std::size_t count = 1; count <= LanesPerBatch; ++count)
    {
      const double cost = IterationsPerDirectMode * static_cast<double>(count) +
        (count < LanesPerBatch ? left[slowest[count]] : 0.0);
      if (cost < leastCost)
      {
        best = count;
        leastCost = cost;
      }
    }
    for (std::size_t i = 0; i < best; ++i)
    {
      IsSolved[slowest[i]] = false;
    }
  }

  /// Solves for V.s.
  void iterate(const Scalars& scale)
  {
    Scalars rho{};
    Scalars alpha{};
    Scalars beta{};
    Scalars curvature{};
    Steps.start(System, V.inverse.data(), V.pivot.data(), V.s.data(), V.r.data(), rho.data());
    std::fill(V.x.begin(), V.x.end(), 0.0f);
    std::fill(V.p.begin(), V.p.end(), 0.0f);
    const Scalars first = rho;
    this->look(scale, rho);
    const std::array<double, LanesPerBatch> firstOver = Over;
    for (int step = 0; step < IterationsAllowed; ++step)
    {
      if (step > 0 && step % IterationsPerDecision == 0)
      {
        this->check();
        this->giveUp(firstOver, step);
      }
      bool done = true;
      for (std::size_t c = 0; c < BatchWidth; ++c)
      {
        const std::size_t l = c % LanesPerBatch;
        done =
          done && (!IsSolved[l] || Over[l] <= 1.0 || rho[c] <= Reduction * Reduction * first[c]);
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
      this->look(scale, rho);
    }
  }

  const HelmholtzProblems& Problems;
  const std::function<void()>& Check;
  const PrismKernels& Kernels;
  const HelmholtzKernels& Steps;
  HelmholtzSystem<double> InDouble;
  HelmholtzSystem<float> System;
  Index Size;
  Vectors& V;
  std::array<double, LanesPerBatch> Target{};
  std::array<double, LanesPerBatch> Over{};
  Lanes IsSolved{};
  int Iterations = 0;
};

HelmholtzBatchSolver::HelmholtzBatchSolver(const HelmholtzMesh& mesh, const PrismKernels& kernels)
  : Mesh(mesh)
  , Kernels(kernels)
{
}

const HelmholtzSolution& HelmholtzBatchSolver::solve(
  const HelmholtzProblems& problems, const std::function<void()>& check)
{
  const std::size_t all = this->Mesh.levels.size() - 1;
  this->Solution.values.clear();
  this->Solution.iterations = 0;
  this->Solution.isSolved.fill(true);
  std::size_t preconditioner = 0;
  for (std::size_t reached = reachedLevels(this->Mesh, problems);;)
  {
    const Index size = this->Mesh.levels[reached];
    const Index allocated = this->Mesh.levels[std::min(reached + 1, all)];
    const bool isZero = this->Solution.values.empty();
    this->Solution.values.resize(at(allocated * BatchWidth), 0.0);
    const Lanes tried = this->Solution.isSolved;
    Iteration iteration(this->Mesh, this->Kernels, problems, Preconditioners[preconditioner], size,
      allocated, this->Memory, check);
    this->Solution.isSolved =
      iteration.refine(tried, isZero, this->Solution.values, this->Residual);
    this->Solution.iterations += iteration.iterations();
    this->Solution.size = size;
    if (this->Solution.isSolved != tried && preconditioner + 1 < std::size(Preconditioners))
    {
      this->clearUnsolved();
      this->Solution.isSolved = tried;
      ++preconditioner;
      continue;
    }
    if (reached == all || excess(this->Mesh, problems, reached, this->Solution) <= 1.0)
    {
      return this->Solution;
    }
    reached = std::min(all, reached + 1 + reached / 2);
  }
}

void HelmholtzBatchSolver::clearUnsolved()
{
  for (std::size_t entry = 0; entry < this->Solution.values.size(); ++entry)
  {
    if (!this->Solution.isSolved[entry % LanesPerBatch])
    {
      this->Solution.values[entry] = 0.0;
    }
  }
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CapEquations.h"

#include "Core/Common/Errors.h"
#include "Core/Solvers/ConjugateGradients.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr int GradientSteps = 60;
constexpr double GradientTolerance = 0.05;
}

CapEquations::CapEquations(const CapCorners& cap, NewtonEquations kind)
  : Kind(kind)
{
  Index nodes = 0;
  for (const QuadCorner& corner : cap.corners())
  {
    nodes = std::max({ nodes, corner.node[0] + 1, corner.node[1] + 1, corner.node[2] + 1 });
  }
  this->Variable.assign(static_cast<std::size_t>(nodes), -1);
  for (std::size_t k = 0; k < cap.freeNodes().size(); ++k)
  {
    this->Variable[static_cast<std::size_t>(cap.freeNodes()[k])] = static_cast<int>(k);
  }
  for (std::size_t c = 0; c < cap.corners().size(); ++c)
  {
    // The corners of a quad stand side by side, in the order of the quads.
    this->FirstCorner.resize(static_cast<std::size_t>(cap.corners()[c].quad) + 1, c);
  }
  this->FirstCorner.resize(static_cast<std::size_t>(cap.quads().rows()) + 1, cap.corners().size());
  this->makeHessian(cap.corners(), cap.freeNodes().size());
  this->color(cap.quads());
}

std::array<int, 3> CapEquations::variables(const QuadCorner& corner) const
{
  std::array<int, 3> v{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    v[i] = this->Variable[static_cast<std::size_t>(corner.node[i])];
  }
  return v;
}

void CapEquations::setZero()
{
  std::fill_n(this->Hessian.valuePtr(), this->Hessian.nonZeros(), 0.0);
}

void CapEquations::add(
  std::size_t corner, std::size_t i, std::size_t j, const Eigen::Matrix2d& block)
{
  const auto addAt = [&](const std::pair<int, int>& slot, const Eigen::Matrix2d& part) {
    double* first = this->Hessian.valuePtr() + slot.first;
    double* second = first + slot.second;
    first[0] += part(0, 0);
    first[1] += part(1, 0);
    second[0] += part(0, 1);
    second[1] += part(1, 1);
  };
  addAt(this->Slots[9 * corner + 3 * i + j], block);
  if (i != j)
  {
    addAt(this->Slots[9 * corner + 3 * j + i], block.transpose());
  }
}

void CapEquations::damp(double part)
{
  double* values = this->Hessian.valuePtr();
  double sum = 0.0;
  for (const int i : this->Diagonal)
  {
    sum += values[i];
  }
  const double shift = part * sum / static_cast<double>(this->Diagonal.size());
  for (const int i : this->Diagonal)
  {
    values[i] += shift;
  }
}

Eigen::VectorXd CapEquations::step(
  const Eigen::VectorXd& gradient, const PointsRef& places, const ParallelFor& parallelFor)
{
  if (this->Kind == NewtonEquations::Roughly)
  {
    return conjugateGradients(
      this->Hessian, -gradient, NodeUnknowns::Two, GradientSteps, GradientTolerance, parallelFor);
  }
  if (!this->Solver)
  {
    this->Solver.emplace(this->Hessian, MultifrontalSolver::Kind::Cholesky, places, 2);
  }
  try
  {
    this->Solver->factorize(this->Hessian, parallelFor);
    return this->Solver->solve(-gradient);
  }
  catch (const SolverFailure&)
  {
    return Eigen::VectorXd::Constant(gradient.size(), std::nan(""));
  }
}

/// The pattern, all values zero, and where the blocks of the corners are in it.
void CapEquations::makeHessian(const std::vector<QuadCorner>& corners, std::size_t freeNodes)
{
  std::vector<std::vector<int>> neighbors(freeNodes);
  for (const QuadCorner& corner : corners)
  {
    const std::array<int, 3> v = this->variables(corner);
    for (const int j : v)
    {
      for (const int i : v)
      {
        if (i >= 0 && j >= 0)
        {
          neighbors[static_cast<std::size_t>(j)].push_back(i);
        }
      }
    }
  }
  Index values = 0;
  for (std::vector<int>& rows : neighbors)
  {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    values += 4 * static_cast<Index>(rows.size());
  }
  const Index n = 2 * static_cast<Index>(freeNodes);
  this->Hessian.resize(n, n);
  this->Hessian.reserve(values);
  for (Index column = 0; column < n; ++column)
  {
    this->Hessian.startVec(column);
    for (const int i : neighbors[static_cast<std::size_t>(column / 2)])
    {
      this->Hessian.insertBack(2 * i, column) = 0.0;
      this->Hessian.insertBack(2 * i + 1, column) = 0.0;
    }
  }
  this->Hessian.finalize();
  const auto slot = [&](int i, int j) {
    const std::vector<int>& rows = neighbors[static_cast<std::size_t>(j)];
    const auto rank = std::lower_bound(rows.begin(), rows.end(), i) - rows.begin();
    return this->Hessian.outerIndexPtr()[2 * j] + 2 * static_cast<int>(rank);
  };
  this->Slots.reserve(9 * corners.size());
  for (const QuadCorner& corner : corners)
  {
    const std::array<int, 3> v = this->variables(corner);
    for (const int i : v)
    {
      for (const int j : v)
      {
        this->Slots.emplace_back(i >= 0 && j >= 0 ? std::make_pair(slot(i, j), this->nextColumn(j))
                                                  : std::make_pair(-1, 0));
      }
    }
  }
  for (int j = 0; j < static_cast<int>(freeNodes); ++j)
  {
    this->Diagonal.push_back(slot(j, j));
    this->Diagonal.push_back(slot(j, j) + this->nextColumn(j) + 1);
  }
}

/// Greedily.
void CapEquations::color(const Quads& quads)
{
  constexpr int MostColors = 64;
  std::vector<std::uint64_t> taken(this->Variable.size(), 0); // a bit a color
  for (Index q = 0; q < quads.rows(); ++q)
  {
    std::uint64_t around = 0;
    for (const Index node : quads.row(q))
    {
      around |= taken[static_cast<std::size_t>(node)];
    }
    int color = 0;
    while (color < MostColors && (around >> color & 1U) != 0)
    {
      ++color;
    }
    if (color == MostColors)
    {
      // So many quads at one node that the rest is a color of its own each.
      this->Colors.resize(std::max<std::size_t>(this->Colors.size(), MostColors));
      this->Colors.push_back({ q });
      continue;
    }
    if (static_cast<std::size_t>(color) >= this->Colors.size())
    {
      this->Colors.resize(static_cast<std::size_t>(color) + 1);
    }
    this->Colors[static_cast<std::size_t>(color)].push_back(q);
    for (const Index node : quads.row(q))
    {
      taken[static_cast<std::size_t>(node)] |= std::uint64_t{ 1 } << color;
    }
  }
}
}

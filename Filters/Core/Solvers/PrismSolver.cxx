// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/PrismSolver.h"

#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Common/StoppablePieces.h"
#include "Core/Solvers/HelmholtzDirect.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <mutex>
#include <utility>

namespace hexsweep
{
namespace
{
// Of the greatest given value, for one mode; their errors add up like random numbers.
constexpr double ModeAccuracy = 1e-12;

constexpr Index PointsPerPanel = PanelWidth / 3;
// Points that are transformed together: all modes of them stay in the cache.
constexpr Index PointsAtOnce = 4 * PointsPerPanel;
constexpr Index PointsPerPiece = 32 * PointsAtOnce;

// Entries of IsGiven, besides 0.
constexpr char Given = 1;
constexpr char Unused = 2;

std::vector<char> givenPoints(const QuadLaplacian& laplacian, const std::vector<Index>& fixedPoints)
{
  std::vector<char> given(at(laplacian.mass.cols()), 0);
  for (const Index id : fixedPoints)
  {
    given.at(at(id)) = Given;
  }
  for (Index i = 0; i < laplacian.mass.cols(); ++i)
  {
    if (!Eigen::SparseMatrix<double>::InnerIterator(laplacian.mass, i))
    {
      given[at(i)] = Unused;
    }
  }
  return given;
}

/// Copies of a solver that no thread uses at the moment.
template <typename Solver>
class IdleSolvers
{
public:
  /// @param first is never used itself.
  explicit IdleSolvers(Solver first)
    : First(std::move(first))
  {
  }

  std::unique_ptr<Solver> take()
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (this->Idle.empty())
    {
      return std::make_unique<Solver>(this->First);
    }
    auto solver = std::move(this->Idle.back());
    this->Idle.pop_back();
    return solver;
  }

  void giveBack(std::unique_ptr<Solver> solver)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Idle.push_back(std::move(solver));
  }

private:
  const Solver First;
  std::mutex Guard;
  std::vector<std::unique_ptr<Solver>> Idle;
};
}

PrismSolver::PrismSolver(const QuadLaplacian& laplacian, const Eigen::VectorXd& layerHeights,
  const std::vector<Index>& fixedPoints)
  : NumberOfPoints(laplacian.stiffness.rows())
  , Modes(layerModes(layerHeights))
  , Stiffness(laplacian.stiffness)
  , IsGiven(givenPoints(laplacian, fixedPoints))
{
  this->Mesh = helmholtzMesh(laplacian, this->IsGiven);
  const Eigen::MatrixXd& functions = this->Modes.functions;
  const Index inner = functions.cols();
  if (!this->Modes.isSymmetric)
  {
    this->Synthesis = functions;
    return;
  }
  const Index half = (inner + 1) / 2;
  this->Synthesis.resize(half, inner);
  for (Index j = 0; j < inner; ++j)
  {
    this->Synthesis.col(j % 2 == 0 ? j / 2 : half + j / 2) = functions.col(j).head(half);
  }
}

PrismSolver::PrismSolver(const QuadLaplacian& laplacian, Index numberOfLayers, double layerHeight,
  const std::vector<Index>& fixedPoints)
  : PrismSolver(laplacian,
      Eigen::VectorXd::Constant(std::max<Index>(numberOfLayers, 0), layerHeight), fixedPoints)
{
}

void PrismSolver::addCaps(const Points& values, Sources& sources) const
{
  const Index n = this->NumberOfPoints;
  const Index top = (this->Modes.fractions.size() - 1) * n;
  bool zero = true;
  for (Index i = 0; i < n && zero; ++i)
  {
    zero = this->IsGiven[at(i)] == Unused ||
      (values.row(i).isZero(0.0) && values.row(top + i).isZero(0.0));
  }
  if (zero)
  {
    return;
  }
  const Points first = -(this->Stiffness * values.topRows(n));
  const Points last = -(this->Stiffness * values.bottomRows(n));
  sources.first.resize(this->Mesh.size(), 3);
  sources.last.resize(this->Mesh.size(), 3);
  for (Index i = 0; i < this->Mesh.size(); ++i)
  {
    sources.first.row(i) = first.row(this->Mesh.ids[at(i)]);
    sources.last.row(i) = last.row(this->Mesh.ids[at(i)]);
  }
}

/// Modes x 3 numbers for each given point; what the caps carry inside is subtracted.
Eigen::MatrixXd PrismSolver::sideCoefficients(const Points& values) const
{
  const Index n = this->NumberOfPoints;
  const Index layers = this->Modes.fractions.size() - 1;
  Eigen::MatrixXd sides(layers - 1, 3 * static_cast<Index>(this->Mesh.given.size()));
  for (Index g = 0; g < static_cast<Index>(this->Mesh.given.size()); ++g)
  {
    const Index id = this->Mesh.given[at(g)];
    for (Index k = 1; k < layers; ++k)
    {
      const double t = this->Modes.fractions[k];
      sides.block<1, 3>(k - 1, 3 * g) =
        values.row(k * n + id) - (1.0 - t) * values.row(id) - t * values.row(layers * n + id);
    }
  }
  return this->Modes.analysis * sides;
}

Eigen::RowVector3d PrismSolver::loadOf(Index mode, Index node, const Sources& sources) const
{
  Eigen::RowVector3d load = Eigen::RowVector3d::Zero();
  const double lambda = this->Modes.eigenvalues[mode];
  const MatrixPart& coupling = this->Mesh.coupling;
  for (Index e = coupling.begin[at(node)]; e < coupling.begin[at(node + 1)]; ++e)
  {
    load -= (coupling.inDouble.stiffness[at(e)] + lambda * coupling.inDouble.mass[at(e)]) *
      sources.sides.block<1, 3>(mode, 3 * static_cast<Index>(coupling.column[at(e)]));
  }
  if (sources.first.rows() > 0)
  {
    load += this->Modes.firstLoad[mode] * sources.first.row(node) +
      this->Modes.lastLoad[mode] * sources.last.row(node);
  }
  return load;
}

/// Of the coefficients of a mode, from that of the solution.
double PrismSolver::toleranceOf(Index mode, const Sources& sources) const
{
  return ModeAccuracy * sources.greatest / this->Modes.functions.col(mode).cwiseAbs().maxCoeff();
}

HelmholtzProblems PrismSolver::problems(Index batch, const Sources& sources) const
{
  const Index modes = this->Modes.eigenvalues.size();
  HelmholtzProblems problems;
  problems.loadEnd = sources.first.rows() > 0 ? this->Mesh.size() : this->Mesh.levels[1];
  problems.load.assign(at(problems.loadEnd * BatchWidth), 0.0);
  for (Index lane = 0; lane < LanesPerBatch; ++lane)
  {
    const Index mode = std::min(batch * LanesPerBatch + lane, modes - 1);
    problems.lambda[at(lane)] = this->Modes.eigenvalues[mode];
    problems.tolerance[at(lane)] = this->toleranceOf(mode, sources);
    if (batch * LanesPerBatch + lane >= modes)
    {
      continue; // no load: nothing to solve
    }
    problems.amplitude[at(lane)] =
      sources.sides.cols() > 0 ? sources.sides.row(mode).cwiseAbs().maxCoeff() : 0.0;
    for (Index i = 0; i < problems.loadEnd; ++i)
    {
      const Eigen::RowVector3d load = this->loadOf(mode, i, sources);
      for (Index c = 0; c < 3; ++c)
      {
        problems.load[at(i * BatchWidth + c * LanesPerBatch + lane)] = load[c];
      }
    }
  }
  return problems;
}

/// @return the modes that were given up.
std::vector<Index> PrismSolver::solveBatches(const Sources& sources, const PrismKernels& kernels,
  const Progress& progress, const ParallelFor& parallelFor, Points& values) const
{
  const Index modes = this->Modes.eigenvalues.size();
  const Index batches = (modes + LanesPerBatch - 1) / LanesPerBatch;
  std::vector<char> isSolved(at(batches * LanesPerBatch));
  IdleSolvers<HelmholtzBatchSolver> solvers({ this->Mesh, kernels });
  // Progress is reported by the calling thread only.
  const auto check = [&](Index batch) -> std::function<void()> {
    if (parallelFor)
    {
      return {};
    }
    return [&progress, batch, batches] {
      reportProgress(progress, static_cast<double>(batch) / static_cast<double>(batches));
    };
  };
  forStoppablePieces(parallelFor, progress, batches, 1, [&](Index batch, Index) {
    auto solver = solvers.take();
    const HelmholtzSolution& solution = solver->solve(this->problems(batch, sources), check(batch));
    this->storeModes(batch, solution, values);
    std::copy(
      solution.isSolved.begin(), solution.isSolved.end(), isSolved.begin() + batch * LanesPerBatch);
    solvers.giveBack(std::move(solver));
  });
  std::vector<Index> rest;
  for (Index mode = 0; mode < modes; ++mode)
  {
    if (!isSolved[at(mode)])
    {
      rest.push_back(mode);
    }
  }
  return rest;
}

void PrismSolver::solveDirectly(const std::vector<Index>& modes, const Sources& sources,
  const Progress& progress, const ParallelFor& parallelFor, Points& values) const
{
  if (modes.empty())
  {
    return;
  }
  IdleSolvers<HelmholtzDirectSolver> solvers(HelmholtzDirectSolver(this->Mesh));
  const Index count = static_cast<Index>(modes.size());
  forStoppablePieces(parallelFor, progress, count, 1, [&](Index piece, Index) {
    const Index mode = modes[at(piece)];
    const bool hasCaps = sources.first.rows() > 0;
    Points load = Points::Zero(this->Mesh.size(), 3);
    for (Index i = 0; i < (hasCaps ? this->Mesh.size() : this->Mesh.levels[1]); ++i)
    {
      load.row(i) = this->loadOf(mode, i, sources);
    }
    auto solver = solvers.take();
    const Points solution =
      solver->solve(this->Modes.eigenvalues[mode], load, this->toleranceOf(mode, sources));
    solvers.giveBack(std::move(solver));
    for (Index i = 0; i < this->Mesh.size(); ++i)
    {
      values.row((mode + 1) * this->NumberOfPoints + this->Mesh.ids[at(i)]) = solution.row(i);
    }
  });
}

/// Coefficients of mode j go where the values of layer j + 1 will be.
void PrismSolver::storeModes(Index batch, const HelmholtzSolution& solution, Points& values) const
{
  const Index first = batch * LanesPerBatch;
  const Index count = std::min<Index>(LanesPerBatch, this->Modes.eigenvalues.size() - first);
  for (Index i = 0; i < this->Mesh.size(); ++i)
  {
    const bool isZero = i >= solution.size;
    const double* from = solution.values.data() + (isZero ? 0 : i * BatchWidth);
    double* to = values.data() + 3 * ((first + 1) * this->NumberOfPoints + this->Mesh.ids[at(i)]);
    for (Index lane = 0; lane < count; ++lane)
    {
      for (Index c = 0; c < 3; ++c)
      {
        to[3 * lane * this->NumberOfPoints + c] = isZero ? 0.0 : from[c * LanesPerBatch + lane];
      }
    }
  }
}

/// From coefficients to values on the inner layers; both inner x PanelWidth.
void PrismSolver::synthesizePanel(
  const PrismKernels& kernels, const double* coefficients, double* values) const
{
  const Index inner = this->Modes.eigenvalues.size();
  const double* functions = this->Synthesis.data();
  if (!this->Modes.isSymmetric)
  {
    kernels.multiply(inner, inner, functions, inner, coefficients, PanelWidth, values);
    return;
  }
  // Even functions make the mean of layers k and L - k, odd ones half their difference.
  const Index half = (inner + 1) / 2;
  const Index odd = inner / 2;
  Panel even(half, PanelWidth);
  Panel uneven(half, PanelWidth);
  kernels.multiply(half, half, functions, inner, coefficients, 2 * PanelWidth, even.data());
  kernels.multiply(
    half, odd, functions + half, inner, coefficients + PanelWidth, 2 * PanelWidth, uneven.data());
  Eigen::Map<Panel> layers(values, inner, PanelWidth);
  layers.topRows(half) = even + uneven;
  layers.bottomRows(odd) = (even - uneven).topRows(odd).colwise().reverse();
}

/// The same in place, for points [begin, end), of which there are at most PointsAtOnce.
void PrismSolver::synthesize(const PrismKernels& kernels, Index begin, Index end, bool hasCaps,
  Panel& coefficients, Panel& layers, Points& values) const
{
  const Index n = this->NumberOfPoints;
  const Index inner = this->Modes.eigenvalues.size();
  const Index panels = (end - begin + PointsPerPanel - 1) / PointsPerPanel;
  const auto widthOf = [&](Index panel) {
    return 3 * std::min(PointsPerPanel, end - begin - panel * PointsPerPanel);
  };
  // The columns of given points are transformed with the others, and not used.
  for (Index j = 0; j < inner; ++j)
  {
    const double* from = values.data() + 3 * ((j + 1) * n + begin);
    for (Index panel = 0; panel < panels; ++panel)
    {
      std::memcpy(coefficients.data() + (panel * inner + j) * PanelWidth, from + panel * PanelWidth,
        at(widthOf(panel)) * sizeof(double));
    }
  }
  for (Index panel = 0; panel < panels; ++panel)
  {
    const Index offset = panel * inner * PanelWidth;
    this->synthesizePanel(kernels, coefficients.data() + offset, layers.data() + offset);
  }
  const bool allFree = std::all_of(this->IsGiven.begin() + begin, this->IsGiven.begin() + end,
    [](char given) { return given == 0; });
  for (Index k = 0; k < inner; ++k)
  {
    if (allFree && !hasCaps)
    {
      double* to = values.data() + 3 * ((k + 1) * n + begin);
      for (Index panel = 0; panel < panels; ++panel)
      {
        std::memcpy(to + panel * PanelWidth, layers.data() + (panel * inner + k) * PanelWidth,
          at(widthOf(panel)) * sizeof(double));
      }
      continue;
    }
    const double t = this->Modes.fractions[k + 1];
    for (Index i = begin; i < end; ++i)
    {
      if (this->IsGiven[at(i)])
      {
        continue;
      }
      const Index panel = (i - begin) / PointsPerPanel;
      auto value = values.row((k + 1) * n + i);
      value = layers.block<1, 3>(panel * inner + k, 3 * ((i - begin) % PointsPerPanel));
      if (hasCaps)
      {
        value += (1.0 - t) * values.row(i) + t * values.row((inner + 1) * n + i);
      }
    }
  }
}

double PrismSolver::greatestGiven(const Points& values) const
{
  const Index n = this->NumberOfPoints;
  const Index layers = this->Modes.fractions.size() - 1;
  double greatest = 0.0;
  double sum = 0.0; // a maximum may pass over what is not a number, a sum never does
  const auto look = [&](Index row) {
    greatest = std::max(greatest, values.row(row).cwiseAbs().maxCoeff());
    sum += values.row(row).cwiseAbs().sum();
  };
  for (Index i = 0; i < n; ++i)
  {
    if (this->IsGiven[at(i)] != Unused)
    {
      look(i);
      look(layers * n + i);
    }
  }
  for (const Index id : this->Mesh.given)
  {
    for (Index k = 1; k < layers; ++k)
    {
      look(k * n + id);
    }
  }
  if (!std::isfinite(sum))
  {
    throw SolverFailure("the prism's Laplace equation has boundary values that are not finite.");
  }
  return greatest;
}

Points PrismSolver::extend(
  Points values, const Progress& progress, const ParallelFor& parallelFor) const
{
  const Index n = this->NumberOfPoints;
  const Index layers = this->Modes.fractions.size() - 1;
  if (values.rows() != (layers + 1) * n)
  {
    throw InvalidInput("the prism needs one value for each point on each layer.");
  }
  if (layers == 1 || this->Mesh.size() == 0)
  {
    return values;
  }
  reportProgress(progress, 0.0);
  const double greatest = this->greatestGiven(values);
  if (!(greatest > 0.0))
  {
    for (const Index id : this->Mesh.ids)
    {
      for (Index k = 1; k < layers; ++k)
      {
        values.row(k * n + id).setZero();
      }
    }
    return values;
  }
  Sources sources;
  sources.greatest = greatest;
  reportProgress(progress, 0.0);
  sources.sides = this->sideCoefficients(values);
  reportProgress(progress, 0.0);
  this->addCaps(values, sources);
  const bool hasCaps = sources.first.rows() > 0;

  const PrismKernels& kernels = prismKernels();
  const std::vector<Index> givenUp =
    this->solveBatches(sources, kernels, progressPart(progress, 0.0, 0.6), parallelFor, values);
  this->solveDirectly(givenUp, sources, progressPart(progress, 0.6, 0.8), parallelFor, values);
  forStoppablePieces(
    parallelFor, progressPart(progress, 0.8, 1.0), n, PointsPerPiece, [&](Index first, Index end) {
      Panel coefficients = Panel::Zero(PointsAtOnce / PointsPerPanel * (layers - 1), PanelWidth);
      Panel layerValues(coefficients.rows(), PanelWidth);
      for (Index begin = first; begin < end; begin += PointsAtOnce)
      {
        this->synthesize(kernels, begin, std::min(begin + PointsAtOnce, end), hasCaps, coefficients,
          layerValues, values);
      }
    });
  reportProgress(progress, 1.0);
  return values;
}
}

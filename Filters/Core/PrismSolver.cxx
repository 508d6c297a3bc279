// SPDX-License-Identifier: BSD-3-Clause
#include "PrismSolver.h"

#include "Errors.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
using Sparse = Eigen::SparseMatrix<double>;

/// Rows and columns of a matrix, picked; the result has exactly the entries that are stored.
Sparse block(
  const Sparse& matrix, const std::vector<Index>& rows, const std::vector<Index>& columns)
{
  std::vector<int> newRow(static_cast<std::size_t>(matrix.rows()), -1);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    newRow[static_cast<std::size_t>(rows[i])] = static_cast<int>(i);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t j = 0; j < columns.size(); ++j)
  {
    for (Sparse::InnerIterator entry(matrix, columns[j]); entry; ++entry)
    {
      const int row = newRow[static_cast<std::size_t>(entry.row())];
      if (row >= 0)
      {
        entries.emplace_back(row, static_cast<int>(j), entry.value());
      }
    }
  }
  Sparse result(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// S(j, k) = sin(pi (j + 1) (k + 1) / L), symmetric, S S = L / 2.
Eigen::MatrixXd sineMatrix(Index layers)
{
  Eigen::MatrixXd sine(layers - 1, layers - 1);
  const double pi = std::acos(-1.0);
  for (Index j = 1; j < layers; ++j)
  {
    for (Index k = 1; k < layers; ++k)
    {
      // Reduced to one period, which keeps the argument and so its rounding error small.
      const Index phase = (j * k) % (2 * layers);
      sine(j - 1, k - 1) = std::sin(pi * static_cast<double>(phase) / static_cast<double>(layers));
    }
  }
  return sine;
}

/// Values of some points on the inner layers: one row a layer, three columns a point.
Eigen::MatrixXd gatherColumns(
  const PointsRef& values, Index pointsPerLayer, Index layers, const std::vector<Index>& ids)
{
  Eigen::MatrixXd gathered(layers - 1, 3 * static_cast<Index>(ids.size()));
  for (Index k = 1; k < layers; ++k)
  {
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      gathered.block<1, 3>(k - 1, 3 * static_cast<Index>(i)) =
        values.row(k * pointsPerLayer + ids[i]);
    }
  }
  return gathered;
}

/// One row of such a matrix as points.
Points rowAsPoints(const Eigen::MatrixXd& gathered, Index row)
{
  const Eigen::RowVectorXd values = gathered.row(row);
  return Eigen::Map<const Points>(values.data(), values.size() / 3, 3);
}
}

PrismSolver::PrismSolver(QuadLaplacian laplacian, Index numberOfLayers, double layerHeight,
  const std::vector<Index>& fixedPoints)
  : Laplacian(std::move(laplacian))
  , NumberOfLayers(numberOfLayers)
  , LayerHeight(layerHeight)
{
  const Index n = this->Laplacian.stiffness.rows();
  if (numberOfLayers < 1)
  {
    throw InvalidInput("the number of layers must be at least 1.");
  }
  if (!(layerHeight > 0.0) || !std::isfinite(layerHeight))
  {
    throw InvalidInput("the height of a layer must be positive: source and target coincide.");
  }
  std::vector<char> fixed(static_cast<std::size_t>(n), 0);
  for (const Index id : fixedPoints)
  {
    fixed.at(static_cast<std::size_t>(id)) = 1;
  }
  for (Index i = 0; i < n; ++i)
  {
    const bool unused = Sparse::InnerIterator(this->Laplacian.mass, i) ? false : true;
    (fixed[static_cast<std::size_t>(i)] || unused ? this->Fixed : this->Free).push_back(i);
  }
}

Points PrismSolver::extend(const PointsRef& values, const Progress& progress) const
{
  const Index n = this->Laplacian.stiffness.rows();
  const Index layers = this->NumberOfLayers;
  if (values.rows() != (layers + 1) * n)
  {
    throw InvalidInput("the prism needs one value for each point on each layer.");
  }
  Points result = values;
  if (layers == 1 || this->Free.empty())
  {
    return result;
  }

  const Sparse& K = this->Laplacian.stiffness;
  const Sparse& M = this->Laplacian.mass;
  const Sparse freeK = block(K, this->Free, this->Free);
  const Sparse freeM = block(M, this->Free, this->Free);
  const Sparse sideK = block(K, this->Free, this->Fixed);
  const Sparse sideM = block(M, this->Free, this->Fixed);
  const double h = this->LayerHeight;

  // What layers 0 and L add to the right-hand sides of layers 1 and L - 1.
  const auto capLoad = [&](const Points& cap) -> Points {
    const Points load = M * (cap / h) - K * (cap * (h / 6.0));
    Points picked(static_cast<Index>(this->Free.size()), 3);
    for (std::size_t i = 0; i < this->Free.size(); ++i)
    {
      picked.row(static_cast<Index>(i)) = load.row(this->Free[i]);
    }
    return picked;
  };
  const Points bottomLoad = capLoad(values.topRows(n));
  const Points topLoad = capLoad(values.bottomRows(n));

  const Eigen::MatrixXd sine = sineMatrix(layers);
  const double scale = 2.0 / static_cast<double>(layers);
  const Eigen::MatrixXd sideModes = scale * (sine * gatherColumns(values, n, layers, this->Fixed));
  Eigen::MatrixXd modes =
    Eigen::MatrixXd::Zero(layers - 1, 3 * static_cast<Index>(this->Free.size()));

  Eigen::SimplicialLLT<Sparse> solver;
  Sparse matrix = freeK;
  solver.analyzePattern(matrix);
  const double pi = std::acos(-1.0);
  for (Index j = 1; j < layers; ++j)
  {
    reportProgress(progress, static_cast<double>(j - 1) / static_cast<double>(layers));
    const double cosine = std::cos(pi * static_cast<double>(j) / static_cast<double>(layers));
    const double massFactor = h / 3.0 * (2.0 + cosine);
    const double stiffnessFactor = 2.0 / h * (1.0 - cosine);

    const Points side = rowAsPoints(sideModes, j - 1);
    const Points load = sideK * (-massFactor * side) + sideM * (-stiffnessFactor * side) +
      scale * (sine(j - 1, 0) * bottomLoad + sine(j - 1, layers - 2) * topLoad);
    if (load.isZero(0.0))
    {
      continue;
    }
    // Same sparsity: stiffness and mass come from the same quads.
    matrix.coeffs() = massFactor * freeK.coeffs() + stiffnessFactor * freeM.coeffs();
    solver.factorize(matrix);
    if (solver.info() != Eigen::Success)
    {
      throw SolverFailure("the prism's Laplace equation could not be factorised (mode " +
        std::to_string(j) + "): the target quads may be collapsed.");
    }
    const Points solution = solver.solve(load);
    if (solver.info() != Eigen::Success || !solution.allFinite())
    {
      throw SolverFailure("the prism's Laplace equation could not be solved (mode " +
        std::to_string(j) + "): the target quads may be collapsed.");
    }
    modes.row(j - 1) = Eigen::Map<const Eigen::RowVectorXd>(solution.data(), solution.size());
  }

  const Eigen::MatrixXd inner = sine * modes;
  for (Index k = 1; k < layers; ++k)
  {
    for (std::size_t i = 0; i < this->Free.size(); ++i)
    {
      result.row(k * n + this->Free[i]) = inner.block<1, 3>(k - 1, 3 * static_cast<Index>(i));
    }
  }
  reportProgress(progress, 1.0);
  return result;
}
}

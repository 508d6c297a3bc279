// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/LayerModes.h"

#include "Core/Common/DenseAlgebra.h"
#include "Core/Common/Errors.h"

#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
void checkHeights(const Eigen::VectorXd& heights)
{
  if (heights.size() < 1)
  {
    throw InvalidInput("the number of layers must be at least 1.");
  }
  for (Index k = 0; k < heights.size(); ++k)
  {
    if (!(heights[k] > 0.0) || !std::isfinite(heights[k]))
    {
      throw InvalidInput("the height of layer " + std::to_string(k) +
        " must be positive: source and target coincide, or two rings do.");
    }
  }
}

/// L - 1 inner rows, all L + 1 columns.
Eigen::MatrixXd massOfInnerLayers(const Eigen::VectorXd& heights)
{
  const Index inner = heights.size() - 1;
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(inner, inner + 2);
  for (Index k = 0; k < inner; ++k)
  {
    mass(k, k) = heights[k] / 6.0;
    mass(k, k + 1) = (heights[k] + heights[k + 1]) / 3.0;
    mass(k, k + 2) = heights[k + 1] / 6.0;
  }
  return mass;
}

void setSines(Index layers, double height, LayerModes& modes)
{
  const double pi = std::acos(-1.0);
  for (Index j = 1; j < layers; ++j)
  {
    const double cosine = std::cos(pi * static_cast<double>(j) / static_cast<double>(layers));
    const double half = std::sin(0.5 * pi * static_cast<double>(j) / static_cast<double>(layers));
    const double mass = height / 3.0 * (2.0 + cosine);
    modes.eigenvalues[j - 1] = 4.0 / height * half * half / mass;
    const double scale = std::sqrt(2.0 / (static_cast<double>(layers) * mass));
    for (Index k = 1; k < layers; ++k)
    {
      // Reduced to one period, which keeps the argument and so its rounding error small.
      const Index phase = (j * k) % (2 * layers);
      modes.functions(k - 1, j - 1) =
        scale * std::sin(pi * static_cast<double>(phase) / static_cast<double>(layers));
    }
  }
}

void solveEigenproblem(
  const Eigen::VectorXd& heights, const Eigen::MatrixXd& mass, LayerModes& modes)
{
  const Index inner = heights.size() - 1;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(inner, inner);
  for (Index k = 0; k < inner; ++k)
  {
    stiffness(k, k) = 1.0 / heights[k] + 1.0 / heights[k + 1];
    if (k + 1 < inner)
    {
      stiffness(k, k + 1) = stiffness(k + 1, k) = -1.0 / heights[k + 1];
    }
  }
  GeneralizedAxes axes = generalizedAxes(stiffness, mass.middleCols(1, inner));
  if (axes.values.size() == 0 || !(axes.values.minCoeff() > 0.0))
  {
    throw SolverFailure("the modes of the layers could not be found: their heights differ by too "
                        "many orders of magnitude.");
  }
  modes.eigenvalues = std::move(axes.values);
  modes.functions = std::move(axes.vectors);
}
}

LayerModes layerModes(const Eigen::VectorXd& heights)
{
  checkHeights(heights);
  const Index layers = heights.size();
  const Index inner = layers - 1;
  LayerModes modes;
  modes.isSymmetric = (heights.array() == heights[0]).all();

  // In units of the mean height: squares of lengths neither under- nor overflow.
  const double unit = heights.mean();
  const Eigen::VectorXd scaled = heights / unit;
  modes.fractions = Eigen::VectorXd::Zero(layers + 1);
  for (Index k = 0; k < layers; ++k)
  {
    modes.fractions[k + 1] = modes.fractions[k] + scaled[k];
  }
  modes.fractions /= modes.fractions[layers];

  const Eigen::MatrixXd mass = massOfInnerLayers(scaled);
  modes.eigenvalues.resize(inner);
  modes.functions.resize(inner, inner);
  if (inner == 0)
  {
    return modes;
  }
  if (modes.isSymmetric)
  {
    setSines(layers, 1.0, modes);
  }
  else
  {
    solveEigenproblem(scaled, mass, modes);
  }
  modes.analysis = modes.functions.transpose() * mass.middleCols(1, inner);
  modes.lastLoad = modes.functions.transpose() * (mass * modes.fractions);
  modes.firstLoad = modes.functions.transpose() * (mass * (1.0 - modes.fractions.array()).matrix());
  // A mass is a length: functions are per square root of one.
  modes.eigenvalues /= unit * unit;
  modes.functions /= std::sqrt(unit);
  modes.analysis *= std::sqrt(unit);
  modes.firstLoad *= std::sqrt(unit);
  modes.lastLoad *= std::sqrt(unit);
  return modes;
}
}

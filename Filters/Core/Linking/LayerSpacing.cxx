// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/LayerSpacing.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr Index MostLayers = 1000000;
/// Of the whole: thinner layers have their nodes in one place, when coordinates are rounded.
constexpr double LeastThickness = 1e-14;
}

std::vector<double> layerFractions(Index layers, double growth, bool bothEnds)
{
  if (layers < 1 || layers > MostLayers)
  {
    throw InvalidInput("the number of layers is " + std::to_string(layers) +
      ". Set it to 1 or more, at most " + std::to_string(MostLayers) + ".");
  }
  if (!(growth > 0.0) || !std::isfinite(growth))
  {
    throw InvalidInput("the growth ratio is " + describe(growth) +
      ". It is the thickness of a layer over that of the layer before it: set it to a positive "
      "number, 1 for layers of equal thickness.");
  }
  std::vector<double> fractions(static_cast<std::size_t>(layers) + 1, 0.0);
  if (growth == 1.0)
  {
    for (Index k = 1; k < layers; ++k)
    {
      fractions[static_cast<std::size_t>(k)] = static_cast<double>(k) / static_cast<double>(layers);
    }
    fractions.back() = 1.0;
    return fractions;
  }
  const auto logThickness = [&](Index k) {
    return std::log(growth) * static_cast<double>(bothEnds ? std::min(k, layers - 1 - k) : k);
  };
  // Relative to the thickest layer, so that nothing overflows.
  const double thickest =
    std::max({ logThickness(0), logThickness(layers - 1), logThickness((layers - 1) / 2) });
  for (Index k = 0; k < layers; ++k)
  {
    fractions[static_cast<std::size_t>(k) + 1] =
      fractions[static_cast<std::size_t>(k)] + std::exp(logThickness(k) - thickest);
  }
  const double whole = fractions.back();
  for (double& fraction : fractions)
  {
    fraction /= whole;
  }
  for (std::size_t k = 1; k < fractions.size(); ++k)
  {
    if (!(fractions[k] - fractions[k - 1] > LeastThickness))
    {
      throw InvalidInput("with growth ratio " + describe(growth) + " layer " + std::to_string(k) +
        " of " + std::to_string(layers) +
        " has no thickness. Choose a ratio nearer to 1, or fewer layers.");
    }
  }
  return fractions;
}

std::vector<double> layerFractions(const std::vector<double>& positions)
{
  std::vector<double> fractions = { 0.0 };
  for (std::size_t k = 0; k < positions.size(); ++k)
  {
    if (!(positions[k] > fractions.back()) || !(positions[k] < 1.0))
    {
      throw InvalidInput("layer position " + std::to_string(k) + " is " + describe(positions[k]) +
        (k > 0 ? ", after " + describe(positions[k - 1]) : std::string()) +
        ". The positions are fractions of the way from source to target: make them rise strictly "
        "between 0 and 1.");
    }
    fractions.push_back(positions[k]);
  }
  fractions.push_back(1.0);
  return fractions;
}

Index layersOfSize(double length, double size)
{
  if (!(size > 0.0) || !std::isfinite(size))
  {
    throw InvalidInput("the layer size is " + describe(size) +
      ". Set it to a positive length, or use a number of layers instead.");
  }
  const double layers = std::max(1.0, std::round(length / size));
  if (!(layers <= static_cast<double>(MostLayers)))
  {
    throw InvalidInput("layers of size " + describe(size) + " on columns of length " +
      describe(length) + " would be more than " + std::to_string(MostLayers) +
      ". Choose a greater size; it is in the unit of the coordinates.");
  }
  return static_cast<Index>(layers);
}

double evenlySampled(const std::vector<double>& values, double place)
{
  const double scaled = place * static_cast<double>(values.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(scaled), values.size() - 2);
  const double along = scaled - static_cast<double>(below);
  return values[below] + along * (values[below + 1] - values[below]);
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepBestSweep.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Solids/SweepForecast.h"
#include "Core/Solids/SweepSize.h"
#include "HexSweepArrays.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
double meanOf(const BodyMesh& mesh)
{
  return mesh.hexes->GetFieldData()->GetArray(reports::MeanScaledJacobian)->GetTuple1(0);
}

/// The least and mean scaled Jacobian together: the least alone is that of one hexahedron. One that
/// is not positive counts nothing, untangling may change it.
double qualityOf(const BodyMesh& mesh)
{
  return std::max(0.0, leastOf(mesh)) + meanOf(mesh);
}

/// A sweep to be tried.
struct Trial
{
  const SweepTopology* topology;
  /// A mesh can have good hexahedra there only where it leaves the solid.
  bool hasTangentRims;
  /// Of a rough mesh: per cent of its hexahedra that are not certified, qualityOf(), and what its
  /// caps and sides allow.
  double bad = std::numeric_limits<double>::infinity();
  double quality = 0.0;
  double floor = 0.0;
  /// Why there is no mesh, or no certified one; empty: not known.
  std::string failure = std::string();
};

std::string nameOf(const Trial& trial)
{
  return describeWay(trial.topology->sourceFaceIds, trial.topology->targetFaceIds);
}

/// Runs some work. @return why it failed; empty where it did not.
std::string failureOf(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  catch (const SolverFailure& error)
  {
    return error.what();
  }
  return {};
}

void tryRoughly(const Sweep& roughly, Trial& trial)
{
  constexpr double Mended = 0.01; // a share that untangling deals with
  const std::string failure = failureOf([&] {
    BodyMesh mesh;
    roughly(*trial.topology, mesh);
    trial.bad =
      std::round(badHexes(mesh) / (Mended * static_cast<double>(mesh.hexes->GetNumberOfCells())));
    trial.quality = qualityOf(mesh);
    trial.floor = mesh.hexes->GetFieldData()->GetArray(reports::FloorScaledJacobian)->GetTuple1(0);
  });
  trial.failure = failure.empty() ? "" : " (meshed roughly): " + failure;
}

/// Those worth more first, by a rough mesh of each; the first in the choice of those that are worth
/// nearly as much as the best one.
std::vector<const Trial*> inOrder(const std::vector<Trial>& trials)
{
  constexpr double Noticed = 0.02; // of the quality
  std::vector<const Trial*> order;
  for (const Trial& trial : trials)
  {
    order.push_back(&trial);
  }
  const auto grave = [](const Trial& trial) {
    return std::make_pair(trial.hasTangentRims, trial.bad);
  };
  std::stable_sort(order.begin(), order.end(), [&](const Trial* a, const Trial* b) {
    return std::make_pair(grave(*a), -a->quality) < std::make_pair(grave(*b), -b->quality);
  });
  const Trial& best = *order.front();
  const auto first =
    std::min_element(order.begin(), order.end(), [&](const Trial* a, const Trial* b) {
      const auto isNear = [&](const Trial& trial) {
        return grave(trial) == grave(best) && trial.quality >= best.quality - Noticed;
      };
      return std::make_pair(!isNear(*a), a) < std::make_pair(!isNear(*b), b);
    });
  std::rotate(order.begin(), first, first + 1);
  return order;
}

/// What went wrong with the first so many.
std::string failuresOf(const std::vector<Trial>& trials, std::size_t count)
{
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
  {
    text += trials[i].failure.empty() ? "" : " " + nameOf(trials[i]) + trials[i].failure;
  }
  return text;
}

/// Makes the layers that are asked for few enough. @return their number; 0: it follows the size.
double thinLayers(double length, LayerRequest& layers)
{
  constexpr std::size_t Most = 50;
  if (!layers.positions.empty())
  {
    const std::size_t stride = layers.positions.size() / Most + 1;
    std::vector<double> kept;
    for (std::size_t i = stride - 1; i < layers.positions.size(); i += stride)
    {
      kept.push_back(layers.positions[i]);
    }
    layers.positions = std::move(kept);
    return static_cast<double>(layers.positions.size() + 1);
  }
  if (layers.size > 0.0)
  {
    layers.size = std::max(layers.size, length / static_cast<double>(Most));
    return std::max(1.0, length / layers.size);
  }
  layers.layers = std::min(layers.layers, static_cast<Index>(Most));
  return static_cast<double>(layers.layers);
}

}

double badHexes(const BodyMesh& mesh)
{
  const auto count = [&](const char* report) {
    return mesh.hexes->GetFieldData()->GetArray(report)->GetTuple1(0);
  };
  const double bad = count(reports::NotCertified);
  // Where nobody asked for certificates no hexahedron has one, and those that are not inverted
  // are undecided.
  return bad == count(reports::Hexes) ? bad - count(reports::Undecided) : bad;
}

double leastOf(const BodyMesh& mesh)
{
  return mesh.hexes->GetFieldData()->GetArray(reports::MinScaledJacobian)->GetTuple1(0);
}

bool isBetter(const BodyMesh& mesh, const BodyMesh& other)
{
  return badHexes(mesh) != badHexes(other) ? badHexes(mesh) < badHexes(other)
                                           : qualityOf(mesh) > qualityOf(other);
}

SolidSweepSettings roughSettings(
  const SolidSurface& surface, const SweepTopology& topology, const SolidSweepSettings& settings)
{
  constexpr Index MostHexes = 20000;
  constexpr double Most = MostHexes;
  SolidSweepSettings rough = settings;
  rough.mostHexes = MostHexes;
  rough.moveBoundaryNodes = false;
  rough.hexes.ensureValid = false;
  rough.hexes.improveQuality = false;
  rough.hexes.isTrial = true;
  rough.hexes.certify = true;
  rough.hexes.failIfInvalid = false;
  const double wanted = settings.quadSize > 0.0 ? settings.quadSize : settings.size;
  const double length = sideLength(surface, topology);
  if (!(wanted >= 0.0) || !std::isfinite(wanted) || !(length > 0.0))
  {
    return rough; // is refused
  }
  const double layers = thinLayers(length, rough.layers);
  if (layers > 0.0)
  {
    const double least = std::sqrt(expectedQuads(surface, topology, 1.0) * layers / Most);
    rough.quadSize = std::max(wanted, least);
  }
  else if (wanted > 0.0)
  {
    const double quads = expectedQuads(surface, topology, wanted);
    const double high = length / (settings.size > 0.0 ? settings.size : wanted);
    const double share = quads * std::max(1.0, high) / Most;
    // Where one layer is left, quads alone can be fewer.
    const double factor =
      std::max(1.0, std::max(std::cbrt(share), std::sqrt(share / std::max(1.0, high))));
    rough.size *= factor;
    rough.quadSize *= factor;
  }
  return rough;
}

std::vector<std::string> bestOfSweeps(const SolidSurface& surface, const SweepChoice& choice,
  const Sweep& sweep, const Sweep& roughly, BodyMesh& best)
{
  std::vector<Trial> trials;
  for (const SweepTopology& topology : choice.sweeps)
  {
    trials.push_back({ &topology, !forecastSweep(surface, topology).tangentRims.empty() });
    if (choice.sweeps.size() > 1)
    {
      tryRoughly(roughly, trials.back());
    }
  }
  std::vector<std::string> warnings;
  std::optional<std::size_t> taken;
  bool valid = false;
  for (const Trial* next : inOrder(trials))
  {
    const auto place = static_cast<std::size_t>(next - trials.data());
    Trial& trial = trials[place];
    const double wanted = trial.hasTangentRims ? 0.0 : std::min(LowScaledJacobian, trial.floor);
    if (valid && leastOf(best) >= wanted)
    {
      continue;
    }
    const std::string failure = failureOf([&] {
      BodyMesh mesh;
      SolidSweepResult result = sweep(*trial.topology, mesh);
      trial.failure = result.valid
        ? ""
        : " has " + describe(badHexes(mesh)) + " hexahedra that are not certified.";
      if (!taken || isBetter(mesh, best))
      {
        best = std::move(mesh);
        warnings = std::move(result.warnings);
        taken = place;
      }
      valid = valid || result.valid;
    });
    if (!failure.empty())
    {
      trial.failure = ": " + failure;
    }
  }
  if (!taken)
  {
    throw InvalidInput("no source face is named, and of the sweeps that look best none works:" +
      failuresOf(trials, trials.size()) +
      " Name SourceFaceIds and TargetFaceIds if another sweep is meant.");
  }
  const std::string failed = failuresOf(trials, *taken);
  if (!failed.empty())
  {
    warnings.insert(warnings.begin(),
      "no source face is named, and this is the sweep " + nameOf(trials[*taken]) +
        ", since others that looked better did not work:" + failed +
        " Name SourceFaceIds if another sweep is meant.");
  }
  return warnings;
}
}

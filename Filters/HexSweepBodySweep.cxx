// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepBodySweep.h"

#include "Core/Common/Describe.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Solids/SweepChoice.h"
#include "Core/Solids/SweepForecast.h"
#include "Core/Solids/SweepSize.h"
#include "HexSweepAppend.h"
#include "HexSweepArrays.h"
#include "HexSweepReader.h"
#include "HexSweepStackSweep.h"
#include "HexSweepWriter.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
/// A sweep whose least scaled Jacobian is below this is not the last word.
constexpr double LowScaledJacobian = 0.2;

using Sweep = std::function<SolidSweepResult(const SweepTopology& topology, BodyMesh& mesh)>;

double badHexes(const BodyMesh& mesh)
{
  return mesh.hexes->GetFieldData()->GetArray(reports::NotCertified)->GetTuple1(0);
}

double meanOf(const BodyMesh& mesh)
{
  return mesh.hexes->GetFieldData()->GetArray(reports::MeanScaledJacobian)->GetTuple1(0);
}

double leastOf(const BodyMesh& mesh)
{
  return mesh.hexes->GetFieldData()->GetArray(reports::MinScaledJacobian)->GetTuple1(0);
}

/// The least and mean scaled Jacobian together: the least alone is that of one hexahedron. One that
/// is not positive counts nothing, untangling may change it.
double qualityOf(const BodyMesh& mesh)
{
  return std::max(0.0, leastOf(mesh)) + meanOf(mesh);
}

bool isBetter(const BodyMesh& mesh, const BodyMesh& other)
{
  return badHexes(mesh) != badHexes(other) ? badHexes(mesh) < badHexes(other)
                                           : qualityOf(mesh) > qualityOf(other);
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
  std::string failure =
    std::string(); ///< why there is no mesh, or no certified one; empty: not known
};

std::string nameOf(const Trial& trial)
{
  return describeWay(trial.topology->sourceFaceIds, trial.topology->targetFaceIds);
}

void tryRoughly(const Sweep& roughly, Trial& trial)
{
  constexpr double Mended = 0.01; // a share that untangling deals with
  try
  {
    BodyMesh mesh;
    roughly(*trial.topology, mesh);
    trial.bad =
      std::round(badHexes(mesh) / (Mended * static_cast<double>(mesh.hexes->GetNumberOfCells())));
    trial.quality = qualityOf(mesh);
    trial.floor = mesh.hexes->GetFieldData()->GetArray(reports::FloorScaledJacobian)->GetTuple1(0);
  }
  catch (const InvalidInput& error)
  {
    trial.failure = std::string(" (meshed roughly): ") + error.what();
  }
  catch (const SolverFailure& error)
  {
    trial.failure = std::string(" (meshed roughly): ") + error.what();
  }
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

/**
 * Tries one sweep after the other until one gives a valid mesh; where its least scaled Jacobian is
 * low, those that may have a higher one as well. The best is taken.
 *
 * @return what to tell the user.
 * @throw InvalidInput when none gives a mesh.
 */
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
    try
    {
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
    }
    catch (const InvalidInput& error)
    {
      trial.failure = std::string(": ") + error.what();
    }
    catch (const SolverFailure& error)
    {
      trial.failure = std::string(": ") + error.what();
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

/// Of a mesh that tells what a sweep is worth: as fine as asked for up to some thousand hexahedra.
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

/// Sweeps one body between two caps. @return what to tell the user, with places of the body.
std::vector<std::string> sweepBetweenTwo(const SolidToSweep& solid, NamedCaps named,
  const SolidSweepSettings& settings, StageClock& stages, const Progress& progress, BodyMesh& mesh)
{
  SolidSweepSettings own = settings;
  own.targetIsNamed = !named.targetFaceIds.empty();
  const SolidSurface& surface = solid.body.surface;
  const std::optional<QuadMesh> quads = readOptionalQuads(solid.sourceQuads, "source quads");
  if (quads && named.sourceFaceIds.empty())
  {
    named.sourceFaceIds =
      facesUnder(surface, { reflected(quads->points, solid.body.solid.reflection), quads->quads });
  }
  const SweepChoice choice = chooseSweeps(surface, named.sourceFaceIds, named.targetFaceIds);
  stages.finish("Topology");
  reportProgress(progress, 0.03);

  const Sweep sweep = [&](const SweepTopology& topology, BodyMesh& made) {
    return sweepSolid(
      solid, topology, own, stages, progressPart(progress, 0.03, 1.0), made.hexes, made.boundary);
  };
  const Sweep roughly = [&](const SweepTopology& topology, BodyMesh& made) {
    return sweepSolid(solid, topology, roughSettings(surface, topology, own), stages,
      progressPart(progress, 0.03, 0.03), made.hexes, made.boundary);
  };
  const bool isNamed = !named.sourceFaceIds.empty() || !named.targetFaceIds.empty();
  if (isNamed)
  {
    const SweepForecast forecast = forecastSweep(surface, choice.sweeps.front());
    if (!forecast.shoulder.empty() && own.hexes.ensureValid)
    {
      // It would be fought for in vain, and long.
      throw InvalidInput(forecast.shoulder + " Switch EnsureValid off to sweep it all the same.");
    }
    for (const std::string& text : { forecast.shoulder, forecast.tangentRims })
    {
      if (settings.tell && !text.empty())
      {
        settings.tell(messageAbout(solid.body, text));
      }
    }
  }
  std::vector<std::string> warnings = !isNamed ? bestOfSweeps(surface, choice, sweep, roughly, mesh)
                                               : sweep(choice.sweeps.front(), mesh).warnings;
  std::vector<std::string> ranking;
  for (const std::string& line : describeRanking(choice.ranking))
  {
    ranking.push_back(messageAbout(solid.body, line));
  }
  addReport(mesh.hexes->GetFieldData(), reports::Candidates, ranking);
  return warnings;
}

/// Where a sweep between two caps failed (no cells) or has low hexahedra: the same by columns, if
/// that is better. @return whether it was taken.
bool replaceByColumns(const SolidToSweep& solid, const SolidSweepSettings& settings,
  StageClock& stages, const Progress& progress, BodyMesh& mesh, std::vector<std::string>& warnings)
{
  const bool failed = mesh.hexes->GetNumberOfCells() == 0;
  if (!failed && badHexes(mesh) == 0.0 && leastOf(mesh) >= LowScaledJacobian)
  {
    return false;
  }
  const std::optional<StackWay> way = plainWay(solid.body, *settings.stacks);
  if (!way)
  {
    return false;
  }
  try
  {
    BodyMesh columns;
    std::vector<std::string> own =
      sweepSeveralCaps(solid, *way, settings, stages, progress, columns);
    if (failed || isBetter(columns, mesh))
    {
      mesh = std::move(columns);
      warnings = std::move(own);
      return true;
    }
  }
  catch (const InvalidInput&)
  {
    // The sweep between two caps says what is wrong.
  }
  return false;
}

/// Sweeps one body. @return what to tell the user, with places of the body.
std::vector<std::string> sweepBody(const SolidToSweep& solid, const NamedCaps& named,
  const SolidSweepSettings& settings, StageClock& stages, const Progress& progress, BodyMesh& mesh)
{
  if (!settings.stacks)
  {
    return sweepBetweenTwo(solid, named, settings, stages, progress, mesh);
  }
  const std::optional<StackWay> way = severalCaps(solid.body, *settings.stacks);
  stages.finish("Topology");
  if (way)
  {
    return sweepSeveralCaps(solid, *way, settings, stages, progress, mesh);
  }
  const auto refusal = [&] { return whyNoSeveralCaps(solid.body, *settings.stacks); };
  const Progress first = progressPart(progress, 0.0, 0.8);
  const Progress second = progressPart(progress, 0.8, 1.0);
  std::vector<std::string> warnings;
  try
  {
    warnings = sweepBetweenTwo(solid, named, settings, stages, first, mesh);
  }
  catch (const InvalidInput& error)
  {
    mesh = BodyMesh();
    if (replaceByColumns(solid, settings, stages, second, mesh, warnings))
    {
      return warnings;
    }
    const std::string several = refusal();
    throw InvalidInput(several.empty() ? std::string(error.what())
                                       : "the solid has no sweep between several caps: " + several +
          " Nor is there one between two: " + error.what());
  }
  if (!replaceByColumns(solid, settings, stages, second, mesh, warnings) && badHexes(mesh) > 0.0)
  {
    const std::string several = refusal();
    if (!several.empty())
    {
      warnings.push_back("there is no sweep between several caps instead: " + several);
    }
  }
  return warnings;
}

void checkSeveral(const BodiesToSweep& solid, const NamedCaps& named)
{
  if (solid.sourceQuads)
  {
    throw InvalidInput("source quads are given, and the solid has " +
      countOf(solid.bodies.size(), "volume") +
      ". Name the one that they lie on (VolumeIds), or give none.");
  }
  checkNamedFaces(solid.bodies, named.sourceFaceIds);
  checkNamedFaces(solid.bodies, named.targetFaceIds);
}

[[noreturn]] void failOnBodies(
  const std::vector<Index>& swept, const std::vector<std::string>& problems)
{
  constexpr std::size_t Shown = 3;
  std::string text = countOf(problems.size(), "volume") + " of the solid cannot be swept";
  text += swept.empty()
    ? ":"
    : ", those that can are " + listIds(swept) + " (set VolumeIds to sweep them alone):";
  for (std::size_t i = 0; i < std::min(Shown, problems.size()); ++i)
  {
    text += " " + problems[i];
  }
  throw InvalidInput(text + (problems.size() > Shown ? " ..." : ""));
}

std::vector<std::string> sweepSeveral(const BodiesToSweep& solid, const NamedCaps& named,
  const SolidSweepSettings& settings, StageClock& stages, const Progress& progress,
  std::vector<BodyMesh>& meshes)
{
  checkSeveral(solid, named);
  std::vector<std::string> warnings;
  std::vector<std::string> problems;
  std::vector<Index> swept;
  const auto count = static_cast<double>(solid.bodies.size());
  for (std::size_t b = 0; b < solid.bodies.size(); ++b)
  {
    const ReadBody& body = solid.bodies[b];
    if (!body.problem.empty())
    {
      problems.push_back(body.problem);
      continue;
    }
    const auto begin = static_cast<double>(b);
    const NamedCaps own{ facesOnBody(body, named.sourceFaceIds),
      facesOnBody(body, named.targetFaceIds) };
    try
    {
      BodyMesh mesh;
      for (const std::string& warning : sweepBody({ solid.data, nullptr, body }, own, settings,
             stages, progressPart(progress, begin / count, (begin + 1.0) / count), mesh))
      {
        warnings.push_back(messageAbout(body, warning));
      }
      meshes.push_back(std::move(mesh));
      swept.push_back(body.volumeId);
    }
    catch (const InvalidInput& error)
    {
      problems.push_back(messageAbout(body, error.what()));
    }
    catch (const SolverFailure& error)
    {
      problems.push_back(messageAbout(body, error.what()));
    }
  }
  if (!problems.empty())
  {
    failOnBodies(swept, problems);
  }
  return warnings;
}
}

std::vector<std::string> sweepBodies(const BodiesToSweep& solid, const NamedCaps& named,
  const SolidSweepSettings& settings, StageClock& stages, const Progress& progress,
  vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary)
{
  if (solid.bodies.size() > 1)
  {
    std::vector<BodyMesh> meshes;
    std::vector<std::string> warnings =
      sweepSeveral(solid, named, settings, stages, progress, meshes);
    appendBodies(meshes, hexes, boundary);
    std::vector<Index> volumeIds;
    for (const ReadBody& body : solid.bodies)
    {
      volumeIds.push_back(body.volumeId);
    }
    addIds(hexes->GetFieldData(), reports::VolumeIds, volumeIds);
    return warnings;
  }
  const ReadBody& body = solid.bodies.front();
  BodyMesh mesh;
  std::vector<std::string> warnings = aboutBody(body, [&] {
    return sweepBody(
      { solid.data, solid.sourceQuads, body }, named, settings, stages, progress, mesh);
  });
  for (std::string& warning : warnings)
  {
    warning = messageAbout(body, warning);
  }
  hexes->ShallowCopy(mesh.hexes);
  boundary->ShallowCopy(mesh.boundary);
  return warnings;
}
}

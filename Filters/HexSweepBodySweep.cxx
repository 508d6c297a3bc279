// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepBodySweep.h"

#include "Core/Common/Describe.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Solids/SweepChoice.h"
#include "Core/Solids/SweepForecast.h"
#include "HexSweepAppend.h"
#include "HexSweepArrays.h"
#include "HexSweepBestSweep.h"
#include "HexSweepReader.h"
#include "HexSweepStackSweep.h"
#include "HexSweepWriter.h"

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
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

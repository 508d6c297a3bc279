// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepStackSweep.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Describe.h"
#include "Core/Hexahedra/HexUntangling.h"
#include "Core/Stacks/StackSweep.h"
#include "HexSweepArrays.h"
#include "HexSweepAsking.h"
#include "HexSweepFineBody.h"
#include "HexSweepHexText.h"
#include "HexSweepQualityArrays.h"
#include "HexSweepRun.h"
#include "HexSweepSolidPort.h"
#include "HexSweepStackGrid.h"
#include "HexSweepVolumeId.h"
#include "HexSweepWriter.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
double draftOf(const StackSweepSettings& settings)
{
  if (!(settings.draftAngle >= 0.0 && settings.draftAngle <= 30.0))
  {
    throw InvalidInput("the draft angle is " + describe(settings.draftAngle) +
      " degrees. Set DraftAngle to 0 to 30.");
  }
  return settings.draftAngle * Pi / 180.0;
}

/// Of the body where it was put; nothing: it is to be found.
std::optional<Eigen::RowVector3d> givenDirection(
  const ReadBody& body, const StackSweepSettings& settings)
{
  const Eigen::RowVector3d& direction = settings.direction;
  if (!direction.allFinite())
  {
    throw InvalidInput("the sweep direction is not finite. Set SweepDirection to a vector, or to "
                       "(0, 0, 0) for one that is found.");
  }
  if (direction.isZero(0.0))
  {
    return std::nullopt;
  }
  return direction.normalized().cwiseProduct(body.solid.reflection.signs);
}

/// @throw InvalidInput where faces were picked that are no caps, or at the other end.
void requirePicked(const StackSweepSettings& settings, const CapLikeFaces& faces, const char* way)
{
  if (!areAtTheirEnds(settings.picked, faces))
  {
    throw InvalidInput("the given " + std::string(way) + " does not have " +
      describePicked(settings.picked) +
      ". Pick caps at its ends, turn it round, or set it to 0, for one that is found.");
  }
}

/// The same the other way round.
std::optional<RevolvedStack> turnedRound(
  const SolidSurface& surface, const RevolutionAxis& axis, double draft)
{
  return revolvedStack(surface, { axis.point, -axis.direction }, draft);
}

StackOptions stackOptions(
  const SolidToSweep& solid, const SolidSweepSettings& settings, const Progress& progress)
{
  StackOptions options;
  options.size = settings.size;
  const LayerRequest& layers = settings.layers;
  options.layerSize = layers.size;
  options.layers = layers.size > 0.0 ? 0 : layers.layers;
  options.imprintTolerance = settings.stacks->imprintTolerance;
  options.chordTolerance = settings.chordTolerance;
  options.ensureValid = settings.hexes.ensureValid;
  options.improveQuality = settings.hexes.improveQuality;
  options.geometry = solid.body.geometry.get();
  options.parallelFor = askingFor(progress);
  return options;
}

/// The facets between which hexahedra are made: straight, whatever the sweep is.
struct StackFacets
{
  SolidSurface surface;
  CapLikeFaces faces;
  std::optional<RevolvedSpace> space;
};

/// @return nothing where faces of these facets are in the way.
std::optional<StackFacets> facetsOf(
  const SolidSurface& surface, const StackWay& way, const StackSweepSettings& settings)
{
  const double draft = draftOf(settings);
  StackFacets facets;
  if (!way.revolved)
  {
    facets.surface = surface;
    facets.faces = capLikeFaces(surface, way.faces.direction, draft);
  }
  else
  {
    std::optional<RevolvedStack> stack = revolvedStack(surface, *way.revolved, draft);
    if (!stack)
    {
      return std::nullopt;
    }
    facets.surface = std::move(stack->straight);
    facets.faces = std::move(stack->faces);
    facets.space = stack->space;
  }
  return facets.faces.isStack() ? std::optional<StackFacets>(std::move(facets)) : std::nullopt;
}

/// The body, as finely divided as the hexahedra ask for, where its geometry is known.
std::optional<StackFacets> finerFacets(const SolidToSweep& solid, const StackFacets& coarse,
  const StackWay& way, const SolidSweepSettings& settings, const Progress& progress)
{
  if (!solid.body.geometry || solid.body.solid.input.quads.rows() > 0)
  {
    return std::nullopt;
  }
  const double size =
    settings.size > 0.0 ? settings.size : chosenStackSize(coarse.surface, coarse.faces);
  const std::optional<ReadBody> body =
    refinedBody(solid.body, size, settings.chordTolerance, true, progress);
  return body ? facetsOf(body->surface, way, *settings.stacks) : std::nullopt;
}

void addStackReports(const StackMesh& mesh, const StackFacets& facets, const Reflection& reflection,
  vtkFieldData* fieldData)
{
  addReport(fieldData, reports::Method, mesh.method);
  std::vector<Index> bottoms;
  std::vector<Index> tops;
  for (const StackFace& face : facets.faces.faces)
  {
    if (face.kind == StackFaceKind::Bottom)
    {
      bottoms.push_back(face.id);
    }
    if (face.kind == StackFaceKind::Top)
    {
      tops.push_back(face.id);
    }
  }
  addReport(fieldData, reports::SourceQuads, std::string("made"));
  addIds(fieldData, reports::SourceFaceIds, bottoms);
  addIds(fieldData, reports::TargetFaceIds, tops);
  addReport(fieldData, reports::Size, mesh.size);
  addReport(fieldData, reports::InvertedQuads, mesh.invertedQuads);
  const auto given = [&](const Eigen::RowVector3d& vector) {
    const Eigen::RowVector3d back = vector.cwiseProduct(reflection.signs);
    return std::vector<double>(back.data(), back.data() + 3);
  };
  if (facets.space)
  {
    addReport(fieldData, reports::SweepAxisPoint, given(facets.space->axis().point));
    addReport(fieldData, reports::SweepAxisDirection, given(facets.space->axis().direction));
  }
  else
  {
    addReport(fieldData, reports::SweepDirection, given(facets.faces.direction));
  }
  addReport(fieldData, reports::Regions, mesh.regions);
  addReport(fieldData, reports::Levels, mesh.levels);
  addReport(fieldData, reports::GreatestImprint, mesh.greatestGap);
}

/// What to tell about bad hexahedra. @throw InvalidInput with failIfInvalid.
std::vector<std::string> verdicts(const StackMesh& mesh, const HexOutputSettings& settings)
{
  const HexQualitySummary summary = summarize(mesh.qualities);
  const JudgedHexes judged = { summary, mesh.hexes.rows(),
    [&](Index h) { return mesh.qualities[static_cast<std::size_t>(h)]; },
    [&](Index h) {
      HexCorners places;
      for (int c = 0; c < 8; ++c)
      {
        places.row(c) = mesh.points.row(mesh.hexes(h, c));
      }
      return places;
    } };
  const std::string advice =
    "set Size to another length, ImprintTolerance to another value, or cut "
    "the part into pieces there";
  std::vector<std::string> warnings;
  if (summary.inverted + summary.degenerate > 0)
  {
    warnings.push_back(describeInverted(judged, advice));
    if (settings.failIfInvalid)
    {
      throw InvalidInput(warnings.back());
    }
  }
  if (summary.undecided > 0)
  {
    warnings.push_back(describeUndecided(judged, advice));
  }
  return warnings;
}

void writeStack(const SolidToSweep& solid, const StackMesh& mesh, const StackFacets& facets,
  const HexOutputSettings& settings, BodyMesh& output)
{
  const Reflection& reflection = solid.body.solid.reflection;
  writeStackGrid(mesh, reflection, settings.precision, output.hexes);
  writeStackBoundary(mesh, reflection, output.hexes, output.boundary);
  if (solid.body.name.empty())
  {
    carryVolumeId(solid.data, output.hexes);
  }
  else
  {
    setVolumeId(solid.body.volumeId, output.hexes);
    setVolumeId(solid.body.volumeId, output.boundary);
  }
  passSolidFields(solid.data, output.hexes->GetFieldData());
  passSolidFields(solid.data, output.boundary->GetFieldData());
  QualityArrays arrays(static_cast<vtkIdType>(mesh.qualities.size()));
  for (std::size_t h = 0; h < mesh.qualities.size(); ++h)
  {
    arrays.set(static_cast<vtkIdType>(h), mesh.qualities[h]);
  }
  arrays.addTo(output.hexes->GetCellData());
  output.hexes->GetCellData()->SetActiveScalars(arrays::ScaledJacobian);
  vtkFieldData* fieldData = output.hexes->GetFieldData();
  addQualityReport(fieldData, summarize(mesh.qualities));
  addStackReports(mesh, facets, reflection, fieldData);
  addReport(fieldData, reports::MergedPoints, solid.body.surface.mergedPoints);
  addReport(fieldData, reports::FlippedTriangles, solid.body.surface.flippedTriangles);
  if (solid.body.geometry)
  {
    addReport(fieldData, reports::SnappedNodes, mesh.snapped);
    addReport(fieldData, reports::UnsnappedNodes, mesh.unsnapped);
  }
}
}

std::optional<StackWay> severalCaps(const ReadBody& body, const StackSweepSettings& settings)
{
  const double draft = draftOf(settings);
  const Eigen::RowVector3d& signs = body.solid.reflection.signs;
  if (!settings.axisDirection.isZero(0.0))
  {
    const RevolutionAxis axis{ settings.axisPoint.cwiseProduct(signs),
      settings.axisDirection.cwiseProduct(signs) };
    std::optional<RevolvedStack> stack = revolvedStack(body.surface, axis, draft);
    if (!stack)
    {
      throw InvalidInput("the solid reaches the axis, or closes round it. Set Axis to a line that "
                         "it does not reach, and leave out some degrees round it.");
    }
    if (!stack->faces.isStack())
    {
      throw InvalidInput("round the axis " + describeRefusedFaces(stack->faces));
    }
    requirePicked(settings, stack->faces, "axis");
    return StackWay{ std::move(stack->faces), axis };
  }
  if (const auto direction = givenDirection(body, settings))
  {
    CapLikeFaces faces = capLikeFaces(body.surface, *direction, draft);
    if (!faces.isStack())
    {
      throw InvalidInput(describeRefusedFaces(faces));
    }
    requirePicked(settings, faces, "direction");
    return StackWay{ std::move(faces), std::nullopt };
  }
  std::vector<CapLikeFaces> ways = pickedDirections(body.surface, settings.picked, draft);
  if (!ways.empty() && ways.front().isStack())
  {
    return ways.front().isPlain()
      ? std::nullopt
      : std::optional<StackWay>(StackWay{ std::move(ways.front()), std::nullopt });
  }
  std::optional<RevolvedStack> stack = findRevolvedStack(body.surface, draft);
  if (stack && !areAtTheirEnds(settings.picked, stack->faces))
  {
    stack = turnedRound(body.surface, stack->space.axis(), draft);
  }
  if (!stack || stack->faces.isPlain() || !areAtTheirEnds(settings.picked, stack->faces))
  {
    return std::nullopt;
  }
  return StackWay{ std::move(stack->faces), stack->space.axis() };
}

std::optional<StackWay> plainWay(const ReadBody& body, const StackSweepSettings& settings)
{
  std::vector<CapLikeFaces> ways =
    pickedDirections(body.surface, settings.picked, draftOf(settings));
  if (ways.empty() || !ways.front().isStack())
  {
    return std::nullopt;
  }
  return StackWay{ std::move(ways.front()), std::nullopt };
}

std::string whyNoSeveralCaps(const ReadBody& body, const StackSweepSettings& settings)
{
  const std::vector<CapLikeFaces> ways =
    pickedDirections(body.surface, settings.picked, draftOf(settings));
  const std::string picked = describePicked(settings.picked);
  if (ways.empty())
  {
    return picked.empty() ? "there is no direction along which the solid has caps at both ends."
                          : "there is no direction with " + picked + ". Pick others, or none.";
  }
  return ways.front().isStack() ? std::string() : describeRefusedFaces(ways.front());
}

std::vector<std::string> sweepSeveralCaps(const SolidToSweep& solid, const StackWay& way,
  const SolidSweepSettings& settings, StageClock& stages, const Progress& progress, BodyMesh& mesh)
{
  std::optional<StackFacets> facets = facetsOf(solid.body.surface, way, *settings.stacks);
  if (!facets)
  {
    throw InvalidInput(describeRefusedFaces(way.faces));
  }
  std::optional<StackFacets> finer =
    finerFacets(solid, *facets, way, settings, progressPart(progress, 0.0, 0.05));
  if (finer)
  {
    facets = std::move(finer);
  }
  stages.finish("Facets");
  StackOptions options = stackOptions(solid, settings, progress);
  if (facets->space)
  {
    // The true surfaces are where the solid is bent.
    options.geometry = nullptr;
    options.toSpace = [&](const PointsRef& points) { return facets->space->revolved(points); };
  }
  StackMesh made =
    sweepStack(facets->surface, facets->faces, options, progressPart(progress, 0.05, 0.95));
  stages.finish(made.stages);
  if (settings.hexes.precision == vtkAlgorithm::SINGLE_PRECISION)
  {
    made.points = stored(made.points, Precision::Single);
    made.qualities = hexQualities(made.points, made.hexes, true, smpFor());
  }
  std::vector<std::string> warnings = std::move(made.warnings);
  const std::vector<std::string> more = verdicts(made, settings.hexes);
  warnings.insert(warnings.end(), more.begin(), more.end());
  const LayerRequest& layers = settings.layers;
  if (!layers.positions.empty() || layers.growth != 1.0)
  {
    warnings.push_back("layers of a sweep between several caps are evenly thick between two caps: "
                       "positions and growth are left aside.");
  }
  if (made.unsnapped > 0)
  {
    warnings.push_back(std::to_string(made.unsnapped) +
      " columns of nodes are not on the CAD surfaces: no place on them is near, or hexahedra would "
      "be turned over there. Set Size to a smaller length.");
  }
  writeStack(solid, made, *facets, settings.hexes, mesh);
  stages.finish("Output");
  return warnings;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepSolidSweep.h"

#include "Core/Common/Describe.h"
#include "Core/Solids/BoundarySliding.h"
#include "Core/Solids/FaceQuads.h"
#include "Core/Solids/FoundTarget.h"
#include "Core/Solids/GeometrySnap.h"
#include "Core/Solids/HinderingEdges.h"
#include "Core/Solids/SideDeviation.h"
#include "Core/Solids/SolidCage.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Solids/SourceQuads.h"
#include "Core/Solids/SweepSize.h"
#include "HexSweepArrays.h"
#include "HexSweepAsking.h"
#include "HexSweepBoundaryGrid.h"
#include "HexSweepCapDiskGrid.h"
#include "HexSweepChoices.h"
#include "HexSweepFineBody.h"
#include "HexSweepLinkingReport.h"
#include "HexSweepRun.h"
#include "HexSweepSolidPort.h"
#include "HexSweepSolidQuads.h"
#include "HexSweepVolumeId.h"
#include "HexSweepWriter.h"

#include <vtkAlgorithm.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
void addReports(const SolidCage& cage, const SolidSurface& solid, const SweepTopology& topology,
  const std::string& quadsFrom, vtkFieldData* fieldData)
{
  addReport(fieldData, reports::SourceQuads, quadsFrom);
  addIds(fieldData, reports::SourceFaceIds, topology.sourceFaceIds);
  addIds(fieldData, reports::TargetFaceIds, topology.targetFaceIds);
  addReport(fieldData, reports::MergedPoints, solid.mergedPoints);
  addReport(fieldData, reports::FlippedTriangles, solid.flippedTriangles);
  addLinkingReport(fieldData, cage.linking);
  addReport(fieldData, reports::InvertedQuads, cage.projection.quality.inverted);
  addReport(fieldData, reports::MaximumSourceDistance, cage.greatestDistance);
  addReport(
    fieldData, reports::MaximumSideDistance, greatestSideDistance(cage, solid, topology, smpFor()));
}

void addSnapReport(const GeometrySnap& snap, vtkFieldData* fieldData)
{
  addReport(fieldData, reports::SnappedNodes, snap.moved);
  addReport(fieldData, reports::UnsnappedNodes, snap.left);
  addReport(fieldData, reports::GreatestSnap, snap.greatestMove);
}

/// Empty where all nodes are on the geometry.
std::string snapWarning(const GeometrySnap& snap)
{
  return snap.left == 0 ? std::string()
                        : std::to_string(snap.left) +
      " nodes of the boundary are not on the CAD surfaces: no place on them is near, or quads "
      "would "
      "be turned over there. Set Size to a smaller length.";
}

/// Quads of the source cap, and the layers that go with them.
struct SizedQuads
{
  SourceCapQuads quads;
  LayerRequest layers;
  double size = 0.0;        ///< asked for, or that of the quads
  double refusedSize = 0.0; ///< that would have given too many hexahedra; 0: none
};

SizedQuads sizedQuads(const SolidToSweep& solid, const SweepTopology& topology,
  const std::optional<AffineSweep>& affine, const SolidSweepSettings& settings, bool withBorders,
  const Progress& progress)
{
  if (!(settings.size >= 0.0) || !std::isfinite(settings.size))
  {
    throw InvalidInput("the size is " + describe(settings.size) +
      ". Set Size to a positive length, or to 0 for one that fits the solid.");
  }
  const double wanted = settings.quadSize != 0.0 ? settings.quadSize : settings.size;
  if (wanted > 0.0 && !solid.sourceQuads)
  {
    checkSweepBudget(expectedQuads(solid.body.surface, topology, wanted),
      sideLength(solid.body.surface, topology), settings.size > 0.0 ? settings.size : wanted,
      settings.layers);
  }
  const auto quadsOf = [&](double size) {
    return sourceQuads(
      solid, topology, size, settings.chordTolerance, affine, progress, withBorders);
  };
  SizedQuads result{ quadsOf(wanted), settings.layers, settings.size, 0.0 };
  double width = meanHexWidth(solid.body.surface, topology, result.quads.mesh);
  result.size = settings.size > 0.0 ? settings.size : width;
  const bool isFree =
    settings.layers.layers == 0 && settings.layers.size == 0.0 && settings.layers.positions.empty();
  if (!isFree || settings.size > 0.0)
  {
    checkSweepBudget(static_cast<double>(result.quads.mesh.quads.rows()),
      sideLength(solid.body.surface, topology), result.size, settings.layers);
  }
  if (!isFree)
  {
    return result;
  }
  if (settings.size == 0.0)
  {
    // The mesher of the cap does not hit a size exactly.
    constexpr int Trials = 4;
    constexpr double Slack = 1.02;
    const double length = sideLength(solid.body.surface, topology);
    for (int trial = 0; trial < Trials; ++trial)
    {
      const double factor =
        coarseningFor(length, result.quads.mesh.quads.rows(), width, settings.mostHexes);
      if (factor == 1.0)
      {
        break;
      }
      result.refusedSize = result.refusedSize > 0.0 ? result.refusedSize : width;
      if (result.quads.origin != "made" || settings.quadSize != 0.0)
      {
        break;
      }
      result.quads = quadsOf(Slack * factor * result.quads.size);
      width = meanHexWidth(solid.body.surface, topology, result.quads.mesh);
    }
    const Index quads = result.quads.mesh.quads.rows();
    result.layers.mostLayers = std::max<Index>(1, settings.mostHexes / quads);
    result.size = std::max(width, length / static_cast<double>(result.layers.mostLayers));
  }
  result.layers.size = result.size;
  return result;
}

/// What there is to say of the quads and the sides, before the hexahedra.
std::vector<std::string> warningsOf(const SizedQuads& sized, const SolidCage& cage)
{
  std::vector<std::string> warnings = linkingWarnings(cage.linking);
  if (sized.refusedSize > 0.0)
  {
    warnings.push_back("hexahedra of size " + describe(sized.refusedSize) + " would be more than " +
      std::to_string(MostChosenHexes) + ": they are coarser, of size " + describe(sized.size) +
      ". Set Size to choose it.");
  }
  if (sized.quads.inverted > 0)
  {
    warnings.push_back(std::to_string(sized.quads.inverted) +
      " of the quads that were made on the source cap are inverted: edges of length " +
      describe(sized.quads.size) +
      " are too long for its holes or walls. Set QuadSize to a smaller length, or give quads of "
      "the source cap.");
  }
  warnings.push_back(sized.quads.imprintWarning);
  if (cage.leftBorders)
  {
    warnings.push_back(
      "quads of the target lie on two of its faces: along the borders between them "
      "quads would be inverted. Set QuadSize to a smaller length.");
  }
  if (!cage.freedSides.empty())
  {
    warnings.push_back("CAD edges of the sides (" + listFaces(cage.freedSides) +
      ") are no edges of the mesh where they run from cap to cap: hexahedra along them would be "
      "inverted or poor.");
  }
  warnings.push_back(describeMismatch(
    cage.projection.sourceMismatch, "source cap of the solid", "boundary of the source quads"));
  return warnings;
}

/// What may be behind bad hexahedra.
std::vector<std::string> advice(
  const SolidSurface& solid, const SweepTopology& topology, bool targetIsNamed)
{
  std::vector<std::string> warnings;
  constexpr double CoarseTurn = 30.0;
  const double facetTurn = greatestFacetTurn(solid, topology);
  if (facetTurn > CoarseTurn)
  {
    warnings.push_back("the triangles of the solid turn by up to " +
      describe(std::round(facetTurn)) +
      " degrees from facet to facet round a curve of the source cap, which bends the quads on it. "
      "Export the solid with finer triangles on its curves.");
  }
  if (!targetIsNamed)
  {
    const bool one = topology.targetFaceIds.size() == 1;
    warnings.push_back("no target face was named, and " + listFaces(topology.targetFaceIds) +
      (one ? " was" : " were") +
      " found to fit. If the sweep is not meant to end there, name its target.");
  }
  return warnings;
}

SolidCage cageOf(const SolidToSweep& solid, const SweepTopology& topology,
  const std::optional<AffineSweep>& affine, const SolidSweepSettings& settings,
  const SizedQuads& sized, const Progress& progress)
{
  SolidCageInput input{ solid.body.surface, topology, sized.quads.mesh,
    sidePatches(solid.body.solid.input, solid.body.surface, topology), sized.layers,
    settings.matchTolerance, settings.hexes.precision == vtkAlgorithm::SINGLE_PRECISION,
    settings.hexes.ensureValid, settings.hexes.improveQuality, settings.projection,
    settings.weights, settings.improvement, sized.quads.imprinted, {}, 1.0, askingFor(progress),
    &affine };
  return settings.hexes.ensureValid ? makeUnhinderedCage(input, askingFor(progress), progress)
                                    : makeSolidCage(input, progress);
}

/// Nothing where it is not asked for.
std::optional<SlidBoundary> slidBoundary(const SolidToSweep& solid, const SweepTopology& topology,
  const SolidSweepSettings& settings, const SizedQuads& sized, const Progress& progress,
  const SolidCage& cage)
{
  if (!settings.moveBoundaryNodes)
  {
    return std::nullopt;
  }
  const ReadBody& body = solid.body;
  const std::vector<std::vector<QuadMesh>> patches =
    sidePatches(body.solid.input, body.surface, topology);
  const GivenQuads given{ sized.quads.origin != "made",
    std::any_of(patches.begin(), patches.end(), [](const auto& side) { return !side.empty(); }) };
  return slideBoundary(body.surface, topology, body.geometry.get(), cage, given,
    startsOf(cage, settings.hexes), interiorOptions(settings.hexes, progress), progress);
}

SolidSweepResult sweepFacets(const SolidToSweep& solid, const SweepTopology& topology,
  const SolidSweepSettings& settings, StageClock& stages, const Progress& progress,
  vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary)
{
  const std::optional<AffineSweep> affine = findAffineSweep(solid.body.surface, topology);
  SizedQuads sized =
    sizedQuads(solid, topology, affine, settings, true, progressPart(progress, 0.0, 0.1));
  stages.finish("Source quads");
  SolidCage cage =
    cageOf(solid, topology, affine, settings, sized, progressPart(progress, 0.1, 0.3));
  if (cage.leftBorders)
  {
    // Quads that were made for the borders are worse than others, and now for nothing.
    sized = sizedQuads(solid, topology, affine, settings, false, progressPart(progress, 0.3, 0.35));
    cage = cageOf(solid, topology, affine, settings, sized, progressPart(progress, 0.35, 0.48));
    cage.leftBorders = true;
  }
  stages.finish(cage.stages);
  std::optional<GeometrySnap> snap;
  if (solid.body.geometry)
  {
    snap = snapToGeometry(solid.body.surface, topology, *solid.body.geometry, cage,
      progressPart(progress, 0.48, 0.5), askingFor(progress));
    stages.finish("Snap to geometry");
  }
  if (!settings.targetIsNamed)
  {
    checkFoundTarget(cage.boundary, topology.targetFaceIds);
  }

  passSolidFields(solid.data, hexes->GetFieldData());
  passSolidFields(solid.data, boundary->GetFieldData());
  HexOutputSettings hexSettings = settings.hexes;
  hexSettings.reflection = solid.body.solid.reflection;
  const std::optional<SlidBoundary> slid =
    slidBoundary(solid, topology, settings, sized, progressPart(progress, 0.5, 0.8), cage);
  if (slid)
  {
    cage = slid->cage;
    hexSettings.begun = { &slid->points, slid->method };
    stages.finish("Move boundary nodes");
    addReport(hexes->GetFieldData(), reports::MovedBoundaryNodes, slid->moved);
    addReport(hexes->GetFieldData(), reports::GreatestBoundaryMove, slid->greatestMove);
  }
  const HexOutput output = writeHexes(
    cage, sized.quads.attributes, hexSettings, stages, progressPart(progress, 0.8, 0.97), hexes);
  writeBoundary(cage, solid.body.surface, topology, output.sourceIsBottom,
    hexSettings.reflection.turnsOver(), hexes, boundary);
  if (solid.body.name.empty())
  {
    carryVolumeId(solid.data, hexes);
  }
  else
  {
    setVolumeId(solid.body.volumeId, hexes);
    setVolumeId(solid.body.volumeId, boundary);
  }
  addReports(cage, solid.body.surface, topology, sized.quads.origin, hexes->GetFieldData());
  addReport(hexes->GetFieldData(), reports::Size, sized.size);
  addReport(hexes->GetFieldData(), reports::Projection, nameOf(settings.projection));
  if (cage.projection.target)
  {
    addReport(hexes->GetFieldData(), reports::Weights,
      std::string(nameOf(cage.projection.target->weights)));
  }
  SolidSweepResult result;
  result.valid = output.warnings.empty();
  result.warnings = warningsOf(sized, cage);
  if (snap)
  {
    addSnapReport(*snap, hexes->GetFieldData());
    result.warnings.push_back(snapWarning(*snap));
  }
  stages.finish("Output");
  if (!result.valid)
  {
    const std::vector<std::string> more =
      advice(solid.body.surface, topology, settings.targetIsNamed);
    result.warnings.insert(result.warnings.end(), output.warnings.begin(), output.warnings.end());
    result.warnings.insert(result.warnings.end(), more.begin(), more.end());
  }
  return result;
}
}

SolidSweepResult sweepSolid(const SolidToSweep& solid, const SweepTopology& topology,
  const SolidSweepSettings& settings, StageClock& stages, const Progress& progress,
  vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary)
{
  if (!solid.body.geometry)
  {
    return sweepFacets(solid, topology, settings, stages, progress, hexes, boundary);
  }
  const double size = settings.quadSize > 0.0 ? settings.quadSize : settings.size;
  const std::optional<FineBody> fine = fineBody(
    solid.body, topology, size, settings.chordTolerance, progressPart(progress, 0.0, 0.02));
  stages.finish("Facets");
  const Progress rest = progressPart(progress, 0.02, 1.0);
  return fine ? sweepFacets({ solid.data, solid.sourceQuads, fine->body }, fine->topology, settings,
                  stages, rest, hexes, boundary)
              : sweepFacets(solid, topology, settings, stages, rest, hexes, boundary);
}
}

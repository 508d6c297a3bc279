// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepSolidQuads.h"

#include "Core/Solids/FaceQuads.h"
#include "Core/Solids/SourceQuads.h"
#include "HexSweepAsking.h"
#include "HexSweepReader.h"
#include "HexSweepRun.h"

#include <vtkDataSet.h>

#include <numeric>
#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
std::vector<Index> upTo(Index n)
{
  std::vector<Index> ids(static_cast<std::size_t>(n));
  std::iota(ids.begin(), ids.end(), Index{ 0 });
  return ids;
}

SourceCapQuads madeQuads(SourceQuads made)
{
  SourceCapQuads result;
  result.attributes.pointIds = upTo(made.mesh.points.rows());
  result.attributes.cellIds = upTo(made.mesh.quads.rows());
  result.mesh = std::move(made.mesh);
  result.inverted = made.inverted;
  result.size = made.size;
  result.imprinted = std::move(made.imprinted);
  result.imprintWarning = std::move(made.imprintWarning);
  result.origin = "made";
  return result;
}
}

SourceCapQuads sourceQuads(const SolidToSweep& solid, const SweepTopology& topology, double size,
  double chordTolerance, const std::optional<AffineSweep>& affine, const Progress& progress,
  bool withBorders)
{
  SourceCapQuads result;
  const SolidInput& input = solid.body.solid.input;
  if (vtkDataSet* given = solid.sourceQuads)
  {
    QuadInput quads = readQuads(given, "source quads");
    result.mesh = std::move(quads.mesh);
    result.mesh.points = reflected(std::move(result.mesh.points), solid.body.solid.reflection);
    result.attributes = { given, upTo(given->GetNumberOfPoints()), std::move(quads.cellIds) };
    result.origin = "SourceQuads";
    return result;
  }
  if (std::optional<FaceQuads> quads =
        quadsOfFaces(input, solid.body.surface, topology.sourceFaceIds))
  {
    result.mesh = std::move(quads->mesh);
    result.attributes = { solid.data, std::move(quads->pointIds), std::move(quads->cellIds) };
    result.origin = "Solid";
    return result;
  }
  return madeQuads(makeSourceQuads(input, solid.body.surface, topology, size, progress, withBorders,
    askingFor(progress), chordTolerance, &affine));
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/LinkingSides.h"

#include "Core/Common/Describe.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Common/StoppablePieces.h"
#include "Core/Geometry/BoundarySearch.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Linking/LayerSpacing.h"
#include "Core/Linking/RingAlignment.h"
#include "Core/Linking/RuledColumns.h"
#include "Core/Linking/SideTurns.h"
#include "Core/Surfaces/SurfacePart.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
/// Several loops of several surfaces, as one set of boundaries.
struct Curves
{
  Points points{ 0, 3 };
  std::vector<Loop> loops;

  void add(const Points& polygon)
  {
    const Index first = this->points.rows();
    this->points.conservativeResize(first + polygon.rows(), Eigen::NoChange);
    this->points.bottomRows(polygon.rows()) = polygon;
    Loop loop(at(polygon.rows()));
    for (Index i = 0; i < polygon.rows(); ++i)
    {
      loop[at(i)] = first + i;
    }
    this->loops.push_back(std::move(loop));
  }
};

/// The curve that most nodes of the polygon are nearest to.
std::size_t nearestCurve(const BoundarySearch& search, std::size_t count, const Points& polygon)
{
  std::vector<Index> votes(count, 0);
  for (Index i = 0; i < polygon.rows(); ++i)
  {
    ++votes[search.closest(polygon.row(i)).loop];
  }
  return static_cast<std::size_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
}

/// For each polygon the curve that it lies on; each curve is taken once at most.
std::vector<std::size_t> pairUp(
  const std::vector<Points>& polygons, const Curves& curves, std::size_t groupSize)
{
  const BoundarySearch search(curves.points, curves.loops);
  std::vector<std::size_t> found;
  std::vector<Index> taken(curves.loops.size() / groupSize, -1);
  for (std::size_t l = 0; l < polygons.size(); ++l)
  {
    const std::size_t curve = nearestCurve(search, curves.loops.size(), polygons[l]);
    Index& by = taken[curve / groupSize];
    if (by >= 0)
    {
      throw InvalidInput("loops " + std::to_string(by) + " and " + std::to_string(l) +
        " of the source quads (the one at " + describe(polygons[l].row(0)) +
        ") both lie nearest to the same linking side. Check that the quads mesh the whole source "
        "cap, with each of its holes.");
    }
    by = static_cast<Index>(l);
    found.push_back(curve);
  }
  return found;
}

std::vector<Points> polygonsOf(const PointsRef& points, const std::vector<Loop>& loops)
{
  std::vector<Points> polygons;
  for (const Loop& loop : loops)
  {
    polygons.push_back(loopPoints(points, loop));
  }
  return polygons;
}

void checkCounts(std::size_t loops, std::size_t sides)
{
  if (loops != sides)
  {
    throw InvalidInput("the source quads have " + std::to_string(loops) +
      " boundary loops, but there are " + std::to_string(sides) +
      " linking sides. Every loop of the source cap needs one side, and every side a loop: check "
      "that the quads mesh the whole source cap and leave out each of its holes.");
  }
}

/// Quads of the faces that have no other cells among these rows of the surface.
std::vector<QuadMesh> patchesOf(const LinkingSurface& surface, const std::vector<Index>& rows)
{
  std::map<Index, std::vector<Index>> quadsOfFace;
  std::set<Index> mixed;
  for (const Index row : surface.quadOfTriangle.empty() ? std::vector<Index>{} : rows)
  {
    const Index face = surface.faceIds.empty() ? 0 : surface.faceIds[at(row)];
    const Index quad = surface.quadOfTriangle[at(row)];
    quadsOfFace[face].push_back(quad);
    if (quad < 0)
    {
      mixed.insert(face);
    }
  }
  std::vector<QuadMesh> patches;
  for (auto& [face, quads] : quadsOfFace)
  {
    if (mixed.count(face) > 0)
    {
      continue;
    }
    std::sort(quads.begin(), quads.end());
    quads.erase(std::unique(quads.begin(), quads.end()), quads.end());
    std::map<Index, Index> newId;
    QuadMesh patch;
    patch.quads.resize(static_cast<Index>(quads.size()), 4);
    for (std::size_t q = 0; q < quads.size(); ++q)
    {
      for (Index c = 0; c < 4; ++c)
      {
        const auto [known, isNew] =
          newId.emplace(surface.quads(quads[q], c), static_cast<Index>(newId.size()));
        patch.quads(static_cast<Index>(q), c) = known->second;
      }
    }
    patch.points.resize(static_cast<Index>(newId.size()), 3);
    for (const auto& [old, id] : newId)
    {
      patch.points.row(id) = surface.mesh.points.row(old);
    }
    patches.push_back(std::move(patch));
  }
  return patches;
}

/// Some rows of a surface, with their faces.
SideTube sideOf(const LinkingSurface& surface, const std::vector<Index>& rows)
{
  SideTube side;
  side.surface = surfacePart(surface.mesh.points, surface.mesh.triangles, rows).mesh;
  for (const Index row : surface.faceIds.empty() ? std::vector<Index>{} : rows)
  {
    side.faceIds.push_back(surface.faceIds[at(row)]);
  }
  side.patches = patchesOf(surface, rows);
  return side;
}

/// Where there are layers already, they count instead of a size.
Index layersFor(const LayerRequest& request, Index meshedLayers, double columnLength)
{
  if (request.size == 0.0)
  {
    return request.layers;
  }
  if (meshedLayers > 1)
  {
    return meshedLayers;
  }
  const Index layers = layersOfSize(columnLength, request.size);
  return request.mostLayers > 0 ? std::min(layers, request.mostLayers) : layers;
}

/// The loops of the quads, each with the side that it lies on.
struct PairedLoops
{
  std::vector<Points> rings;
  std::vector<std::size_t> sideOf;
};

PairedLoops pairLoops(const PointsRef& quadPoints, const std::vector<Loop>& quadLoops,
  const std::vector<SideTube>& sides)
{
  checkCounts(quadLoops.size(), sides.size());
  PairedLoops paired;
  paired.rings = polygonsOf(quadPoints, quadLoops);
  Curves curves;
  for (const SideTube& side : sides)
  {
    curves.add(loopPoints(side.surface.points, side.sourceLoop));
  }
  paired.sideOf = pairUp(paired.rings, curves, 1);
  return paired;
}

template <typename Columns>
double meanColumnLength(const std::deque<Columns>& columns)
{
  Index nodes = 0;
  double length = 0.0;
  for (const Columns& side : columns)
  {
    nodes += side.size();
    length += static_cast<double>(side.size()) * side.meanLength();
  }
  return length / static_cast<double>(nodes);
}

std::vector<double> fractionsFor(const LayerRequest& request, Index meshedLayers, double length)
{
  return request.positions.empty()
    ? layerFractions(layersFor(request, meshedLayers, length), request.growth, request.bothEnds)
    : layerFractions(request.positions);
}

/// Lays the rings of all sides and numbers them side after side.
template <typename Columns>
void layRings(const std::deque<Columns>& columns, const std::vector<double>& fractions,
  const std::vector<Loop>& quadLoops, const std::vector<std::size_t>& sideOf,
  const Progress& progress, const ParallelFor& parallelFor, LinkingMesh& result)
{
  std::vector<SideTubeMesh> meshes(columns.size());
  forStoppablePieces(parallelFor, progress, static_cast<Index>(columns.size()), 1,
    [&](Index l, Index) { meshes[at(l)] = columns[at(l)].mesh(fractions); });
  const Index layers = static_cast<Index>(fractions.size()) - 1;
  Index nodes = 0;
  for (const Columns& side : columns)
  {
    nodes += side.size();
  }
  Points points((layers + 1) * nodes, 3);
  result.quads.resize(layers * nodes, 4);
  Index row = 0;
  Index quad = 0;
  for (std::size_t l = 0; l < columns.size(); ++l)
  {
    const SideTubeMesh& side = meshes[l];
    const Index n = columns[l].size();
    points.middleRows(row, side.nodes.rows()) = side.nodes;
    result.edges.insert(result.edges.end(), side.edges.begin(), side.edges.end());
    for (Index k = 0; k <= layers; ++k)
    {
      result.nodeRing.insert(result.nodeRing.end(), at(n), k);
      result.sourcePoint.insert(result.sourcePoint.end(), quadLoops[l].begin(), quadLoops[l].end());
    }
    for (Index k = 0; k < layers; ++k)
    {
      result.quadLayer.insert(result.quadLayer.end(), at(n), k);
      for (Index j = 0; j < n; ++j, ++quad)
      {
        const Index a = row + k * n + j;
        const Index b = row + k * n + (j + 1) % n;
        result.quads.row(quad) << a, b, b + n, a + n;
      }
    }
    result.quadSide.insert(
      result.quadSide.end(), side.quadTriangle.size(), static_cast<Index>(sideOf[l]));
    result.quadTriangle.insert(
      result.quadTriangle.end(), side.quadTriangle.begin(), side.quadTriangle.end());
    row += side.nodes.rows();
  }
  reportProgress(progress, 1.0);
  result.rings = stackRings(std::move(points), quadLoops, layers);
}
}

std::vector<SideTube> splitLinkingSides(
  const LinkingSurface& given, const PointsRef& quadPoints, const std::vector<Loop>& quadLoops)
{
  const TriangleMesh& surface = given.mesh;
  DisjointSets pieces(surface.points.rows());
  for (Index t = 0; t < surface.triangles.rows(); ++t)
  {
    pieces.join(surface.triangles(t, 0), surface.triangles(t, 1));
    pieces.join(surface.triangles(t, 0), surface.triangles(t, 2));
  }
  std::vector<std::vector<Index>> rows;
  std::vector<Index> pieceAt(at(surface.points.rows()), -1);
  for (Index t = 0; t < surface.triangles.rows(); ++t)
  {
    Index& piece = pieceAt[at(pieces.find(surface.triangles(t, 0)))];
    if (piece < 0)
    {
      piece = static_cast<Index>(rows.size());
      rows.emplace_back();
    }
    rows[at(piece)].push_back(t);
  }
  std::vector<SideTube> sides;
  std::vector<std::vector<Loop>> loops;
  Curves curves;
  for (const std::vector<Index>& piece : rows)
  {
    sides.push_back(sideOf(given, piece));
    TriangleMesh& mesh = sides.back().surface;
    mesh.triangles = orientFaces(mesh.triangles, "linking surface");
    const SurfaceTopology topology =
      checkSurface(mesh.triangles, mesh.points.rows(), "linking surface");
    if (topology.loops.size() != 2 || topology.eulerCharacteristic != 0)
    {
      throw InvalidInput("the piece of the linking surface at " + describe(mesh.points.row(0)) +
        " is no tube between two loops: it has " + std::to_string(topology.loops.size()) +
        " boundary loops and Euler characteristic " + std::to_string(topology.eulerCharacteristic) +
        " (2 and 0 for a tube). Take only the faces that join a loop of the source cap to a loop "
        "of the target cap, all of them, and merge points that coincide.");
    }
    loops.push_back(topology.loops);
    curves.add(loopPoints(mesh.points, topology.loops[0]));
    curves.add(loopPoints(mesh.points, topology.loops[1]));
  }
  checkCounts(quadLoops.size(), sides.size());
  for (const std::size_t curve : pairUp(polygonsOf(quadPoints, quadLoops), curves, 2))
  {
    sides[curve / 2].sourceLoop = loops[curve / 2][curve % 2];
  }
  return sides;
}

LinkingMesh meshLinkingSides(const PointsRef& quadPoints, const std::vector<Loop>& quadLoops,
  const std::vector<SideTube>& sides, const LayerRequest& request, double matchTolerance,
  const Progress& progress, const ParallelFor& parallelFor)
{
  const PairedLoops paired = pairLoops(quadPoints, quadLoops, sides);
  const double count = static_cast<double>(paired.rings.size());
  std::deque<LinkingSideColumns> columns;
  for (std::size_t l = 0; l < paired.rings.size(); ++l)
  {
    columns.emplace_back(sides[paired.sideOf[l]], paired.rings[l], matchTolerance);
    reportProgress(progress, 0.8 * static_cast<double>(l + 1) / count);
  }
  LinkingMesh result;
  Index meshedLayers = 0;
  const std::vector<double> turns = sideTurns(columns);
  result.hasSteps.resize(sides.size(), false);
  for (std::size_t l = 0; l < columns.size(); ++l)
  {
    columns[l].turnEnds(turns[l]);
    result.hasSteps[paired.sideOf[l]] = columns[l].hasSteps();
  }
  levelRingsWhereBetter(columns);
  shareRingsWhereBetter(columns);
  for (const LinkingSideColumns& side : columns)
  {
    meshedLayers = std::max(meshedLayers, side.meshedLayers());
    result.keptEdges += side.keptEdges();
    result.flipped += side.flipped();
    result.lostEdges.insert(
      result.lostEdges.end(), side.lostEdges().begin(), side.lostEdges().end());
    result.lostCorners.insert(
      result.lostCorners.end(), side.lostCorners().begin(), side.lostCorners().end());
    result.refusedPatches.insert(
      result.refusedPatches.end(), side.refusedPatches().begin(), side.refusedPatches().end());
  }
  result.meanColumnLength = meanColumnLength(columns);
  layRings(columns, fractionsFor(request, meshedLayers, result.meanColumnLength), quadLoops,
    paired.sideOf, progressPart(progress, 0.8, 1.0), parallelFor, result);
  return result;
}

LinkingMesh meshRuledSides(const PointsRef& quadPoints, const std::vector<Loop>& quadLoops,
  const std::vector<SideTube>& sides, const LayerRequest& request, const AffineMap& map,
  const Progress& progress, const ParallelFor& parallelFor)
{
  const PairedLoops paired = pairLoops(quadPoints, quadLoops, sides);
  std::deque<RuledColumns> columns;
  for (std::size_t l = 0; l < paired.rings.size(); ++l)
  {
    columns.emplace_back(sides[paired.sideOf[l]], paired.rings[l], map);
  }
  LinkingMesh result;
  result.meanColumnLength = meanColumnLength(columns);
  layRings(columns, fractionsFor(request, 0, result.meanColumnLength), quadLoops, paired.sideOf,
    progress, parallelFor, result);
  return result;
}
}

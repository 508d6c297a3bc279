// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SweepTopology.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Solids/SweepCap.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace hexsweep
{
namespace
{
void checkDifferent(const std::vector<Index>& source, const std::vector<Index>& target)
{
  if (source == target)
  {
    throw InvalidInput("source and target are the same " + listFaces(source) +
      ". Name the two opposite ends of the sweep.");
  }
  std::vector<Index> both;
  std::set_intersection(
    source.begin(), source.end(), target.begin(), target.end(), std::back_inserter(both));
  if (!both.empty())
  {
    throw InvalidInput(listFaces(both) + (both.size() == 1 ? " is" : " are") +
      " named in the source cap and in the target cap. A face can be in one of them only.");
  }
}

void checkApart(const SolidSurface& solid, const HalfEdgeTriangles& halfEdges,
  const SweepCap& source, const SweepCap& target)
{
  std::size_t edges = 0;
  Index first = -1;
  std::vector<Index> sourcePoints;
  for (const std::vector<Index>& loop : source.loops)
  {
    for (const Index half : loop)
    {
      sourcePoints.push_back(halfEdges.from(half));
      const auto other = static_cast<std::size_t>(halfEdges.twin(half) / 3);
      if (std::binary_search(target.faceIds.begin(), target.faceIds.end(), solid.faceIds[other]))
      {
        first = edges == 0 ? half : first;
        ++edges;
      }
    }
  }
  if (edges > 0)
  {
    throw InvalidInput("the " + source.name + " and the " + target.name + " share " +
      countOf(edges, "edge") + ", the first one at " +
      describe(
        0.5 * (solid.points.row(halfEdges.from(first)) + solid.points.row(halfEdges.to(first)))) +
      ". There must be linking sides between the caps everywhere: name other faces.");
  }
  std::sort(sourcePoints.begin(), sourcePoints.end());
  for (const std::vector<Index>& loop : target.loops)
  {
    for (const Index half : loop)
    {
      const Index p = halfEdges.from(half);
      if (std::binary_search(sourcePoints.begin(), sourcePoints.end(), p))
      {
        throw InvalidInput("the " + source.name + " and the " + target.name +
          " meet in a point, at " + describe(solid.points.row(p)) +
          ", so that a side covers only part of a loop. There must be linking sides between the "
          "caps everywhere: name other faces, or pull the caps apart.");
      }
    }
  }
}

/// What lies between the caps: a connected set of triangles, and the loops that it touches.
struct Piece
{
  std::vector<Index> triangles;
  std::vector<std::size_t> sourceLoops;
  std::vector<std::size_t> targetLoops;
};

std::vector<Piece> piecesBetween(const SolidSurface& solid, const HalfEdgeTriangles& halfEdges,
  const SweepCap& source, const SweepCap& target)
{
  constexpr Index Cap = -1;
  constexpr Index Unseen = -2;
  std::vector<Index> pieceOf(static_cast<std::size_t>(solid.triangles.rows()), Unseen);
  for (const SweepCap* cap : { &source, &target })
  {
    for (const Index t : cap->triangles)
    {
      pieceOf[static_cast<std::size_t>(t)] = Cap;
    }
  }
  std::vector<Piece> pieces;
  for (std::size_t seed = 0; seed < pieceOf.size(); ++seed)
  {
    if (pieceOf[seed] != Unseen)
    {
      continue;
    }
    const auto number = static_cast<Index>(pieces.size());
    std::vector<Index> triangles = { static_cast<Index>(seed) };
    pieceOf[seed] = number;
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      for (Index half = 3 * triangles[i]; half < 3 * triangles[i] + 3; ++half)
      {
        const Index other = halfEdges.twin(half) / 3;
        if (pieceOf[static_cast<std::size_t>(other)] == Unseen)
        {
          pieceOf[static_cast<std::size_t>(other)] = number;
          triangles.push_back(other);
        }
      }
    }
    std::sort(triangles.begin(), triangles.end());
    pieces.push_back({ std::move(triangles), {}, {} });
  }
  // The caps are apart, so that all edges of a loop lie on one piece.
  const auto touched = [&](const std::vector<Index>& loop) -> Piece& {
    const Index t = halfEdges.twin(loop.front()) / 3;
    return pieces[static_cast<std::size_t>(pieceOf[static_cast<std::size_t>(t)])];
  };
  for (std::size_t l = 0; l < source.loops.size(); ++l)
  {
    touched(source.loops[l]).sourceLoops.push_back(l);
  }
  for (std::size_t l = 0; l < target.loops.size(); ++l)
  {
    touched(target.loops[l]).targetLoops.push_back(l);
  }
  return pieces;
}

Index handlesOf(const SolidSurface& solid, const Piece& piece, std::size_t boundaryEdges)
{
  const auto faces = static_cast<Index>(piece.triangles.size());
  const Index edges = (3 * faces + static_cast<Index>(boundaryEdges)) / 2;
  // An annulus has Euler characteristic 0; each handle takes two away.
  return -(countPoints(solid, piece.triangles) - edges + faces) / 2;
}

/// What is wrong with a piece that is no linking side; empty: nothing.
std::string problemOf(
  const SolidSurface& solid, const SweepCap& source, const SweepCap& target, const Piece& piece)
{
  const std::vector<Index> ids = facesOfTriangles(solid, piece.triangles);
  const bool one = ids.size() == 1;
  const std::string faces =
    listFaces(ids) + " at " + describe(triangleCenter(solid, piece.triangles.front()));
  const std::size_t onSource = piece.sourceLoops.size();
  const std::size_t onTarget = piece.targetLoops.size();
  if (onSource > 0 && onTarget > 0)
  {
    if (onSource > 1 || onTarget > 1)
    {
      return faces + (one ? " branches: it joins " : " branch: they join ") +
        countOf(onSource, "loop") + " of the " + source.name + " with " +
        countOf(onTarget, "loop") + " of the " + target.name +
        ". A linking side joins one loop with one: cut the solid where it branches, or name other "
        "caps.";
    }
    const Index handles = handlesOf(solid, piece,
      source.loops[piece.sourceLoops[0]].size() + target.loops[piece.targetLoops[0]].size());
    return handles == 0 ? std::string()
                        : faces + (one ? " is" : " are") + " no linking side: there " +
        (handles == 1 ? "is" : "are") + " " + countOf(static_cast<std::size_t>(handles), "handle") +
        " (a hole that goes through the side) on the way from the source loop to the target loop. "
        "Cut the solid so that each side is a tube.";
  }
  const SweepCap& only = onSource > 0 ? source : target;
  const SweepCap& other = onSource > 0 ? target : source;
  if (onSource + onTarget > 1)
  {
    return faces + (one ? " joins " : " join ") + countOf(onSource + onTarget, "loop") +
      " of the " + only.name +
      " with each other (a tunnel that comes back to the same cap) "
      "and never " +
      (one ? "reaches" : "reach") + " the " + other.name +
      ". Cut the tunnel off, or name other caps.";
  }
  return faces + (one ? " touches" : " touch") + " the " + only.name + " only and never " +
    (one ? "reaches" : "reach") + " the " + other.name +
    " (a blind hole or a boss). Cut it off, name " + (one ? "it" : "them") +
    " as part of that cap, or name other caps.";
}

void checkPieces(const SolidSurface& solid, const SweepCap& source, const SweepCap& target,
  const std::vector<Piece>& pieces)
{
  for (const Piece& piece : pieces)
  {
    const std::string problem = problemOf(solid, source, target, piece);
    if (problem.empty())
    {
      continue;
    }
    if (source.loops.size() != target.loops.size())
    {
      throw InvalidInput("the " + source.name + " has " + countOf(source.loops.size(), "loop") +
        ", the " + target.name + " has " + countOf(target.loops.size(), "loop") +
        ": the caps have different numbers of holes and cannot be swept into each other. The " +
        problem);
    }
    throw InvalidInput("the solid cannot be swept between these caps: " + problem);
  }
}

void moveOuterSideFirst(const SolidSurface& solid, std::vector<SweepSide>& sides)
{
  std::vector<double> lengths;
  for (const SweepSide& side : sides)
  {
    lengths.push_back(closedLength(loopPoints(solid.points, side.sourceLoop)) +
      closedLength(loopPoints(solid.points, side.targetLoop)));
  }
  const auto outer = std::max_element(lengths.begin(), lengths.end()) - lengths.begin();
  std::rotate(sides.begin(), sides.begin() + outer, sides.begin() + outer + 1);
}

SweepCap capOfFaces(const SolidSurface& solid, const HalfEdgeTriangles& halfEdges,
  const std::vector<Index>& ids, const std::string& role)
{
  return makeSweepCap(solid, halfEdges, ids, trianglesOfFaces(solid, ids), role + " cap");
}
}

SweepTopology sweepBetween(const SolidSurface& solid, const std::vector<Index>& sourceFaceIds,
  const std::vector<Index>& targetFaceIds)
{
  SweepTopology topology;
  topology.sourceFaceIds = checkedFaceIds(solid, sourceFaceIds, "source");
  topology.targetFaceIds = checkedFaceIds(solid, targetFaceIds, "target");
  checkDifferent(topology.sourceFaceIds, topology.targetFaceIds);

  const HalfEdgeTriangles halfEdges(solid.triangles);
  const SweepCap source = capOfFaces(solid, halfEdges, topology.sourceFaceIds, "source");
  const SweepCap target = capOfFaces(solid, halfEdges, topology.targetFaceIds, "target");
  checkApart(solid, halfEdges, source, target);
  std::vector<Piece> pieces = piecesBetween(solid, halfEdges, source, target);
  checkPieces(solid, source, target, pieces);

  std::sort(pieces.begin(), pieces.end(),
    [](const Piece& a, const Piece& b) { return a.sourceLoops[0] < b.sourceLoops[0]; });
  for (Piece& piece : pieces)
  {
    SweepSide side;
    side.faceIds = facesOfTriangles(solid, piece.triangles);
    side.triangles = std::move(piece.triangles);
    side.sourceLoop = pointsOfHalfEdges(halfEdges, source.loops[piece.sourceLoops[0]]);
    side.targetLoop = pointsOfHalfEdges(halfEdges, target.loops[piece.targetLoops[0]]);
    topology.sides.push_back(std::move(side));
  }
  moveOuterSideFirst(solid, topology.sides);
  topology.sourceTriangles = source.triangles;
  topology.targetTriangles = target.triangles;
  return topology;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SweepCap.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Solids/SolidMessages.h"

#include <algorithm>
#include <utility>

namespace hexsweep
{
namespace
{
bool isIn(const std::vector<Index>& sorted, Index value)
{
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

std::vector<Index> sortedUnique(std::vector<Index> ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

/// Pieces of the cap that edges join, each as the rows of its triangles.
std::vector<std::vector<Index>> piecesOf(
  const HalfEdgeTriangles& halfEdges, const std::vector<Index>& triangles)
{
  const auto placeOf = [&](Index t) {
    const auto place = std::lower_bound(triangles.begin(), triangles.end(), t);
    return place != triangles.end() && *place == t ? place - triangles.begin() : -1;
  };
  std::vector<char> seen(triangles.size(), 0);
  std::vector<std::vector<Index>> pieces;
  for (std::size_t seed = 0; seed < triangles.size(); ++seed)
  {
    if (seen[seed])
    {
      continue;
    }
    seen[seed] = 1;
    std::vector<Index> piece = { triangles[seed] };
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      for (Index half = 3 * piece[i]; half < 3 * piece[i] + 3; ++half)
      {
        const Index other = halfEdges.twin(half) / 3;
        const auto place = placeOf(other);
        if (place >= 0 && !seen[static_cast<std::size_t>(place)])
        {
          seen[static_cast<std::size_t>(place)] = 1;
          piece.push_back(other);
        }
      }
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

[[noreturn]] void failOnPieces(
  const SolidSurface& solid, const std::string& name, const std::vector<std::vector<Index>>& pieces)
{
  std::string places;
  const std::size_t shown = std::min<std::size_t>(pieces.size(), 4);
  for (std::size_t p = 0; p < shown; ++p)
  {
    places += (p == 0 ? "" : "; ") + listFaces(facesOfTriangles(solid, pieces[p])) + " at " +
      describe(triangleCenter(solid, pieces[p].front()));
  }
  throw InvalidInput("the " + name + " falls into " + std::to_string(pieces.size()) +
    " pieces that no edge joins (" + places + (shown < pieces.size() ? "; ..." : "") +
    "). A cap is one piece: name faces that adjoin each other.");
}

/// The half-edges between the cap and the rest, in loops.
std::vector<std::vector<Index>> loopsOf(
  const SolidSurface& solid, const HalfEdgeTriangles& halfEdges, const SweepCap& cap)
{
  std::vector<std::pair<Index, Index>> starts; // first point, half-edge
  for (const Index t : cap.triangles)
  {
    for (Index half = 3 * t; half < 3 * t + 3; ++half)
    {
      const auto other = static_cast<std::size_t>(halfEdges.twin(half) / 3);
      if (!isIn(cap.faceIds, solid.faceIds[other]))
      {
        starts.emplace_back(halfEdges.from(half), half);
      }
    }
  }
  std::sort(starts.begin(), starts.end());
  const auto samePoint = [](const auto& a, const auto& b) { return a.first == b.first; };
  const auto pinch = std::adjacent_find(starts.begin(), starts.end(), samePoint);
  if (pinch != starts.end())
  {
    throw InvalidInput("the " + cap.name + " touches itself in a point only, at " +
      describe(solid.points.row(pinch->first)) + " (" + describeCell(solid, pinch->second / 3) +
      " and " + describeCell(solid, (pinch + 1)->second / 3) +
      "), so that its boundary has no loops there. Pull the loops apart, or name the faces between "
      "as well.");
  }

  std::vector<char> seen(starts.size(), 0);
  std::vector<std::vector<Index>> loops;
  for (std::size_t first = 0; first < starts.size(); ++first)
  {
    std::vector<Index> loop;
    for (std::size_t i = first; !seen[i];)
    {
      seen[i] = 1;
      loop.push_back(starts[i].second);
      const std::pair<Index, Index> next(halfEdges.to(starts[i].second), -1);
      i = static_cast<std::size_t>(
        std::lower_bound(starts.begin(), starts.end(), next) - starts.begin());
    }
    if (!loop.empty())
    {
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

Index genusOf(const SolidSurface& solid, const SweepCap& cap)
{
  Index boundary = 0;
  for (const std::vector<Index>& loop : cap.loops)
  {
    boundary += static_cast<Index>(loop.size());
  }
  const auto faces = static_cast<Index>(cap.triangles.size());
  const Index characteristic =
    countPoints(solid, cap.triangles) - (3 * faces + boundary) / 2 + faces;
  return (2 - static_cast<Index>(cap.loops.size()) - characteristic) / 2;
}
}

std::vector<Index> checkedFaceIds(
  const SolidSurface& solid, const std::vector<Index>& ids, const std::string& role)
{
  const std::vector<Index> existing = sortedUnique(solid.faceIds);
  if (ids.empty())
  {
    throw InvalidInput("no " + role + " face is named: the solid has " + listFaces(existing) +
      ". Name those of the " + role + " cap.");
  }
  for (const Index id : ids)
  {
    if (!isIn(existing, id))
    {
      throw InvalidInput("the " + role + " face id " + std::to_string(id) +
        " does not exist: the solid has " + listFaces(existing) + ".");
    }
  }
  return sortedUnique(ids);
}

Loop pointsOfHalfEdges(const HalfEdgeTriangles& halfEdges, const std::vector<Index>& loop)
{
  Loop points;
  points.reserve(loop.size());
  for (const Index half : loop)
  {
    points.push_back(halfEdges.from(half));
  }
  return points;
}

Index countPoints(const SolidSurface& solid, const std::vector<Index>& triangles)
{
  std::vector<Index> points;
  points.reserve(3 * triangles.size());
  for (const Index t : triangles)
  {
    points.insert(
      points.end(), { solid.triangles(t, 0), solid.triangles(t, 1), solid.triangles(t, 2) });
  }
  std::sort(points.begin(), points.end());
  return std::unique(points.begin(), points.end()) - points.begin();
}

SweepCap makeSweepCap(const SolidSurface& solid, const HalfEdgeTriangles& halfEdges,
  const std::vector<Index>& faceIds, const std::vector<Index>& triangles, const std::string& role)
{
  SweepCap cap{ role + " (" + listFaces(faceIds) + ")", faceIds, triangles, {} };
  if (static_cast<Index>(triangles.size()) == solid.triangles.rows())
  {
    throw InvalidInput("the " + cap.name +
      " is the whole surface of the solid and has no boundary loop. Name only the faces of one "
      "end; the solid needs at least three faces: two caps and a side.");
  }
  const std::vector<std::vector<Index>> pieces = piecesOf(halfEdges, triangles);
  if (pieces.size() > 1)
  {
    failOnPieces(solid, cap.name, pieces);
  }
  cap.loops = loopsOf(solid, halfEdges, cap);
  const Index genus = genusOf(solid, cap);
  if (genus != 0)
  {
    throw InvalidInput("the " + cap.name + " has genus " + std::to_string(genus) +
      " (a handle or a tunnel within the cap), near " +
      describe(triangleCenter(solid, triangles.front())) +
      ". A cap must be a disk with holes: name fewer faces, or cut the handle off.");
  }
  return cap;
}
}

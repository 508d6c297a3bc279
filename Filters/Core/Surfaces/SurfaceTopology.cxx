// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SurfaceTopology.h"

#include "Core/Common/Describe.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Surfaces/FaceSides.h"

#include <algorithm>
#include <sstream>
#include <unordered_map>

namespace hexsweep
{
namespace
{
Index greatestPoint(const FacesRef& faces)
{
  return faces.size() > 0 ? faces.maxCoeff() : -1;
}

[[noreturn]] void failAtEdge(const FaceSide& side, const std::string& what,
  const std::string& problem, const std::string& cure)
{
  std::ostringstream message;
  message << "the " << what << ": " << problem << " at the edge between points " << side.low
          << " and " << side.high << " (face " << side.face << "). " << cure;
  throw InvalidInput(message.str());
}

void checkCorners(const FacesRef& faces, Index numberOfPoints, const std::string& what)
{
  for (Index f = 0; f < faces.rows(); ++f)
  {
    for (Index c = 0; c < faces.cols(); ++c)
    {
      const Index p = faces(f, c);
      if (p < 0 || p >= numberOfPoints)
      {
        throw InvalidInput("the " + what + ": face " + std::to_string(f) + " names point " +
          std::to_string(p) + ", which does not exist.");
      }
      for (Index d = 0; d < c; ++d)
      {
        if (faces(f, d) == p)
        {
          throw InvalidInput("the " + what + ": face " + std::to_string(f) + " uses point " +
            std::to_string(p) + " twice. Remove collapsed faces before sweeping.");
        }
      }
    }
  }
}

/// Boundary point -> next boundary point, in face direction.
std::unordered_map<Index, Index> boundarySuccessors(
  const std::vector<FaceSide>& sides, const FacesRef& faces, const std::string& what)
{
  std::unordered_map<Index, Index> next;
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first != 1)
    {
      return;
    }
    const FaceSide& side = sides[first];
    const Index a = faces(side.face, side.corner);
    const Index b = faces(side.face, (side.corner + 1) % faces.cols());
    if (!next.emplace(a, b).second)
    {
      throw InvalidInput("the " + what + ": two boundary chains meet in point " +
        std::to_string(a) +
        ", where faces touch in that point only. Separate them, or join them along an edge.");
    }
  });
  return next;
}

/// Faces around each point must form one fan: count the fans by joining face corners over edges.
void checkFans(const std::vector<FaceSide>& sides, const FacesRef& faces, Index numberOfPoints,
  const std::string& what)
{
  const Index corners = faces.cols();
  DisjointSets fans(faces.size());
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first != 2)
    {
      return;
    }
    const FaceSide& s = sides[first];
    const FaceSide& t = sides[first + 1];
    // The sides run in opposite directions: the begin of one is the end of the other.
    fans.join(s.face * corners + s.corner, t.face * corners + (t.corner + 1) % corners);
    fans.join(s.face * corners + (s.corner + 1) % corners, t.face * corners + t.corner);
  });
  std::vector<Index> fanOfPoint(static_cast<std::size_t>(numberOfPoints), -1);
  for (Index f = 0; f < faces.rows(); ++f)
  {
    for (Index c = 0; c < corners; ++c)
    {
      Index& fan = fanOfPoint[static_cast<std::size_t>(faces(f, c))];
      const Index found = fans.find(f * corners + c);
      if (fan >= 0 && fan != found)
      {
        throw InvalidInput("the " + what + ": faces touch in point " + std::to_string(faces(f, c)) +
          " only. Separate them, or join them along an edge.");
      }
      fan = found;
    }
  }
}

std::vector<Loop> collectLoops(const std::unordered_map<Index, Index>& next)
{
  std::vector<Index> starts;
  starts.reserve(next.size());
  for (const auto& link : next)
  {
    starts.push_back(link.first);
  }
  std::sort(starts.begin(), starts.end());
  std::unordered_map<Index, bool> seen;
  std::vector<Loop> loops;
  for (const Index start : starts)
  {
    if (seen[start])
    {
      continue;
    }
    Loop loop;
    for (Index p = start; !seen[p]; p = next.at(p))
    {
      seen[p] = true;
      loop.push_back(p);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}
}

SurfaceTopology checkSurface(const FacesRef& faces, Index numberOfPoints, const std::string& what)
{
  if (faces.rows() == 0)
  {
    throw InvalidInput(
      "the " + what + verb(what, " has", " have") + " no faces. Connect a surface mesh.");
  }
  checkCorners(faces, numberOfPoints, what);

  const std::vector<FaceSide> sides = sortedSides(faces, numberOfPoints);
  DisjointSets pieces(numberOfPoints);
  Index edges = 0;
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    ++edges;
    pieces.join(sides[first].low, sides[first].high);
    if (last - first > 2)
    {
      failAtEdge(sides[first], what, "more than two faces meet",
        "A cap must be a manifold: remove inner or duplicate faces.");
    }
  });
  // Only now: a face that is there twice disagrees with itself, which is not what is wrong.
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first == 2 && sides[first].forward == sides[first + 1].forward)
    {
      failAtEdge(sides[first], what, "neighbouring faces have opposite orientation",
        "Orient the faces consistently (in ParaView: Generate Surface Normals with Consistency).");
    }
  });
  const auto next = boundarySuccessors(sides, faces, what);
  checkFans(sides, faces, numberOfPoints, what);

  SurfaceTopology topology;
  topology.loops = collectLoops(next);
  std::vector<char> used(static_cast<std::size_t>(numberOfPoints), 0);
  for (Index i = 0; i < faces.size(); ++i)
  {
    used[static_cast<std::size_t>(faces(i / faces.cols(), i % faces.cols()))] = 1;
  }
  Index points = 0;
  for (Index p = 0; p < numberOfPoints; ++p)
  {
    if (used[static_cast<std::size_t>(p)])
    {
      ++points;
      topology.numberOfComponents += pieces.find(p) == p ? 1 : 0;
    }
  }
  topology.eulerCharacteristic = points - edges + faces.rows();
  return topology;
}

Faces orientFaces(const FacesRef& faces, const std::string& what)
{
  const Index corners = faces.cols();
  const std::vector<FaceSide> sides = sortedSides(faces, greatestPoint(faces) + 1);
  struct Link
  {
    Index face;
    bool agrees;
  };
  std::vector<std::vector<Link>> links(static_cast<std::size_t>(faces.rows()));
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first > 2)
    {
      failAtEdge(sides[first], what, "more than two faces meet",
        "A cap must be a manifold: remove inner or duplicate faces.");
    }
    if (last - first == 2)
    {
      const FaceSide& s = sides[first];
      const FaceSide& t = sides[first + 1];
      const bool agrees = s.forward != t.forward;
      links[static_cast<std::size_t>(s.face)].push_back({ t.face, agrees });
      links[static_cast<std::size_t>(t.face)].push_back({ s.face, agrees });
    }
  });

  constexpr char Unseen = 0;
  constexpr char Kept = 1;
  constexpr char Turned = 2;
  std::vector<char> state(static_cast<std::size_t>(faces.rows()), Unseen);
  std::vector<Index> stack;
  for (Index seed = 0; seed < faces.rows(); ++seed)
  {
    if (state[static_cast<std::size_t>(seed)] != Unseen)
    {
      continue;
    }
    state[static_cast<std::size_t>(seed)] = Kept;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const Index f = stack.back();
      stack.pop_back();
      const char own = state[static_cast<std::size_t>(f)];
      for (const Link& link : links[static_cast<std::size_t>(f)])
      {
        const char wanted = link.agrees ? own : (own == Kept ? Turned : Kept);
        char& other = state[static_cast<std::size_t>(link.face)];
        if (other == Unseen)
        {
          other = wanted;
          stack.push_back(link.face);
        }
        else if (other != wanted)
        {
          throw InvalidInput(
            "the " + what + " cannot be oriented (a Moebius strip): a cap must have two sides.");
        }
      }
    }
  }

  Faces oriented = faces;
  for (Index f = 0; f < faces.rows(); ++f)
  {
    if (state[static_cast<std::size_t>(f)] == Turned)
    {
      std::reverse(oriented.row(f).data() + 1, oriented.row(f).data() + corners);
    }
  }
  return oriented;
}

void checkCap(const SurfaceTopology& topology, const std::string& what)
{
  const Index loops = static_cast<Index>(topology.loops.size());
  if (topology.numberOfComponents != 1)
  {
    throw InvalidInput("the " + what + verb(what, " falls", " fall") + " into " +
      std::to_string(topology.numberOfComponents) +
      " pieces that no edge joins. A cap is one piece: merge coincident points (in ParaView: "
      "Clean to Grid) or sweep the pieces one by one.");
  }
  if (loops == 0)
  {
    throw InvalidInput("the " + what + verb(what, " is", " form") +
      " a closed surface without a boundary loop. Pass the cap alone, not the whole boundary "
      "of the volume.");
  }
  const Index genus = (2 - loops - topology.eulerCharacteristic) / 2;
  if (genus != 0)
  {
    throw InvalidInput("the " + what + verb(what, " has", " have") + " genus " +
      std::to_string(genus) +
      " (a handle); a cap must be a disk with holes. Cut the handle open or check for faces that "
      "bridge the cap.");
  }
}

Triangles triangleNeighbors(const TrianglesRef& triangles)
{
  Triangles neighbors = Triangles::Constant(triangles.rows(), 3, -1);
  const std::vector<FaceSide> sides = sortedSides(triangles, greatestPoint(triangles) + 1);
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first == 2)
    {
      const FaceSide& s = sides[first];
      const FaceSide& t = sides[first + 1];
      neighbors(s.face, s.corner) = t.face;
      neighbors(t.face, t.corner) = s.face;
    }
  });
  return neighbors;
}
}

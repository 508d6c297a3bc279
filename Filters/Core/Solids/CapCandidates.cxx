// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/CapCandidates.h"

#include "Core/Common/Constants.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>

namespace hexsweep
{
namespace
{
/// A face lies along a direction where the mean of (normal * direction)^2 is less: 8 degrees.
constexpr double AlongDirection = 0.02;

/// How a rim that turns by this angle suits a cap: 1 at 90 degrees.
double uprightness(double turn)
{
  constexpr double Tangent = 0.05;
  constexpr double Reentrant = 0.02;
  return turn < -Tangent ? Reentrant : std::max(Tangent, std::sin(turn));
}

/// The half-edges between the faces and the rest, in loops from their smallest points on; nothing
/// where loops touch each other.
std::optional<std::vector<std::vector<Index>>> loopsOf(
  const FaceGraph& graph, const FaceSet& faces, const std::vector<char>& isIn)
{
  std::vector<std::pair<Index, Index>> starts; // first point, half-edge
  for (const std::size_t face : faces)
  {
    for (const std::size_t c : graph.contactsOfFace[face])
    {
      const FaceContact& contact = graph.contacts[c];
      if (isIn[contact.first] && isIn[contact.second])
      {
        continue;
      }
      for (const Index half : contact.halfEdges)
      {
        const Index own = contact.first == face ? half : graph.halfEdges.twin(half);
        starts.emplace_back(graph.halfEdges.from(own), own);
      }
    }
  }
  std::sort(starts.begin(), starts.end());
  const auto samePoint = [](const auto& a, const auto& b) { return a.first == b.first; };
  if (std::adjacent_find(starts.begin(), starts.end(), samePoint) != starts.end())
  {
    return std::nullopt;
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
      const std::pair<Index, Index> next(graph.halfEdges.to(starts[i].second), -1);
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

bool isConnected(const FaceGraph& graph, const FaceSet& faces, const std::vector<char>& isIn)
{
  std::size_t wanted = 0;
  for (const std::size_t face : faces)
  {
    wanted += graph.faces[face].patches.size();
  }
  std::set<Index> seen = { graph.faces[faces.front()].patches.front() };
  std::vector<Index> queue(seen.begin(), seen.end());
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    for (const Index next : graph.patchNeighbors[static_cast<std::size_t>(queue[i])])
    {
      if (isIn[graph.faceOfPatch[static_cast<std::size_t>(next)]] && seen.insert(next).second)
      {
        queue.push_back(next);
      }
    }
  }
  return queue.size() == wanted;
}

/// Euler's: points less edges plus triangles.
Index characteristicOf(const FaceGraph& graph, const CapCandidate& candidate)
{
  std::vector<Index> border;
  Index points = 0;
  Index triangles = 0;
  for (const std::size_t face : candidate.faces)
  {
    const FaceShape& shape = graph.faces[face];
    border.insert(border.end(), shape.borderPoints.begin(), shape.borderPoints.end());
    points += shape.innerPoints;
    triangles += static_cast<Index>(graph.patches.triangles[face].size());
  }
  std::sort(border.begin(), border.end());
  points += std::unique(border.begin(), border.end()) - border.begin();
  Index rim = 0;
  for (const std::vector<Index>& loop : candidate.loops)
  {
    rim += static_cast<Index>(loop.size());
  }
  return points - (3 * triangles + rim) / 2 + triangles;
}

void measureRim(const FaceGraph& graph, CapCandidate& candidate)
{
  constexpr double CornerTurn = 40.0 * Pi / 180.0;
  double logarithms = 0.0;
  for (const std::vector<Index>& loop : candidate.loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Index half = loop[i];
      const Index next = loop[(i + 1) % loop.size()];
      const Eigen::RowVector3d in = graph.solid.points.row(graph.halfEdges.to(half)) -
        graph.solid.points.row(graph.halfEdges.from(half));
      const Eigen::RowVector3d out = graph.solid.points.row(graph.halfEdges.to(next)) -
        graph.solid.points.row(graph.halfEdges.from(next));
      candidate.corners += std::atan2(in.cross(out).norm(), in.dot(out)) > CornerTurn ? 1 : 0;
      candidate.perimeter += in.norm();
      logarithms += in.norm() * std::log(uprightness(graph.turns[static_cast<std::size_t>(half)]));
      candidate.rimPoints.push_back(graph.halfEdges.from(half));
    }
  }
  std::sort(candidate.rimPoints.begin(), candidate.rimPoints.end());
  candidate.upright = std::exp(logarithms / candidate.perimeter);
}

void measureFaces(const FaceGraph& graph, CapCandidate& candidate)
{
  Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
  double folds = 0.0;
  for (const std::size_t face : candidate.faces)
  {
    candidate.area += graph.faces[face].area;
    normal += graph.faces[face].area * graph.faces[face].normal;
    for (const std::size_t c : graph.contactsOfFace[face])
    {
      const FaceContact& contact = graph.contacts[c];
      if (contact.first == face &&
        std::binary_search(candidate.faces.begin(), candidate.faces.end(), contact.second))
      {
        folds += contact.length * contact.sharpest * contact.sharpest;
      }
    }
  }
  candidate.flatness = normal.norm() / candidate.area;
  candidate.smooth = 1.0 / (1.0 + folds / candidate.perimeter);
}
}

std::optional<CapCandidate> makeCapCandidate(const FaceGraph& graph, const FaceSet& faces)
{
  CapCandidate candidate;
  candidate.faces = faces;
  for (const std::size_t face : faces)
  {
    candidate.faceIds.push_back(graph.patches.ids[face]);
  }
  std::sort(candidate.faceIds.begin(), candidate.faceIds.end());
  std::vector<char> isIn(graph.faces.size(), 0);
  for (const std::size_t face : faces)
  {
    isIn[face] = 1;
  }
  std::optional<std::vector<std::vector<Index>>> loops = loopsOf(graph, faces, isIn);
  if (!loops || loops->empty() || !isConnected(graph, faces, isIn))
  {
    return std::nullopt;
  }
  candidate.loops = std::move(*loops);
  if (characteristicOf(graph, candidate) != 2 - static_cast<Index>(candidate.loops.size()))
  {
    return std::nullopt;
  }
  measureRim(graph, candidate);
  measureFaces(graph, candidate);
  return candidate;
}

double likelihoodOf(const CapCandidate& cap)
{
  return cap.upright * cap.smooth * std::pow(cap.area, 0.25);
}

std::vector<FaceSet> smoothFaceSets(const FaceGraph& graph, const std::vector<char>& allowed)
{
  std::set<FaceSet> known;
  std::vector<FaceSet> sets;
  for (const double angle : { graph.solid.featureAngle, Pi / 12.0, Pi / 36.0, 0.0 })
  {
    for (FaceSet& set : connectedFaces(
           graph, allowed, [&](const FaceContact& contact) { return contact.sharpest < angle; }))
    {
      if (known.insert(set).second)
      {
        sets.push_back(std::move(set));
      }
    }
  }
  return sets;
}

std::optional<std::pair<FaceSet, FaceSet>> endsAlong(
  const FaceGraph& graph, const Eigen::RowVector3d& direction)
{
  std::vector<char> above(graph.faces.size(), 0);
  std::vector<char> below(graph.faces.size(), 0);
  for (std::size_t f = 0; f < graph.faces.size(); ++f)
  {
    const FaceShape& face = graph.faces[f];
    if (direction * face.spread() * direction.transpose() > AlongDirection)
    {
      (face.normal.dot(direction) > 0.0 ? above : below)[f] = 1;
    }
  }
  const auto always = [](const FaceContact&) { return true; };
  std::vector<FaceSet> upper = connectedFaces(graph, above, always);
  std::vector<FaceSet> lower = connectedFaces(graph, below, always);
  if (upper.size() != 1 || lower.size() != 1)
  {
    return std::nullopt;
  }
  return std::make_pair(std::move(upper.front()), std::move(lower.front()));
}
}

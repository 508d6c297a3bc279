// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SweepMeasure.h"

#include "Core/Common/Constants.h"
#include "Core/Common/DenseAlgebra.h"
#include "Core/Solids/SideMotion.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr double SharpEdge = 25.0 * Pi / 180.0;
constexpr double StepEdge = 60.0 * Pi / 180.0;

/// One sweep's sides: which faces are in them, and how edges run there.
class Sides
{
public:
  Sides(const FaceGraph& graph, const CapCandidate& source, const CapCandidate& target,
    const std::vector<double>& fromSource, const std::vector<double>& fromTarget)
    : Graph(graph)
    , Source(source)
    , Target(target)
    , FromSource(fromSource)
    , FromTarget(fromTarget)
    , IsSide(graph.faces.size(), 1)
  {
    for (const CapCandidate* cap : { &source, &target })
    {
      for (const std::size_t face : cap->faces)
      {
        this->IsSide[face] = 0;
      }
    }
  }

  SweepMeasure measure()
  {
    this->measureHeight();
    this->findMotion();
    if (!this->Motion)
    {
      this->measureLeaning();
    }
    this->measureTurning();
    return std::move(this->Result);
  }

private:
  void measureHeight()
  {
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    double sum = 0.0;
    for (const Index p : this->Target.rimPoints)
    {
      const double way = this->FromSource[static_cast<std::size_t>(p)];
      least = std::min(least, way);
      most = std::max(most, way);
      sum += way;
    }
    this->Result.height = sum / static_cast<double>(this->Target.rimPoints.size());
    this->Result.leastShare = least / most;
  }

  /// Where the sides lie along a rigid motion it tells exactly what is else told by distances.
  void findMotion()
  {
    constexpr double Along = 0.02; // of the facets of bent sides
    constexpr double Turned = 1e-3;
    const SideMotion found = findSideMotion(this->Graph, this->IsSide, this->Source, this->Target);
    if (!(found.slip < Along))
    {
      return;
    }
    this->Motion = found.motion;
    this->Result.leaning = found.slip;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const CapCandidate* cap : { &this->Source, &this->Target })
    {
      for (const Index p : cap->rimPoints)
      {
        const double speed = this->Motion->at(this->Graph.solid.points.row(p)).norm();
        least = std::min(least, speed);
        most = std::max(most, speed);
      }
    }
    this->Result.leastShare = least / most;
    this->Result.isTurned = this->Motion->angular.norm() * this->Graph.radius > Turned * most;
  }

  void measureLeaning()
  {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    double area = 0.0;
    for (std::size_t f = 0; f < this->IsSide.size(); ++f)
    {
      if (this->IsSide[f])
      {
        spread += this->Graph.faces[f].area * this->Graph.faces[f].spread();
        area += this->Graph.faces[f].area;
      }
    }
    this->Result.leaning = std::max(0.0, principalAxes(spread / area).values[0]);
  }

  /// How much an edge runs across the sweep: 0 along a column, 1 along a layer.
  double acrossness(Index half, double length) const
  {
    if (this->Motion)
    {
      const Eigen::RowVector3d from =
        this->Graph.solid.points.row(this->Graph.halfEdges.from(half));
      const Eigen::RowVector3d to = this->Graph.solid.points.row(this->Graph.halfEdges.to(half));
      const Eigen::RowVector3d velocity = this->Motion->at(0.5 * (from + to));
      const double along = (to - from).dot(velocity) / (length * velocity.norm());
      return 1.0 - std::min(1.0, along * along);
    }
    const auto from = static_cast<std::size_t>(this->Graph.halfEdges.from(half));
    const auto to = static_cast<std::size_t>(this->Graph.halfEdges.to(half));
    const double a = this->FromSource[from] + this->FromTarget[from];
    const double b = this->FromSource[to] + this->FromTarget[to];
    const double rise =
      std::abs(this->FromSource[to] / b - this->FromSource[from] / a) * 0.5 * (a + b) / length;
    return rise >= 1.0 ? 0.0 : rise <= 0.0 ? 1.0 : 1.0 - rise * rise;
  }

  void measureTurning()
  {
    const FacePatches& patches = this->Graph.patches;
    std::vector<double> border(static_cast<std::size_t>(patches.numberOfPatches), 0.0);
    std::vector<double> steps(border.size(), 0.0);
    double sum = 0.0;
    for (Index half = 0; half < this->Graph.halfEdges.numberOfHalfEdges(); ++half)
    {
      const auto t = static_cast<std::size_t>(half / 3);
      const auto other = static_cast<std::size_t>(this->Graph.halfEdges.twin(half) / 3);
      const auto patch = static_cast<std::size_t>(patches.patchOfTriangle[t]);
      if (!this->IsSide[patches.faceOfTriangle[t]])
      {
        continue;
      }
      const double angle = std::abs(this->Graph.turns[static_cast<std::size_t>(half)]);
      const bool isBorder = patches.patchOfTriangle[t] != patches.patchOfTriangle[other];
      if (!isBorder && angle < SharpEdge)
      {
        continue;
      }
      const double length = this->Graph.edgeLength(half);
      border[patch] += isBorder ? length : 0.0;
      if (angle < SharpEdge || !this->IsSide[patches.faceOfTriangle[other]])
      {
        continue;
      }
      const double across = this->acrossness(half, length);
      steps[patch] += isBorder && angle > StepEdge ? across * length : 0.0;
      sum += 0.5 * across * length * angle * angle; // each edge comes twice
      if (across > 0.5 && angle > 1.2 * SharpEdge)
      {
        this->Result.turningFaces.push_back(patches.ids[patches.faceOfTriangle[t]]);
      }
    }
    this->Result.turning = 2.0 * sum / (this->Source.perimeter + this->Target.perimeter);
    std::vector<Index>& ids = this->Result.turningFaces;
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    this->findShoulders(border, steps);
  }

  Index patchBeyond(const std::vector<Index>& loop) const
  {
    const Index t = this->Graph.halfEdges.twin(loop.front()) / 3;
    return this->Graph.patches.patchOfTriangle[static_cast<std::size_t>(t)];
  }

  /// Ledges are patches that mostly end at steps. Where they bar the way from a source loop to the
  /// target, they are a shoulder.
  void findShoulders(const std::vector<double>& border, const std::vector<double>& steps)
  {
    constexpr double LedgeShare = 0.6;
    std::vector<char> isFree(border.size(), 1);
    for (std::size_t p = 0; p < border.size(); ++p)
    {
      isFree[p] = this->IsSide[this->Graph.faceOfPatch[p]];
    }
    std::vector<char> reached(border.size(), 0);
    for (const std::vector<Index>& loop : this->Source.loops)
    {
      std::vector<Index> queue = { this->patchBeyond(loop) };
      std::vector<std::size_t> ledges; // numbers of faces
      reached[static_cast<std::size_t>(queue.front())] = 1;
      for (std::size_t i = 0; i < queue.size(); ++i)
      {
        const auto p = static_cast<std::size_t>(queue[i]);
        if (steps[p] > LedgeShare * border[p])
        {
          ledges.push_back(this->Graph.faceOfPatch[p]);
          continue;
        }
        for (const Index next : this->Graph.patchNeighbors[p])
        {
          const auto q = static_cast<std::size_t>(next);
          if (isFree[q] && !reached[q])
          {
            reached[q] = 1;
            queue.push_back(next);
          }
        }
      }
      if (!this->reachesAnotherTarget(reached))
      {
        this->addShoulder(ledges);
      }
    }
    std::vector<Index>& ids = this->Result.shoulders;
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }

  void addShoulder(const std::vector<std::size_t>& ledges)
  {
    double area = 0.0;
    for (const std::size_t face : ledges)
    {
      area += this->Graph.faces[face].area;
      this->Result.shoulders.push_back(this->Graph.patches.ids[face]);
    }
    this->Result.shoulderShare =
      std::max(this->Result.shoulderShare, area / std::min(this->Source.area, this->Target.area));
  }

  /// Counts loops: as many target loops must be reached as source loops have been followed.
  bool reachesAnotherTarget(const std::vector<char>& reached)
  {
    std::size_t count = 0;
    for (const std::vector<Index>& loop : this->Target.loops)
    {
      count += reached[static_cast<std::size_t>(this->patchBeyond(loop))] ? 1 : 0;
    }
    const bool more = count > this->LoopsReached;
    this->LoopsReached = count;
    return more;
  }

  const FaceGraph& Graph;
  const CapCandidate& Source;
  const CapCandidate& Target;
  const std::vector<double>& FromSource;
  const std::vector<double>& FromTarget;
  std::vector<char> IsSide; // one a face
  std::optional<RigidMotion> Motion;
  std::size_t LoopsReached = 0;
  SweepMeasure Result;
};
}

RimDistances::RimDistances(const FaceGraph& graph)
  : Graph(graph)
  , First(static_cast<std::size_t>(graph.solid.points.rows()) + 1, 0)
  , HalfEdges(static_cast<std::size_t>(graph.halfEdges.numberOfHalfEdges()))
{
  const Index edges = graph.halfEdges.numberOfHalfEdges();
  for (Index half = 0; half < edges; ++half)
  {
    ++this->First[static_cast<std::size_t>(graph.halfEdges.from(half)) + 1];
  }
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  std::vector<Index> place(this->First.begin(), this->First.end() - 1);
  for (Index half = 0; half < edges; ++half)
  {
    Index& next = place[static_cast<std::size_t>(graph.halfEdges.from(half))];
    this->HalfEdges[static_cast<std::size_t>(next++)] = half;
  }
}

std::vector<double> RimDistances::from(const CapCandidate& cap) const
{
  const FaceGraph& graph = this->Graph;
  const auto n = static_cast<std::size_t>(graph.solid.points.rows());
  std::vector<char> within(n, 0);
  for (const std::size_t face : cap.faces)
  {
    for (const Index t : graph.patches.triangles[face])
    {
      for (int c = 0; c < 3; ++c)
      {
        within[static_cast<std::size_t>(graph.solid.triangles(t, c))] = 1;
      }
    }
  }
  std::vector<double> distances(n, std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (const Index p : cap.rimPoints)
  {
    distances[static_cast<std::size_t>(p)] = 0.0;
    queue.emplace(0.0, p);
  }
  while (!queue.empty())
  {
    const auto [distance, point] = queue.top();
    queue.pop();
    const auto p = static_cast<std::size_t>(point);
    if (distance > distances[p])
    {
      continue;
    }
    for (Index i = this->First[p]; i < this->First[p + 1]; ++i)
    {
      const Index half = this->HalfEdges[static_cast<std::size_t>(i)];
      const auto next = static_cast<std::size_t>(graph.halfEdges.to(half));
      const double way = distance + graph.edgeLength(half);
      if (!within[next] && way < distances[next])
      {
        distances[next] = way;
        queue.emplace(way, graph.halfEdges.to(half));
      }
    }
  }
  return distances;
}

SweepMeasure measureSweep(const FaceGraph& graph, const CapCandidate& source,
  const CapCandidate& target, const std::vector<double>& fromSource,
  const std::vector<double>& fromTarget)
{
  return Sides(graph, source, target, fromSource, fromTarget).measure();
}
}

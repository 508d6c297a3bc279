// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/TrianglePairing.h"

#include "Core/Common/Constants.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr double WidestFixedAngle = 140.0 * Pi / 180.0;
constexpr double WidestAngle = 172.0 * Pi / 180.0;
constexpr double LeastOnPath = 0.2; // score of pairs that paths may make
constexpr std::size_t LongestSearch = 400;

/// Two triangles that may become a quad.
struct Candidate
{
  double score;
  Index first; // rows of the triangles
  Index second;
  std::array<Index, 4> quad;
};

class Pairing
{
public:
  Pairing(const TriangleMesh& mesh, const PointsRef& normals,
    const std::vector<std::pair<Index, Index>>& keptEdges)
    : Mesh(mesh)
    , Normals(normals)
    , Kept(keptEdges)
    , Partner(static_cast<std::size_t>(mesh.triangles.rows()), -1)
    , Ways(static_cast<std::size_t>(mesh.triangles.rows()))
  {
    for (std::pair<Index, Index>& edge : this->Kept)
    {
      if (edge.first > edge.second)
      {
        std::swap(edge.first, edge.second);
      }
    }
    std::sort(this->Kept.begin(), this->Kept.end());
    this->collect();
  }

  void takeBestFirst()
  {
    for (std::size_t c = 0; c < this->Candidates.size(); ++c)
    {
      const Candidate& pair = this->Candidates[c];
      if (this->partner(pair.first) < 0 && this->partner(pair.second) < 0)
      {
        this->join(static_cast<Index>(c));
      }
    }
  }

  void followPaths()
  {
    for (Index t = 0; t < this->Mesh.triangles.rows(); ++t)
    {
      if (this->partner(t) < 0)
      {
        this->augmentFrom(t);
      }
    }
  }

  PairedTriangles result() const
  {
    std::vector<Index> quads;
    std::vector<Index> triangles;
    for (Index t = 0; t < this->Mesh.triangles.rows(); ++t)
    {
      const Index c = this->partner(t);
      if (c < 0)
      {
        for (Index i = 0; i < 3; ++i)
        {
          triangles.push_back(this->Mesh.triangles(t, i));
        }
      }
      else if (this->Candidates[static_cast<std::size_t>(c)].first == t)
      {
        const auto& quad = this->Candidates[static_cast<std::size_t>(c)].quad;
        quads.insert(quads.end(), quad.begin(), quad.end());
      }
    }
    return { Eigen::Map<const Quads>(quads.data(), static_cast<Index>(quads.size()) / 4, 4),
      Eigen::Map<const Triangles>(triangles.data(), static_cast<Index>(triangles.size()) / 3, 3) };
  }

private:
  /// Number of the candidate that a triangle is part of, or -1.
  Index partner(Index t) const { return this->Partner[static_cast<std::size_t>(t)]; }

  Index other(Index candidate, Index t) const
  {
    const Candidate& pair = this->Candidates[static_cast<std::size_t>(candidate)];
    return pair.first == t ? pair.second : pair.first;
  }

  void join(Index candidate)
  {
    const Candidate& pair = this->Candidates[static_cast<std::size_t>(candidate)];
    this->Partner[static_cast<std::size_t>(pair.first)] = candidate;
    this->Partner[static_cast<std::size_t>(pair.second)] = candidate;
  }

  bool isKept(Index a, Index b) const
  {
    return std::binary_search(
      this->Kept.begin(), this->Kept.end(), std::pair<Index, Index>(std::minmax(a, b)));
  }

  /// Score of a quad; negative: it must not be.
  double score(const std::array<Index, 4>& quad) const
  {
    double worst = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Index here = quad[i];
      const Index next = quad[(i + 1) % 4];
      const Index previous = quad[(i + 3) % 4];
      const Eigen::RowVector3d a = this->Mesh.points.row(next) - this->Mesh.points.row(here);
      const Eigen::RowVector3d b = this->Mesh.points.row(previous) - this->Mesh.points.row(here);
      double angle = std::atan2(a.cross(b).dot(this->Normals.row(here)), a.dot(b));
      angle += angle < 0.0 ? 2.0 * Pi : 0.0;
      const bool fixed = this->isKept(here, next) && this->isKept(previous, here);
      if (angle > (fixed ? WidestFixedAngle : WidestAngle))
      {
        return -1.0;
      }
      worst = std::max(worst, std::abs(0.5 * Pi - angle));
    }
    return 1.0 - worst / (0.5 * Pi);
  }

  void collect()
  {
    const Triangles neighbors = triangleNeighbors(this->Mesh.triangles);
    for (Index t = 0; t < neighbors.rows(); ++t)
    {
      for (Index c = 0; c < 3; ++c)
      {
        const Index u = neighbors(t, c);
        const Index a = this->Mesh.triangles(t, c);
        const Index b = this->Mesh.triangles(t, (c + 1) % 3);
        if (u < t || this->isKept(a, b))
        {
          continue;
        }
        Index apex = 0;
        while (this->Mesh.triangles(u, apex) == a || this->Mesh.triangles(u, apex) == b)
        {
          ++apex;
        }
        const std::array<Index, 4> quad = { a, this->Mesh.triangles(u, apex), b,
          this->Mesh.triangles(t, (c + 2) % 3) };
        const double score = this->score(quad);
        if (score >= 0.0)
        {
          this->Candidates.push_back({ score, t, u, quad });
        }
      }
    }
    std::stable_sort(this->Candidates.begin(), this->Candidates.end(),
      [](const Candidate& x, const Candidate& y) { return x.score > y.score; });
    for (std::size_t c = 0; c < this->Candidates.size(); ++c)
    {
      this->Ways[static_cast<std::size_t>(this->Candidates[c].first)].push_back(
        static_cast<Index>(c));
      this->Ways[static_cast<std::size_t>(this->Candidates[c].second)].push_back(
        static_cast<Index>(c));
    }
  }

  /// Breadth first; paths are simple, since no triangle is entered twice.
  void augmentFrom(Index start)
  {
    struct Step
    {
      Index triangle;
      Index candidate; // the new pair that led here, by way of its other triangle's partner
      Index from;      // number of the step before
    };
    std::vector<Step> steps = { { start, -1, -1 } };
    std::vector<Index> entered = { start };
    for (std::size_t s = 0; s < steps.size() && steps.size() < LongestSearch; ++s)
    {
      for (const Index candidate : this->Ways[static_cast<std::size_t>(steps[s].triangle)])
      {
        const Index met = this->other(candidate, steps[s].triangle);
        if (this->Candidates[static_cast<std::size_t>(candidate)].score < LeastOnPath ||
          std::find(entered.begin(), entered.end(), met) != entered.end())
        {
          continue;
        }
        if (this->partner(met) < 0)
        {
          // Steps whose pairs are about to be made; each frees the triangle behind it.
          this->join(candidate);
          for (Index k = static_cast<Index>(s); steps[static_cast<std::size_t>(k)].from >= 0;
               k = steps[static_cast<std::size_t>(k)].from)
          {
            this->join(steps[static_cast<std::size_t>(k)].candidate);
          }
          return;
        }
        const Index freed = this->other(this->partner(met), met);
        if (std::find(entered.begin(), entered.end(), freed) != entered.end())
        {
          continue;
        }
        entered.push_back(met);
        entered.push_back(freed);
        steps.push_back({ freed, candidate, static_cast<Index>(s) });
      }
    }
  }

  const TriangleMesh& Mesh;
  PointsRef Normals;
  std::vector<std::pair<Index, Index>> Kept;
  std::vector<Candidate> Candidates;    // best first
  std::vector<Index> Partner;           // candidate that each triangle is part of
  std::vector<std::vector<Index>> Ways; // candidates of each triangle
};
}

PairedTriangles pairTriangles(const TriangleMesh& mesh, const PointsRef& normals,
  const std::vector<std::pair<Index, Index>>& keptEdges)
{
  Pairing pairing(mesh, normals, keptEdges);
  pairing.takeBestFirst();
  pairing.followPaths();
  return pairing.result();
}
}

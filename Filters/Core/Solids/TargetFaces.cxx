// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/TargetFaces.h"

#include "Core/Common/Describe.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Solids/FacePatches.h"
#include "Core/Solids/FeatureFaces.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Solids/SweepCap.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace hexsweep
{
namespace
{
/// Looks for the target cap of one source cap.
class TargetSearch
{
public:
  TargetSearch(const SolidSurface& solid, std::vector<Index> sourceIds)
    : Solid(solid)
    , SourceIds(std::move(sourceIds))
    , HalfEdges(solid.triangles)
    , Source(makeSweepCap(solid, this->HalfEdges, this->SourceIds,
        trianglesOfFaces(solid, this->SourceIds), "source cap"))
    , Table(findFacePatches(solid, this->HalfEdges))
    , Neighbors(patchNeighbors(this->Table, this->HalfEdges))
  {
    this->markFacesAtSource();
  }

  std::vector<Index> find() const
  {
    std::vector<std::vector<Index>> fitting;
    for (std::size_t f = 0; f < this->Table.ids.size(); ++f)
    {
      if (!this->AtSource[f] && this->fits({ f }))
      {
        fitting.push_back({ this->Table.ids[f] });
      }
    }
    if (fitting.empty())
    {
      for (const std::vector<std::size_t>& group : this->smoothGroups())
      {
        if (this->fits(group))
        {
          fitting.push_back(this->idsOf(group));
        }
      }
    }
    if (fitting.empty())
    {
      this->failOnLikeliest();
    }
    if (fitting.size() > 1)
    {
      this->failOnSeveral(fitting);
    }
    return fitting.front();
  }

private:
  /// Faces that are in the source cap or share a point with it.
  void markFacesAtSource()
  {
    std::vector<char> onSource(static_cast<std::size_t>(this->Solid.points.rows()), 0);
    for (const Index t : this->Source.triangles)
    {
      for (int c = 0; c < 3; ++c)
      {
        onSource[static_cast<std::size_t>(this->Solid.triangles(t, c))] = 1;
      }
    }
    this->AtSource.assign(this->Table.ids.size(), 0);
    for (Index i = 0; i < this->Solid.triangles.size(); ++i)
    {
      if (onSource[static_cast<std::size_t>(this->Solid.triangles.data()[i])])
      {
        this->AtSource[this->Table.faceOfTriangle[static_cast<std::size_t>(i / 3)]] = 1;
      }
    }
  }

  std::vector<Index> idsOf(const std::vector<std::size_t>& faces) const
  {
    std::vector<Index> ids;
    for (const std::size_t f : faces)
    {
      ids.push_back(this->Table.ids[f]);
    }
    return ids;
  }

  SweepCap capOf(const std::vector<std::size_t>& faces) const
  {
    std::vector<Index> triangles;
    for (const std::size_t f : faces)
    {
      triangles.insert(
        triangles.end(), this->Table.triangles[f].begin(), this->Table.triangles[f].end());
    }
    std::sort(triangles.begin(), triangles.end());
    return makeSweepCap(this->Solid, this->HalfEdges, this->idsOf(faces), triangles, "target cap");
  }

  /// Whether everything but the source cap and these faces (rising) falls into annuli from loop to
  /// loop.
  bool fits(const std::vector<std::size_t>& faces) const
  {
    try
    {
      const SweepCap target = this->capOf(faces);
      return target.loops.size() == this->Source.loops.size() && this->hasGenusOfSweep() &&
        this->joinsLoopWithLoop(target);
    }
    catch (const InvalidInput&)
    {
      return false;
    }
  }

  /// With caps of b loops, b linking sides have 2 - 2 g - 2 (2 - b) = 2 (b - 1 - g) for the sum of
  /// their Euler characteristics, g being the genus of the solid's surface: annuli have none.
  bool hasGenusOfSweep() const
  {
    const Index m = this->Solid.triangles.rows();
    const Index genus = (2 - (this->Solid.points.rows() - 3 * m / 2 + m)) / 2;
    return genus == static_cast<Index>(this->Source.loops.size()) - 1;
  }

  Index patchBeyond(const std::vector<Index>& loop) const
  {
    return this->Table
      .patchOfTriangle[static_cast<std::size_t>(this->HalfEdges.twin(loop.front()) / 3)];
  }

  /// Walks from each source loop over the patches between the caps: the walk must come upon one
  /// target loop, and no other source loop.
  bool joinsLoopWithLoop(const SweepCap& target) const
  {
    if (target.loops.size() == 1)
    {
      return true; // a disk taken off a connected surface leaves it connected
    }
    constexpr Index Free = -1;
    constexpr Index Cap = -2;
    std::vector<Index> reached(static_cast<std::size_t>(this->Table.numberOfPatches), Free);
    for (const SweepCap* cap : { &this->Source, &target })
    {
      for (const Index t : cap->triangles)
      {
        reached[static_cast<std::size_t>(
          this->Table.patchOfTriangle[static_cast<std::size_t>(t)])] = Cap;
      }
    }
    for (std::size_t l = 0; l < this->Source.loops.size(); ++l)
    {
      std::vector<Index> queue = { this->patchBeyond(this->Source.loops[l]) };
      if (reached[static_cast<std::size_t>(queue.front())] != Free)
      {
        return false;
      }
      reached[static_cast<std::size_t>(queue.front())] = static_cast<Index>(l);
      for (std::size_t i = 0; i < queue.size(); ++i)
      {
        for (const Index next : this->Neighbors[static_cast<std::size_t>(queue[i])])
        {
          if (reached[static_cast<std::size_t>(next)] == Free)
          {
            reached[static_cast<std::size_t>(next)] = static_cast<Index>(l);
            queue.push_back(next);
          }
        }
      }
    }
    std::vector<Index> joined;
    for (const std::vector<Index>& loop : target.loops)
    {
      joined.push_back(reached[static_cast<std::size_t>(this->patchBeyond(loop))]);
    }
    std::sort(joined.begin(), joined.end());
    return joined.front() >= 0 && std::adjacent_find(joined.begin(), joined.end()) == joined.end();
  }

  /// Sets of two faces and more that meet smoothly and keep clear of the source cap.
  std::vector<std::vector<std::size_t>> smoothGroups() const
  {
    std::map<std::pair<std::size_t, std::size_t>, double> sharpest;
    for (Index half = 0; half < this->HalfEdges.numberOfHalfEdges(); ++half)
    {
      const Index t = half / 3;
      const Index other = this->HalfEdges.twin(half) / 3;
      const std::size_t a = this->Table.faceOfTriangle[static_cast<std::size_t>(t)];
      const std::size_t b = this->Table.faceOfTriangle[static_cast<std::size_t>(other)];
      if (a < b)
      {
        double& angle = sharpest.emplace(std::make_pair(a, b), 0.0).first->second;
        angle = std::max(
          angle, angleBetweenTriangles(this->Solid.points, this->Solid.triangles, t, other));
      }
    }
    DisjointSets joined(static_cast<Index>(this->Table.ids.size()));
    for (const auto& contact : sharpest)
    {
      if (contact.second < this->Solid.featureAngle)
      {
        joined.join(
          static_cast<Index>(contact.first.first), static_cast<Index>(contact.first.second));
      }
    }
    std::map<Index, std::vector<std::size_t>> groups;
    for (std::size_t f = 0; f < this->Table.ids.size(); ++f)
    {
      groups[joined.find(static_cast<Index>(f))].push_back(f);
    }
    std::vector<std::vector<std::size_t>> result;
    for (auto& group : groups)
    {
      const bool clear = std::none_of(group.second.begin(), group.second.end(),
        [&](std::size_t f) { return this->AtSource[f] != 0; });
      if (clear && group.second.size() > 1)
      {
        result.push_back(std::move(group.second));
      }
    }
    return result;
  }

  double areaOf(std::size_t face) const
  {
    double area = 0.0;
    for (const Index t : this->Table.triangles[face])
    {
      const Eigen::RowVector3d a = this->Solid.points.row(this->Solid.triangles(t, 0));
      const Eigen::RowVector3d u = this->Solid.points.row(this->Solid.triangles(t, 1)) - a;
      const Eigen::RowVector3d v = this->Solid.points.row(this->Solid.triangles(t, 2)) - a;
      area += 0.5 * u.cross(v).norm();
    }
    return area;
  }

  /// How far a face is from having as many loops as the source cap.
  std::size_t missingLoops(std::size_t face) const
  {
    try
    {
      const std::size_t loops = this->capOf({ face }).loops.size();
      const std::size_t wanted = this->Source.loops.size();
      return std::max(loops, wanted) - std::min(loops, wanted);
    }
    catch (const InvalidInput&)
    {
      return std::numeric_limits<std::size_t>::max();
    }
  }

  [[noreturn]] void failOnLikeliest() const
  {
    std::size_t likeliest = 0;
    std::pair<std::size_t, double> best(std::numeric_limits<std::size_t>::max(), 1.0);
    for (std::size_t f = 0; f < this->Table.ids.size(); ++f)
    {
      if (!this->AtSource[f])
      {
        // The fewest loops amiss, then the largest area.
        const std::pair<std::size_t, double> rank(this->missingLoops(f), -this->areaOf(f));
        if (rank < best)
        {
          best = rank;
          likeliest = f;
        }
      }
    }
    const std::string start = "no target face is named, and none fits the " + this->Source.name;
    if (best.second > 0.0)
    {
      throw InvalidInput(start +
        ": every other face touches it. A target cap is a face at the other end, with a side in "
        "between. Check the face ids, or name the target faces.");
    }
    std::string problem;
    try
    {
      sweepBetween(this->Solid, this->SourceIds, { this->Table.ids[likeliest] });
    }
    catch (const InvalidInput& error)
    {
      problem = error.what();
    }
    throw InvalidInput(start + ". The likeliest is face " +
      std::to_string(this->Table.ids[likeliest]) + ", but: " + problem +
      " If the target cap consists of several faces, name them all.");
  }

  [[noreturn]] void failOnSeveral(const std::vector<std::vector<Index>>& fitting) const
  {
    if (fitting.front().size() == 1)
    {
      std::vector<Index> ids;
      for (const std::vector<Index>& cap : fitting)
      {
        ids.push_back(cap.front());
      }
      throw InvalidInput("no target face is named, and several fit the " + this->Source.name +
        ": " + listFaces(ids) + ". Name the one that is meant.");
    }
    std::string caps;
    for (std::size_t i = 0; i < fitting.size(); ++i)
    {
      caps += (i == 0 ? "" : i + 1 == fitting.size() ? ", or " : ", ") + listFaces(fitting[i]);
    }
    throw InvalidInput("no target face is named, and several sets of faces fit the " +
      this->Source.name + ": " + caps + ". Name those that are meant.");
  }

  const SolidSurface& Solid;
  std::vector<Index> SourceIds;
  HalfEdgeTriangles HalfEdges;
  SweepCap Source;
  FacePatches Table;
  std::vector<std::vector<Index>> Neighbors;
  std::vector<char> AtSource; // one a face
};
}

std::vector<Index> findTargetFaces(
  const SolidSurface& solid, const std::vector<Index>& sourceFaceIds)
{
  return TargetSearch(solid, checkedFaceIds(solid, sourceFaceIds, "source")).find();
}

SweepTopology findSweepTopology(const SolidSurface& solid, const std::vector<Index>& sourceFaceIds,
  const std::vector<Index>& targetFaceIds)
{
  const std::vector<Index> source = checkedFaceIds(solid, sourceFaceIds, "source");
  return sweepBetween(
    solid, source, targetFaceIds.empty() ? findTargetFaces(solid, source) : targetFaceIds);
}
}

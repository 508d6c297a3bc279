// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblyChecks.h"

#include "Core/Common/Describe.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/SurfaceSearch.h"
#include "Core/Surfaces/SurfaceCrossings.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
/// Of the smaller volume's size: a gap is this narrow at most.
constexpr double NarrowGap = 1e-3;
/// Of the size: volumes with boxes that differ by less may be the same.
constexpr double SameBox = 1e-6;

using Box = Eigen::AlignedBox3d;
using VolumePair = std::pair<Index, Index>; // lower one first

Box boxOf(const SolidSurface& solid)
{
  Box box;
  for (Index i = 0; i < solid.points.rows(); ++i)
  {
    box.extend(solid.points.row(i).transpose());
  }
  return box;
}

/// How the points of a solid lie to the surface of another one.
struct Lie
{
  Index inside = 0;
  Index outside = 0;
  Index on = 0;
  double least = std::numeric_limits<double>::infinity(); ///< distance, of those that are not on it
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();  ///< where that is
};

Lie lieOf(const Points& points, const SurfaceSearch& surface, double size)
{
  Lie lie;
  Index near = -1;
  for (Index i = 0; i < points.rows(); ++i)
  {
    const SurfacePlace found = surface.project(points.row(i), near);
    near = found.triangle;
    const Eigen::RowVector3d away = points.row(i) - found.point;
    const double distance = away.norm();
    if (distance <= SameBox * size)
    {
      ++lie.on;
      continue;
    }
    ++(away.dot(found.normal) < 0.0 ? lie.inside : lie.outside);
    if (distance < lie.least)
    {
      lie.least = distance;
      lie.place = points.row(i);
    }
  }
  return lie;
}

class NeighbourCheck
{
public:
  NeighbourCheck(
    const std::vector<const SolidSurface*>& solids, const std::vector<std::string>& names)
    : Solids(solids)
    , Names(names)
    , Searches(solids.size())
  {
    for (const SolidSurface* solid : solids)
    {
      this->Boxes.push_back(boxOf(*solid));
    }
  }

  /// Volumes whose boxes, with a gap between them, have something in common, rising.
  std::vector<VolumePair> nearPairs() const
  {
    std::vector<Box> wide = this->Boxes;
    std::vector<std::size_t> byStart(wide.size());
    for (std::size_t v = 0; v < wide.size(); ++v)
    {
      const double gap = wide[v].isEmpty() ? 0.0 : NarrowGap * wide[v].diagonal().norm();
      wide[v].min().array() -= gap;
      wide[v].max().array() += gap;
      byStart[v] = v;
    }
    std::sort(byStart.begin(), byStart.end(),
      [&](std::size_t a, std::size_t b) { return wide[a].min()[0] < wide[b].min()[0]; });
    std::vector<VolumePair> pairs;
    for (std::size_t i = 0; i < byStart.size(); ++i)
    {
      const Box& own = wide[byStart[i]];
      if (own.isEmpty())
      {
        continue;
      }
      for (std::size_t j = i + 1; j < byStart.size() && wide[byStart[j]].min()[0] <= own.max()[0];
           ++j)
      {
        if (own.intersects(wide[byStart[j]]))
        {
          pairs.push_back(
            std::minmax({ static_cast<Index>(byStart[i]), static_cast<Index>(byStart[j]) }));
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  /// @return a sentence, empty where there is nothing to say.
  std::string describe(std::size_t a, std::size_t b)
  {
    const double size =
      std::min(this->Boxes[a].diagonal().norm(), this->Boxes[b].diagonal().norm());
    const Lie ofA = lieOf(this->Solids[a]->points, this->search(b), size);
    const Lie ofB = lieOf(this->Solids[b]->points, this->search(a), size);
    const std::string both = this->Names[a] + " and " + this->Names[b];
    const bool sameBox = (this->Boxes[a].min() - this->Boxes[b].min()).norm() < SameBox * size &&
      (this->Boxes[a].max() - this->Boxes[b].max()).norm() < SameBox * size;
    if (sameBox && ofA.inside + ofA.outside == 0 && ofB.inside + ofB.outside == 0)
    {
      return both + " are the same body. Leave one of them out.";
    }
    for (const bool first : { true, false })
    {
      const Lie& lie = first ? ofA : ofB;
      const Lie& other = first ? ofB : ofA;
      if (lie.inside > 0 && lie.outside == 0 && other.inside == 0)
      {
        return this->Names[first ? a : b] + " lies in " + this->Names[first ? b : a] +
          ". Cut the one out of the other in the CAD system.";
      }
    }
    if (ofA.inside + ofB.inside > 0)
    {
      return both + " overlap at " + hexsweep::describe(ofA.inside > 0 ? ofA.place : ofB.place) +
        ". Mend this in the CAD system.";
    }
    const double gap = std::min(ofA.least, ofB.least);
    if (ofA.on + ofB.on == 0 && gap < NarrowGap * size)
    {
      return both + " are " + hexsweep::describe(gap) + " apart at " +
        hexsweep::describe(ofA.least < ofB.least ? ofA.place : ofB.place) +
        ": they do not touch, and their meshes do not fit. Where they should touch, make "
        "ImprintTolerance of the reader larger than this gap.";
    }
    return {};
  }

private:
  const SurfaceSearch& search(std::size_t v)
  {
    if (!this->Searches[v])
    {
      this->Searches[v] = std::make_unique<SurfaceSearch>(
        TriangleMesh{ this->Solids[v]->points, this->Solids[v]->triangles });
    }
    return *this->Searches[v];
  }

  const std::vector<const SolidSurface*>& Solids;
  const std::vector<std::string>& Names;
  std::vector<Box> Boxes;
  std::vector<std::unique_ptr<SurfaceSearch>> Searches;
};

/// A place where triangles of different volumes go through or lie upon each other.
std::string describeCrossing(
  const AssemblyComplex& complex, const std::vector<std::string>& names, VolumePair& pair)
{
  const std::optional<SurfaceCrossing> crossing =
    findCrossing({ complex.points, complex.triangles });
  if (!crossing)
  {
    return {};
  }
  const ComplexFace& one = complex.faces[at(complex.faceOf[at(crossing->first)])];
  const ComplexFace& other = complex.faces[at(complex.faceOf[at(crossing->second)])];
  pair = std::minmax({ one.volumes.front(), other.volumes.front() });
  if (pair.first == pair.second)
  {
    return {};
  }
  return names[at(pair.first)] + " and " + names[at(pair.second)] +
    " go through or lie upon each other at " + describe(crossing->place) + " (face " +
    std::to_string(one.id) + " and face " + std::to_string(other.id) +
    ") without sharing a face there: their meshes do not fit. Imprint and merge them (vtkCADReader "
    "does), or mend this in the CAD system.";
}
}

std::vector<std::string> describeNeighbours(const AssemblyComplex& complex,
  const std::vector<const SolidSurface*>& solids, const std::vector<std::string>& names)
{
  std::set<VolumePair> share;
  for (const ComplexFace& face : complex.faces)
  {
    if (face.volumes.size() > 1)
    {
      share.insert(std::minmax({ face.volumes[0], face.volumes[1] }));
    }
  }
  std::vector<std::string> sentences;
  std::set<VolumePair> told;
  NeighbourCheck check(solids, names);
  for (const VolumePair& pair : check.nearPairs())
  {
    std::string sentence =
      share.count(pair) > 0 ? std::string() : check.describe(at(pair.first), at(pair.second));
    if (!sentence.empty())
    {
      sentences.push_back(std::move(sentence));
      told.insert(pair);
    }
  }
  VolumePair pair;
  std::string crossing = describeCrossing(complex, names, pair);
  if (!crossing.empty() && told.count(pair) == 0)
  {
    sentences.push_back(std::move(crossing));
  }
  return sentences;
}
}

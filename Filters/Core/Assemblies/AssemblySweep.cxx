// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblySweep.h"

#include "Core/Assemblies/CapFaces.h"
#include "Core/Assemblies/CapImprint.h"
#include "Core/Assemblies/CapSizes.h"
#include "Core/Assemblies/FaceGrid.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
/// Runs what may throw about a volume; an error becomes the volume's problem.
template <typename Call>
void fillOrTell(SweptVolume& volume, Call&& call)
{
  try
  {
    call();
  }
  catch (const InvalidInput& error)
  {
    volume.problem = error.what();
  }
  catch (const SolverFailure& error)
  {
    volume.problem = error.what();
  }
}

/// Whether the caps of a volume are needed: its own, or those of others of its stack.
std::vector<bool> neededVolumes(const AssemblySweep& sweep)
{
  const std::vector<Index>& stackOf = sweep.planned.plan.stackOf;
  std::set<Index> stacks;
  for (std::size_t v = 0; v < stackOf.size(); ++v)
  {
    if (sweep.volumes[v].isMine && stackOf[v] >= 0)
    {
      stacks.insert(stackOf[v]);
    }
  }
  std::vector<bool> needed;
  for (const Index stack : stackOf)
  {
    needed.push_back(stacks.count(stack) > 0);
  }
  return needed;
}

/// Structured quads on all faces of the volumes that are sides of some volume.
void meshSides(
  const AssemblyGeometry& geometry, const std::vector<bool>& needed, AssemblySweep& sweep)
{
  const PlannedAssembly& planned = sweep.planned;
  std::set<Index> wanted;
  for (std::size_t v = 0; v < needed.size(); ++v)
  {
    if (needed[v])
    {
      const std::vector<Index>& own = planned.complex.volumes[v].faces;
      wanted.insert(own.begin(), own.end());
    }
  }
  for (const SweepLayout& layout : planned.plan.sweeps)
  {
    for (const SideFace& side : layout.sides)
    {
      if (wanted.erase(side.face) > 0)
      {
        meshSideFace(planned.complex, geometry, side, planned.intervals, sweep.boundary);
      }
    }
  }
}

/// Quads on the caps of a volume.
VolumeCage meshCaps(const AssemblyGeometry& geometry, Index volume, const SolidSurface& solid,
  const ParallelFor& parallelFor, const Progress& progress, AssemblySweep& sweep)
{
  const PlannedAssembly& planned = sweep.planned;
  const SweepLayout& layout = planned.plan.sweeps[at(volume)];
  for (const Index face : layout.sources)
  {
    if (sweep.boundary.faces[at(face)].rows() == 0)
    {
      meshCapFace(planned.complex, geometry, face, capSize(planned.complex, face, planned.size),
        sweep.boundary, progressPart(progress, 0.0, 0.5), parallelFor);
    }
  }
  return carryToTarget(planned.complex, geometry, volume, layout,
    capMapOf(planned.complex, volume, layout, solid), sweep.boundary,
    progressPart(progress, 0.5, 1.0), parallelFor);
}

/// The nodes of a volume in the numbers of the assembly; those inside get new ones.
std::vector<Index> numberNodes(const VolumeCage& cage, Index& next)
{
  std::vector<Index> nodes;
  nodes.reserve(at(cage.nodes.size()));
  for (Index k = 0; k < cage.nodes.rows(); ++k)
  {
    for (Index i = 0; i < cage.nodes.cols(); ++i)
    {
      nodes.push_back(cage.nodes(k, i) >= 0 ? cage.nodes(k, i) : next++);
    }
  }
  return nodes;
}

/// Takes the hexahedra away from bodies of which a piece has none.
void emptyBrokenBodies(AssemblySweep& sweep)
{
  const std::vector<Index>& bodyOf = sweep.planned.bodyOf;
  std::map<Index, std::string> broken;
  for (std::size_t v = 0; v < sweep.volumes.size(); ++v)
  {
    if (!sweep.volumes[v].problem.empty())
    {
      broken.try_emplace(bodyOf[v], sweep.volumes[v].problem);
    }
  }
  for (std::size_t v = 0; v < sweep.volumes.size(); ++v)
  {
    const auto found = broken.find(bodyOf[v]);
    if (found != broken.end() && sweep.volumes[v].problem.empty())
    {
      const bool isMine = sweep.volumes[v].isMine;
      sweep.volumes[v] = {};
      sweep.volumes[v].problem = found->second;
      sweep.volumes[v].isMine = isMine;
    }
  }
}

Points placesOfAll(const AssemblySweep& sweep, Index count)
{
  Points places = Points::Zero(count, 3); // numbers of what was taken away are no one's
  for (Index i = 0; i < sweep.boundary.nodes.size(); ++i)
  {
    places.row(i) = sweep.boundary.nodes[i];
  }
  for (const SweptVolume& volume : sweep.volumes)
  {
    for (std::size_t i = 0; i < volume.nodes.size(); ++i)
    {
      if (volume.nodes[i] >= sweep.boundary.nodes.size())
      {
        places.row(volume.nodes[i]) = volume.hexes.points.row(static_cast<Index>(i));
      }
    }
  }
  return places;
}
}

AssemblySweep sweepAssembly(const std::vector<AssemblyVolume>& volumes, PlannedAssembly planned,
  const std::vector<bool>& isMine, const ParallelFor& parallelFor, const Progress& progress)
{
  AssemblySweep result;
  StageClock stages;
  result.planned = std::move(planned);
  AssemblyGeometry::Solids geometries;
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    geometries.push_back(volumes[v].geometry);
    result.volumes.emplace_back();
    result.volumes.back().isMine = isMine.empty() || isMine[v];
    result.volumes.back().problem = result.planned.problems[v];
  }
  const AssemblyGeometry geometry(result.planned.complex, std::move(geometries));
  result.boundary = divideCurves(result.planned.complex, geometry, result.planned.intervals.curves);
  const std::vector<bool> needed = neededVolumes(result);
  meshSides(geometry, needed, result);
  stages.finish("Linking sides");

  const double count = static_cast<double>(volumes.size());
  std::vector<VolumeCage> cages(volumes.size());
  double done = 0.0;
  for (const Index v : result.planned.plan.order)
  {
    if (needed[at(v)])
    {
      fillOrTell(result.volumes[at(v)], [&] {
        VolumeCage cage = meshCaps(geometry, v, volumes[at(v)].surface, parallelFor,
          progressPart(progress, 0.4 * done / count, 0.4 * (done + 1.0) / count), result);
        if (result.volumes[at(v)].isMine)
        {
          cages[at(v)] = std::move(cage);
        }
      });
    }
    done += 1.0;
  }
  stages.finish("Caps");
  Index next = result.boundary.nodes.size();
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    SweptVolume& volume = result.volumes[v];
    if (!volume.problem.empty() || !volume.isMine)
    {
      continue;
    }
    const double begin = static_cast<double>(v) / count;
    fillOrTell(volume, [&] {
      volume.hexes = fillVolume(cages[v],
        progressPart(progress, 0.4 + 0.6 * begin, 0.4 + 0.6 * (begin + 1.0 / count)), parallelFor);
      volume.nodes = numberNodes(cages[v], next);
    });
    cages[v] = {};
  }
  emptyBrokenBodies(result);
  stages.finish("Hexahedra");
  result.nodes = placesOfAll(result, next);
  result.stages = result.planned.stages;
  result.stages.insert(result.stages.end(), stages.stages().begin(), stages.stages().end());
  return result;
}
}

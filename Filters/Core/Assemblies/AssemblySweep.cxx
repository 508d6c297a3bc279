// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblySweep.h"

#include "Core/Assemblies/AssemblyChecks.h"
#include "Core/Assemblies/CapFaces.h"
#include "Core/Assemblies/CapImprint.h"
#include "Core/Assemblies/FaceGrid.h"
#include "Core/CapQuads/CapMeshing.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr double MostDefaultHexes = 4e5;

/// Runs what may throw about a volume, with its name.
template <typename Call>
auto aboutVolume(const AssemblyVolume& volume, Call&& call)
{
  try
  {
    return call();
  }
  catch (const InvalidInput& error)
  {
    throw InvalidInput(volume.name + ": " + error.what());
  }
  catch (const SolverFailure& error)
  {
    throw SolverFailure(volume.name + ": " + error.what());
  }
}

double volumeOf(const SolidSurface& solid)
{
  double volume = 0.0;
  const Eigen::RowVector3d origin = solid.points.row(0);
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = solid.points.row(solid.triangles(t, 0)) - origin;
    const Eigen::RowVector3d b = solid.points.row(solid.triangles(t, 1)) - origin;
    const Eigen::RowVector3d c = solid.points.row(solid.triangles(t, 2)) - origin;
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

/// Structured quads on all faces that are sides of a volume.
void meshSides(const AssemblyGeometry& geometry, AssemblySweep& sweep)
{
  std::set<Index> done;
  for (const SweepLayout& layout : sweep.plan.sweeps)
  {
    for (const SideFace& side : layout.sides)
    {
      if (done.insert(side.face).second)
      {
        meshSideFace(
          sweep.complex, geometry, side, sweep.intervals.tubeLayers[at(side.face)], sweep.boundary);
      }
    }
  }
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

Points placesOfAll(const AssemblySweep& sweep, Index count)
{
  Points places(count, 3);
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

double defaultAssemblySize(const AssemblyComplex& complex, const AssemblyPlan& plan,
  const std::vector<AssemblyVolume>& volumes)
{
  double size = std::numeric_limits<double>::infinity();
  double all = 0.0;
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    size = std::min(
      size, defaultQuadSize(meshOfFaces(complex, static_cast<Index>(v), plan.sweeps[v].sources)));
    all += std::abs(volumeOf(volumes[v].surface));
  }
  return std::max(size, std::cbrt(all / MostDefaultHexes));
}

AssemblySweep sweepAssembly(const std::vector<AssemblyVolume>& volumes,
  const AssemblySettings& settings, const Progress& progress)
{
  AssemblySweep result;
  StageClock stages;
  std::vector<SolidSurface> surfaces;
  AssemblyGeometry::Solids geometries;
  for (const AssemblyVolume& volume : volumes)
  {
    surfaces.push_back(volume.surface);
    geometries.push_back(volume.geometry);
  }
  result.complex = makeAssemblyComplex(surfaces);
  surfaces.clear();
  std::vector<const SolidSurface*> solids;
  std::vector<std::string> names;
  for (const AssemblyVolume& volume : volumes)
  {
    solids.push_back(&volume.surface);
    names.push_back(volume.name);
  }
  result.warnings = describeNeighbours(result.complex, solids, names);
  stages.finish("Faces and curves");
  const double count = static_cast<double>(volumes.size());
  std::vector<VolumeOptions> options(volumes.size());
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    reportProgress(progress, 0.1 * static_cast<double>(v) / count);
    options[v] = aboutVolume(volumes[v], [&] {
      return sweepOptions(
        result.complex, static_cast<Index>(v), volumes[v].surface, volumes[v].named);
    });
  }
  result.plan = planAssembly(result.complex, options, [&](Index volume, const SweepLayout& layout) {
    return capMapOf(result.complex, layout, *solids[at(volume)]).has_value();
  });
  result.size =
    settings.size > 0.0 ? settings.size : defaultAssemblySize(result.complex, result.plan, volumes);
  imprintTargets(solids, result.size, result.complex, result.plan);
  stages.finish("Plan");
  std::vector<Index> layers;
  for (const AssemblyVolume& volume : volumes)
  {
    layers.push_back(volume.named.layers);
  }
  result.intervals = assemblyIntervals(result.complex, result.plan, result.size, layers);
  stages.finish("Intervals");
  const AssemblyGeometry geometry(result.complex, std::move(geometries));
  result.boundary = divideCurves(result.complex, geometry, result.intervals.curves);
  meshSides(geometry, result);
  stages.finish("Linking sides");

  result.volumes.resize(volumes.size());
  std::vector<VolumeCage> cages(volumes.size());
  double done = 0.0;
  for (const Index v : result.plan.order)
  {
    const SweepLayout& layout = result.plan.sweeps[at(v)];
    const Progress part =
      progressPart(progress, 0.1 + 0.4 * done / count, 0.1 + 0.4 * (done + 1.0) / count);
    try
    {
      for (const Index face : layout.sources)
      {
        if (result.boundary.faces[at(face)].rows() == 0)
        {
          meshCapFace(result.complex, geometry, face, result.size, result.boundary,
            progressPart(part, 0.0, 0.5), settings.parallelFor);
        }
      }
      cages[at(v)] = carryToTarget(result.complex, geometry, v, layout, result.boundary,
        progressPart(part, 0.5, 1.0), settings.parallelFor);
    }
    catch (const InvalidInput& error)
    {
      result.volumes[at(v)].problem = error.what();
    }
    catch (const SolverFailure& error)
    {
      result.volumes[at(v)].problem = error.what();
    }
    done += 1.0;
  }
  stages.finish("Caps");
  Index next = result.boundary.nodes.size();
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    SweptVolume& volume = result.volumes[v];
    if (!volume.problem.empty())
    {
      continue;
    }
    const double begin = static_cast<double>(v) / count;
    volume.hexes = fillVolume(cages[v],
      progressPart(progress, 0.5 + 0.5 * begin, 0.5 + 0.5 * (begin + 1.0 / count)),
      settings.parallelFor);
    volume.nodes = numberNodes(cages[v], next);
    cages[v] = {};
  }
  stages.finish("Hexahedra");
  result.nodes = placesOfAll(result, next);
  result.stages = stages.stages();
  return result;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblyPlanning.h"

#include "Core/Assemblies/AssemblyChecks.h"
#include "Core/Assemblies/CapImprint.h"
#include "Core/CapQuads/CapMeshing.h"
#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr double MostDefaultHexes = 4e5;

/// Of a volume whose faces are those of a complex.
double volumeOf(const AssemblyComplex& complex, Index volume)
{
  double sum = 0.0;
  const Eigen::RowVector3d origin = complex.points.row(0);
  for (const Index face : complex.volumes[at(volume)].faces)
  {
    const double sign = complex.faces[at(face)].volumes.front() == volume ? 1.0 : -1.0;
    for (const Index t : complex.faces[at(face)].triangles)
    {
      const Eigen::RowVector3d a = complex.points.row(complex.triangles(t, 0)) - origin;
      const Eigen::RowVector3d b = complex.points.row(complex.triangles(t, 1)) - origin;
      const Eigen::RowVector3d c = complex.points.row(complex.triangles(t, 2)) - origin;
      sum += sign * a.dot(b.cross(c)) / 6.0;
    }
  }
  return std::abs(sum);
}

double defaultSize(const PlannedAssembly& planned)
{
  double size = std::numeric_limits<double>::infinity();
  double all = 0.0;
  for (std::size_t v = 0; v < planned.problems.size(); ++v)
  {
    if (planned.problems[v].empty())
    {
      const Index row = static_cast<Index>(v);
      size = std::min(
        size, defaultQuadSize(meshOfFaces(planned.complex, row, planned.plan.sweeps[v].sources)));
      all += volumeOf(planned.complex, row);
    }
  }
  return std::max(size, std::cbrt(all / MostDefaultHexes));
}

std::vector<Index> bodiesOf(const std::vector<AssemblyVolume>& volumes)
{
  std::map<Index, Index> firstOf; // by whole
  std::vector<Index> bodies;
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    const Index row = static_cast<Index>(v);
    bodies.push_back(
      volumes[v].whole < 0 ? row : firstOf.try_emplace(volumes[v].whole, row).first->second);
  }
  return bodies;
}

/// Leaves a volume out, and with it the other pieces of one that was cut.
void leaveOut(const std::vector<AssemblyVolume>& volumes, std::size_t volume,
  const std::string& problem, std::vector<VolumeOptions>& options, PlannedAssembly& planned)
{
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    if (v == volume || (volumes[v].whole >= 0 && volumes[v].whole == volumes[volume].whole))
    {
      planned.problems[v] = problem;
      options[v] = {};
    }
  }
}

/// The ways of all volumes; those that have none are left out, with why.
std::vector<VolumeOptions> optionsOf(
  const std::vector<AssemblyVolume>& volumes, const Progress& progress, PlannedAssembly& planned)
{
  std::vector<VolumeOptions> options(volumes.size());
  planned.problems.resize(volumes.size());
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    reportProgress(progress, static_cast<double>(v) / static_cast<double>(volumes.size()));
    if (!volumes[v].problem.empty())
    {
      leaveOut(volumes, v, volumes[v].problem, options, planned);
    }
    if (!planned.problems[v].empty())
    {
      continue;
    }
    try
    {
      options[v] =
        sweepOptions(planned.complex, static_cast<Index>(v), volumes[v].surface, volumes[v].named);
    }
    catch (const InvalidInput& error)
    {
      leaveOut(volumes, v, error.what(), options, planned);
    }
  }
  const auto isBad = [](const std::string& problem) { return !problem.empty(); };
  if (std::all_of(planned.problems.begin(), planned.problems.end(), isBad))
  {
    throw InvalidInput(volumes.front().name + ": " + planned.problems.front());
  }
  return options;
}

constexpr double MostHexes = 1e9;

void checkSize(const PlannedAssembly& planned)
{
  double all = 0.0;
  for (std::size_t v = 0; v < planned.problems.size(); ++v)
  {
    all += planned.problems[v].empty() ? volumeOf(planned.complex, static_cast<Index>(v)) : 0.0;
  }
  const double hexes = all / (planned.size * planned.size * planned.size);
  if (!(hexes <= MostHexes))
  {
    throw InvalidInput("hexahedra of size " + describe(planned.size) + " would be about " +
      describe(hexes) + ", more than a thousand million. Set Size to a larger length, at least " +
      describe(std::cbrt(all / MostHexes)) + ".");
  }
}

/// @return whether there is a plan now; else a volume was left out, with why.
bool planAndImprint(const std::vector<AssemblyVolume>& volumes,
  const std::vector<const SolidSurface*>& solids, double size, std::vector<VolumeOptions>& options,
  PlannedAssembly& result)
{
  result.plan = planAssembly(result.complex, options, [&](Index volume, const SweepLayout& layout) {
    return capMapOf(result.complex, volume, layout, *solids[at(volume)]).has_value();
  });
  result.size = size > 0.0 ? size : defaultSize(result);
  checkSize(result);
  try
  {
    imprintTargets(solids, result.size, result.complex, result.plan);
    return true;
  }
  catch (const ImprintFailure& failure)
  {
    leaveOut(volumes, at(failure.volume()), failure.what(), options, result);
    const auto isThere = [](const std::string& problem) { return problem.empty(); };
    if (std::none_of(result.problems.begin(), result.problems.end(), isThere))
    {
      throw;
    }
    return false;
  }
}

/// Rank by rank the work that it has.
class RankLoads
{
public:
  explicit RankLoads(int ranks)
    : Loads(static_cast<std::size_t>(ranks), 0.0)
  {
  }

  int give(double work)
  {
    const auto least = std::min_element(this->Loads.begin(), this->Loads.end());
    *least += work;
    return static_cast<int>(least - this->Loads.begin());
  }

private:
  std::vector<double> Loads;
};
}

PlannedAssembly planVolumes(const std::vector<AssemblyVolume>& volumes, double size,
  double matchTolerance, const Progress& progress)
{
  PlannedAssembly result;
  StageClock stages;
  std::vector<const SolidSurface*> solids;
  std::vector<std::string> names;
  std::vector<Index> layers;
  for (const AssemblyVolume& volume : volumes)
  {
    solids.push_back(&volume.surface);
    names.push_back(volume.name);
    layers.push_back(volume.named.layers);
  }
  result.bodyOf = bodiesOf(volumes);
  result.complex = makeAssemblyComplex(solids, matchTolerance);
  stages.finish("Faces and curves");
  result.warnings = describeNeighbours(result.complex, solids, names);
  stages.finish("Neighbours");
  std::vector<VolumeOptions> options = optionsOf(volumes, progressPart(progress, 0.0, 0.8), result);
  while (!planAndImprint(volumes, solids, size, options, result))
  {
    // Faces may have been cut before a border had no place.
    result.complex = makeAssemblyComplex(solids, matchTolerance);
  }
  stages.finish("Plan");
  result.intervals = assemblyIntervals(result.complex, result.plan, result.size, layers);
  stages.finish("Intervals");
  reportProgress(progress, 1.0);
  result.stages = stages.stages();
  return result;
}

std::vector<int> shareVolumes(const PlannedAssembly& planned, int ranks)
{
  std::vector<double> work(planned.problems.size(), 0.0);
  std::map<Index, double> workOfStack;
  for (std::size_t v = 0; v < work.size(); ++v)
  {
    if (planned.problems[v].empty())
    {
      work[v] = volumeOf(planned.complex, static_cast<Index>(v));
      workOfStack[planned.plan.stackOf[v]] += work[v];
    }
  }
  const double all = std::accumulate(work.begin(), work.end(), 0.0);
  const double most = std::accumulate(workOfStack.begin(), workOfStack.end(), 0.0,
    [](double greatest, const auto& stack) { return std::max(greatest, stack.second); });
  const bool byStacks = most * ranks <= 1.2 * all;
  // Pieces of one body stay together.
  std::map<Index, double> workOfPart;
  const auto partOf = [&](std::size_t v) {
    return byStacks ? planned.plan.stackOf[at(planned.bodyOf[v])] : planned.bodyOf[v];
  };
  for (std::size_t v = 0; v < work.size(); ++v)
  {
    if (planned.problems[v].empty())
    {
      workOfPart[partOf(v)] += work[v];
    }
  }
  std::vector<std::pair<double, Index>> parts; // work (negative: the most first), stack or body
  for (const auto& [part, own] : workOfPart)
  {
    parts.emplace_back(-own, part);
  }
  std::sort(parts.begin(), parts.end());
  RankLoads loads(ranks);
  std::map<Index, int> rankOf;
  for (const auto& [own, part] : parts)
  {
    rankOf[part] = loads.give(-own);
  }
  std::vector<int> result(work.size(), 0);
  for (std::size_t v = 0; v < work.size(); ++v)
  {
    const auto found = rankOf.find(partOf(v));
    result[v] = found == rankOf.end() ? 0 : found->second;
  }
  return result;
}
}

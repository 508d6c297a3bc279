// SPDX-License-Identifier: BSD-3-Clause
// The plan of an assembly of many volumes: a lattice of blocks, each of whose inner faces two
// share.
//
//   HexSweepPlannerBenchmark 5 10 22
//
// prints CPU seconds of planVolumes() for n^3 blocks, n as given, and how the work falls on ranks.
#include "Core/Assemblies/AssemblyPlanning.h"
#include "Core/Assemblies/VolumePieces.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace
{
using hexsweep::AssemblyVolume;
using hexsweep::Index;
using hexsweep::SolidSurface;

/// Ids of faces by their places: axis, and the lattice node that they begin at.
class FaceIds
{
public:
  Index of(int axis, const std::array<int, 3>& node)
  {
    return this->Ids
      .try_emplace({ axis, node[0], node[1], node[2] }, static_cast<Index>(this->Ids.size()) + 1)
      .first->second;
  }

private:
  std::map<std::array<int, 4>, Index> Ids;
};

SolidSurface block(const std::array<int, 3>& cell, FaceIds& ids)
{
  SolidSurface solid;
  solid.points.resize(8, 3);
  for (int i = 0; i < 8; ++i)
  {
    solid.points.row(i) << cell[0] + (i & 1), cell[1] + ((i >> 1) & 1), 0.8 * (cell[2] + (i >> 2));
  }
  // Two triangles a face, the same diagonal from both sides.
  static const int corners[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
  solid.triangles.resize(12, 3);
  for (int f = 0; f < 6; ++f)
  {
    std::array<int, 3> node = cell;
    node[static_cast<std::size_t>(f / 2)] += f % 2;
    // The diagonal from the least corner to the greatest: both are first and third.
    const int* c = corners[f];
    solid.triangles.row(2 * f) << c[0], c[1], c[2];
    solid.triangles.row(2 * f + 1) << c[0], c[2], c[3];
    solid.faceIds.insert(solid.faceIds.end(), 2, ids.of(f / 2, node));
  }
  solid.cellIds.resize(12);
  solid.triangleRows.resize(12);
  solid.pointRows.resize(8);
  std::iota(solid.cellIds.begin(), solid.cellIds.end(), 0);
  std::iota(solid.triangleRows.begin(), solid.triangleRows.end(), 0);
  std::iota(solid.pointRows.begin(), solid.pointRows.end(), 0);
  return solid;
}

std::vector<AssemblyVolume> lattice(int n)
{
  FaceIds ids;
  std::vector<AssemblyVolume> volumes;
  for (int z = 0; z < n; ++z)
  {
    for (int y = 0; y < n; ++y)
    {
      for (int x = 0; x < n; ++x)
      {
        AssemblyVolume volume;
        volume.surface = block({ x, y, z }, ids);
        volume.name = "volume " + std::to_string(volumes.size() + 1);
        volumes.push_back(std::move(volume));
      }
    }
  }
  return volumes;
}
}

int main(int argc, char** argv)
{
  std::printf("%8s %10s %12s\n", "volumes", "CPU s", "us a volume");
  for (int i = 1; i < argc; ++i)
  {
    std::vector<AssemblyVolume> volumes = lattice(std::atoi(argv[i]));
    const std::clock_t begin = std::clock();
    volumes = hexsweep::cutIntoPieces(std::move(volumes));
    const double pieces = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    const hexsweep::PlannedAssembly planned = hexsweep::planVolumes(volumes, 0.25);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    std::printf("%8zu %10.2f %12.1f\n", volumes.size(), seconds,
      1e6 * seconds / static_cast<double>(volumes.size()));
    std::printf("    %-18s %8.2f\n", "Pieces", pieces);
    for (const hexsweep::Stage& stage : planned.stages)
    {
      std::printf("    %-18s %8.2f\n", stage.name.c_str(), stage.seconds);
    }
    for (const int ranks : { 64, 256, 1024 })
    {
      std::vector<double> loads(static_cast<std::size_t>(ranks), 0.0);
      for (const int rank : hexsweep::shareVolumes(planned, ranks))
      {
        loads[static_cast<std::size_t>(rank)] += 1.0;
      }
      std::printf("    %d ranks: the busiest has %.2f of the mean\n", ranks,
        *std::max_element(loads.begin(), loads.end()) * ranks /
          static_cast<double>(volumes.size()));
    }
  }
  return 0;
}

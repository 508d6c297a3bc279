// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/SurfaceRemeshing.h"

#include "Core/CapQuads/TriangleRemesher.h"
#include "Core/Common/Errors.h"

namespace hexsweep
{
namespace
{
constexpr int Rounds = 8;
constexpr int SmoothingRounds = 6;
constexpr int MaximumCollapsePasses = 30;
constexpr int MaximumSplitPasses = 60; // each halves what is longest
}

RemeshedSurface remeshSurface(const RemeshingInput& input, const SurfaceSearch& surface,
  double size, double growth, const Progress& progress, const ParallelFor& parallelFor,
  const LengthLimit& longest)
{
  TriangleRemesher mesh(input, surface, size, growth, parallelFor, longest);
  mesh.flip();
  for (int round = 0; round < Rounds; ++round)
  {
    reportProgress(progress, static_cast<double>(round) / Rounds);
    mesh.shortenCurves();
    mesh.updateSizes();
    for (int pass = 0; pass < MaximumCollapsePasses && mesh.collapseShort() > 0; ++pass)
    {
      mesh.shortenCurves();
      mesh.flip();
      mesh.updateSizes();
    }
    mesh.collectGarbage();
    for (int pass = 0; pass < MaximumSplitPasses && mesh.splitLong() > 0; ++pass)
    {
      mesh.flip();
      mesh.updateSizes();
    }
    mesh.flip();
    mesh.relax();
    mesh.flip();
    mesh.relax();
  }
  mesh.shortenCurves();
  for (int round = 0; round < SmoothingRounds; ++round)
  {
    mesh.flip();
    mesh.relax();
  }
  mesh.flip();
  return mesh.result();
}
}

// SPDX-License-Identifier: BSD-3-Clause
// Koebe's iteration on 40 holes against one harmonic map of the same mesh.
#include "Interleaved.h"
#include "Support/CircleDomains.h"

#include "Core/DiskMaps/KoebeMap.h"
#include "Core/Solvers/DirichletSolver.h"
#include "Core/Solvers/SurfaceLaplacian.h"
#include "Core/Surfaces/SurfaceTopology.h"

namespace
{
using hexsweep::Index;
using hexsweep::KoebeMap;
using hexsweep::Loop;
using hexsweep::TriangleMesh;

/// A cap of 40 holes of many sizes, none of them round, and its loops, the outer one first.
struct Cap
{
  TriangleMesh mesh;
  std::vector<Loop> loops;
};

Cap fortyHoles(double spacing, int around, int refinements)
{
  test::CircleDomain domain =
    test::circleDomain(test::scatteredHoles(40, 0.03, 0.08), spacing, around);
  for (int k = 0; k < refinements; ++k)
  {
    domain = test::refined(domain);
  }
  Cap cap{ domain.mesh, {} };
  for (Index i = 0; i < cap.mesh.points.rows(); ++i)
  {
    const double x = cap.mesh.points(i, 0);
    const double y = cap.mesh.points(i, 1);
    cap.mesh.points.row(i) << 1.5 * x + 0.2 * std::sin(3.0 * y), y + 0.1 * std::sin(4.0 * x),
      0.3 * std::cos(2.0 * x + y);
  }
  cap.loops =
    hexsweep::checkSurface(cap.mesh.triangles, cap.mesh.points.rows(), "benchmark's cap").loops;
  return cap;
}

/// Assembly, factor and two right-hand sides.
void harmonicMap(const Cap& cap)
{
  std::vector<bool> fixed(static_cast<std::size_t>(cap.mesh.points.rows()), false);
  for (const Loop& loop : cap.loops)
  {
    for (const Index v : loop)
    {
      fixed[static_cast<std::size_t>(v)] = true;
    }
  }
  const hexsweep::DirichletSolver solver(
    hexsweep::surfaceLaplacian(cap.mesh.points, cap.mesh.triangles, hexsweep::Weights::Cotangent),
    fixed, cap.mesh.points);
  benchmark::DoNotOptimize(solver.solve(cap.mesh.points.leftCols<2>()).sum());
}

void koebe(benchmark::State& state, double spacing, int around)
{
  const Cap cap = fortyHoles(spacing, around, static_cast<int>(state.range(0)));
  KoebeMap map;
  test::Interleaved runs;
  runs.add("harmonicMap", [&] { harmonicMap(cap); });
  runs.add(
    "koebeMap", [&] { map = hexsweep::koebeMap(cap.mesh.points, cap.mesh.triangles, cap.loops); });
  runs.report(state);
  state.counters["triangles"] = static_cast<double>(cap.mesh.triangles.rows());
  state.counters["rounds"] = static_cast<double>(map.rounds.size());
  state.counters["last_change"] = map.rounds.back().change;
}
}

// Edges of one length, and finer ones round the holes: twice the share of the nodes on loops.
BENCHMARK_CAPTURE(koebe, Even, 0.05, 8)->DenseRange(0, 3)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(koebe, Graded, 0.08, 12)
  ->DenseRange(0, 3)
  ->Iterations(1)
  ->Unit(benchmark::kSecond);

// SPDX-License-Identifier: BSD-3-Clause
// The harmonic map of a cap to the unit disk, arrays in, coordinates out.
#include "BenchmarkMeshes.h"
#include "Interleaved.h"

#include "Core/CanonicalDiskMap.h"

#ifdef HEXSWEEP_BENCHMARK_CGAL
#include "CgalDiskMap.h"

#include <complex>
#endif

namespace
{
using hexsweep::CapDisk;
using hexsweep::Index;
using hexsweep::PlanePoints;
using hexsweep::TriangleMesh;
using test::Numbering;

constexpr Index Thousand = 1000;
constexpr double Bulge = 0.2;

CapDisk diskMap(const TriangleMesh& mesh)
{
  return hexsweep::canonicalDiskMap(
    mesh, hexsweep::HoleTreatment::Filled, hexsweep::Weights::Cotangent);
}

#ifdef HEXSWEEP_BENCHMARK_CGAL
/// Greatest distance between the two maps of the points of `mesh` once a turn of the disk has been
/// taken out: the two begin their arc length at different nodes.
double difference(const PlanePoints& a, const PlanePoints& b)
{
  std::complex<double> turn = 0.0;
  for (Index i = 0; i < a.rows(); ++i)
  {
    turn += std::complex<double>(a(i, 0), a(i, 1)) * std::complex<double>(b(i, 0), -b(i, 1));
  }
  turn /= std::abs(turn);
  double greatest = 0.0;
  for (Index i = 0; i < a.rows(); ++i)
  {
    greatest = std::max(greatest,
      std::abs(
        std::complex<double>(a(i, 0), a(i, 1)) - turn * std::complex<double>(b(i, 0), b(i, 1))));
  }
  return greatest;
}

void againstCgal(benchmark::State& state, Numbering numbering)
{
  const TriangleMesh mesh = test::cap(200 * Thousand, numbering, Bulge);
  test::CgalDiskMap cgal(mesh);
  CapDisk ours;
  test::Interleaved runs;
  runs.add("canonicalDiskMap", [&] { ours = diskMap(mesh); });
  runs.add("CGAL_default", [&] { cgal.parameterize<CGAL::Default>(); });
  runs.add("CGAL_LDLT", [&] { cgal.parameterize<test::BorderLdlt<false>>(); });
  runs.add("CGAL_LDLT_one_factor", [&] { cgal.parameterize<test::BorderLdlt<true>>(); });
  runs.report(state);
  state.counters["difference"] =
    difference(ours.disk.topRows(mesh.points.rows()), cgal.coordinates());
}
#endif

/// How the time grows with the mesh, and what memory the large one takes.
void growth(benchmark::State& state, Numbering numbering)
{
  const TriangleMesh small = test::cap(200 * Thousand, numbering, Bulge);
  const TriangleMesh large = test::cap(2000 * Thousand, numbering, Bulge);
  CapDisk result;
  test::Interleaved runs;
  runs.add("200k", [&] { result = diskMap(small); });
  runs.add("2M", [&] { result = diskMap(large); });
  runs.report(state);
  state.counters["2M_flipped"] = static_cast<double>(result.flipped.size());
}
}

#ifdef HEXSWEEP_BENCHMARK_CGAL
BENCHMARK_CAPTURE(againstCgal, FileOrder, Numbering::FileOrder)
  ->Iterations(1)
  ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(againstCgal, RandomNumbering, Numbering::Random)
  ->Iterations(1)
  ->Unit(benchmark::kSecond);
#endif
BENCHMARK_CAPTURE(growth, FileOrder, Numbering::FileOrder)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(growth, RandomNumbering, Numbering::Random)
  ->Iterations(1)
  ->Unit(benchmark::kSecond);

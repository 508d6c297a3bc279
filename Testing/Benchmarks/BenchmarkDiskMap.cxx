// SPDX-License-Identifier: BSD-3-Clause
// The harmonic map of a cap to the unit disk, arrays in, coordinates out.
#include "BenchmarkMeshes.h"
#include "Interleaved.h"

#include "Core/DiskMaps/CanonicalDiskMap.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Solvers/MultifrontalSolver.h"
#include "Core/Solvers/SurfaceLaplacian.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <Eigen/SparseCholesky>

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

/// The linear system of the harmonic map: the nodes inside the loop are unknown.
struct DirichletProblem
{
  hexsweep::SparseMatrix matrix; // m x m, symmetric
  hexsweep::Points places;       // m x 3
  Eigen::MatrixXd b;             // m x 2
};

DirichletProblem dirichletProblem(const TriangleMesh& mesh)
{
  const Index n = mesh.points.rows();
  const hexsweep::Loop loop =
    hexsweep::checkSurface(mesh.triangles, n, "benchmark's cap").loops.front();
  const std::vector<double> angles =
    hexsweep::arcLengthAngles(hexsweep::loopPoints(mesh.points, loop));
  std::vector<bool> inside(static_cast<std::size_t>(n), true);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(n, 2);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    inside[static_cast<std::size_t>(loop[i])] = false;
    values.row(loop[i]) << std::cos(angles[i]), std::sin(angles[i]);
  }

  const Index m = n - static_cast<Index>(loop.size());
  hexsweep::SparseMatrix unknowns(n, m); // takes a node's column
  unknowns.reserve(m);
  DirichletProblem problem;
  problem.places.resize(m, 3);
  Index free = 0;
  for (Index i = 0; i < n; ++i)
  {
    if (inside[static_cast<std::size_t>(i)])
    {
      problem.places.row(free) = mesh.points.row(i);
      unknowns.startVec(free);
      unknowns.insertBack(i, free++) = 1.0;
    }
  }
  unknowns.finalize();
  const hexsweep::SparseMatrix laplacian =
    hexsweep::cotangentLaplacian(mesh.points, mesh.triangles);
  const hexsweep::SparseMatrix rows = unknowns.transpose() * laplacian;
  problem.matrix = rows * unknowns;
  problem.b = -(rows * values);
  return problem;
}

/// The solver alone: order, factor and two right-hand sides of the same matrix, which is assembled
/// beforehand for both.
void againstAmd(benchmark::State& state, Numbering numbering)
{
  const DirichletProblem problem = dirichletProblem(test::cap(200 * Thousand, numbering, Bulge));
  Eigen::MatrixXd ours;
  Eigen::MatrixXd theirs;
  test::Interleaved runs;
  runs.add("MultifrontalSolver", [&] {
    hexsweep::MultifrontalSolver solver(
      problem.matrix, hexsweep::MultifrontalSolver::Kind::Cholesky, problem.places);
    solver.factorize(problem.matrix);
    ours = solver.solve(problem.b);
  });
  runs.add("SimplicialLDLT", [&] {
    const Eigen::SimplicialLDLT<hexsweep::SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<int>>
      solver(problem.matrix);
    theirs = solver.solve(problem.b);
  });
  runs.report(state);
  state.counters["difference"] = (ours - theirs).cwiseAbs().maxCoeff();
}

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
BENCHMARK_CAPTURE(againstAmd, FileOrder, Numbering::FileOrder)
  ->Iterations(1)
  ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(againstAmd, RandomNumbering, Numbering::Random)
  ->Iterations(1)
  ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(growth, FileOrder, Numbering::FileOrder)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(growth, RandomNumbering, Numbering::Random)
  ->Iterations(1)
  ->Unit(benchmark::kSecond);

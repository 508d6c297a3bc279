// SPDX-License-Identifier: BSD-3-Clause
// Against dense factorisations and Eigen's sparse ones.
#include "Core/Solvers/MultifrontalSolver.h"
#include "Core/Solvers/SurfaceLaplacian.h"

#include "Support/CapMeshes.h"
#include "Support/DenseTruth.h"
#include "Support/LentThreads.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include <limits>
#include <numeric>

namespace TestMultifrontalSolver
{
using hexsweep::Index;
using hexsweep::MultifrontalSolver;
using hexsweep::SparseMatrix;
using hexsweep::TriangleMesh;
using Kind = MultifrontalSolver::Kind;

Eigen::MatrixXd randomMatrix(Index rows, Index columns, unsigned seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

/// Something added to each diagonal entry, at most `shift`.
SparseMatrix shifted(SparseMatrix matrix, double shift)
{
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> uniform(0.1 * shift, shift);
  for (Index i = 0; i < matrix.rows(); ++i)
  {
    matrix.coeffRef(i, i) += uniform(generator);
  }
  matrix.makeCompressed();
  return matrix;
}

TriangleMesh curvedPlate(int cells)
{
  const int c = cells / 12;
  TriangleMesh mesh = test::plate(cells,
    { { 2 * c, 2 * c, 2 * c, 2 * c }, { 7 * c, 3 * c, 3 * c, 2 * c },
      { 4 * c, 7 * c, 2 * c, 3 * c } },
    0.3);
  mesh.points = test::lifted(mesh.points, test::bump);
  return mesh;
}

/// Two curved plates that know nothing of each other.
TriangleMesh twoPlates()
{
  TriangleMesh two = curvedPlate(12);
  const Index n = two.points.rows();
  const Index m = two.triangles.rows();
  two.points.conservativeResize(2 * n, 3);
  two.points.bottomRows(n) = 3.0 * two.points.topRows(n);
  two.triangles.conservativeResize(2 * m, 3);
  two.triangles.bottomRows(m) = two.triangles.topRows(m).array() + n;
  return two;
}

SparseMatrix pathMatrix(int n)
{
  SparseMatrix matrix(n, n);
  for (int i = 0; i < n; ++i)
  {
    matrix.insert(i, i) = 2.5;
    if (i > 0)
    {
      matrix.insert(i - 1, i) = -1.0;
      matrix.insert(i, i - 1) = -1.0;
    }
  }
  matrix.makeCompressed();
  return matrix;
}

SparseMatrix starMatrix(int n)
{
  SparseMatrix matrix(n, n);
  for (int i = 0; i < n; ++i)
  {
    matrix.insert(i, i) = i == n / 2 ? n : 1.5;
    if (i != n / 2)
    {
      matrix.insert(i, n / 2) = -1.0;
      matrix.insert(n / 2, i) = -1.0;
    }
  }
  matrix.makeCompressed();
  return matrix;
}

SparseMatrix diagonalMatrix(int n)
{
  SparseMatrix matrix(n, n);
  for (int i = 0; i < n; ++i)
  {
    matrix.insert(i, i) = 1.0 + i;
  }
  matrix.makeCompressed();
  return matrix;
}

/// Symmetric and positive definite, small enough for dense matrices.
std::vector<std::pair<std::string, SparseMatrix>> definiteMatrices()
{
  const auto laplacian = [](const TriangleMesh& mesh) {
    return shifted(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), 0.5);
  };
  return { { "one row", diagonalMatrix(1) }, { "two rows", pathMatrix(2) },
    { "a diagonal", diagonalMatrix(100) }, { "a path", pathMatrix(333) },
    { "a star", starMatrix(300) }, { "a plate with holes", laplacian(curvedPlate(12)) },
    { "a finer one", laplacian(curvedPlate(24)) }, { "two plates", laplacian(twoPlates()) },
    { "a disk", laplacian(test::disk(9, 30)) },
    { "an annulus", laplacian(test::annulus(0.3, 1.0, 6, 96)) } };
}

/// Two unknowns a point, which feel each other.
SparseMatrix inPairs(const SparseMatrix& matrix)
{
  std::vector<Eigen::Triplet<double, int>> entries;
  for (int j = 0; j < static_cast<int>(matrix.cols()); ++j)
  {
    for (SparseMatrix::InnerIterator it(matrix, j); it; ++it)
    {
      const int i = static_cast<int>(it.row());
      const double mixed = 0.2 * it.value();
      entries.emplace_back(2 * i, 2 * j, it.value());
      entries.emplace_back(2 * i + 1, 2 * j + 1, 2.0 * it.value());
      entries.emplace_back(2 * i, 2 * j + 1, mixed);
      entries.emplace_back(2 * i + 1, 2 * j, mixed);
    }
  }
  SparseMatrix pairs(2 * matrix.rows(), 2 * matrix.cols());
  pairs.setFromTriplets(entries.begin(), entries.end());
  return pairs;
}

Eigen::MatrixXd solved(Kind kind, const SparseMatrix& matrix, const Eigen::MatrixXd& right)
{
  MultifrontalSolver solver(matrix, kind);
  solver.factorize(matrix);
  return solver.solve(right);
}

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return (a - b).norm() / b.norm();
}

TEST(MultifrontalSolver, CholeskyEqualsADenseSolve)
{
  for (const auto& [name, matrix] : definiteMatrices())
  {
    SCOPED_TRACE(name);
    const Eigen::MatrixXd right = randomMatrix(matrix.rows(), 3, 1);
    EXPECT_LT(
      difference(solved(Kind::Cholesky, matrix, right), test::denseSolution(matrix, right)), 1e-12);
    // LU takes symmetric matrices as well.
    EXPECT_LT(
      difference(solved(Kind::LU, matrix, right), test::denseSolution(matrix, right)), 1e-12);
  }
}

TEST(MultifrontalSolver, SelectedRowsEqualThoseOfAWholeSolve)
{
  for (const auto& [name, matrix] : definiteMatrices())
  {
    SCOPED_TRACE(name);
    const Index n = matrix.rows();
    std::vector<Index> rows(static_cast<std::size_t>(n));
    std::iota(rows.begin(), rows.end(), Index{ 0 });
    std::shuffle(rows.begin(), rows.end(), std::mt19937(5));
    for (const Kind kind : { Kind::Cholesky, Kind::LU })
    {
      MultifrontalSolver solver(matrix, kind);
      solver.factorize(matrix);
      for (const Index count : { Index{ 1 }, (n + 9) / 10, n })
      {
        const std::vector<Index> some(rows.begin(), rows.begin() + count);
        const Eigen::MatrixXd right = randomMatrix(count, 2, 6);
        Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n, 2);
        for (Index i = 0; i < count; ++i)
        {
          all.row(some[static_cast<std::size_t>(i)]) = right.row(i);
        }
        const Eigen::MatrixXd whole = solver.solve(all);
        const Eigen::MatrixXd part = solver.solve(solver.select(some), right);
        ASSERT_EQ(part.rows(), count);
        for (Index i = 0; i < count; ++i)
        {
          EXPECT_LE((part.row(i) - whole.row(some[static_cast<std::size_t>(i)])).norm(),
            1e-14 * whole.norm());
        }
      }
    }
  }
}

TEST(MultifrontalSolver, FewRowsTouchLittleOfTheFactor)
{
  const TriangleMesh mesh = test::disk(40, 120);
  const SparseMatrix matrix =
    shifted(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), 0.5);
  const MultifrontalSolver solver(matrix, Kind::Cholesky, mesh.points);
  std::vector<Index> rows(static_cast<std::size_t>(matrix.rows()));
  std::iota(rows.begin(), rows.end(), Index{ 0 });
  const std::size_t all = solver.select(rows).fronts.size();
  EXPECT_LT(solver.select({ 17 }).fronts.size(), all / 20);
  EXPECT_TRUE(solver.select({}).fronts.empty());
}

TEST(MultifrontalSolver, LUEqualsADenseSolveOnMeanValueLaplacians)
{
  for (const TriangleMesh& mesh :
    { curvedPlate(12), curvedPlate(24), twoPlates(), test::disk(9, 30) })
  {
    const SparseMatrix laplacian = hexsweep::meanValueLaplacian(mesh.points, mesh.triangles);
    const SparseMatrix matrix =
      shifted(laplacian, 1.0 / laplacian.diagonal().cwiseInverse().mean());
    ASSERT_GT(
      (Eigen::MatrixXd(matrix) - Eigen::MatrixXd(matrix.transpose())).norm(), 0.01 * matrix.norm());
    const Eigen::MatrixXd right = randomMatrix(matrix.rows(), 3, 1);
    EXPECT_LT(
      difference(solved(Kind::LU, matrix, right), test::denseSolution(matrix, right)), 1e-11);
  }
}

TEST(MultifrontalSolver, EqualsEigensSparseFactorsOnALargeSurface)
{
  const TriangleMesh mesh = curvedPlate(96);
  const Eigen::MatrixXd right = randomMatrix(mesh.points.rows(), 2, 4);
  const SparseMatrix symmetric =
    shifted(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), 1e-3);
  const Eigen::SimplicialLDLT<SparseMatrix> ldlt(symmetric);
  EXPECT_LT(difference(solved(Kind::Cholesky, symmetric, right), ldlt.solve(right)), 1e-9);
  const SparseMatrix laplacian = hexsweep::meanValueLaplacian(mesh.points, mesh.triangles);
  const SparseMatrix unsymmetric = shifted(laplacian, 1e-3 * laplacian.diagonal().mean());
  Eigen::SparseLU<SparseMatrix> lu(unsymmetric);
  EXPECT_LT(difference(solved(Kind::LU, unsymmetric, right), lu.solve(right)), 1e-9);
}

TEST(MultifrontalSolver, LUPivotsWithinAPart)
{
  // Eight rows are one part; their diagonal is zero.
  Eigen::MatrixXd dense = randomMatrix(8, 8, 3);
  dense.diagonal().setZero();
  SparseMatrix matrix(8, 8);
  for (Index j = 0; j < 8; ++j)
  {
    for (Index i = 0; i < 8; ++i)
    {
      matrix.insert(i, j) = dense(i, j);
    }
  }
  matrix.makeCompressed();
  const Eigen::MatrixXd right = randomMatrix(8, 2, 1);
  EXPECT_LT(difference(solved(Kind::LU, matrix, right), test::denseSolution(dense, right)), 1e-11);
}

TEST(MultifrontalSolver, OnePatternManyMatrices)
{
  const TriangleMesh mesh = curvedPlate(24);
  TriangleMesh other = mesh;
  other.points =
    test::lifted(mesh.points, [](double x, double y) { return std::sin(5.0 * x * y); });
  const Eigen::MatrixXd right = randomMatrix(mesh.points.rows(), 2, 1);
  for (const Kind kind : { Kind::Cholesky, Kind::LU })
  {
    MultifrontalSolver solver(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), kind);
    SparseMatrix part = shifted(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), 1.0);
    part.prune([](Index i, Index j, double) { return i == j || (i + j) % 3 != 0; });
    part = shifted(part, 40.0); // definite again
    for (const SparseMatrix& matrix :
      { shifted(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), 1.0),
        shifted(hexsweep::cotangentLaplacian(other.points, other.triangles), 1.0), part })
    {
      solver.factorize(matrix);
      EXPECT_LT(difference(solver.solve(right), test::denseSolution(matrix, right)), 1e-10);
    }
  }
}

TEST(MultifrontalSolver, AnyNumberOfColumns)
{
  const SparseMatrix matrix = pathMatrix(200);
  MultifrontalSolver solver(matrix, Kind::Cholesky);
  solver.factorize(matrix);
  const Eigen::MatrixXd right = randomMatrix(200, 50, 2);
  const Eigen::MatrixXd all = solver.solve(right);
  EXPECT_LT(difference(matrix * all, right), 1e-13);
  for (const Index k : { 0, 17, 49 })
  {
    EXPECT_LT(difference(solver.solve(right.col(k)), all.col(k)), 1e-14);
  }
  EXPECT_EQ(solver.solve(Eigen::MatrixXd(200, 0)).cols(), 0);
}

TEST(MultifrontalSolver, ScaleDoesNotMatter)
{
  const TriangleMesh mesh = curvedPlate(24);
  const SparseMatrix matrix =
    shifted(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), 0.5);
  const Eigen::MatrixXd right = randomMatrix(matrix.rows(), 1, 1);
  const Eigen::MatrixXd expected = solved(Kind::Cholesky, matrix, right);
  for (const double scale : { 0x1p-300, 0x1p300 })
  {
    for (const Kind kind : { Kind::Cholesky, Kind::LU })
    {
      EXPECT_LT(
        difference(scale * solved(kind, SparseMatrix(scale * matrix), right), expected), 1e-12);
    }
  }
}

TEST(MultifrontalSolver, TwiceGivesTheSameBits)
{
  const TriangleMesh mesh = curvedPlate(24);
  const SparseMatrix matrix =
    shifted(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), 0.5);
  const Eigen::MatrixXd right = randomMatrix(matrix.rows(), 2, 1);
  for (const Kind kind : { Kind::Cholesky, Kind::LU })
  {
    EXPECT_EQ(solved(kind, matrix, right), solved(kind, matrix, right));
  }
}

TEST(MultifrontalSolver, BlocksOfRowsAreOrderedAsOne)
{
  const TriangleMesh mesh = curvedPlate(24);
  const SparseMatrix matrix =
    inPairs(shifted(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), 0.5));
  const Eigen::MatrixXd right = randomMatrix(matrix.rows(), 2, 7);
  const Eigen::MatrixXd truth = test::denseSolution(matrix, right);
  for (const hexsweep::Points& places : { hexsweep::Points(0, 3), mesh.points })
  {
    MultifrontalSolver solver(matrix, Kind::Cholesky, places, 2);
    solver.factorize(matrix);
    EXPECT_LT(difference(solver.solve(right), truth), 1e-12);
  }
}

TEST(MultifrontalSolver, BranchesInAnyOrderGiveTheSameBits)
{
  const TriangleMesh mesh = curvedPlate(96); // enough for several branches
  const SparseMatrix plate =
    shifted(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), 0.5);
  const Eigen::MatrixXd right = randomMatrix(2 * plate.rows(), 2, 7);
  for (const Kind kind : { Kind::Cholesky, Kind::LU })
  {
    const SparseMatrix matrix = inPairs(plate);
    MultifrontalSolver solver(matrix, kind, mesh.points, 2);
    solver.factorize(matrix);
    const Eigen::MatrixXd one = solver.solve(right);
    hexsweep::Index pieces = 0;
    solver.factorize(matrix, [&](hexsweep::Index count, const auto& call) {
      pieces = count;
      test::backwards(count, call);
    });
    EXPECT_GT(pieces, 8);
    EXPECT_EQ(one, solver.solve(right));
    solver.factorize(matrix, test::sideBySide);
    EXPECT_EQ(one, solver.solve(right));
  }
}

TEST(MultifrontalSolver, SingularMatricesAreErrors)
{
  const auto expectFailure = [](Kind kind, const SparseMatrix& matrix) {
    MultifrontalSolver solver(matrix, kind);
    EXPECT_THROW(solver.factorize(matrix), hexsweep::SolverFailure);
  };
  const TriangleMesh mesh = curvedPlate(24);
  const SparseMatrix matrix =
    shifted(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles), 0.5);
  const Index n = matrix.rows();
  for (const Kind kind : { Kind::Cholesky, Kind::LU })
  {
    SparseMatrix zero = diagonalMatrix(1);
    zero.coeffRef(0, 0) = 0.0;
    expectFailure(kind, zero);
    for (const Index row : { Index(0), n / 2, n - 1 })
    {
      SparseMatrix empty = matrix;
      empty.prune([row](Index i, Index j, double) { return i != row && j != row; });
      expectFailure(kind, empty);
      SparseMatrix notFinite = matrix;
      notFinite.coeffRef(row, row) = std::numeric_limits<double>::quiet_NaN();
      expectFailure(kind, notFinite);
    }
  }
  SparseMatrix indefinite = matrix;
  indefinite.coeffRef(n / 3, n / 3) -= 100.0;
  expectFailure(Kind::Cholesky, indefinite);
  expectFailure(Kind::Cholesky, -matrix);
  // Exactly singular: weights whose sums and quotients have no rounding.
  SparseMatrix path = pathMatrix(2);
  path.coeffRef(0, 0) = path.coeffRef(1, 1) = 1.0;
  expectFailure(Kind::Cholesky, path);
  expectFailure(Kind::LU, path);
}

TEST(MultifrontalSolver, AFailedFactorIsReplacedByTheNext)
{
  const SparseMatrix matrix = pathMatrix(100);
  MultifrontalSolver solver(matrix, Kind::Cholesky);
  EXPECT_THROW(solver.factorize(-matrix), hexsweep::SolverFailure);
  solver.factorize(matrix);
  const Eigen::MatrixXd right = randomMatrix(100, 1, 2);
  EXPECT_LT(difference(matrix * solver.solve(right), right), 1e-13);
}
}

// SPDX-License-Identifier: BSD-3-Clause
// What an elimination tree must be, on graphs of many shapes, and the fill that it leaves.
#include "Core/Solvers/NestedDissection.h"
#include "Core/Solvers/SurfaceLaplacian.h"

#include "Support/CapMeshes.h"

#include <Eigen/SparseCholesky>

#include <numeric>

namespace TestNestedDissection
{
using hexsweep::Dissection;
using hexsweep::Index;
using hexsweep::SparseMatrix;

/// The Laplacian of a graph plus one, from its edges.
SparseMatrix graphMatrix(int n, const std::vector<std::pair<int, int>>& edges)
{
  std::vector<Eigen::Triplet<double, int>> entries;
  for (int i = 0; i < n; ++i)
  {
    entries.emplace_back(i, i, 1.0);
  }
  for (const auto& [a, b] : edges)
  {
    entries.emplace_back(a, b, -1.0);
    entries.emplace_back(b, a, -1.0);
    entries.emplace_back(a, a, 1.0);
    entries.emplace_back(b, b, 1.0);
  }
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

SparseMatrix meshMatrix(const hexsweep::TriangleMesh& mesh)
{
  return hexsweep::meanValueLaplacian(mesh.points, mesh.triangles);
}

std::vector<std::pair<std::string, SparseMatrix>> graphs()
{
  std::vector<std::pair<std::string, SparseMatrix>> result;
  result.emplace_back("one row", graphMatrix(1, {}));
  result.emplace_back("rows without neighbours", graphMatrix(137, {}));
  std::vector<std::pair<int, int>> path;
  std::vector<std::pair<int, int>> star;
  std::vector<std::pair<int, int>> complete;
  std::vector<std::pair<int, int>> pieces;
  for (int i = 1; i < 300; ++i)
  {
    path.emplace_back((i - 1) * 7 % 300, i * 7 % 300);
    star.emplace_back(17, i <= 17 ? i - 1 : i);
    for (int j = 0; j < i && i < 60; ++j)
    {
      complete.emplace_back(j, i);
    }
    if (i % 50 != 0)
    {
      pieces.emplace_back(i - 1, i);
    }
  }
  result.emplace_back("a path", graphMatrix(300, path));
  result.emplace_back("a star", graphMatrix(300, star));
  result.emplace_back("a complete graph", graphMatrix(60, complete));
  result.emplace_back("six paths", graphMatrix(300, pieces));
  result.emplace_back("a plate with holes",
    meshMatrix(test::plate(36, { { 6, 6, 6, 6 }, { 21, 9, 9, 6 }, { 12, 21, 6, 9 } }, 0.3)));
  result.emplace_back("an annulus", meshMatrix(test::annulus(0.3, 1.0, 12, 144)));
  // Two plates and, between them, points that nothing uses.
  hexsweep::TriangleMesh two = test::plate(15, { { 3, 3, 2, 2 } });
  const Index n = two.points.rows();
  const Index m = two.triangles.rows();
  two.points.conservativeResize(2 * n + 5, 3);
  two.points.bottomRows(n) = two.points.topRows(n).eval();
  two.triangles.conservativeResize(2 * m, 3);
  two.triangles.bottomRows(m) = two.triangles.topRows(m).array() + (n + 5);
  result.emplace_back("two plates", meshMatrix(two));
  return result;
}

/// For each row the part that eliminates it, once the parts are known to be a tree in order.
std::vector<int> checkedParts(const Dissection& dissection, Index n)
{
  std::vector<int> part(static_cast<std::size_t>(n), -1);
  EXPECT_EQ(dissection.order.size(), static_cast<std::size_t>(n));
  int place = 0;
  for (int k = 0; k < static_cast<int>(dissection.parts.size()); ++k)
  {
    const Dissection::Part& p = dissection.parts[static_cast<std::size_t>(k)];
    EXPECT_EQ(p.begin, place);
    EXPECT_LE(p.begin, p.end);
    EXPECT_TRUE(p.parent == -1 || p.parent > k);
    EXPECT_LT(p.parent, static_cast<int>(dissection.parts.size()));
    for (place = p.begin; place < p.end; ++place)
    {
      int& owner =
        part[static_cast<std::size_t>(dissection.order[static_cast<std::size_t>(place)])];
      EXPECT_EQ(owner, -1) << "row twice";
      owner = k;
    }
  }
  EXPECT_EQ(place, n);
  return part;
}

bool onOneBranch(const Dissection& dissection, int a, int b)
{
  for (int low = std::min(a, b); low >= 0;
       low = dissection.parts[static_cast<std::size_t>(low)].parent)
  {
    if (low == std::max(a, b))
    {
      return true;
    }
  }
  return false;
}

void check(const SparseMatrix& matrix, const hexsweep::PointsRef& places)
{
  const Dissection dissection = hexsweep::dissect(matrix, places);
  const std::vector<int> part = checkedParts(dissection, matrix.rows());
  const auto joined = [&](Index a, Index b) {
    return onOneBranch(
      dissection, part[static_cast<std::size_t>(a)], part[static_cast<std::size_t>(b)]);
  };
  for (Index j = 0; j < matrix.outerSize(); ++j)
  {
    for (SparseMatrix::InnerIterator it(matrix, j); it; ++it)
    {
      ASSERT_TRUE(joined(it.row(), j)) << "entry " << it.row() << ", " << j;
    }
  }
  const Dissection again = hexsweep::dissect(matrix, places);
  EXPECT_EQ(again.order, dissection.order);
  EXPECT_EQ(again.parts.size(), dissection.parts.size());
}

/// Entries of a Cholesky factor in this order.
Index fill(const SparseMatrix& matrix, const std::vector<int>& order)
{
  Eigen::VectorXi place(matrix.rows());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    place[order[k]] = static_cast<int>(k);
  }
  const Eigen::PermutationMatrix<Eigen::Dynamic> permutation(place);
  const SparseMatrix reordered = permutation * matrix * permutation.transpose();
  const Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> cholesky(
    reordered);
  EXPECT_EQ(cholesky.info(), Eigen::Success);
  return SparseMatrix(cholesky.matrixL()).nonZeros();
}

TEST(NestedDissection, BranchesHaveNoEntryInCommon)
{
  for (const auto& [name, matrix] : graphs())
  {
    SCOPED_TRACE(name);
    check(matrix, hexsweep::Points(0, 3));
  }
}

TEST(NestedDissection, PlacesInSpace)
{
  // Those of the mesh, and nonsense: the order may be bad then, but never wrong.
  const hexsweep::TriangleMesh mesh = test::plate(36, { { 6, 6, 6, 6 }, { 21, 9, 9, 6 } }, 0.3);
  check(meshMatrix(mesh), mesh.points);
  hexsweep::Points scattered = mesh.points;
  std::mt19937 generator(5);
  std::shuffle(scattered.data(), scattered.data() + scattered.size(), generator);
  check(meshMatrix(mesh), scattered);
  check(meshMatrix(mesh), hexsweep::Points::Zero(mesh.points.rows(), 3));
  // With the true places the factor is no fuller than with those guessed from the graph.
  SparseMatrix matrix = hexsweep::cotangentLaplacian(mesh.points, mesh.triangles);
  for (Index i = 0; i < matrix.rows(); ++i)
  {
    matrix.coeffRef(i, i) += 1.0;
  }
  EXPECT_LT(20 * fill(matrix, hexsweep::dissect(matrix, mesh.points).order),
    21 * fill(matrix, hexsweep::dissect(matrix).order));
}

// What is not connected is ordered as if each part were alone: its factor is as full.
TEST(NestedDissection, FillOfADisconnectedGraphIsTheSumOfItsParts)
{
  const hexsweep::TriangleMesh plate = test::plate(36, { { 6, 6, 6, 6 } }, 0.3);
  const Index n = plate.points.rows();
  const auto copies = [&](Index count) {
    hexsweep::TriangleMesh mesh = plate;
    mesh.triangles.resize(count * plate.triangles.rows(), 3);
    mesh.points.resize(count * n, 3);
    for (Index k = 0; k < count; ++k)
    {
      mesh.points.middleRows(k * n, n) = plate.points;
      mesh.triangles.middleRows(k * plate.triangles.rows(), plate.triangles.rows()) =
        plate.triangles.array() + k * n;
    }
    SparseMatrix matrix = hexsweep::cotangentLaplacian(mesh.points, mesh.triangles);
    for (Index i = 0; i < matrix.rows(); ++i)
    {
      matrix.coeffRef(i, i) += 1.0;
    }
    return std::make_pair(matrix, mesh.points);
  };
  const auto [one, places] = copies(1);
  for (const Index count : { 2, 3, 5 })
  {
    const auto [many, manyPlaces] = copies(count);
    EXPECT_EQ(
      fill(many, hexsweep::dissect(many).order), count * fill(one, hexsweep::dissect(one).order));
    // Of copies one on top of the other, too.
    EXPECT_EQ(fill(many, hexsweep::dissect(many, manyPlaces).order),
      count * fill(one, hexsweep::dissect(one, places).order));
  }
}

TEST(NestedDissection, AnEmptyMatrix)
{
  const Dissection dissection = hexsweep::dissect(SparseMatrix(0, 0));
  EXPECT_TRUE(dissection.order.empty());
  EXPECT_TRUE(dissection.parts.empty());
}

TEST(NestedDissection, FillGrowsAsNLogN)
{
  // A separator of n^(1/2) rows gives n log n. Minimum degree wins on meshes of this size, by less
  // the larger they are.
  for (const int size : { 30, 60, 120 })
  {
    const int c = size / 10;
    const hexsweep::TriangleMesh mesh =
      test::plate(size, { { 2 * c, 2 * c, c, c }, { 5 * c, 6 * c, 2 * c, c } }, 0.3);
    SparseMatrix matrix = hexsweep::cotangentLaplacian(mesh.points, mesh.triangles);
    for (Index i = 0; i < matrix.rows(); ++i)
    {
      matrix.coeffRef(i, i) += 1.0;
    }
    const auto n = static_cast<double>(matrix.rows());
    const auto ours = static_cast<double>(fill(matrix, hexsweep::dissect(matrix).order));
    EXPECT_LT(ours, 2.6 * n * std::log2(n)) << size;
    const Eigen::SimplicialLLT<SparseMatrix> amd(matrix);
    EXPECT_LT(ours, 1.5 * static_cast<double>(SparseMatrix(amd.matrixL()).nonZeros())) << size;
  }
}
}

// SPDX-License-Identifier: BSD-3-Clause
// The paper's voxel grid against closed forms, and the prism solver against the voxel grid.
#include "Support/VoxelHarmonics.h"

#include "Core/Solvers/PrismSolver.h"
#include "Core/Solvers/QuadLaplacian.h"
#include "Support/CageTests.h"
#include "Support/DenseTruth.h"

#include <sstream>

namespace TestVoxelHarmonics
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::Quads;
using test::VoxelHarmonics;

/// A leaning prism over a parallelogram, turned out of the grid's directions: n x n x n hexahedra.
struct LeaningPrism
{
  explicit LeaningPrism(Index n)
    : Cells(n)
    , Cap((n + 1) * (n + 1), 3)
    , CapQuads(n * n, 4)
  {
    for (Index j = 0; j <= n; ++j)
    {
      for (Index i = 0; i <= n; ++i)
      {
        this->Cap.row(j * (n + 1) + i) = this->place(i, j, 0);
      }
    }
    for (Index j = 0; j < n; ++j)
    {
      for (Index i = 0; i < n; ++i)
      {
        const Index first = j * (n + 1) + i;
        this->CapQuads.row(j * n + i) << first, first + 1, first + n + 2, first + n + 1;
      }
    }
  }

  Eigen::RowVector3d place(Index i, Index j, Index k) const
  {
    const Eigen::Vector3d cell =
      Eigen::Vector3d(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)) /
      static_cast<double>(this->Cells);
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    return (turn * Eigen::Vector3d(cell.x() + 0.3 * cell.y(), 0.9 * cell.y(), 0.8 * cell.z()))
      .transpose();
  }

  /// Row of a grid node of the swept points.
  Index row(Index i, Index j, Index k) const
  {
    return (k * (this->Cells + 1) + j) * (this->Cells + 1) + i;
  }

  bool isInside(Index i, Index j, Index k) const
  {
    return std::min({ i, j, k }) > 0 && std::max({ i, j, k }) < this->Cells;
  }

  Index Cells;
  Points Cap;
  Quads CapQuads;
};

/// The cage of 2 x 2 x 2 hexahedra with its triangulation.
struct CoarseCage
{
  CoarseCage()
  {
    const LeaningPrism prism(2);
    Points swept(27, 3);
    for (Index k = 0; k <= 2; ++k)
    {
      for (Index j = 0; j <= 2; ++j)
      {
        for (Index i = 0; i <= 2; ++i)
        {
          swept.row(prism.row(i, j, k)) = prism.place(i, j, k);
        }
      }
    }
    const auto mesh =
      hexsweep::triangulateCage(hexsweep::cageQuads(prism.CapQuads, swept, 2), swept, swept);
    this->Vertices = hexsweep::cageVertices(mesh, swept);
    this->Triangles = mesh.triangles;
    // Three coordinates: of a corner, of the middle of an edge, of the middle of a cap.
    this->Values = Points::Zero(this->Vertices.rows(), 3);
    int column = 0;
    for (const Index row : { prism.row(0, 0, 0), prism.row(1, 2, 2), prism.row(1, 1, 0) })
    {
      const auto found = std::find(mesh.nodes.begin(), mesh.nodes.end(), row);
      this->Values(found - mesh.nodes.begin(), column++) = 1.0;
    }
  }

  /// Piecewise linear at a point of the cage: the triangle that it is in.
  Eigen::RowVector3d valueAt(const Eigen::RowVector3d& point) const
  {
    Eigen::RowVector3d value;
    double best = -1e9;
    for (Index t = 0; t < this->Triangles.rows(); ++t)
    {
      Eigen::Matrix3d corners;
      Eigen::Matrix3d values;
      for (int c = 0; c < 3; ++c)
      {
        corners.row(c) = this->Vertices.row(this->Triangles(t, c));
        values.row(c) = this->Values.row(this->Triangles(t, c));
      }
      // Weights in the plane of the triangle; what is left is the distance from it.
      Eigen::Matrix<double, 3, 2> edges;
      edges << (corners.row(1) - corners.row(0)).transpose(),
        (corners.row(2) - corners.row(0)).transpose();
      const Eigen::Vector3d offset = (point - corners.row(0)).transpose();
      const Eigen::Vector2d st = test::leastSquaresSolution(edges, offset);
      const Eigen::RowVector3d weights(1 - st.sum(), st[0], st[1]);
      const double inside = weights.minCoeff() - 1e3 * (edges * st - offset).norm();
      if (inside > best)
      {
        best = inside;
        value = weights * values;
      }
    }
    EXPECT_GT(best, -1e-9);
    return value;
  }

  Points Vertices;
  hexsweep::Triangles Triangles;
  Points Values;
};

/// The three coordinates by the prism solver with n x n x n hexahedra.
Points prismValues(const CoarseCage& cage, const LeaningPrism& prism)
{
  const Index n = prism.Cells;
  Points values = Points::Zero((n + 1) * (n + 1) * (n + 1), 3);
  std::vector<Index> loop;
  for (Index j = 0; j <= n; ++j)
  {
    for (Index i = 0; i <= n; ++i)
    {
      if (!prism.isInside(i, j, 1))
      {
        loop.push_back(prism.row(i, j, 0));
      }
      for (Index k = 0; k <= n; ++k)
      {
        if (!prism.isInside(i, j, k))
        {
          values.row(prism.row(i, j, k)) = cage.valueAt(prism.place(i, j, k));
        }
      }
    }
  }
  return hexsweep::PrismSolver(
    hexsweep::quadLaplacian(prism.Cap, prism.CapQuads), n, 0.8 / static_cast<double>(n), loop)
    .extend(values);
}

TEST(VoxelHarmonics, TendToBarycentricCoordinatesOfATetrahedron)
{
  Points corners(4, 3);
  corners << 0.1, 0, 0, 1, 0.2, 0.1, 0.3, 1, 0, 0.4, 0.3, 1;
  hexsweep::Triangles triangles(4, 3);
  triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3;
  // Three of the four coordinates; the grid takes three functions at once.
  Points unit = Points::Zero(4, 3);
  unit.topRows(3).setIdentity();
  const Eigen::RowVector4d inside(0.3, 0.25, 0.25, 0.2);
  double last = 1.0;
  for (const Index cells : { 12, 24, 48 })
  {
    const VoxelHarmonics grid(corners, triangles, cells, unit, {});
    const double error = (grid.at(inside * corners) - inside.leftCols(3)).cwiseAbs().maxCoeff();
    EXPECT_LT(error, last) << cells;
    last = error;
  }
  EXPECT_LT(last, 0.02);
}

TEST(VoxelHarmonics, TagsTheVolume)
{
  // A cube of edge 1 and 20 cells along it. Its faces fall on those of cells, so that the boundary
  // cells are those on one side of a face or the other.
  Points corners(8, 3);
  corners << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  hexsweep::Triangles triangles(12, 3);
  triangles << 0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2,
    7, 6, 3, 0, 4, 3, 4, 7;
  const VoxelHarmonics grid(corners, triangles, 20, corners, {});
  const double cell = std::pow(grid.step(), 3);
  const double inside = static_cast<double>(grid.count(VoxelHarmonics::Tag::Interior)) * cell;
  const double shell = static_cast<double>(grid.count(VoxelHarmonics::Tag::Boundary)) * cell;
  EXPECT_EQ(grid.count(VoxelHarmonics::Tag::Untyped), 0);
  // The surface lies in the shell of boundary cells.
  EXPECT_LT(inside, 1.0);
  EXPECT_GT(inside + shell, 1.0);
  EXPECT_GT(inside, std::pow(1 - 2.1 * grid.step(), 3));
  // Coordinates are harmonic themselves.
  EXPECT_LT((grid.at({ 0.4, 0.5, 0.3 }) - Eigen::RowVector3d(0.4, 0.5, 0.3)).norm(), 0.03);
}

TEST(VoxelHarmonics, DifferFromThePrismSolverLessWhenBothAreRefined)
{
  const CoarseCage cage;
  const LeaningPrism places(4);
  std::ostringstream table;
  double last = 0.0;
  std::function<Eigen::RowVector3d(const Eigen::RowVector3d&)> start;
  std::vector<VoxelHarmonics> grids;
  grids.reserve(4);
  for (const Index level : { 0, 1, 2, 3 })
  {
    const LeaningPrism prism(Index{ 4 } << level);
    const Points byPrism = prismValues(cage, prism);
    const Index cells = Index{ 10 } << level;
    grids.emplace_back(cage.Vertices, cage.Triangles, cells, cage.Values, start);
    const VoxelHarmonics& grid = grids.back();
    start = [&grid](const Eigen::RowVector3d& point) { return grid.at(point); };

    // At the inner nodes of the coarsest prism, which all of them have.
    double sum2 = 0.0;
    Index count = 0;
    for (Index k = 1; k < 4; ++k)
    {
      for (Index j = 1; j < 4; ++j)
      {
        for (Index i = 1; i < 4; ++i)
        {
          const Index scale = prism.Cells / 4;
          const Eigen::RowVector3d difference = grid.at(places.place(i, j, k)) -
            byPrism.row(prism.row(scale * i, scale * j, scale * k));
          sum2 += difference.squaredNorm();
          count += 3;
        }
      }
    }
    const double difference = std::sqrt(sum2 / static_cast<double>(count));
    table << prism.Cells << "^3 hexes, " << cells << " cells: " << difference << "; ";
    if (level > 0)
    {
      EXPECT_GT(last / difference, 1.5) << table.str();
    }
    last = difference;
  }
  RecordProperty("RootMeanSquareDifference", table.str());
}
}

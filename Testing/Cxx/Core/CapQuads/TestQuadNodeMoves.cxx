// SPDX-License-Identifier: BSD-3-Clause
#include "Support/CapMeshes.h"
#include "Support/LentThreads.h"

#include "Core/CapQuads/QuadNodeMoves.h"
#include "Core/Surfaces/SurfaceTopology.h"

namespace TestQuadNodeMoves
{
using namespace hexsweep;
using namespace test;

std::vector<bool> boundaryOf(const QuadMesh& mesh)
{
  std::vector<bool> fixed(static_cast<std::size_t>(mesh.points.rows()), false);
  for (const Loop& loop : checkSurface(mesh.quads, mesh.points.rows(), "quads").loops)
  {
    for (const Index i : loop)
    {
      fixed[static_cast<std::size_t>(i)] = true;
    }
  }
  return fixed;
}

/// A shaken grid in a square with holes, over coarse or curved triangles.
struct ShakenGrid
{
  QuadMesh quads;
  QuadMesh straight;
  TriangleMesh surface;

  ShakenGrid(int cells, const std::vector<Block>& holes, double shake, double bulge)
    : quads(quadPlate(cells, holes, shake))
    , straight(quadPlate(cells, holes))
    , surface(plate(2 * cells, {}))
  {
    for (Points* points : { &this->quads.points, &this->straight.points, &this->surface.points })
    {
      for (Index i = 0; i < points->rows(); ++i)
      {
        (*points)(i, 2) = bulge * points->row(i).head<2>().squaredNorm();
      }
    }
    this->quads.points = SurfaceSearch(this->surface).project(this->quads.points).points;
  }

  /// With columns along z at every second boundary node.
  CapCorners corners(bool columns, const ParallelFor& parallelFor = {}) const
  {
    const std::vector<bool> fixed = boundaryOf(this->quads);
    std::vector<ColumnDirection> directions;
    for (std::size_t i = 0; i < fixed.size(); i += 2)
    {
      if (fixed[i] && columns)
      {
        directions.push_back({ static_cast<Index>(i), { 0.1, -0.2, 1.0 } });
      }
    }
    return CapCorners(this->quads.quads, fixed, this->surface, directions, this->quads.points,
      hexsweep::LeaningColumns::PassedOver, parallelFor);
  }
};

QuadNodeMoves::Losses same(const CornerLoss& loss, const CapCorners& corners, double floor)
{
  return { loss, std::vector<CornerLoss>(static_cast<std::size_t>(corners.numberOfColumns()), loss),
    floor };
}

const std::vector<Block>& twoHoles()
{
  static const std::vector<Block> holes = { { 2, 2, 2, 2 }, { 7, 6, 3, 3 } };
  return holes;
}

TEST(QuadNodeMoves, BringAGridBackToItsSquares)
{
  const ShakenGrid grid(8, {}, 0.25, 0.0);
  const CapCorners corners = grid.corners(false);
  QuadNodeMoves moves(corners, grid.quads.points, grid.straight.points);
  const double given = moves.least();
  moves.wake(2.0);
  for (int sweep = 0; sweep < 200 && moves.sweep(same({}, corners, given)) > 0; ++sweep)
  {
  }
  // The grid of squares is where both sums are least; steps end where they gain a hundredth.
  EXPECT_LT((moves.points() - grid.straight.points).rowwise().norm().maxCoeff(), 0.02 / 8);
  EXPECT_GT(moves.least(), 0.99);
}

TEST(QuadNodeMoves, LeastIsThatOfTheCorners)
{
  for (const double bulge : { 0.0, 0.4 })
  {
    const ShakenGrid grid(12, twoHoles(), 0.3, bulge);
    const CapCorners corners = grid.corners(true);
    QuadNodeMoves moves(corners, grid.quads.points, grid.straight.points);
    EXPECT_NEAR(moves.least(), corners.measure(grid.quads.points).minimum, 1e-12);
    moves.wake(2.0);
    moves.sweep(same({}, corners, moves.least()));
    EXPECT_NEAR(moves.least(), corners.measure(moves.points()).minimum, 1e-12);
  }
}

TEST(QuadNodeMoves, NoCornerFallsBelowTheFloor)
{
  for (const double bulge : { 0.0, 0.4 })
  {
    for (const double sharpness : { 0.0, 20.0, 80.0 })
    {
      const ShakenGrid grid(12, twoHoles(), 0.25, bulge);
      const CapCorners corners = grid.corners(true);
      const CornerQuality before = corners.measure(grid.quads.points);
      ASSERT_EQ(before.inverted, 0);
      QuadNodeMoves moves(corners, grid.quads.points, grid.straight.points);
      const double floor = moves.least();
      const CornerLoss loss{ sharpness, sharpness > 0.0 ? floor : 0.9 * floor };
      moves.wake(2.0);
      Index moved = 0;
      for (int sweep = 0; sweep < 6; ++sweep)
      {
        moved += moves.sweep(same(loss, corners, floor));
        EXPECT_GE(moves.least(), floor);
      }
      EXPECT_GT(moved, 0);
    }
  }
}

TEST(QuadNodeMoves, NodesStayOnTheSurfaceAndFixedOnesStay)
{
  const ShakenGrid grid(12, twoHoles(), 0.25, 0.4);
  const CapCorners corners = grid.corners(true);
  QuadNodeMoves moves(corners, grid.quads.points, grid.straight.points);
  moves.wake(2.0);
  moves.sweep(same({}, corners, moves.least()));
  const Points nearest = SurfaceSearch(grid.surface).project(moves.points()).points;
  EXPECT_LT((moves.points() - nearest).rowwise().norm().maxCoeff(), 1e-14);
  const std::vector<bool> fixed = boundaryOf(grid.quads);
  for (std::size_t i = 0; i < fixed.size(); ++i)
  {
    if (fixed[i])
    {
      EXPECT_EQ(
        moves.points().row(static_cast<Index>(i)), grid.quads.points.row(static_cast<Index>(i)));
    }
  }
}

TEST(QuadNodeMoves, OrderOfThePiecesDoesNotMatter)
{
  const ShakenGrid grid(40, twoHoles(), 0.25, 0.4);
  const auto moved = [&](const ParallelFor& parallelFor) -> Points {
    const CapCorners corners = grid.corners(true, parallelFor);
    QuadNodeMoves moves(corners, grid.quads.points, grid.straight.points);
    const double floor = moves.least();
    for (const double enough : { 2.0, 0.9 })
    {
      moves.wake(enough);
      for (int sweep = 0; sweep < 3; ++sweep)
      {
        moves.sweep(same({}, corners, floor));
      }
    }
    return moves.points();
  };
  const Points forwards = moved({});
  EXPECT_EQ(forwards, moved(backwards));
  EXPECT_EQ(forwards, moved(sideBySide));
}

TEST(QuadNodeMoves, ResetIsANewBeginning)
{
  const ShakenGrid grid(20, twoHoles(), 0.25, 0.4);
  const ShakenGrid other(20, twoHoles(), 0.1, 0.4);
  const CapCorners corners = grid.corners(true);
  QuadNodeMoves used(corners, other.quads.points, grid.straight.points);
  used.sweep(same({}, corners, used.least()));
  used.reset(grid.quads.points);
  QuadNodeMoves fresh(corners, grid.quads.points, grid.straight.points);
  EXPECT_EQ(used.least(), fresh.least());
  const double floor = fresh.least();
  EXPECT_EQ(used.sweep(same({}, corners, floor)), fresh.sweep(same({}, corners, floor)));
  EXPECT_EQ(used.points(), fresh.points());
}

TEST(QuadNodeMoves, SleepingNodesStay)
{
  const ShakenGrid grid(12, {}, 0.3, 0.0);
  const CapCorners corners = grid.corners(false);
  QuadNodeMoves moves(corners, grid.quads.points, grid.straight.points);
  moves.wake(moves.least()); // no corner is below the least
  EXPECT_EQ(moves.sweep(same({}, corners, moves.least())), 0);
  EXPECT_EQ(moves.points(), grid.quads.points);
}
}

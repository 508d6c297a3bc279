// SPDX-License-Identifier: BSD-3-Clause
#include "Support/CapMeshes.h"

#include "Core/CapQuads/QuadPolishing.h"
#include "Core/CapQuads/QuadQuality.h"

namespace TestQuadUntangling
{
using namespace hexsweep;
using namespace test;

/// Quads on a surface that is triangulated apart from them.
struct CapModel
{
  QuadMesh quads;
  Points upright; ///< the mesh before it was shaken
  TriangleMesh surface;
  std::vector<bool> fixed;

  CapCorners corners() const
  {
    return CapCorners(this->quads.quads, this->fixed, this->surface, {}, this->quads.points);
  }
};

using Shape = std::function<Eigen::RowVector3d(double x, double y)>;

Points shaped(const Points& flat, const Shape& shape)
{
  Points points(flat.rows(), 3);
  for (Index i = 0; i < flat.rows(); ++i)
  {
    points.row(i) = shape(flat(i, 0), flat(i, 1));
  }
  return points;
}

/// Inner nodes shaken by a multiple of a cell in the parameter square, then put on the surface.
CapModel model(
  int cells, const std::vector<Block>& holes, double shake, const Shape& shape, int surfaceCells)
{
  CapModel result;
  result.quads = quadPlate(cells, holes, shake);
  result.upright = shaped(quadPlate(cells, holes).points, shape);
  result.surface = plate(surfaceCells, {});
  result.surface.points = shaped(result.surface.points, shape);
  result.fixed.assign(static_cast<std::size_t>(result.quads.points.rows()), false);
  for (const Loop& loop :
    checkSurface(result.quads.quads, result.quads.points.rows(), "quads").loops)
  {
    for (const Index i : loop)
    {
      result.fixed[static_cast<std::size_t>(i)] = true;
    }
  }
  result.quads.points =
    SurfaceSearch(result.surface).project(shaped(result.quads.points, shape)).points;
  return result;
}

Shape flat()
{
  return [](double x, double y) { return Eigen::RowVector3d(x, y, 0.0); };
}

/// A square patch of the unit sphere that reaches from one pole to 127 degrees and more from it, by
/// stereographic projection: conformal, so that its corners are right angles.
Shape threeQuarterSphere()
{
  return [](double x, double y) {
    const Eigen::RowVector2d p(4.0 * x - 2.0, 4.0 * y - 2.0);
    const double square = p.squaredNorm();
    return Eigen::RowVector3d(
      Eigen::RowVector3d(2.0 * p.x(), 2.0 * p.y(), 1.0 - square) / (1.0 + square));
  };
}

/// Depth of the four dents of the rim, where the square's corners land.
constexpr double Dent = 0.1;

/// Radius of a round rim that is dented where the square's corners land: smooth, and concave there.
double dentedRadius(double angle)
{
  return 1.0 + Dent * std::cos(4.0 * angle);
}

/// The unit square onto the inside of that rim: squares become dented circles.
Eigen::RowVector3d ontoDentedDisk(double x, double y)
{
  const double u = 2.0 * x - 1.0;
  const double v = 2.0 * y - 1.0;
  const double radius = std::max(std::abs(u), std::abs(v));
  if (radius == 0.0)
  {
    return Eigen::RowVector3d::Zero();
  }
  const double quarter = std::atan(1.0);
  const double angle = std::abs(u) >= std::abs(v)
    ? quarter * v / u + (u > 0.0 ? 0.0 : 4.0 * quarter)
    : 2.0 * quarter - quarter * u / v + (v > 0.0 ? 0.0 : 4.0 * quarter);
  return radius * dentedRadius(angle) * Eigen::RowVector3d(std::cos(angle), std::sin(angle), 0.0);
}

/// A square of quads on the dented disk: one quad at each dent has more than 180 degrees there.
CapModel dentedModel(int cells, double shake)
{
  CapModel result = model(cells, {}, shake, flat(), 1);
  result.upright =
    shaped(result.upright, [](double x, double y) { return Eigen::RowVector3d(x, y, 0.0); });
  result.quads.points = shaped(result.quads.points, ontoDentedDisk);
  result.surface.points =
    shaped(result.surface.points, [](double x, double y) -> Eigen::RowVector3d {
      return Eigen::RowVector3d(4.0 * x - 2.0, 4.0 * y - 2.0, 0.0);
    });
  return result;
}

/// Sine of the angle at a dent, from the rim's nodes alone.
double sineAtDent(int cells)
{
  const double step = 2.0 * std::atan(1.0) / cells;
  const double angle = std::atan(1.0);
  const double side = dentedRadius(angle + step);
  const double half =
    std::atan2(side * std::sin(step), dentedRadius(angle) - side * std::cos(step));
  return std::sin(2.0 * half);
}

/// Which quads of a plane mesh have a corner <= 0.
std::vector<Index> invertedQuads(const Points& points, const Quads& quads)
{
  std::vector<Index> inverted;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    bool upright = true;
    for (Index c = 0; c < 4; ++c)
    {
      const Eigen::RowVector3d p = points.row(quads(q, c));
      const Eigen::RowVector3d a = points.row(quads(q, (c + 1) % 4)) - p;
      const Eigen::RowVector3d b = points.row(quads(q, (c + 3) % 4)) - p;
      upright = upright && a.x() * b.y() - a.y() * b.x() > 0.0;
    }
    if (!upright)
    {
      inverted.push_back(q);
    }
  }
  return inverted;
}

std::vector<Index> quadsAtCornersOfSquare(int cells)
{
  return { 0, cells - 1, cells * (cells - 1), cells * cells - 1 };
}

void expectUntangled(const CapModel& cap)
{
  const CapCorners corners = cap.corners();
  const CornerQuality before = corners.measure(cap.quads.points);
  ASSERT_GT(before.inverted, 0);
  const ImprovedQuads result = untangleQuads(corners, cap.quads.points, cap.upright);
  EXPECT_EQ(result.quality.inverted, 0);

  // Judged again by other code, on the surface.
  const SurfaceSearch surface(cap.surface);
  const SurfacePlaces places = surface.project(result.points);
  EXPECT_EQ(quadQuality(result.points, cap.quads.quads, places.normals).inverted, 0);
  EXPECT_LT((places.points - result.points).rowwise().norm().maxCoeff(), 1e-12);
  for (std::size_t i = 0; i < cap.fixed.size(); ++i)
  {
    if (cap.fixed[i])
    {
      const Index row = static_cast<Index>(i);
      ASSERT_EQ(result.points.row(row), cap.quads.points.row(row)) << "boundary node " << i;
    }
  }
}

TEST(QuadUntangling, CuresAShakenPlate)
{
  expectUntangled(model(12, {}, 1.5, flat(), 12));
}

TEST(QuadUntangling, CuresAShakenPlateWithHoles)
{
  expectUntangled(model(12, threeHoles(), 1.2, flat(), 24));
}

TEST(QuadUntangling, CuresQuadsOnThreeQuartersOfASphere)
{
  expectUntangled(model(16, {}, 0.9, threeQuarterSphere(), 48));
}

TEST(QuadUntangling, LeavesAnUprightMeshAlone)
{
  const CapModel cap = model(8, {}, 0.2, flat(), 8);
  const ImprovedQuads result = untangleQuads(cap.corners(), cap.quads.points, cap.upright);
  EXPECT_EQ(result.rounds, 0);
  EXPECT_EQ(result.points, cap.quads.points);
}

TEST(QuadUntangling, NamesWhatNoInnerNodeCanCure)
{
  // Two boundary nodes exchanged: the corners there are inverted for good.
  CapModel cap = model(6, {}, 0.0, flat(), 6);
  const Loop loop = checkSurface(cap.quads.quads, cap.quads.points.rows(), "quads").loops[0];
  cap.quads.points.row(loop[2]).swap(cap.quads.points.row(loop[3]));
  const CapCorners corners = cap.corners();
  const CornerQuality before = corners.measure(cap.quads.points);
  const ImprovedQuads result = untangleQuads(corners, cap.quads.points, cap.upright);
  EXPECT_GT(result.quality.inverted, 0);
  EXPECT_LE(result.quality.inverted, before.inverted);
  EXPECT_LT(result.rounds, 100); // of 300: it sees that it is stuck
}

TEST(QuadUntangling, GoesOnWhereManyRoundsAreNeeded)
{
  // Nodes thrown right across the plate: no wanted shape may be given up too early.
  const CapModel cap = model(16, {}, 8.0, flat(), 12);
  const ImprovedQuads result = untangleQuads(cap.corners(), cap.quads.points, cap.upright);
  EXPECT_GT(result.rounds, 10);
  EXPECT_EQ(result.quality.inverted, 0);
  EXPECT_TRUE(invertedQuads(result.points, cap.quads.quads).empty());
}

TEST(QuadUntangling, CuresAllButCornersBetweenFixedEdges)
{
  for (const int cells : { 8, 12, 20 })
  {
    const CapModel cap = dentedModel(cells, 1.2);
    const CapCorners corners = cap.corners();
    const CornerQuality before = corners.measure(cap.quads.points);
    ASSERT_GT(before.inverted, 0);
    EXPECT_EQ(before.fixedInverted, 4);
    const ImprovedQuads result = untangleQuads(corners, cap.quads.points, cap.upright);
    EXPECT_EQ(result.quality.inverted, 0);
    EXPECT_EQ(result.quality.fixedInverted, 4);
    EXPECT_LT(result.rounds, 40);
    EXPECT_EQ(invertedQuads(result.points, cap.quads.quads), quadsAtCornersOfSquare(cells));
  }
}

TEST(QuadUntangling, HasNothingToDoWhereOnlyFixedCornersAreInverted)
{
  CapModel cap = dentedModel(8, 1.2);
  cap.quads.points = untangleQuads(cap.corners(), cap.quads.points, cap.upright).points;
  ASSERT_EQ(invertedQuads(cap.quads.points, cap.quads.quads).size(), 4u);
  const ImprovedQuads again = untangleQuads(cap.corners(), cap.quads.points, cap.upright);
  EXPECT_EQ(again.rounds, 0);
  EXPECT_EQ(again.points, cap.quads.points);
}

TEST(QuadUntangling, FixedCornersSetTheFloor)
{
  const int cells = 12;
  const CapModel cap = dentedModel(cells, 1.2);
  const SurfaceSearch surface(cap.surface);
  const Points normals = surface.project(cap.quads.points).normals;
  const FixedQuadCorners fixed =
    fixedQuadCorners(cap.quads.points, cap.quads.quads, normals, cap.fixed);
  EXPECT_LT(fixed.floor, -0.05);
  EXPECT_NEAR(fixed.floor, sineAtDent(cells), 1e-12);
  std::vector<Index> quads;
  for (const FixedCorner& corner : fixed.inverted)
  {
    quads.push_back(corner.quad);
    EXPECT_NEAR(corner.scaledJacobian, sineAtDent(cells), 1e-12);
    // The node is where the rim is nearest to the middle.
    EXPECT_NEAR(
      cap.quads.points.row(cap.quads.quads(corner.quad, corner.corner)).norm(), 1.0 - Dent, 1e-12);
  }
  EXPECT_EQ(quads, quadsAtCornersOfSquare(cells));
}

// A few nodes pulled across their neighbours: all of them are cured together and one by one, and
// then nothing that is far from them moves.
TEST(QuadUntangling, LeavesTheRestAlone)
{
  for (const Shape& shape : { flat(), threeQuarterSphere() })
  {
    const int cells = 36;
    CapModel cap = model(cells, {}, 0.1, shape, 48);
    const auto node = [&](int i, int j) { return static_cast<Index>(j * (cells + 1) + i); };
    const std::vector<std::pair<int, int>> pulled{ { 5, 5 }, { 18, 6 }, { 12, 19 } };
    for (const auto& [i, j] : pulled)
    {
      cap.quads.points.row(node(i, j)) = cap.quads.points.row(node(i + 2, j + 1));
    }
    const CapCorners corners = cap.corners();
    ASSERT_GT(corners.measure(cap.quads.points).inverted, 0);
    expectUntangled(cap);
    const ImprovedQuads together = untangleTogether(corners, cap.quads.points, cap.upright);
    const ImprovedQuads local = untangleQuads(corners, cap.quads.points, cap.upright);
    EXPECT_EQ(together.quality.inverted, 0);
    EXPECT_EQ(local.quality.inverted, 0);
    EXPECT_GT(local.quality.minimum, 0.1);
    Index moved = 0;
    for (int j = 0; j <= cells; ++j)
    {
      for (int i = 0; i <= cells; ++i)
      {
        int near = cells;
        for (const auto& [a, b] : pulled)
        {
          near = std::min(near, std::max(std::abs(i - a), std::abs(j - b)));
        }
        const bool stays = local.points.row(node(i, j)) == cap.quads.points.row(node(i, j));
        moved += stays ? 0 : 1;
        EXPECT_TRUE(stays || near <= 6) << i << " " << j;
      }
    }
    EXPECT_GT(moved, 20);
  }
}

// What a patch's corners are, the whole's are: judged apart and together.
TEST(QuadUntangling, CornersOfAPatchAreTheWholes)
{
  const CapModel cap = model(8, {}, 0.8, threeQuarterSphere(), 24);
  const Eigen::RowVector3d up(0.2, 0.1, 1.0);
  const CapCorners whole(cap.quads.quads, cap.fixed, cap.surface, { { 4, up } }, cap.quads.points);
  const CellsAtNodes atNodes(cap.quads.quads, cap.quads.points.rows());
  for (const Index start : { 3, 27, 63 })
  {
    const CellPatch patch = cellPatches(cap.quads.quads, atNodes, { start }, 1, cap.fixed)[0];
    const CapCorners part(whole, patch);
    std::vector<QuadCorner> expected;
    for (const QuadCorner& corner : whole.corners())
    {
      if (std::binary_search(patch.cells.begin(), patch.cells.end(), corner.quad))
      {
        expected.push_back(corner);
      }
    }
    ASSERT_EQ(part.corners().size(), expected.size());
    Index free = 0;
    for (std::size_t c = 0; c < expected.size(); ++c)
    {
      const QuadCorner& corner = part.corners()[c];
      EXPECT_EQ(patch.cells[static_cast<std::size_t>(corner.quad)], expected[c].quad);
      EXPECT_EQ(corner.corner, expected[c].corner);
      EXPECT_EQ(corner.column, expected[c].column);
      bool movable = false;
      for (int i = 0; i < 3; ++i)
      {
        const auto local = static_cast<std::size_t>(corner.node[i]);
        EXPECT_EQ(patch.nodes[local], expected[c].node[i]);
        movable = movable || patch.free[local];
      }
      EXPECT_EQ(corner.movable, movable);
      free += movable ? 1 : 0;
    }
    EXPECT_GT(free, 0);
    EXPECT_EQ(static_cast<Index>(part.freeNodes().size()),
      std::count(patch.free.begin(), patch.free.end(), true));

    // What counts in the patch counts in the whole, in the same places.
    Points points(static_cast<Index>(patch.nodes.size()), 3);
    for (Index i = 0; i < points.rows(); ++i)
    {
      points.row(i) = cap.quads.points.row(patch.nodes[static_cast<std::size_t>(i)]);
    }
    const std::vector<Index> all = whole.quadsBelow(0.3, cap.quads.points);
    for (const Index q : part.quadsBelow(0.3, points))
    {
      EXPECT_TRUE(
        std::binary_search(all.begin(), all.end(), patch.cells[static_cast<std::size_t>(q)]));
    }
  }
}

TEST(QuadUntangling, GivesTheSameBitsTwice)
{
  const CapModel cap = model(10, threeHoles(), 1.0, flat(), 20);
  const CapCorners corners = cap.corners();
  const ImprovedQuads once = untangleQuads(corners, cap.quads.points, cap.upright);
  const ImprovedQuads again = untangleQuads(corners, cap.quads.points, cap.upright);
  EXPECT_EQ(once.points, again.points);
}

TEST(QuadUntangling, StopsWhenAsked)
{
  const CapModel cap = model(12, {}, 1.5, flat(), 12);
  EXPECT_THROW(
    untangleQuads(cap.corners(), cap.quads.points, cap.upright, [](double) { return false; }),
    Aborted);
}

TEST(QuadPolishing, BringsAShakenGridBackToSquares)
{
  const CapModel cap = model(10, {}, 0.35, flat(), 10);
  const CapCorners corners = cap.corners();
  const CornerQuality before = corners.measure(cap.quads.points);
  ASSERT_EQ(before.inverted, 0);
  const ImprovedQuads result = polishQuads(corners, cap.quads.points, cap.upright);
  EXPECT_LT(before.minimum, 0.7);
  EXPECT_GT(result.quality.minimum, 0.99);
  EXPECT_GT(result.quality.mean, 0.995);
}

TEST(QuadPolishing, NeverLowersTheMinimum)
{
  for (const double shake : { 0.05, 0.15, 0.3, 0.4 })
  {
    for (const Shape& shape : { flat(), threeQuarterSphere() })
    {
      const CapModel cap = model(12, threeHoles(), shake, shape, 36);
      const CapCorners corners = cap.corners();
      const CornerQuality before = corners.measure(cap.quads.points);
      const ImprovedQuads result = polishQuads(corners, cap.quads.points, cap.upright);
      EXPECT_LE(result.quality.inverted, before.inverted);
      EXPECT_GE(result.quality.minimum, before.minimum);
      EXPECT_GE(result.quality.mean, before.mean - 1e-12);
    }
  }
}

TEST(QuadPolishing, WorksRoundCornersThatNothingCures)
{
  CapModel cap = dentedModel(12, 1.2);
  const CapCorners corners = cap.corners();
  cap.quads.points = untangleQuads(corners, cap.quads.points, cap.upright).points;
  const CornerQuality before = corners.measure(cap.quads.points);
  ASSERT_EQ(before.inverted, 0);
  const ImprovedQuads result = polishQuads(corners, cap.quads.points, cap.upright);
  EXPECT_GT(result.rounds, 0);
  EXPECT_EQ(result.quality.inverted, 0);
  EXPECT_EQ(result.quality.fixedInverted, 4);
  EXPECT_GT(result.quality.minimum, before.minimum);
  EXPECT_GT(result.quality.mean, before.mean);
  EXPECT_EQ(invertedQuads(result.points, cap.quads.quads), quadsAtCornersOfSquare(12));
}

TEST(QuadPolishing, DoesNotCollapseEdges)
{
  // A scaled Jacobian alone would let edges shrink to nothing.
  const CapModel cap = model(12, threeHoles(), 0.4, flat(), 24);
  const ImprovedQuads result = polishQuads(cap.corners(), cap.quads.points, cap.upright);
  double shortest = 1.0;
  for (Index q = 0; q < cap.quads.quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      shortest = std::min(shortest,
        (result.points.row(cap.quads.quads(q, (c + 1) % 4)) -
          result.points.row(cap.quads.quads(q, c)))
          .norm());
    }
  }
  EXPECT_GT(shortest, 0.3 / 12);
}

TEST(QuadPolishing, DoesNotDependOnSizeAndPlace)
{
  const CapModel cap = model(10, threeHoles(), 0.3, flat(), 20);
  const ImprovedQuads reference = polishQuads(cap.corners(), cap.quads.points, cap.upright);
  for (const Placement& placement : placements())
  {
    CapModel moved = cap;
    moved.quads.points = placement.motion(cap.quads.points);
    moved.upright = placement.motion(cap.upright);
    moved.surface.points = placement.motion(cap.surface.points);
    const ImprovedQuads result = polishQuads(moved.corners(), moved.quads.points, moved.upright);
    // A descent amplifies rounding: the meshes agree in quality, not in their last digits.
    const double tolerance = std::max(1e-6, 1e4 * placement.relativeRounding);
    EXPECT_NEAR(result.quality.minimum, reference.quality.minimum, tolerance) << placement.name;
    EXPECT_NEAR(result.quality.mean, reference.quality.mean, tolerance) << placement.name;
  }
}
}

// SPDX-License-Identifier: BSD-3-Clause
// Straight stacks bent round an axis, and walls that lean.
#include "Core/Stacks/RevolvedSpace.h"

#include "Core/Common/Constants.h"
#include "Core/Solids/SolidInput.h"
#include "Core/Stacks/StackSweep.h"
#include "Support/SolidShapes.h"

namespace TestRevolvedSpace
{
using hexsweep::findRevolvedStack;
using hexsweep::Index;
using hexsweep::Pi;
using hexsweep::Points;
using hexsweep::PointsRef;
using hexsweep::RevolutionAxis;
using hexsweep::RevolvedSpace;
using hexsweep::revolvedStack;
using hexsweep::RevolvedStack;
using hexsweep::SolidSurface;

/// z of the blocks goes round the y axis, 20 degrees each; x is the way from it.
Points bent(const PointsRef& points)
{
  Points result(points.rows(), 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    const double angle = points(i, 2) * Pi / 9.0;
    const double radius = 4.0 + points(i, 0);
    result.row(i) << radius * std::cos(angle), points(i, 1), -radius * std::sin(angle);
  }
  return result;
}

/// A step at one end, and a rib in the middle.
bool inSteps(int x, int y, int z)
{
  return (x == 1 && y == 1) || z == 0 || (z == 2 && x > 0);
}

SolidSurface bentSteps()
{
  test::SolidInput input = test::cubes({ 3, 3, 4 }, inSteps);
  input.points = bent(input.points);
  return hexsweep::makeSolidSurface(input);
}

double volumeOf(const SolidSurface& solid)
{
  double volume = 0.0;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = solid.points.row(solid.triangles(t, 0));
    const Eigen::RowVector3d b = solid.points.row(solid.triangles(t, 1));
    const Eigen::RowVector3d c = solid.points.row(solid.triangles(t, 2));
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

/// By Pappus: each cube is a sector of 20 degrees.
double exactVolume()
{
  double volume = 0.0;
  for (int x = 0; x < 3; ++x)
  {
    for (int y = 0; y < 3; ++y)
    {
      for (int z = 0; z < 4; ++z)
      {
        volume += inSteps(x, y, z) ? (4.5 + x) * Pi / 9.0 : 0.0;
      }
    }
  }
  return volume;
}

TEST(RevolvedSpace, GoesThereAndBack)
{
  const SolidSurface solid = bentSteps();
  const RevolutionAxis axis{ { 0.0, 1.0, 0.0 }, { 0.0, 2.0, 0.0 } };
  const auto space = RevolvedSpace::make(axis, solid.points);
  ASSERT_TRUE(space.has_value());
  const Points straight = space->straight(solid.points);
  EXPECT_LT((space->revolved(straight) - solid.points).cwiseAbs().maxCoeff(), 1e-12);
  // The orientation stays: the volume has the same sign.
  SolidSurface there = solid;
  there.points = straight;
  EXPECT_GT(volumeOf(solid), 0.0);
  EXPECT_GT(volumeOf(there), 0.0);
}

TEST(RevolvedSpace, SolidsOnTheAxisHaveNone)
{
  const SolidSurface solid = bentSteps();
  EXPECT_FALSE(
    RevolvedSpace::make({ solid.points.row(3), { 0.0, 1.0, 0.0 } }, solid.points).has_value());
  EXPECT_FALSE(
    RevolvedSpace::make({ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } }, solid.points).has_value());
}

TEST(RevolvedSpace, StepsRoundAnAxisAreFoundAndMeshed)
{
  const SolidSurface solid = bentSteps();
  const std::optional<RevolvedStack> stack = findRevolvedStack(solid);
  ASSERT_TRUE(stack.has_value());
  EXPECT_FALSE(stack->faces.isPlain());
  const Eigen::RowVector3d axis = stack->space.axis().direction;
  EXPECT_NEAR(std::abs(axis.y()), 1.0, 1e-9);
  hexsweep::StackOptions options;
  options.size = 0.5;
  options.layerSize = 0.2;
  options.toSpace = [&](const PointsRef& points) { return stack->space.revolved(points); };
  const hexsweep::StackMesh mesh = sweepStack(stack->straight, stack->faces, options);
  const hexsweep::HexQualitySummary summary = hexsweep::summarize(mesh.qualities);
  EXPECT_EQ(summary.notCertified, 0);
  EXPECT_GT(summary.minScaledJacobian, 0.4);
  // Nodes are on the arcs, which the facets of the solid cut short.
  EXPECT_NEAR(mesh.volume, exactVolume(), 0.005 * exactVolume());
}

TEST(LeaningSides, ABossWithDraftHasTheVolumeOfItsFrustum)
{
  // The top of the post is drawn in by a fifth of its height on each side.
  test::SolidInput input = test::cubes(
    { 5, 5, 3 }, [](int x, int y, int z) { return z == 0 || (x > 0 && x < 4 && y > 0 && y < 4); });
  constexpr double Draft = 0.1;
  for (Index i = 0; i < input.points.rows(); ++i)
  {
    const double inward = 1.0 - Draft * std::max(0.0, input.points(i, 2) - 1.0) / 1.5;
    input.points(i, 0) = 2.5 + (input.points(i, 0) - 2.5) * inward;
    input.points(i, 1) = 2.5 + (input.points(i, 1) - 2.5) * inward;
  }
  const SolidSurface solid = hexsweep::makeSolidSurface(input);
  const Eigen::RowVector3d up(0.0, 0.0, 1.0);
  EXPECT_FALSE(hexsweep::capLikeFaces(solid, up).isStack());
  const hexsweep::CapLikeFaces faces = hexsweep::capLikeFaces(solid, up, 0.12);
  ASSERT_TRUE(faces.isStack()) << hexsweep::describeRefusedFaces(faces);
  hexsweep::StackOptions options;
  options.size = 0.4;
  const hexsweep::StackMesh mesh = sweepStack(solid, faces, options);
  const hexsweep::HexQualitySummary summary = hexsweep::summarize(mesh.qualities);
  EXPECT_EQ(summary.notCertified, 0);
  EXPECT_GT(summary.minScaledJacobian, 0.5);
  EXPECT_NEAR(mesh.volume, volumeOf(solid), 1e-6 * volumeOf(solid));
}
}

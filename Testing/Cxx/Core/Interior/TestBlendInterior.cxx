// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/BlendInterior.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Interior/SweptHexes.h"
#include "Core/Solvers/PrismSolver.h"
#include "Support/DenseTruth.h"
#include "Support/InteriorTests.h"

namespace TestBlendInterior
{
using hexsweep::blendInterior;
using hexsweep::fadingBlendInterior;
using hexsweep::Index;
using hexsweep::Points;
using test::Sweep;

TEST(BlendInterior, AffineSweepsAreExact)
{
  test::expectAffineSweepsExact(blendInterior);
  test::expectAffineSweepsExact(fadingBlendInterior);
}

TEST(BlendInterior, AnySizeAnywhere)
{
  test::expectAnySizeAnywhere(blendInterior);
  test::expectAnySizeAnywhere(fadingBlendInterior);
}

TEST(BlendInterior, SimilaritySweepsOfACurvedCapAreExact)
{
  test::expectSimilaritySweepOfACurvedCapExact(blendInterior);
  test::expectSimilaritySweepOfACurvedCapExact(fadingBlendInterior);
}

TEST(BlendInterior, BoundaryIsKeptBitForBit)
{
  test::expectBoundaryBitForBit(blendInterior);
  test::expectBoundaryBitForBit(fadingBlendInterior);
}

TEST(BlendInterior, NearlyPlanarLoopsAreTame)
{
  test::expectNearlyPlanarLoopsTame(blendInterior);
  test::expectNearlyPlanarLoopsTame(fadingBlendInterior);
}

TEST(BlendInterior, KeepsTheContract)
{
  test::expectInteriorContract(blendInterior, 1e-13);
  test::expectInteriorContract(fadingBlendInterior, 1e-13);
}

TEST(BlendInterior, CorrectionIsTheHarmonicExtensionOfTheBoundaryError)
{
  // Where source and target are congruent and all layers but one lie on the straight sweep, the
  // blend is the straight sweep; what is left is the harmonic extension of that ring's shift.
  Sweep sweep = test::makeSweep(12, 9, true, test::evenLayers(6),
    [](double x, double y, double t) { return Eigen::RowVector3d(x, y, 3 * t); });
  const Index n = sweep.source.rows();
  auto boundary = test::boundaryOf(sweep);
  Points shift = Points::Zero(7 * n, 3);
  // Across the affine functions, so that no affine map follows the ring.
  Eigen::MatrixXd affine(boundary.rings[3].rows(), 3);
  affine << Eigen::VectorXd::Ones(affine.rows()), boundary.rings[3].leftCols<2>();
  Eigen::VectorXd wave = (5 * affine.col(1) + 4 * affine.col(2)).array().sin() * 0.01;
  wave -= affine * test::leastSquaresSolution(affine, wave);
  for (Index j = 0; j < wave.size(); ++j)
  {
    shift(3 * n + boundary.nodes[static_cast<std::size_t>(j)], 0) = wave[j];
    boundary.rings[3](j, 0) += wave[j];
  }
  const hexsweep::PrismSolver prism(hexsweep::quadLaplacian(sweep.target, sweep.quads), 6,
    boundary.meanColumnLength / 6, boundary.nodes);
  const Points expected = sweep.layers + prism.extend(shift);
  // The ring's wave tilts the normals' length a little: sqrt(area ratio) does not enter a planar
  // cap.
  EXPECT_LT(test::greatestDistance(
              blendInterior({ sweep.source, sweep.target, sweep.quads, boundary }), expected),
    1e-12);
}

TEST(BlendInterior, MirroredInputGivesTheMirroredMesh)
{
  const Sweep sweep = test::makeSweep(12, 9, true, test::evenLayers(6), test::bendingMotion);
  Sweep mirrored = sweep;
  for (Points* points : { &mirrored.source, &mirrored.target, &mirrored.linkingPoints })
  {
    points->col(1) *= -1;
  }
  Points expected = test::run(blendInterior, sweep);
  expected.col(1) *= -1;
  EXPECT_LT(test::greatestDistance(test::run(blendInterior, mirrored), expected), 1e-12);
}

TEST(BlendInterior, SweptBackwardsItIsTheSameForCongruentCaps)
{
  // Source and target change roles: same blend, and the same prism when the caps are congruent.
  const auto arc = [](double x, double y, double t) {
    const double angle = 2.5 * t;
    const double radius = 3 + x + 0.2 * std::sin(3 * y) * std::sin(std::acos(-1.0) * t);
    return Eigen::RowVector3d(radius * std::cos(angle), radius * std::sin(angle), y);
  };
  const Sweep sweep = test::makeSweep(12, 9, true, test::evenLayers(6), arc);
  const Sweep back = test::makeSweep(12, 9, true, test::evenLayers(6),
    [&arc](double x, double y, double t) { return arc(x, y, 1 - t); });
  const Points forth = test::run(blendInterior, sweep);
  const Points reversed = test::run(blendInterior, back);
  const Index n = sweep.source.rows();
  for (Index k = 0; k <= 6; ++k)
  {
    EXPECT_LT(
      test::greatestDistance(forth.middleRows(k * n, n), reversed.middleRows((6 - k) * n, n)),
      1e-12);
  }
}

TEST(BlendInterior, BendingSweepIsValid)
{
  const Sweep sweep = test::makeSweep(12, 9, true, test::evenLayers(6), test::bendingMotion);
  const auto judge = [&sweep](const Points& points) {
    return hexsweep::summarize(
      hexsweep::hexQualities(points, hexsweep::sweptHexes(sweep.quads, points, 6)));
  };
  const auto truth = judge(sweep.layers);
  ASSERT_EQ(truth.inverted, 0);
  const auto blended = judge(test::run(blendInterior, sweep));
  EXPECT_EQ(blended.inverted, 0);
  EXPECT_GT(blended.minScaledJacobian, 0.8 * truth.minScaledJacobian);
}

TEST(BlendInterior, AbortsAndRefusesAVolumeWithoutHeight)
{
  const Sweep sweep = test::makeSweep(6, 5, false, test::evenLayers(4), test::bendingMotion);
  EXPECT_THROW(blendInterior(test::cageOf(sweep), [](double) { return false; }), hexsweep::Aborted);
  const Sweep flat = test::makeSweep(6, 5, false, test::evenLayers(2),
    [](double x, double y, double) { return Eigen::RowVector3d(x, y, 0); });
  // Rings that coincide weld into one: refused while tracing.
  EXPECT_THROW(test::run(blendInterior, flat), hexsweep::InvalidInput);
}

/// A bulge of the cap that is not there on its boundary.
double bulge(double x, double y)
{
  return 0.4 * x * (2 - x) * y * (1 - y) * 4;
}

/// Height of the middle node of the cap on each layer over the plane between the loops.
std::vector<double> middleHeights(const Sweep& sweep, const Points& points)
{
  const Index n = sweep.source.rows();
  Index middle = 0;
  ((sweep.cap.rowwise() - Eigen::RowVector2d(1.0, 0.5)).rowwise().norm()).minCoeff(&middle);
  std::vector<double> heights;
  for (Index k = 0; k <= sweep.numberOfLayers; ++k)
  {
    const double t = static_cast<double>(k) / static_cast<double>(sweep.numberOfLayers);
    heights.push_back(points(k * n + middle, 2) - 6.0 * t);
  }
  return heights;
}

TEST(BlendInterior, BulgesThatBothCapsShareGoThroughAndOthersFade)
{
  const auto sweepWith = [](double atSource, double atTarget) {
    return test::makeSweep(12, 9, false, test::evenLayers(12), [=](double x, double y, double t) {
      return Eigen::RowVector3d(x, y, 6.0 * t + ((1 - t) * atSource + t * atTarget) * bulge(x, y));
    });
  };
  const Sweep same = sweepWith(1, 1);
  const std::vector<double> kept = middleHeights(same, test::run(fadingBlendInterior, same));
  for (const double height : kept)
  {
    EXPECT_NEAR(height, kept[0], 1e-12);
  }
  // Only one cap bulges: in the blend the height falls linearly, else faster than that.
  const Sweep one = sweepWith(1, 0);
  const std::vector<double> linear = middleHeights(one, test::run(blendInterior, one));
  const std::vector<double> fading = middleHeights(one, test::run(fadingBlendInterior, one));
  for (std::size_t k = 1; k < 12; ++k)
  {
    EXPECT_NEAR(linear[k], linear[0] * (1.0 - static_cast<double>(k) / 12.0), 1e-12);
    EXPECT_LT(fading[k], 0.95 * linear[k]);
    EXPECT_GT(fading[k], 0.0);
  }
  // Opposite bulges share nothing: zero half way.
  const Sweep lens = sweepWith(1, -1);
  EXPECT_NEAR(middleHeights(lens, test::run(fadingBlendInterior, lens))[6], 0.0, 1e-12);
  EXPECT_FALSE(hexsweep::capsBulgeApart(test::cageOf(same)));
  EXPECT_FALSE(hexsweep::capsBulgeApart(test::cageOf(sweepWith(0, 0))));
  EXPECT_TRUE(hexsweep::capsBulgeApart(test::cageOf(one)));
  EXPECT_TRUE(hexsweep::capsBulgeApart(test::cageOf(lens)));
}

TEST(BlendInterior, LoopsThatFlattenDoNotSpoilFadingBulges)
{
  // The affine map from a ring that is not planar to one that is has no inverse.
  const Sweep sweep =
    test::makeSweep(12, 9, false, test::evenLayers(8), [](double x, double y, double t) {
      return Eigen::RowVector3d(
        x, y, 6.0 * t + (1 - t) * 0.3 * ((x - 1) * (x - 1) - (y - 0.5) * (y - 0.5)));
    });
  const Points swept = test::run(fadingBlendInterior, sweep);
  EXPECT_EQ(
    hexsweep::summarize(hexsweep::hexQualities(swept, hexsweep::sweptHexes(sweep.quads, swept, 8)))
      .notCertified,
    0);
}
}

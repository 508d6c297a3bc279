// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/BoundaryErrorInterior.h"

#include "Core/Common/Errors.h"
#include "Support/InteriorTests.h"

namespace TestBoundaryErrorInterior
{
using hexsweep::boundaryErrorInterior;
using hexsweep::Index;
using hexsweep::Points;
using test::Sweep;

TEST(BoundaryErrorInterior, AffineSweepsAreExact)
{
  test::expectAffineSweepsExact(boundaryErrorInterior);
}

TEST(BoundaryErrorInterior, AnySizeAnywhere)
{
  test::expectAnySizeAnywhere(boundaryErrorInterior);
}

TEST(BoundaryErrorInterior, SimilaritySweepsOfACurvedCapAreExact)
{
  test::expectSimilaritySweepOfACurvedCapExact(boundaryErrorInterior);
}

TEST(BoundaryErrorInterior, BoundaryIsKeptBitForBit)
{
  test::expectBoundaryBitForBit(boundaryErrorInterior);
}

TEST(BoundaryErrorInterior, NearlyPlanarLoopsAreTame)
{
  test::expectNearlyPlanarLoopsTame(boundaryErrorInterior);
}

TEST(BoundaryErrorInterior, KeepsTheContract)
{
  test::expectInteriorContract(boundaryErrorInterior);
}

TEST(BoundaryErrorInterior, EqualsItsFormulaNodeByNode)
{
  // Both caps and all affine maps are the identity but for the shift; one ring node is pushed, and
  // its push less the affine part arrives with the weight 1/d^2 over the sum of all weights.
  const Sweep sweep = test::makeSweep(12, 9, true, test::evenLayers(5), test::bendingMotion);
  const auto boundary = test::boundaryOf(sweep);
  const Points swept = boundaryErrorInterior({ sweep.source, sweep.target, sweep.quads, boundary });
  const Index n = sweep.source.rows();
  std::vector<char> onLoop(static_cast<std::size_t>(n), 0);
  for (const Index id : boundary.nodes)
  {
    onLoop[static_cast<std::size_t>(id)] = 1;
  }
  for (const Index k : { 1, 2, 3, 4 })
  {
    const double t = boundary.fractions[static_cast<std::size_t>(k)];
    for (Index i = 0; i < n; ++i)
    {
      if (onLoop[static_cast<std::size_t>(i)])
      {
        continue;
      }
      Eigen::RowVector3d expected = Eigen::RowVector3d::Zero();
      for (const Index cap : { 0, 5 })
      {
        const Points& points = cap == 0 ? sweep.source : sweep.target;
        const hexsweep::AffineMap map = hexsweep::fitLayerMap(boundary, cap, k);
        double sum = 0.0;
        Eigen::RowVector3d error = Eigen::RowVector3d::Zero();
        for (std::size_t j = 0; j < boundary.nodes.size(); ++j)
        {
          const Eigen::RowVector3d node = points.row(boundary.nodes[j]);
          const double weight = 1.0 / (node - points.row(i)).squaredNorm();
          sum += weight;
          error += weight *
            (boundary.rings[static_cast<std::size_t>(k)].row(static_cast<Index>(j)) -
              map.apply(node));
        }
        expected += (cap == 0 ? 1 - t : t) * (map.apply(points.row(i)) + error / sum);
      }
      ASSERT_LT((swept.row(k * n + i) - expected).norm(), 1e-12) << k << ' ' << i;
    }
  }
}

TEST(BoundaryErrorInterior, Aborts)
{
  const Sweep sweep = test::makeSweep(6, 5, false, test::evenLayers(4), test::bendingMotion);
  EXPECT_THROW(
    boundaryErrorInterior(test::cageOf(sweep), [](double) { return false; }), hexsweep::Aborted);
}
}

// SPDX-License-Identifier: BSD-3-Clause
// Places of polygons on rings that sample the same curve elsewhere: the curve knows the truth.
#include "Core/Linking/RingParameter.h"

#include "Support/CapMeshes.h"

namespace TestRingParameter
{
using hexsweep::Index;
using hexsweep::Points;
using Places = std::vector<double>;

/// n points of a closed curve over [0, 1), from `start` on.
Points sampled(Index n, double start, const std::function<Eigen::RowVector3d(double)>& curve)
{
  Points points(n, 3);
  for (Index i = 0; i < n; ++i)
  {
    const double t = start + static_cast<double>(i) / static_cast<double>(n);
    points.row(i) = curve(t - std::floor(t));
  }
  return points;
}

Eigen::RowVector3d circle(double t)
{
  return { std::cos(2 * test::Pi * t), std::sin(2 * test::Pi * t), 0.0 };
}

/// The boundary of [0, 10] x [0, 0.01], by arc length: a slit whose sides are close.
Eigen::RowVector3d slit(double t)
{
  const double length = 10.0;
  const double width = 0.01;
  double s = t * 2.0 * (length + width);
  if (s <= length)
  {
    return { s, 0, 0 };
  }
  s -= length;
  if (s <= width)
  {
    return { length, s, 0 };
  }
  s -= width;
  if (s <= length)
  {
    return { length - s, width, 0 };
  }
  return { 0, width - (s - length), 0 };
}

/// The sum of the steps round the loop is one turn, and no step is zero.
void expectCyclicallyRising(const Places& places, Index ringSize)
{
  const double n = static_cast<double>(ringSize);
  double sum = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    EXPECT_GE(places[i], 0.0);
    EXPECT_LT(places[i], n);
    double step = places[(i + 1) % places.size()] - places[i];
    step += step <= 0.0 ? n : 0.0;
    EXPECT_GT(step, 0.0);
    sum += step;
  }
  EXPECT_NEAR(sum, n, 1e-9);
}

double cyclicDistance(double a, double b, Index ringSize)
{
  return std::abs(std::remainder(a - b, static_cast<double>(ringSize)));
}

TEST(RingParameter, NodesOfTheRingGetTheirNumberExactly)
{
  const Points ring = sampled(24, 0.0, circle);
  for (const Index shift : { 0, 1, 7, 23 })
  {
    const Points polygon = sampled(24, static_cast<double>(shift) / 24.0, circle);
    const Places places = hexsweep::ringParameters(polygon, ring, 1e-6);
    for (Index i = 0; i < 24; ++i)
    {
      EXPECT_EQ(places[static_cast<std::size_t>(i)], static_cast<double>((i + shift) % 24));
    }
  }
}

TEST(RingParameter, VerticesOnARingEdgeByArcLength)
{
  // The ring of a square; the polygon has its corners and more on the sides.
  Points ring(4, 3);
  ring << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  Points polygon(7, 3);
  polygon << 1, 0.25, 0, 1, 0.75, 0, 1, 1, 0, 0.5, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0;
  const Places places = hexsweep::ringParameters(polygon, ring, 1e-6);
  const Places expected{ 1.25, 1.75, 2, 2.5, 3, 0, 1 };
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(places[i], expected[i], 1e-15);
  }
}

TEST(RingParameter, AFinerPolygonWithAllRingNodesAndChords)
{
  // The polygon runs on the circle, the ring on chords: between common nodes by arc length.
  const Points ring = sampled(16, 0.0, circle);
  const Points polygon = sampled(80, 0.3, circle);
  const Places places = hexsweep::ringParameters(polygon, ring, 1e-6);
  expectCyclicallyRising(places, 16);
  for (Index i = 0; i < 80; ++i)
  {
    const double expected = std::fmod((0.3 + static_cast<double>(i) / 80.0) * 16.0, 16.0);
    EXPECT_LT(cyclicDistance(places[static_cast<std::size_t>(i)], expected, 16), 1e-12);
  }
}

TEST(RingParameter, CirclesThatShareNoNode)
{
  const Index n = 48;
  const Points ring = sampled(n, 0.0, circle);
  for (const Index m : { 5, 17, 31, 48, 97, 200 })
  {
    const double start = 0.1234;
    const Places places = hexsweep::ringParameters(sampled(m, start, circle), ring, 1e-6);
    expectCyclicallyRising(places, n);
    for (Index i = 0; i < m; ++i)
    {
      const double expected = (start + static_cast<double>(i) / static_cast<double>(m)) * n;
      // The nearest point of a chord against the angle: of second order in the angle of an edge.
      EXPECT_LT(cyclicDistance(places[static_cast<std::size_t>(i)], expected, n), 0.01);
    }
  }
}

TEST(RingParameter, CloseSidesAreNotConfused)
{
  // A ring of 20 edges along either side of the slit and one across each end.
  const Index n = 42;
  Points ring(n, 3);
  for (Index j = 0; j <= 20; ++j)
  {
    ring.row(j) << 0.5 * static_cast<double>(j), 0, 0;
    ring.row(21 + j) << 10.0 - 0.5 * static_cast<double>(j), 0.01, 0;
  }
  for (const Index m : { 40, 59, 113 })
  {
    const double start = 0.007;
    const Places places = hexsweep::ringParameters(sampled(m, start, slit), ring, 1e-6);
    expectCyclicallyRising(places, n);
    for (Index i = 0; i < m; ++i)
    {
      const double t = start + static_cast<double>(i) / static_cast<double>(m);
      const double length = 20.02 * (t - std::floor(t));
      const double expected = length <= 10.0 ? 2.0 * length
        : length <= 10.01                    ? 20.0 + 100.0 * (length - 10.0)
        : length <= 20.01                    ? 21.0 + 2.0 * (length - 10.01)
                                             : 41.0 + 100.0 * (length - 20.01);
      EXPECT_LT(cyclicDistance(places[static_cast<std::size_t>(i)], expected, n), 1e-9);
    }
  }
}

TEST(RingParameter, ToleranceDecidesWhatIsANode)
{
  const Points ring = sampled(24, 0.0, circle);
  Points polygon = ring;
  const double edge = (ring.row(1) - ring.row(0)).norm();
  polygon.row(5) += 1e-8 * edge * Eigen::RowVector3d(1, 1, 1);
  EXPECT_EQ(hexsweep::ringParameters(polygon, ring, 1e-6)[5], 5.0);
  polygon.row(5) += 0.01 * (ring.row(6) - ring.row(5));
  const Places places = hexsweep::ringParameters(polygon, ring, 1e-6);
  EXPECT_NEAR(places[5], 5.01, 1e-3);
  EXPECT_NE(places[5], 5.0);
  expectCyclicallyRising(places, 24);
}

TEST(RingParameter, CoincidentVerticesComeApart)
{
  // Between two common nodes and far from the ring, several vertices have one nearest point.
  const Points ring = sampled(8, 0.0, circle);
  Points polygon(12, 3);
  polygon.topRows<8>() = ring;
  polygon.row(8) = 1.001 * ring.row(7);
  polygon.row(9) = 1.002 * ring.row(7);
  polygon.row(10) = 1.001 * ring.row(0);
  polygon.row(11) = 1.0005 * ring.row(0);
  expectCyclicallyRising(hexsweep::ringParameters(polygon, ring, 1e-6), 8);
}

TEST(RingParameter, ARingThatRunsTheOtherWayIsAnError)
{
  const Points ring = sampled(24, 0.0, circle);
  const Points reversed = ring.colwise().reverse();
  test::expectInvalid([&] { hexsweep::ringParameters(reversed, ring, 1e-6); }, "another order");
}

TEST(RingParameter, SizePlaceAndTurnDoNotMatter)
{
  const Points ring = sampled(48, 0.0, circle);
  for (const Index m : { 48, 31, 97 })
  {
    const Points polygon = sampled(m, 0.25, circle);
    const Places plain = hexsweep::ringParameters(polygon, ring, 1e-6);
    for (const test::Placement& placement : test::placements())
    {
      const Places moved =
        hexsweep::ringParameters(placement.motion(polygon), placement.motion(ring), 1e-6);
      for (std::size_t i = 0; i < plain.size(); ++i)
      {
        // Rounding of a place, in edges of 1 / 8 of the size; the square root comes from
        // distances near zero that are compared squared.
        EXPECT_LT(cyclicDistance(moved[i], plain[i], 48), 1e3 * placement.relativeRounding)
          << placement.name;
      }
    }
  }
}

TEST(RingParameter, UnionHasAllPlacesOnceAndAllNodes)
{
  const Places first{ 0.5, 2.0, 3.25, 4.99999999 };
  const Places second{ 0.50000001, 1.0, 3.3, 2.00000001 };
  const Places united = hexsweep::uniteParameters(5, { &first, &second });
  const Places expected{ 0, 0.5, 1, 2, 3, 3.25, 3.3, 4 };
  ASSERT_EQ(united.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(united[i], expected[i], 2e-8);
  }
  for (const double s : { 0.0, 1.0, 2.0, 3.0, 4.0 })
  {
    EXPECT_NE(std::find(united.begin(), united.end(), s), united.end());
  }
  for (const Places* places : { &first, &second })
  {
    for (const double s : *places)
    {
      EXPECT_LT(cyclicDistance(united[hexsweep::unitedPlace(united, 5, s)], s, 5), 1e-7);
    }
  }
  EXPECT_EQ(hexsweep::unitedPlace(united, 5, 4.99999999), 0u);
}

TEST(RingParameter, LengthsOfASquare)
{
  Points ring(4, 3);
  ring << 0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0;
  const std::vector<double> lengths = hexsweep::ringLengths(ring, { 0, 0.5, 1, 1.25, 2, 3, 3.5 });
  const std::vector<double> expected{ 0, 1, 2, 2.25, 3, 5, 5.5, 6 };
  ASSERT_EQ(lengths.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(lengths[i], expected[i], 1e-15);
  }
}
}

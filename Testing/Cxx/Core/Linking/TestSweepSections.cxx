// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/SweepSections.h"

#include "Core/Linking/QuadWinding.h"
#include "Support/WindingSweeps.h"

namespace TestSweepSections
{
using hexsweep::Index;
using hexsweep::PlanePoints;
using hexsweep::Points;
using hexsweep::SweepSections;
using test::Holes;
using test::Pi;
using test::WindingShape;
using test::WindingSweep;

WindingShape shapeOf(Holes holes, double degrees, double bend)
{
  WindingShape shape;
  shape.holes = holes;
  shape.degrees = degrees;
  shape.bend = bend;
  shape.height = 4.0;
  return shape;
}

SweepSections sectionsOf(const test::Sweep& sweep)
{
  const auto sections = hexsweep::sweepSections(
    test::traced({ sweep.source, sweep.quads }, { sweep.linkingPoints, sweep.linkingQuads }));
  EXPECT_TRUE(sections.has_value());
  return sections.value_or(SweepSections{});
}

/// All points on all layers as `motion` has them.
test::Sweep swept(const WindingSweep& winding, const test::Motion& motion, int layers)
{
  return test::sweepCap(winding.sweep.cap, winding.sweep.quads, test::evenLayers(layers), motion);
}

TEST(SweepSections, WindingIsWhatTheHolesWereTurnedBy)
{
  for (const double degrees : { 90.0, -120.0, 210.0, 400.0 })
  {
    for (const double bend : { 0.0, 1.2, -3.0 })
    {
      const SweepSections sections =
        sectionsOf(test::windingSweep(shapeOf(Holes::Two, degrees, bend)).sweep);
      const hexsweep::LoopWinding winding = hexsweep::loopWinding(sections);
      ASSERT_EQ(winding.pairs.size(), 1u);
      const double turn = degrees * Pi / 180.0;
      EXPECT_NEAR(winding.pairs[0].turn, turn, 1e-9);
      for (std::size_t l = 0; l < sections.numberOfLoops(); ++l)
      {
        EXPECT_NEAR(winding.own[l], l == sections.outer ? 0.0 : turn, 1e-9);
      }
      EXPECT_NEAR(winding.greatest(), std::abs(turn), 1e-9);
    }
  }
}

TEST(SweepSections, AWholeThatTurnsDoesNotWind)
{
  const WindingSweep winding = test::windingSweep(shapeOf(Holes::Two, 0.0, 0.0));
  const auto twisted = [](double x, double y, double t) -> Eigen::RowVector3d {
    const Eigen::Vector2d p = Eigen::Rotation2Dd(5.0 * t) * Eigen::Vector2d(x, y) * (1.0 + t);
    return { p.x() * std::cos(t) + 3.0 * std::sin(t), p.y(), 3.0 * t - p.x() * std::sin(t) };
  };
  const SweepSections sections = sectionsOf(swept(winding, twisted, 20));
  EXPECT_LT(hexsweep::loopWinding(sections).greatest(), 1e-9);
  // The axes turn with the rim: rings are the first one, larger.
  ASSERT_EQ(sections.rings.size(), 21u);
  for (std::size_t k = 0; k < sections.rings.size(); ++k)
  {
    const double scale = 1.0 + static_cast<double>(k) / 20.0;
    EXPECT_LT((sections.rings[k] - scale * sections.rings[0]).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(SweepSections, LiftUndoesFlatten)
{
  const SweepSections sections =
    sectionsOf(test::windingSweep(shapeOf(Holes::One, 90.0, 1.0)).sweep);
  const Points points = Points::Random(10, 3);
  ASSERT_EQ(sections.frames.size(), static_cast<std::size_t>(WindingShape{}.layers + 1));
  for (const hexsweep::SectionFrame& frame : sections.frames)
  {
    const Points back = frame.lift(frame.flatten(points), frame.heights(points));
    EXPECT_LT((back - points).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST(SweepSections, ARingWithoutAreaHasNoPlane)
{
  const std::vector<Index> nodes{ 0, 1, 2, 3 };
  Points flat(4, 3);
  flat << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  Points eight(4, 3);
  eight << 0, 0, 1, 1, 1, 1, 1, 0, 1, 0, 1, 1;
  EXPECT_TRUE(hexsweep::sweepSections(nodes, { 0, 4 }, { flat, flat }).has_value());
  EXPECT_FALSE(hexsweep::sweepSections(nodes, { 0, 4 }, { flat, eight }).has_value());
  EXPECT_FALSE(hexsweep::sweepSections(nodes, { 0, 4 }, { flat, Points(flat.colwise().reverse()) })
                 .has_value());
}

TEST(QuadWinding, TellsTrueQuadsFromThoseThatTookTheShortWay)
{
  // The true sweep turns what is within the radius of the holes and shears what is outside.
  const double inner = 0.5;
  const auto place = [&](const Eigen::RowVector2d& p, double turn) -> Eigen::RowVector2d {
    const double share = std::clamp((1.0 - p.norm()) / (1.0 - inner), 0.0, 1.0);
    return p * Eigen::Rotation2Dd(-turn * share).toRotationMatrix();
  };
  for (const Holes holes : { Holes::One, Holes::Two })
  {
    const WindingSweep winding = test::windingSweep(shapeOf(holes, 210.0, 0.0));
    const SweepSections sections = sectionsOf(winding.sweep);
    const PlanePoints& cap = winding.sweep.cap;
    const auto missed = [&](double turn) {
      PlanePoints moved(cap.rows(), 2);
      for (Index i = 0; i < cap.rows(); ++i)
      {
        moved.row(i) = place(cap.row(i), turn);
      }
      Index sum = 0;
      for (const Index turns : hexsweep::missedTurns(sections, winding.sweep.quads,
             sections.frames.front().flatten(winding.sweep.source),
             sections.frames.back().flatten(
               (Points(cap.rows(), 3) << moved, Eigen::VectorXd::Constant(cap.rows(), 4.0))
                 .finished())))
      {
        sum += turns;
      }
      return sum;
    };
    EXPECT_EQ(missed(210.0 * Pi / 180.0), 0);
    EXPECT_GE(missed(-150.0 * Pi / 180.0), holes == Holes::One ? 1 : 2);
    EXPECT_GE(missed(570.0 * Pi / 180.0), holes == Holes::One ? 1 : 2);
  }
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/SweepInterior.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/BlendInterior.h"
#include "Core/Interior/SweptHexes.h"
#include "Support/HexBlocks.h"
#include "Support/InteriorTests.h"

namespace TestSweepInterior
{
using hexsweep::InteriorOptions;
using hexsweep::InteriorStart;
using hexsweep::Progress;
using hexsweep::SweepCage;
using test::Index;
using test::Points;

using test::cageOf;

InteriorStart blend()
{
  return { "Blend", hexsweep::blendInterior };
}

Index inner(const SweepCage& cage)
{
  Index i = 0;
  while (std::count(cage.boundary.nodes.begin(), cage.boundary.nodes.end(), i) > 0)
  {
    ++i;
  }
  return i;
}

/// Blend with an inner node of layer 3 thrown far away.
InteriorStart spoilt()
{
  return { "Spoilt",
    [](const SweepCage& cage, const Progress& progress, const hexsweep::ParallelFor&) {
      Points points = blend().method(cage, progress, {});
      points(3 * cage.source.rows() + inner(cage), 0) += 0.7;
      return points;
    } };
}

hexsweep::HexQualitySummary judge(const SweepCage& cage, const Points& points)
{
  return test::judge(
    points, hexsweep::sweptHexes(cage.quads, points, cage.boundary.numberOfLayers()));
}

InteriorOptions unpolished()
{
  InteriorOptions options;
  options.polishingRounds = 0;
  return options;
}

TEST(SweepInterior, AValidStartIsReturnedAsItIs)
{
  const SweepCage cage =
    cageOf(test::makeSweep(12, 9, true, test::evenLayers(6), test::bendingMotion));
  const auto result = hexsweep::sweepInterior(cage, { blend(), spoilt() }, unpolished());
  EXPECT_EQ(result.points, blend().method(cage, {}, {}));
  EXPECT_EQ(result.method, "Blend");
  ASSERT_EQ(result.steps.size(), 1u);
  EXPECT_EQ(result.steps[0].notCertified, 0);
}

TEST(SweepInterior, WhatIsNotValidIsUntangled)
{
  const SweepCage cage =
    cageOf(test::makeSweep(12, 9, true, test::evenLayers(6), test::bendingMotion));
  const auto result = hexsweep::sweepInterior(cage, { spoilt(), blend() }, unpolished());
  EXPECT_EQ(result.method, "Spoilt + untangling");
  ASSERT_EQ(result.steps.size(), 2u);
  EXPECT_GT(result.steps[0].notCertified, 0);
  EXPECT_EQ(result.steps[1].mended, result.steps[0].notCertified);
  EXPECT_EQ(judge(cage, result.points).notCertified, 0);

  InteriorOptions raw = unpolished();
  raw.ensureValid = false;
  const auto left = hexsweep::sweepInterior(cage, { spoilt(), blend() }, raw);
  EXPECT_EQ(left.method, "Spoilt");
  EXPECT_EQ(left.points, spoilt().method(cage, {}, {}));
}

TEST(SweepInterior, TheBestStartIsKept)
{
  // A fold in a curved cap: no single corner forbids the interior, but untangling fails.
  test::Sweep sweep =
    test::makeSweep(8, 6, false, test::evenLayers(4), [](double x, double y, double t) {
      const double bulge = 0.6 * x * (2 - x) * y * (1 - y);
      return Eigen::RowVector3d(x, y, 2 * t + t * bulge);
    });
  sweep.target.row(inner(cageOf(sweep))) += Eigen::RowVector3d(0.4, 0.01, 0.0);
  const SweepCage cage = cageOf(sweep);
  const InteriorStart collapsed{ "Collapsed",
    [](const SweepCage& c, const Progress&, const hexsweep::ParallelFor&) {
      Points points = Points::Zero(5 * c.source.rows(), 3);
      hexsweep::setGivenPoints(c.source, c.target, c.quads, c.boundary, points);
      return points;
    } };
  const InteriorStart failing{ "Failing",
    [](const SweepCage&, const Progress&, const hexsweep::ParallelFor&) -> Points {
      throw hexsweep::SolverFailure("no solution");
    } };
  const auto worth = [&](const std::vector<InteriorStart>& starts) {
    const auto result = hexsweep::sweepInterior(cage, starts, unpolished());
    const auto summary = judge(cage, result.points);
    return std::make_pair(-summary.notCertified, summary.minScaledJacobian);
  };
  const auto both = worth({ collapsed, failing, blend() });
  EXPECT_LT(both.first, 0);
  EXPECT_TRUE(hexsweep::sweepInterior(cage, { blend() }, unpolished()).fixed.conflicts.empty());
  EXPECT_EQ(both, std::max(worth({ collapsed }), worth({ blend() })));
  EXPECT_THROW(worth({ failing, blend() }), hexsweep::SolverFailure);
}

TEST(SweepInterior, OfRivalsTheMorePromisingIsTriedFirst)
{
  const SweepCage cage =
    cageOf(test::makeSweep(12, 9, true, test::evenLayers(6), test::bendingMotion));
  InteriorStart better = blend();
  better.rivals = [](const SweepCage&) { return true; };
  const auto result = hexsweep::sweepInterior(cage, { spoilt(), better }, unpolished());
  EXPECT_EQ(result.method, "Blend");
  ASSERT_EQ(result.steps.size(), 2u); // both were made, nothing was untangled
  EXPECT_EQ(result.steps[0].name, "Spoilt");
  EXPECT_EQ(result.steps[1].name, "Blend");
  EXPECT_EQ(result.points, blend().method(cage, {}, {}));

  // A rival with nothing of its own is not made; one that fails is passed over.
  better.rivals = [](const SweepCage&) { return false; };
  EXPECT_EQ(hexsweep::sweepInterior(cage, { blend(), better }, unpolished()).steps.size(), 1u);
  const InteriorStart failing{ "Failing",
    [](const SweepCage&, const Progress&, const hexsweep::ParallelFor&) -> Points {
      throw hexsweep::SolverFailure("no solution");
    },
    false, [](const SweepCage&) { return true; } };
  EXPECT_EQ(hexsweep::sweepInterior(cage, { blend(), failing }, unpolished()).method, "Blend");
  EXPECT_THROW(
    hexsweep::sweepInterior(cage, { failing, better }, unpolished()), hexsweep::SolverFailure);
}

TEST(SweepInterior, WhatTheCapsForbidDoesNotKeepItGoing)
{
  test::Sweep sweep = test::makeSweep(12, 9, false, test::evenLayers(6),
    [](double x, double y, double t) { return Eigen::RowVector3d(x, y, 2 * t); });
  // An inner node of the target drawn beyond its neighbours.
  sweep.target.row(inner(cageOf(sweep))) += Eigen::RowVector3d(0.25, 0.01, 0.0);
  const SweepCage cage = cageOf(sweep);
  const auto result = hexsweep::sweepInterior(cage, { blend(), spoilt(), spoilt() }, {});
  ASSERT_FALSE(result.fixed.conflicts.empty());
  EXPECT_LE(result.steps.size(), 3u); // no other start
  const auto qualities =
    hexsweep::hexQualities(result.points, hexsweep::sweptHexes(cage.quads, result.points, 6));
  Index bad = 0;
  for (std::size_t h = 0; h < qualities.size(); ++h)
  {
    if (qualities[h].validity != hexsweep::Validity::Certified)
    {
      EXPECT_TRUE(result.fixed.forbids(static_cast<Index>(h))) << h;
      ++bad;
    }
  }
  EXPECT_GT(bad, 0);
}

TEST(SweepInterior, PolishIsTheLastStepAndNeverLowersTheMinimum)
{
  const SweepCage cage =
    cageOf(test::makeSweep(12, 9, true, test::evenLayers(6), test::bendingMotion));
  const auto raw = hexsweep::sweepInterior(cage, { blend() }, unpolished());
  const auto polished = hexsweep::sweepInterior(cage, { blend() }, {});
  EXPECT_EQ(polished.method, "Blend + polish");
  EXPECT_EQ(polished.steps.back().name, "Polish");
  const auto was = judge(cage, raw.points);
  const auto is = judge(cage, polished.points);
  EXPECT_GE(is.minScaledJacobian, was.minScaledJacobian);
  EXPECT_GT(is.meanScaledJacobian, was.meanScaledJacobian);
  EXPECT_EQ(is.notCertified, 0);
}

TEST(SweepInterior, UntangledAgainWhereThePolishLeavesBadHexes)
{
  // Caps that bend so much that not everything can be cured.
  const SweepCage cage =
    cageOf(test::makeSweep(12, 8, true, test::evenLayers(2), [](double x, double y, double t) {
      const double u = std::sin(3 * x + 2 * y + 63);
      const double v = std::sin(4 * y - 2 * x + 126);
      const double w = std::sin(2 * x + 3 * y + 189);
      return Eigen::RowVector3d(x + 0.24 * ((1 - t) * v + t * w), y + 0.24 * ((1 - t) * w + t * u),
        1.5 * t + 0.8 * ((1 - t) * u + t * v));
    }));
  const auto result = hexsweep::sweepInterior(cage, { blend() }, {});
  std::vector<std::string> names;
  Index polished = 0;
  for (const hexsweep::InteriorStep& step : result.steps)
  {
    polished = step.name == "Polish" && polished == 0 ? step.notCertified : polished;
    names.push_back(step.name);
  }
  ASSERT_GE(names.size(), 4u);
  EXPECT_EQ(names[2], "Polish");
  EXPECT_EQ(names[3], "Untangling");
  EXPECT_LE(names.size(), 7u); // twice at the most
  EXPECT_LT(result.steps.back().notCertified, polished);
  const auto after = test::judge(
    result.points, hexsweep::sweptHexes(cage.quads, result.points, cage.boundary.numberOfLayers()));
  EXPECT_EQ(after.notCertified, result.steps.back().notCertified);
}

TEST(SweepInterior, SinglePrecisionIsUntangledAsItIsStored)
{
  // Thin layers so far from the origin that a layer is a few units of the last place high.
  const double offset = 2e5;
  const SweepCage cage =
    cageOf(test::makeSweep(10, 8, false, test::evenLayers(8), [=](double x, double y, double t) {
      const double wave = 0.12 * std::sin(4 * x) * std::sin(4 * y) * (1 - t);
      return Eigen::RowVector3d(x + offset, y - offset, 0.3 * t + wave + offset);
    }));
  const auto precise = hexsweep::sweepInterior(cage, { blend() }, {});
  ASSERT_EQ(judge(cage, precise.points).notCertified, 0);
  EXPECT_EQ(precise.lostByRounding, 0);
  const Points rounded = hexsweep::stored(precise.points, hexsweep::Precision::Single);
  const Index lost = judge(cage, rounded).notCertified;
  ASSERT_GT(lost, 5);

  InteriorOptions options;
  options.precision = hexsweep::Precision::Single;
  const auto result = hexsweep::sweepInterior(cage, { blend() }, options);
  EXPECT_EQ(result.points, hexsweep::stored(result.points, hexsweep::Precision::Single));
  EXPECT_EQ(result.points.topRows(cage.source.rows()),
    hexsweep::stored(cage.source, hexsweep::Precision::Single));
  EXPECT_EQ(judge(cage, result.points).notCertified, 0);
  EXPECT_EQ(result.lostByRounding, 0);
  ASSERT_GE(result.steps.size(), 2u);
  EXPECT_EQ(result.steps[result.steps.size() - 2].name, "Rounding");
  EXPECT_EQ(result.steps[result.steps.size() - 2].notCertified, lost);
  EXPECT_EQ(result.steps.back().name, "Untangling");
}

TEST(SweepInterior, ProgressRisesAndAnAbortStopsTheWork)
{
  const SweepCage cage =
    cageOf(test::makeSweep(12, 9, true, test::evenLayers(6), test::bendingMotion));
  double last = 0.0;
  hexsweep::sweepInterior(cage, { spoilt() }, {}, [&](double done) {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.0);
    last = done;
    return true;
  });
  EXPECT_EQ(last, 1.0);
  for (const double stop : { 0.1, 0.5, 0.7 })
  {
    EXPECT_THROW(
      hexsweep::sweepInterior(cage, { spoilt() }, {}, [&](double done) { return done < stop; }),
      hexsweep::Aborted);
  }
}
}

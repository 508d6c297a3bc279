// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/SectionMarch.h"

#include "Core/Common/Errors.h"
#include "Core/Linking/QuadWinding.h"
#include "Core/Linking/SectionDescent.h"
#include "Support/WindingSweeps.h"

namespace TestSectionMarch
{
using hexsweep::CarriedQuads;
using hexsweep::Index;
using hexsweep::PlanePoints;
using hexsweep::Points;
using hexsweep::SectionDescent;
using hexsweep::SweepSections;
using test::Pi;

SweepSections sectionsOf(const test::Sweep& sweep)
{
  return *hexsweep::sweepSections(
    test::traced({ sweep.source, sweep.quads }, { sweep.linkingPoints, sweep.linkingQuads }));
}

/// A square plate of squares.
struct Plate
{
  hexsweep::QuadMesh mesh;
  PlanePoints places;
  std::vector<bool> rim;

  explicit Plate(int cells)
    : mesh(test::quadPlate(cells, {}))
    , places(mesh.points.leftCols<2>())
  {
    for (Index i = 0; i < this->places.rows(); ++i)
    {
      this->rim.push_back((this->places.row(i).array() - 0.5).abs().maxCoeff() > 0.5 - 1e-9);
    }
  }
  SectionDescent descent() const
  {
    return { this->mesh.quads, this->rim, this->mesh.points, this->mesh.points };
  }
};

Index invertedCorners(const test::Quads& quads, const PlanePoints& at)
{
  Index count = 0;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (int c = 0; c < 4; ++c)
    {
      Eigen::Matrix2d edges;
      edges << at.row(quads(q, (c + 1) % 4)) - at.row(quads(q, c)),
        at.row(quads(q, (c + 3) % 4)) - at.row(quads(q, c));
      count += edges.determinant() <= 0.0;
    }
  }
  return count;
}

TEST(SectionDescent, RelaxesToTheWantedShapes)
{
  const Plate plate(8);
  PlanePoints shaken = plate.places;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> shake(-0.03, 0.03);
  for (Index i = 0; i < shaken.rows(); ++i)
  {
    if (!plate.rim[static_cast<std::size_t>(i)])
    {
      shaken.row(i) += Eigen::RowVector2d(shake(generator), shake(generator));
    }
  }
  SectionDescent descent = plate.descent();
  ASSERT_EQ(descent.inverted(shaken), 0);
  for (int round = 0; round < 5; ++round)
  {
    descent.relax(shaken, 10);
  }
  EXPECT_LT((shaken - plate.places).cwiseAbs().maxCoeff(), 1e-2);
  EXPECT_LT((shaken - plate.places).norm(), 0.03);
}

TEST(SectionDescent, UntanglesWhatIsFoldedAndCountsIt)
{
  const Plate plate(8);
  PlanePoints folded = plate.places;
  for (Index i = 0; i < folded.rows(); ++i)
  {
    if (!plate.rim[static_cast<std::size_t>(i)])
    {
      folded.row(i) = Eigen::RowVector2d(1.0, 1.0) - folded.row(i); // half a turn
    }
  }
  SectionDescent descent = plate.descent();
  EXPECT_EQ(descent.inverted(folded), invertedCorners(plate.mesh.quads, folded));
  EXPECT_GT(descent.inverted(folded), 0);
  EXPECT_EQ(descent.untangle(folded, 100), 0);
  EXPECT_EQ(invertedCorners(plate.mesh.quads, folded), 0);
}

TEST(SectionMarch, LinearSectionsAreExact)
{
  // Sheared, stretched and turned as a whole: all layers are the source's image.
  test::WindingShape shape;
  shape.degrees = 0.0;
  const test::Sweep base = test::windingSweep(shape).sweep;
  const auto motion = [](double x, double y, double t) -> Eigen::RowVector3d {
    const Eigen::Vector2d p =
      Eigen::Rotation2Dd(2.0 * t) * Eigen::Vector2d((1.0 + t) * x, (1.0 + t) * y);
    return { p.x(), p.y() + t * t, 3.0 * t };
  };
  const test::Sweep sweep = test::sweepCap(base.cap, base.quads, test::evenLayers(12), motion);
  const SweepSections sections = sectionsOf(sweep);
  const CarriedQuads carried = hexsweep::carryQuads(sweep.source, sweep.quads, sections);
  ASSERT_EQ(carried.layers.size(), 13u);
  for (std::size_t k = 0; k < carried.layers.size(); ++k)
  {
    const Index n = sweep.source.rows();
    const PlanePoints truth =
      sections.frames[k].flatten(sweep.layers.middleRows(static_cast<Index>(k) * n, n));
    EXPECT_LT((carried.layers[k] - truth).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_EQ(carried.inverted[k], 0);
  }
}

TEST(SectionMarch, WindsAsTheSidesDo)
{
  for (const test::Holes holes : { test::Holes::One, test::Holes::Two })
  {
    test::WindingShape shape;
    shape.holes = holes;
    shape.degrees = 210.0;
    const test::Sweep sweep = test::windingSweep(shape).sweep;
    const SweepSections sections = sectionsOf(sweep);
    const CarriedQuads carried = hexsweep::carryQuads(sweep.source, sweep.quads, sections);
    EXPECT_TRUE(carried.valid());
    for (std::size_t k = 0; k < carried.layers.size(); ++k)
    {
      EXPECT_EQ(invertedCorners(sweep.quads, carried.layers[k]), 0);
      const double turn = 210.0 * Pi / 180.0 * static_cast<double>(k) / 24.0;
      for (const double found :
        test::turnOfPaths(sweep.quads, carried.layers[0], carried.layers[k]))
      {
        EXPECT_NEAR(found, turn, 1e-6);
      }
      for (std::size_t j = 0; j < sections.nodes.size(); ++j)
      {
        EXPECT_EQ(
          carried.layers[k].row(sections.nodes[j]), sections.rings[k].row(static_cast<Index>(j)));
      }
    }
  }
}

TEST(SectionMarch, EndsNearATargetThatIsKnown)
{
  // Quads that were polished on the target: the plain march does not know them.
  test::WindingShape shape;
  shape.degrees = 90.0;
  const test::Sweep sweep = test::windingSweep(shape).sweep;
  const SweepSections sections = sectionsOf(sweep);
  const CarriedQuads plain = hexsweep::carryQuads(sweep.source, sweep.quads, sections);
  PlanePoints moved = plain.layers.back();
  for (Index i = 0; i < moved.rows(); ++i)
  {
    const double r = moved.row(i).norm();
    if (r < 1.0 - 1e-9 && r > 0.45)
    {
      moved.row(i) *= 1.0 + 0.5 * (1.0 - r) * (r - 0.45);
    }
  }
  ASSERT_EQ(invertedCorners(sweep.quads, moved), 0);
  const Points target = sections.frames.back().lift(moved, Eigen::VectorXd::Zero(moved.rows()));
  std::vector<double> fractions;
  for (int k = 0; k <= 24; ++k)
  {
    fractions.push_back(k / 24.0);
  }
  const CarriedQuads known =
    hexsweep::carryQuads(sweep.source, target, fractions, sweep.quads, sections);
  EXPECT_TRUE(known.valid());
  EXPECT_LT((known.layers.back() - moved).norm(), 0.3 * (plain.layers.back() - moved).norm());
}

TEST(SectionMarch, CanBeAborted)
{
  test::WindingShape shape;
  const test::Sweep sweep = test::windingSweep(shape).sweep;
  const SweepSections sections = sectionsOf(sweep);
  int calls = 0;
  EXPECT_THROW(
    hexsweep::carryQuads(sweep.source, sweep.quads, sections, [&](double) { return ++calls < 5; }),
    hexsweep::Aborted);
}
}

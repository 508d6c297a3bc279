// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/GeometrySnap.h"

#include "Core/Common/Constants.h"
#include "Core/Geometry/ReflectedGeometry.h"
#include "Core/Solids/SourceQuads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace TestGeometrySnap
{
using namespace hexsweep;

using Place = Eigen::RowVector3d;

constexpr double Height = 4.0;

/// A drum about the z axis, whose radius at height z is 2 + bulge sin(pi z / Height). Faces: 1
/// below, 2 above, 3 round; edges: 1 below, 2 above.
class Drum : public ModelGeometry
{
public:
  explicit Drum(double bulge)
    : Bulge(bulge)
  {
  }

  double radius(double z) const { return 2.0 + this->Bulge * std::sin(Pi * z / Height); }

  std::optional<Place> closestOnFace(Index faceId, const Place& place) const override
  {
    if (faceId == 3)
    {
      return this->onRound(place);
    }
    return Place(place[0], place[1], faceId == 1 ? 0.0 : Height);
  }

  std::optional<Place> normalOnFace(Index, const Place&) const override { return std::nullopt; }
  std::string surfaceType(Index) const override { return "other"; }

  std::vector<Index> edgesBetween(Index a, Index b) const override
  {
    return std::max(a, b) == 3 && a != b ? std::vector<Index>{ std::min(a, b) }
                                         : std::vector<Index>();
  }

  std::optional<Place> closestOnEdge(Index edgeId, const Place& place) const override
  {
    const Place flat(place[0], place[1], edgeId == 1 ? 0.0 : Height);
    return this->onRound(flat);
  }

  Points endsOfEdge(Index) const override { return Points(0, 3); }
  std::optional<ModelFacets> facets(double, double, const Progress&) const override
  {
    return std::nullopt;
  }

private:
  /// Outward at its height, which is near enough to the nearest point for what is asked here.
  Place onRound(const Place& place) const
  {
    const double now = std::hypot(place[0], place[1]);
    const double wanted = this->radius(place[2]);
    return { place[0] / now * wanted, place[1] / now * wanted, place[2] };
  }

  double Bulge;
};

/// Facets of the drum.
SolidInput facetsOf(const Drum& drum, Index around, Index up)
{
  SolidInput input;
  input.points.resize(around * (up + 1) + 2, 3);
  std::vector<std::array<Index, 3>> triangles;
  for (Index k = 0; k <= up; ++k)
  {
    const double z = Height * static_cast<double>(k) / static_cast<double>(up);
    for (Index i = 0; i < around; ++i)
    {
      const double turn = 2.0 * Pi * static_cast<double>(i) / static_cast<double>(around);
      input.points.row(k * around + i) << drum.radius(z) * std::cos(turn),
        drum.radius(z) * std::sin(turn), z;
    }
  }
  const Index below = around * (up + 1);
  input.points.row(below) << 0.0, 0.0, 0.0;
  input.points.row(below + 1) << 0.0, 0.0, Height;
  for (Index i = 0; i < around; ++i)
  {
    const Index next = (i + 1) % around;
    triangles.push_back({ below, next, i });
    input.faceIds.push_back(1);
    triangles.push_back({ below + 1, up * around + i, up * around + next });
    input.faceIds.push_back(2);
    for (Index k = 0; k < up; ++k)
    {
      triangles.push_back({ k * around + i, k * around + next, (k + 1) * around + next });
      triangles.push_back({ k * around + i, (k + 1) * around + next, (k + 1) * around + i });
      input.faceIds.insert(input.faceIds.end(), 2, 3);
    }
  }
  input.triangles.resize(static_cast<Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    input.triangles.row(static_cast<Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
  }
  return input;
}

struct Snapped
{
  SolidCage cage;
  GeometrySnap snap;
};

Snapped snapped(const SolidInput& input, const ModelGeometry& geometry)
{
  const SolidSurface solid = makeSolidSurface(input);
  const SweepTopology topology = sweepBetween(solid, { 1 }, { 2 });
  SolidCageInput cage{ solid, topology, makeSourceQuads(input, solid, topology, 0.5).mesh, {}, {} };
  cage.layers.layers = 6;
  Snapped result{ makeSolidCage(cage), {} };
  result.snap = snapToGeometry(solid, topology, geometry, result.cage);
  return result;
}

//------------------------------------------------------------------------------
TEST(GeometrySnap, NodesOfAPrismComeToTheCylinder)
{
  const Drum drum(0.0);
  const Snapped result = snapped(facetsOf(drum, 30, 1), drum);
  EXPECT_EQ(result.snap.left, 0);
  // The height of the circle over a facet.
  EXPECT_NEAR(result.snap.greatestMove, 2.0 * (1.0 - std::cos(Pi / 30.0)), 2e-3);
  EXPECT_TRUE(result.cage.isRuled);
  for (const Points& ring : result.cage.boundary.rings)
  {
    for (Index j = 0; j < ring.rows(); ++j)
    {
      EXPECT_NEAR(std::hypot(ring(j, 0), ring(j, 1)), 2.0, 1e-14);
    }
  }
  EXPECT_EQ(result.cage.source.col(2).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_EQ(result.cage.target.col(2).minCoeff(), Height);
}

TEST(GeometrySnap, ColumnsOfACurvedSideAreStraightNoMore)
{
  // Facets that know nothing of the bulge.
  const Drum bulging(0.1);
  const Snapped result = snapped(facetsOf(Drum(0.0), 30, 1), bulging);
  EXPECT_EQ(result.snap.left, 0);
  EXPECT_FALSE(result.cage.isRuled);
  const Points& middle = result.cage.boundary.rings[3];
  for (Index j = 0; j < middle.rows(); ++j)
  {
    EXPECT_NEAR(std::hypot(middle(j, 0), middle(j, 1)), bulging.radius(middle(j, 2)), 1e-14);
  }
}

TEST(GeometrySnap, NodesThatWouldGoFarStayAndAreCounted)
{
  // A bulge wider than a quad: the nodes in the middle belong somewhere else.
  const Snapped result = snapped(facetsOf(Drum(0.0), 30, 1), Drum(1.0));
  EXPECT_GT(result.snap.left, 0);
  EXPECT_LT(result.snap.greatestMove, 0.5);
  const Points& middle = result.cage.boundary.rings[3];
  EXPECT_NEAR(std::hypot(middle(0, 0), middle(0, 1)), 2.0, 0.02);
}

TEST(GeometrySnap, ReflectionsAnswerInTheMirror)
{
  const auto drum = std::make_shared<const Drum>(0.1);
  EXPECT_EQ(reflectedGeometry(drum, {}), drum);
  Reflection mirror;
  mirror.signs << -1.0, 1.0, -1.0;
  const auto reflected = reflectedGeometry(drum, mirror);
  const Place place(1.0, 2.0, -1.0);
  const Place direct = *drum->closestOnFace(3, place.cwiseProduct(mirror.signs));
  EXPECT_EQ(*reflected->closestOnFace(3, place), Place(direct.cwiseProduct(mirror.signs)));
  EXPECT_EQ((*reflected->closestOnEdge(2, place))[2], -Height);
  EXPECT_EQ(reflected->edgesBetween(1, 3), std::vector<Index>{ 1 });
}
}

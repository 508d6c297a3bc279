// SPDX-License-Identifier: BSD-3-Clause
// One solid in many guises.
#include "Core/Common/Errors.h"
#include "Core/Solids/CanonicalSolid.h"

#include "Support/SolidShapes.h"
#include "Support/SweptSolids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace TestCanonicalSolid
{
using hexsweep::CanonicalSolid;
using hexsweep::canonicalSolid;
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::SolidInput;
using hexsweep::SolidSurface;

/// Without any symmetry.
SolidInput crookedSolid()
{
  return test::sweptSolid({ { { 0.0, 0.0 }, { 5.0, 0.5 }, { 4.0, 3.0 }, { 1.0, 3.5 } },
                            test::holeSection(2.0, 1.5, 0.5, 9) },
    [](double x, double y, double h) {
      return Eigen::RowVector3d(x + 0.3 * h, y * (1.0 + 0.1 * h), 2.0 * h);
    });
}

std::vector<Index> shuffled(Index n, unsigned seed)
{
  std::vector<Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), Index{ 0 });
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  return order;
}

/// Other numbers for points and triangles, other first corners, all turned over if asked for.
SolidInput renumbered(const SolidInput& solid, unsigned seed, bool turned)
{
  const std::vector<Index> points = shuffled(solid.points.rows(), seed);
  const std::vector<Index> triangles = shuffled(solid.triangles.rows(), seed + 1);
  std::vector<Index> newId(points.size());
  SolidInput result = solid;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    newId[static_cast<std::size_t>(points[i])] = static_cast<Index>(i);
    result.points.row(static_cast<Index>(i)) = solid.points.row(points[i]);
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index from = (c + static_cast<Index>(t)) % 3;
      result.triangles(static_cast<Index>(t), turned ? 2 - c : c) =
        newId[static_cast<std::size_t>(solid.triangles(triangles[t], from))];
    }
    result.faceIds[t] = solid.faceIds[static_cast<std::size_t>(triangles[t])];
  }
  return result;
}

SolidInput mirrored(SolidInput solid, const Eigen::RowVector3d& signs)
{
  solid.points = (solid.points.array().rowwise() * signs.array()).matrix();
  return solid;
}

void expectSame(const CanonicalSolid& a, const CanonicalSolid& b)
{
  const SolidSurface first = makeSolidSurface(a.input);
  const SolidSurface second = makeSolidSurface(b.input);
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.triangles, second.triangles);
  EXPECT_EQ(first.faceIds, second.faceIds);
}

TEST(CanonicalSolid, DoesNotDependOnNumbersAndOrientation)
{
  for (const SolidInput& solid : { crookedSolid(), test::box(3, 3, 3), test::box(1, 2, 3),
         test::soup(crookedSolid()), test::soup(test::box(2, 2, 1)) })
  {
    for (unsigned seed = 0; seed < 6; ++seed)
    {
      expectSame(canonicalSolid(solid), canonicalSolid(renumbered(solid, seed, seed % 2 != 0)));
    }
  }
}

TEST(CanonicalSolid, IsTheSameForAllReflectionsOfASolid)
{
  const SolidInput solid = crookedSolid();
  const CanonicalSolid canonical = canonicalSolid(solid);
  for (int i = 0; i < 8; ++i)
  {
    const Eigen::RowVector3d signs(i % 2 ? -1.0 : 1.0, i / 2 % 2 ? -1.0 : 1.0, i / 4 ? -1.0 : 1.0);
    const CanonicalSolid image = canonicalSolid(renumbered(mirrored(solid, signs), 7, false));
    expectSame(canonical, image);
    EXPECT_EQ(image.reflection.signs, canonical.reflection.signs.cwiseProduct(signs));
  }
}

TEST(CanonicalSolid, IsTheSameForReflectionsOfASymmetricSolid)
{
  // A box of cubes whose triangles alone tell left from right, and one that looks the same from
  // both sides along one axis.
  for (const SolidInput& solid : { test::box(2, 2, 2), test::box(4, 2, 3) })
  {
    SolidInput centered = solid;
    centered.points.rowwise() -= 0.5 * solid.points.colwise().maxCoeff();
    const CanonicalSolid canonical = canonicalSolid(centered);
    for (int i = 0; i < 8; ++i)
    {
      const Eigen::RowVector3d signs(
        i % 2 ? -1.0 : 1.0, i / 2 % 2 ? -1.0 : 1.0, i / 4 ? -1.0 : 1.0);
      const CanonicalSolid image = canonicalSolid(mirrored(centered, signs));
      EXPECT_EQ(canonical.input.points, image.input.points);
      const SolidSurface first = makeSolidSurface(canonical.input);
      const SolidSurface second = makeSolidSurface(image.input);
      EXPECT_EQ(first.triangles, second.triangles);
    }
  }
}

TEST(CanonicalSolid, KeepsTrackOfItsInput)
{
  SolidInput solid = crookedSolid();
  solid.cellIds = shuffled(solid.triangles.rows(), 3);
  solid.points.conservativeResize(solid.points.rows() + 1, 3); // a point that no triangle uses
  solid.points.row(solid.points.rows() - 1).setConstant(1e9);
  const CanonicalSolid canonical = canonicalSolid(solid);
  const SolidInput& input = canonical.input;
  ASSERT_EQ(input.points.rows(), solid.points.rows() - 1);
  for (Index p = 0; p < input.points.rows(); ++p)
  {
    const Eigen::RowVector3d given = solid.points.row(input.pointIds[static_cast<std::size_t>(p)]);
    EXPECT_EQ(input.points.row(p), given.cwiseProduct(canonical.reflection.signs));
  }
  for (Index t = 0; t < input.triangles.rows(); ++t)
  {
    const Index cell = input.cellIds[static_cast<std::size_t>(t)];
    const auto row = std::find(solid.cellIds.begin(), solid.cellIds.end(), cell);
    const Index given = row - solid.cellIds.begin();
    EXPECT_EQ(
      input.faceIds[static_cast<std::size_t>(t)], solid.faceIds[static_cast<std::size_t>(given)]);
    std::vector<Index> corners;
    std::vector<Index> own;
    for (Index c = 0; c < 3; ++c)
    {
      corners.push_back(solid.triangles(given, c));
      own.push_back(input.pointIds[static_cast<std::size_t>(input.triangles(t, c))]);
    }
    EXPECT_TRUE(std::is_permutation(corners.begin(), corners.end(), own.begin()));
  }
}

TEST(CanonicalSolid, FacesFoundByAngleKeepTheNumbersOfTheFile)
{
  SolidInput solid = test::box(2, 1, 3);
  solid.faceIds.clear();
  const SolidSurface given = makeSolidSurface(solid);
  const SolidSurface canonical = makeSolidSurface(canonicalSolid(solid).input);
  ASSERT_EQ(canonical.faceIds.size(), 44u); // two for each of 22 unit squares
  for (std::size_t t = 0; t < canonical.faceIds.size(); ++t)
  {
    const auto cell = static_cast<std::size_t>(canonical.cellIds[t]);
    EXPECT_EQ(canonical.faceIds[t], given.faceIds[cell]);
  }
}

TEST(CanonicalSolid, RefusesCornersThatDoNotExist)
{
  SolidInput solid = test::box(1, 1, 1);
  solid.triangles(4, 1) = 99;
  EXPECT_THROW(canonicalSolid(solid), hexsweep::InvalidInput);
}
}

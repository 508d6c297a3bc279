// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/CapMeshing.h"
#include "Core/CapQuads/ChordLengths.h"

#include "Core/Common/Constants.h"
#include "Core/Common/Errors.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace TestChordLengths
{
using namespace hexsweep;

constexpr double Radius = 3.0;

/// The cap of a sphere up to 70 degrees from its pole, finely divided.
TriangleMesh sphereCap(Index rings)
{
  const Index around = 6 * rings;
  TriangleMesh mesh;
  mesh.points.resize(1 + rings * around, 3);
  mesh.points.row(0) << 0.0, 0.0, Radius;
  for (Index r = 1; r <= rings; ++r)
  {
    const double polar = 70.0 / 180.0 * Pi * static_cast<double>(r) / static_cast<double>(rings);
    for (Index i = 0; i < around; ++i)
    {
      const double turn = 2.0 * Pi * static_cast<double>(i) / static_cast<double>(around);
      mesh.points.row(1 + (r - 1) * around + i) << Radius * std::sin(polar) * std::cos(turn),
        Radius * std::sin(polar) * std::sin(turn), Radius * std::cos(polar);
    }
  }
  mesh.triangles.resize(around * (2 * rings - 1), 3);
  Index row = 0;
  const auto at = [&](Index ring, Index i) { return 1 + (ring - 1) * around + i % around; };
  for (Index i = 0; i < around; ++i)
  {
    mesh.triangles.row(row++) << 0, at(1, i), at(1, i + 1);
    for (Index r = 1; r < rings; ++r)
    {
      mesh.triangles.row(row++) << at(r, i), at(r + 1, i), at(r + 1, i + 1);
      mesh.triangles.row(row++) << at(r, i), at(r + 1, i + 1), at(r, i + 1);
    }
  }
  return mesh;
}

/// Heights of the sphere over the edges of the quads, over the edges' lengths, rising.
std::vector<double> rises(const QuadMesh& mesh)
{
  std::vector<double> all;
  for (Index q = 0; q < mesh.quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      const Eigen::RowVector3d a = mesh.points.row(mesh.quads(q, c));
      const Eigen::RowVector3d b = mesh.points.row(mesh.quads(q, (c + 1) % 4));
      all.push_back((Radius - (0.5 * (a + b)).norm()) / (a - b).norm());
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

//------------------------------------------------------------------------------
TEST(ChordLengths, AreThoseOfTheSphere)
{
  const ChordLengths lengths(sphereCap(40), {}, 0.05);
  // To first order; the arc over a chord of this length rises by 5.03 % of it.
  EXPECT_NEAR(lengths.at({ 0.0, 0.0, Radius }), 8.0 * 0.05 * Radius, 0.02);
  EXPECT_NEAR(lengths.at({ 2.0, 1.0, 2.0 }), 8.0 * 0.05 * Radius, 0.02);
}

TEST(ChordLengths, PlanesAndBordersBetweenFacesHaveNone)
{
  // A roof: two planes.
  TriangleMesh roof;
  roof.points.resize(6, 3);
  roof.points << 0, 0, 0, 1, 0, 1, 2, 0, 0, 0, 1, 0, 1, 1, 1, 2, 1, 0;
  roof.triangles.resize(4, 3);
  roof.triangles << 0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4;
  const ChordLengths two(roof, { 1, 1, 2, 2 }, 0.05);
  EXPECT_TRUE(std::isinf(two.at({ 0.5, 0.5, 0.5 })));
  const ChordLengths one(roof, {}, 0.05);
  EXPECT_LT(one.at({ 0.5, 0.5, 0.5 }), 1.0);
}

TEST(ChordLengths, QuadsKeepTheToleranceWhereTheyAreMade)
{
  const TriangleMesh cap = sphereCap(60);
  CapQuadOptions options;
  options.size = 2.0;
  const CapQuads coarse = meshCapWithQuads(cap, {}, options);
  EXPECT_GT(rises(coarse.mesh).back(), 0.06);
  for (const double tolerance : { 0.05, 0.025 })
  {
    options.chordTolerance = tolerance;
    const CapQuads quads = meshCapWithQuads(cap, {}, options);
    EXPECT_EQ(quads.inverted, 0);
    const std::vector<double> all = rises(quads.mesh);
    EXPECT_LT(all[all.size() * 9 / 10], tolerance);
    EXPECT_GT(all[all.size() * 9 / 10], 0.6 * tolerance);
    EXPECT_LT(all.back(), 2.0 * tolerance);
  }
  options.chordTolerance = -0.1;
  EXPECT_THROW(meshCapWithQuads(cap, {}, options), hexsweep::InvalidInput);
}
}

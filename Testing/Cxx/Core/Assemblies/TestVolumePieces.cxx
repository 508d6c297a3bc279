// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/CapSections.h"
#include "Core/Assemblies/VolumePieces.h"
#include "Core/Solids/SolidInput.h"
#include "Support/SolidShapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace TestVolumePieces
{
using namespace hexsweep;

using Filled = std::function<bool(int, int, int)>;

/// Unit cubes whose outer faces have an id a connected plane.
SolidSurface solidOf(const test::Cell& size, const Filled& filled)
{
  SolidInput input = test::cubes(size, filled, [](const test::Cell&, int) { return 1; });
  input.faceIds.clear();
  return makeSolidSurface(input, SolidOptions());
}

double volumeOf(const SolidSurface& solid)
{
  double sum = 0.0;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = solid.points.row(solid.triangles(t, 0));
    const Eigen::RowVector3d b = solid.points.row(solid.triangles(t, 1));
    const Eigen::RowVector3d c = solid.points.row(solid.triangles(t, 2));
    sum += a.dot(b.cross(c)) / 6.0;
  }
  return sum;
}

/// Edges of a closed surface are used once each way.
bool isClosed(const SolidSurface& solid)
{
  std::map<std::pair<Index, Index>, int> uses;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      ++uses[{ solid.triangles(t, c), solid.triangles(t, (c + 1) % 3) }];
    }
  }
  return std::all_of(uses.begin(), uses.end(), [&](const auto& use) {
    return use.second == 1 && uses.count({ use.first.second, use.first.first }) == 1;
  });
}

std::vector<AssemblyVolume> volumesOf(const std::vector<SolidSurface>& solids)
{
  std::vector<AssemblyVolume> volumes;
  for (const SolidSurface& solid : solids)
  {
    volumes.emplace_back();
    volumes.back().surface = solid;
    volumes.back().name = "volume " + std::to_string(volumes.size());
  }
  return volumes;
}

/// Volumes of the pieces of a solid, from the lowest on.
std::vector<double> pieceVolumes(const SolidSurface& solid)
{
  std::vector<double> volumes;
  for (const AssemblyVolume& piece : cutIntoPieces(volumesOf({ solid })))
  {
    EXPECT_TRUE(isClosed(piece.surface));
    volumes.push_back(volumeOf(piece.surface));
  }
  return volumes;
}

void expectNear(const std::vector<double>& found, const std::vector<double>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i], expected[i], 1e-9 * expected[i]);
  }
}

/// A plate of 9 x 9 x 2 with a bore of 1 x 1 that is 3 x 3 in its upper half.
bool isCounterbored(int x, int y, int z)
{
  const int wide = std::max(std::abs(x - 4), std::abs(y - 4));
  return z == 0 ? wide > 0 : wide > 1;
}

//------------------------------------------------------------------------------
TEST(CapSections, GoOnFromCapsIntoTheInside)
{
  const SolidSurface solid = solidOf({ 9, 9, 2 }, isCounterbored);
  const CapSection section = sectionAt(solid.points, solid.triangles, 1.0, 1e-6);
  double area = 0.0;
  for (Index t = 0; t < section.triangles.rows(); ++t)
  {
    std::vector<Eigen::RowVector3d> corners;
    for (Index c = 0; c < 3; ++c)
    {
      const Index point = section.triangles(t, c);
      if (point < solid.points.rows())
      {
        corners.emplace_back(solid.points.row(point));
        continue;
      }
      const EdgeCrossing& crossing =
        section.crossings[static_cast<std::size_t>(point - solid.points.rows())];
      corners.emplace_back((1.0 - crossing.fraction) * solid.points.row(crossing.low) +
        crossing.fraction * solid.points.row(crossing.high));
    }
    EXPECT_NEAR(corners[0].z(), 1.0, 1e-12);
    const double doubled = (corners[1] - corners[0]).cross(corners[2] - corners[0]).z();
    EXPECT_GT(doubled, 0.0);
    area += 0.5 * doubled;
  }
  // The plate without the wide bore: the ledge is a cap already.
  EXPECT_NEAR(area, 81.0 - 9.0, 1e-9);
}

TEST(CapSections, AreNoneWhereNoCapIs)
{
  const SolidSurface solid = solidOf({ 9, 9, 2 }, isCounterbored);
  EXPECT_EQ(sectionAt(solid.points, solid.triangles, 0.5, 1e-6).triangles.rows(), 0);
  EXPECT_EQ(sectionAt(solid.points, solid.triangles, 5.0, 1e-6).triangles.rows(), 0);
  // The lowest and the highest caps go on nowhere.
  EXPECT_EQ(sectionAt(solid.points, solid.triangles, 0.0, 1e-6).triangles.rows(), 0);
}

//------------------------------------------------------------------------------
TEST(VolumePieces, AddUpToTheirBody)
{
  SolidSurface solid = solidOf({ 9, 9, 2 }, isCounterbored);
  expectNear(pieceVolumes(solid), { 80.0, 72.0 });
  // The ledge higher than the points outside: the cut goes through edges.
  for (Index i = 0; i < solid.points.rows(); ++i)
  {
    const bool isOuter = (solid.points.row(i).head<2>().array() - 4.5).abs().maxCoeff() > 3.0;
    solid.points(i, 2) += !isOuter && solid.points(i, 2) == 1.0 ? 0.3 : 0.0;
  }
  expectNear(pieceVolumes(solid), { 80.0 * 1.3, 72.0 * 0.7 });
  // Two bosses: the higher one is not cut at the lower one's top.
  expectNear(pieceVolumes(solidOf({ 9, 5, 4 },
               [](int x, int y, int z) {
                 const bool within = y > 0 && y < 4;
                 return z == 0 || (within && x > 0 && x < 3 && z == 1) ||
                   (within && x > 5 && x < 8);
               })),
    { 45.0, 6.0, 18.0 });
}

TEST(VolumePieces, StayWholeWhereOneSourceAndOneTargetDo)
{
  const SolidSurface angle =
    solidOf({ 4, 4, 3 }, [](int x, int y, int) { return x == 0 || y == 0; });
  const std::vector<AssemblyVolume> volumes = cutIntoPieces(volumesOf({ angle }));
  ASSERT_EQ(volumes.size(), 1U);
  EXPECT_EQ(volumes.front().whole, -1);
  EXPECT_EQ(volumes.front().surface.triangles, angle.triangles);
}

TEST(VolumePieces, KeepTheFacesOfTheirBodyAndHaveTheirCapsNamed)
{
  const SolidSurface solid = solidOf({ 9, 9, 2 }, isCounterbored);
  const std::set<Index> given(solid.faceIds.begin(), solid.faceIds.end());
  std::map<Index, int> cuts;
  std::map<Index, double> areas;
  for (const AssemblyVolume& piece : cutIntoPieces(volumesOf({ solid })))
  {
    EXPECT_EQ(piece.whole, 0);
    EXPECT_TRUE(piece.named.eitherWay);
    EXPECT_FALSE(piece.named.sourceFaceIds.empty());
    EXPECT_FALSE(piece.named.targetFaceIds.empty());
    const std::set<Index> own(piece.surface.faceIds.begin(), piece.surface.faceIds.end());
    for (const Index id : own)
    {
      cuts[id] += given.count(id) == 0 ? 1 : 0;
    }
  }
  // One cut between two pieces, with one id in both.
  int shared = 0;
  for (const auto& [id, count] : cuts)
  {
    shared += count == 2 ? 1 : 0;
    EXPECT_TRUE(count == 0 || count == 2);
  }
  EXPECT_EQ(shared, 1);
}

// The cut ends on the face that a neighbour shares: it shares the parts.
TEST(VolumePieces, NeighboursShareWhatWasCut)
{
  SolidSurface plate = solidOf({ 9, 9, 2 }, isCounterbored);
  SolidSurface beside = solidOf({ 2, 9, 2 }, [](int, int, int) { return true; });
  beside.points.col(0).array() += 9.0;
  const std::vector<AssemblyVolume> volumes = cutIntoPieces(volumesOf({ plate, beside }));
  ASSERT_EQ(volumes.size(), 3U);
  std::vector<const SolidSurface*> solids;
  for (const AssemblyVolume& volume : volumes)
  {
    EXPECT_TRUE(isClosed(volume.surface));
    solids.push_back(&volume.surface);
  }
  EXPECT_NEAR(volumeOf(volumes[2].surface), 36.0, 1e-9);
  const AssemblyComplex complex = makeAssemblyComplex(solids);
  std::set<std::vector<Index>> pairs;
  for (const ComplexFace& face : complex.faces)
  {
    if (face.volumes.size() == 2)
    {
      pairs.insert(face.volumes);
    }
  }
  EXPECT_EQ(pairs, (std::set<std::vector<Index>>{ { 0, 1 }, { 0, 2 }, { 1, 2 } }));
}
}

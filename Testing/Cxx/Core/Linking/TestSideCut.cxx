// SPDX-License-Identifier: BSD-3-Clause
// Tubes cut open: what falls apart, and which side is the left one.
#include "Core/Linking/SideCut.h"

#include "Support/CapMeshes.h"
#include "Support/SideTubes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace TestSideCut
{
using hexsweep::CutTube;
using hexsweep::Index;
using hexsweep::TriangleMesh;

constexpr Index Around = 10;
constexpr Index Along = 4;

std::vector<Index> columnAt(Index j)
{
  std::vector<Index> path;
  for (Index k = 0; k <= Along; ++k)
  {
    path.push_back(k * Around + j);
  }
  return path;
}

/// v of a triangle's middle, between 0 and 1, 0 at column `start`.
double middleOf(const TriangleMesh& tube, Index t, Index start)
{
  Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
  for (Index c = 0; c < 3; ++c)
  {
    middle += tube.points.row(tube.triangles(t, c)) / 3.0;
  }
  const double v = std::atan2(middle.y(), middle.x()) / test::TwoPi -
    static_cast<double>(start) / static_cast<double>(Around);
  return v - std::floor(v);
}

void expectSame(const TriangleMesh& tube, const CutTube& cut)
{
  ASSERT_EQ(cut.mesh.triangles.rows(), tube.triangles.rows());
  for (Index t = 0; t < tube.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index copy = cut.mesh.triangles(t, c);
      EXPECT_EQ(cut.original[static_cast<std::size_t>(copy)], tube.triangles(t, c));
      EXPECT_EQ(cut.mesh.points.row(copy), tube.points.row(tube.triangles(t, c)));
    }
  }
}

TEST(SideCut, OneCutLeavesADisk)
{
  const TriangleMesh tube = test::tube(Around, Along, test::Cylinder).surface;
  for (const Index start : { Index(0), Index(7) })
  {
    const CutTube cut = cutTube(tube, { columnAt(start) });
    expectSame(tube, cut);
    EXPECT_EQ(cut.mesh.points.rows(), tube.points.rows() + Along + 1);
    const auto topology =
      hexsweep::checkSurface(cut.mesh.triangles, cut.mesh.points.rows(), "disk");
    EXPECT_EQ(topology.numberOfComponents, 1);
    EXPECT_EQ(topology.loops.size(), 1u);
    EXPECT_EQ(topology.eulerCharacteristic, 1);
    // Up the tube, seen from outside, the left is where v falls.
    std::vector<int> copies(static_cast<std::size_t>(tube.points.rows()), 0);
    for (std::size_t i = 0; i < cut.original.size(); ++i)
    {
      ++copies[static_cast<std::size_t>(cut.original[i])];
    }
    for (Index t = 0; t < tube.triangles.rows(); ++t)
    {
      for (Index c = 0; c < 3; ++c)
      {
        const bool isCut = tube.triangles(t, c) % Around == start;
        EXPECT_EQ(copies[static_cast<std::size_t>(tube.triangles(t, c))], isCut ? 2 : 1);
        EXPECT_EQ(cut.onLeft[static_cast<std::size_t>(cut.mesh.triangles(t, c))],
          isCut && middleOf(tube, t, start) > 0.5);
      }
    }
  }
}

TEST(SideCut, ThreeCutsLeaveThreeDisks)
{
  const TriangleMesh tube = test::tube(Around, Along, test::Cylinder).surface;
  const CutTube cut = cutTube(tube, { columnAt(2), columnAt(3), columnAt(8) });
  expectSame(tube, cut);
  const auto topology = hexsweep::checkSurface(cut.mesh.triangles, cut.mesh.points.rows(), "disks");
  EXPECT_EQ(topology.numberOfComponents, 3);
  EXPECT_EQ(topology.loops.size(), 3u);
  EXPECT_EQ(topology.eulerCharacteristic, 3);
  Index left = 0; // of the first path only
  for (std::size_t i = 0; i < cut.original.size(); ++i)
  {
    left += cut.onLeft[i] ? 1 : 0;
    EXPECT_TRUE(!cut.onLeft[i] || cut.original[i] % Around == 2);
  }
  EXPECT_EQ(left, Along + 1);
}
}

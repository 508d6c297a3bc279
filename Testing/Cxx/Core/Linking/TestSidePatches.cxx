// SPDX-License-Identifier: BSD-3-Clause
// Structured quads on a side come back as columns; what cannot is told.
#include "Core/Linking/SidePatches.h"

#include "Support/CapMeshes.h"
#include "Support/SideTubes.h"

#include "Core/Common/Describe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace TestSidePatches
{
using hexsweep::Index;
using hexsweep::MeshedColumns;
using hexsweep::Points;
using hexsweep::QuadMesh;

constexpr Index Around = 12;
constexpr double Tolerance = 1e-6;

/// Node k of the column at ring node j: layers of unequal heights on a barrel.
Eigen::RowVector3d nodeAt(Index j, Index k, Index layers)
{
  const double angle = test::TwoPi * static_cast<double>(j % Around) / static_cast<double>(Around);
  const double t = static_cast<double>(k) / static_cast<double>(layers);
  const double radius = 1.0 + t * (1.0 - t);
  return { radius * std::cos(angle), radius * std::sin(angle), 2.0 * t * t };
}

Points loopAt(Index k, Index layers)
{
  Points loop(Around, 3);
  for (Index j = 0; j < Around; ++j)
  {
    loop.row(j) = nodeAt(j, k, layers);
  }
  return loop;
}

/// The quads of the columns first ... last, numbered, ordered and turned by chance; the first
/// `present` layers of them.
QuadMesh patch(Index first, Index last, Index layers, Index present)
{
  std::mt19937 generator(5);
  const Index width = last - first + 1;
  std::vector<Index> number(static_cast<std::size_t>(width * (present + 1)));
  for (std::size_t i = 0; i < number.size(); ++i)
  {
    number[i] = static_cast<Index>(i);
  }
  std::shuffle(number.begin(), number.end(), generator);
  const auto point = [&](Index j, Index k) {
    return number[static_cast<std::size_t>(k * width + j)];
  };
  QuadMesh mesh;
  mesh.points.resize(static_cast<Index>(number.size()), 3);
  std::vector<std::vector<Index>> quads;
  for (Index k = 0; k <= present; ++k)
  {
    for (Index j = 0; j < width; ++j)
    {
      mesh.points.row(point(j, k)) = nodeAt(first + j, k, layers);
      if (k < present && j + 1 < width)
      {
        quads.push_back({ point(j, k), point(j + 1, k), point(j + 1, k + 1), point(j, k + 1) });
        std::rotate(
          quads.back().begin(), quads.back().begin() + generator() % 4, quads.back().end());
        if (generator() % 2 == 0)
        {
          std::reverse(quads.back().begin(), quads.back().end());
        }
      }
    }
  }
  std::shuffle(quads.begin(), quads.end(), generator);
  mesh.quads.resize(static_cast<Index>(quads.size()), 4);
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      mesh.quads(static_cast<Index>(q), static_cast<Index>(c)) = quads[q][c];
    }
  }
  return mesh;
}

MeshedColumns trace(const std::vector<QuadMesh>& patches)
{
  return tracePatches(patches, loopAt(0, 1), loopAt(1, 1), Tolerance);
}

/// Columns first ... last and no others, bit for bit.
void expectColumns(const MeshedColumns& result, const std::vector<Index>& expected, Index layers)
{
  ASSERT_EQ(result.columns.size(), static_cast<std::size_t>(Around));
  for (Index j = 0; j < Around; ++j)
  {
    const Points& column = result.columns[static_cast<std::size_t>(j)];
    const bool isMeshed = std::count(expected.begin(), expected.end(), j) > 0;
    ASSERT_EQ(column.rows(), isMeshed ? layers + 1 : 0) << j;
    for (Index k = 0; k < column.rows(); ++k)
    {
      EXPECT_EQ(Eigen::RowVector3d(column.row(k)), nodeAt(j, k, layers)) << j << " " << k;
    }
  }
}

void expectRefused(const QuadMesh& given, const std::vector<std::string>& parts)
{
  const MeshedColumns result = trace({ given });
  EXPECT_EQ(result.layers, 0);
  expectColumns(result, {}, 0);
  ASSERT_EQ(result.refused.size(), 1u);
  for (const std::string& part : parts)
  {
    EXPECT_NE(result.refused[0].find(part), std::string::npos) << result.refused[0];
  }
}

TEST(SidePatches, ComeBackNodeForNode)
{
  const MeshedColumns result = trace({ patch(3, 6, 5, 5) });
  EXPECT_EQ(result.layers, 5);
  EXPECT_TRUE(result.refused.empty());
  expectColumns(result, { 3, 4, 5, 6 }, 5);
}

TEST(SidePatches, LeadAcrossTheBeginningOfTheRing)
{
  const MeshedColumns result = trace({ patch(10, 13, 4, 4), patch(4, 5, 4, 4) });
  EXPECT_EQ(result.layers, 4);
  expectColumns(result, { 10, 11, 0, 1, 4, 5 }, 4);
}

// The last column lies on the first one and has points of its own.
TEST(SidePatches, LeadAllRound)
{
  const MeshedColumns result = trace({ patch(2, 2 + Around, 3, 3) });
  EXPECT_TRUE(result.refused.empty());
  expectColumns(result, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 }, 3);
}

TEST(SidePatches, NoneAreNoLayers)
{
  const MeshedColumns result = trace({});
  EXPECT_EQ(result.layers, 0);
  expectColumns(result, {}, 0);
}

TEST(SidePatches, DifferentLayersAreNamed)
{
  const std::vector<QuadMesh> patches = { patch(3, 6, 5, 5), patch(8, 9, 4, 4) };
  test::expectInvalid([&] { trace(patches); }, "5 layers at ");
  test::expectInvalid([&] { trace(patches); }, "4 layers at (-0.5, -0.866025404, 0)");
}

TEST(SidePatches, OffTheSideAreRefused)
{
  QuadMesh off = patch(3, 6, 5, 5);
  off.points.col(2).array() += 1e-3;
  const Eigen::RowVector3d first = off.points.row(off.quads(0, 0));
  expectRefused(
    off, { "do not begin at the source quads", "15, the first at " + hexsweep::describe(first) });
}

TEST(SidePatches, ThatEndBelowTheTargetAreRefused)
{
  expectRefused(patch(3, 6, 5, 4), { "do not reach the target cap: layer 4 is the last one" });
}

TEST(SidePatches, WithAHoleAreRefused)
{
  QuadMesh torn = patch(3, 6, 5, 5);
  const Index inner = torn.quads.rows() / 2;
  torn.quads.row(inner) = Eigen::Matrix<Index, 1, 4>(torn.quads.row(torn.quads.rows() - 1));
  torn.quads.conservativeResize(torn.quads.rows() - 1, 4);
  expectRefused(torn, { "are not structured" });
}
}

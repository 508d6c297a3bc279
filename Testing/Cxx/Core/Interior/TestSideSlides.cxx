// SPDX-License-Identifier: BSD-3-Clause
// A box in which one node of a side lies badly.
#include "Core/Interior/SideSlides.h"

#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Interior/SweptHexes.h"

#include <gtest/gtest.h>

namespace TestSideSlides
{
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::Points;

constexpr Index Cells = 3; // along each edge of the box, which is as long
constexpr Index Nodes = Cells + 1;
constexpr Index BadRow = 1;   // of the loop: the node at (1, 0)
constexpr Index BadLayer = 1; // of three

struct Box
{
  hexsweep::SweepCage cage;
  Points filled;
  Index badNode;
};

Index idOf(Index x, Index y)
{
  return y * Nodes + x;
}

Loop outline()
{
  Loop loop;
  for (Index i = 0; i < Cells; ++i)
  {
    loop.push_back(idOf(i, 0));
  }
  for (Index i = 0; i < Cells; ++i)
  {
    loop.push_back(idOf(Cells, i));
  }
  for (Index i = Cells; i > 0; --i)
  {
    loop.push_back(idOf(i, Cells));
  }
  for (Index i = Cells; i > 0; --i)
  {
    loop.push_back(idOf(0, i));
  }
  return loop;
}

/// @param bad what the node is moved by, in its side y = 0.
Box boxWith(const Eigen::RowVector3d& bad)
{
  Box box;
  Points layer(Nodes * Nodes, 3);
  for (Index y = 0; y < Nodes; ++y)
  {
    for (Index x = 0; x < Nodes; ++x)
    {
      layer.row(idOf(x, y)) << static_cast<double>(x), static_cast<double>(y), 0.0;
    }
  }
  hexsweep::Quads& quads = box.cage.quads;
  quads.resize(Cells * Cells, 4);
  for (Index y = 0; y < Cells; ++y)
  {
    for (Index x = 0; x < Cells; ++x)
    {
      quads.row(y * Cells + x) << idOf(x, y), idOf(x + 1, y), idOf(x + 1, y + 1), idOf(x, y + 1);
    }
  }
  const Loop loop = outline();
  const Index n = static_cast<Index>(loop.size());
  Points rings((Cells + 1) * n, 3);
  box.filled.resize((Cells + 1) * layer.rows(), 3);
  for (Index k = 0; k <= Cells; ++k)
  {
    const Eigen::RowVector3d up(0.0, 0.0, static_cast<double>(k));
    box.filled.middleRows(k * layer.rows(), layer.rows()) = layer.rowwise() + up;
    for (Index j = 0; j < n; ++j)
    {
      rings.row(k * n + j) = layer.row(loop[static_cast<std::size_t>(j)]) + up;
    }
  }
  box.badNode = BadLayer * layer.rows() + loop[BadRow];
  rings.row(BadLayer * n + BadRow) += bad;
  box.filled.row(box.badNode) += bad;
  box.cage.source = layer;
  box.cage.target = layer.rowwise() + Eigen::RowVector3d(0.0, 0.0, static_cast<double>(Cells));
  box.cage.boundary = hexsweep::gatherSweepBoundary(
    box.cage.source, box.cage.target, hexsweep::stackRings(rings, { loop }, Cells));
  return box;
}

double leastOf(const Box& box, const Points& points)
{
  double least = 1.0;
  for (const hexsweep::HexQuality& quality :
    hexsweep::hexQualities(points, hexsweep::sweptHexes(box.cage.quads, points, Cells)))
  {
    least = std::min(least, quality.scaledJacobian);
  }
  return least;
}

/// The sides of the box: coordinates that are at an end at the source stay there.
hexsweep::NearestOnSide sidesOf(const Box& box)
{
  return [&box](Index row, const Eigen::RowVector3d& place) {
    const Eigen::RowVector3d begin = box.cage.boundary.rings.front().row(row);
    Eigen::RowVector3d near = place;
    for (Index c = 0; c < 2; ++c)
    {
      if (begin[c] == 0.0 || begin[c] == static_cast<double>(Cells))
      {
        near[c] = begin[c];
      }
    }
    return near;
  };
}

const Eigen::RowVector3d Bad(0.85, 0.0, 0.75);

TEST(SideSlides, ABadNodeOfASideComesBack)
{
  const Box box = boxWith(Bad);
  const std::vector<bool> none(box.cage.boundary.nodes.size(), false);
  const double before = leastOf(box, box.filled);
  ASSERT_LT(before, 0.2);
  const hexsweep::SlidSides slid =
    hexsweep::slideSides(box.cage, box.filled, none, sidesOf(box), 0.5);
  EXPECT_GE(slid.least, 0.5);
  EXPECT_GE(leastOf(box, slid.points), 0.5);
  EXPECT_EQ(slid.points(box.badNode, 1), 0.0);
  const Index n = box.cage.source.rows();
  EXPECT_EQ(slid.points.topRows(n), box.filled.topRows(n));
  EXPECT_EQ(slid.points.bottomRows(n), box.filled.bottomRows(n));
}

TEST(SideSlides, ColumnsThatAreToStayDo)
{
  const Box box = boxWith(Bad);
  const std::vector<bool> all(box.cage.boundary.nodes.size(), true);
  const hexsweep::SlidSides slid =
    hexsweep::slideSides(box.cage, box.filled, all, sidesOf(box), 0.5);
  for (const Index node : box.cage.boundary.nodes)
  {
    for (Index k = 0; k <= Cells; ++k)
    {
      const Index id = k * box.cage.source.rows() + node;
      EXPECT_EQ(slid.points.row(id), box.filled.row(id));
    }
  }
  // What inner nodes alone can do is worse.
  EXPECT_LT(slid.least, 0.5);
}

TEST(SideSlides, GoodSidesAreLeftAlone)
{
  const Box box = boxWith(Eigen::RowVector3d::Zero());
  const std::vector<bool> none(box.cage.boundary.nodes.size(), false);
  const hexsweep::SlidSides slid =
    hexsweep::slideSides(box.cage, box.filled, none, sidesOf(box), 0.5);
  EXPECT_EQ(slid.least, 1.0);
  EXPECT_EQ(slid.points, box.filled);
}

TEST(SideSlides, CanBeAborted)
{
  const Box box = boxWith(Bad);
  const std::vector<bool> none(box.cage.boundary.nodes.size(), false);
  EXPECT_THROW(hexsweep::slideSides(box.cage, box.filled, none, sidesOf(box), 0.5, {},
                 [](double done) { return done < 0.3; }),
    hexsweep::Aborted);
}
}

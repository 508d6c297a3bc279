// SPDX-License-Identifier: BSD-3-Clause
// The cut is a shortest path; the jump across it is a closed form with the right periods.
#include "Core/DiskMaps/HoleCut.h"

#include "Support/CapMeshes.h"

#include <numeric>
#include <set>

namespace TestHoleCut
{
using hexsweep::Corners;
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::TriangleMesh;
using Edge = std::pair<Index, Index>;

/// Difference of the jump function along each directed edge of each triangle, from all of them.
std::map<Edge, std::vector<int>> differences(const TriangleMesh& mesh, const Corners& left)
{
  std::map<Edge, std::vector<int>> result;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const Index d = (c + 1) % 3;
      const int step = static_cast<int>(left(t, d)) - static_cast<int>(left(t, c));
      result[{ mesh.triangles(t, c), mesh.triangles(t, d) }].push_back(step);
      result[{ mesh.triangles(t, d), mesh.triangles(t, c) }].push_back(-step);
    }
  }
  return result;
}

int period(const std::map<Edge, std::vector<int>>& form, const Loop& loop)
{
  int sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    sum += form.at({ loop[i], loop[(i + 1) % loop.size()] })[0];
  }
  return sum;
}

/// Edges between the loops by as many rounds of relaxation as there are points.
Index leastNumberOfEdges(
  const std::map<Edge, std::vector<int>>& edges, const Loop& from, const Loop& to)
{
  std::map<Index, Index> distance;
  for (const Index v : from)
  {
    distance[v] = 0;
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const auto& entry : edges)
    {
      const auto [a, b] = entry.first;
      const auto known = distance.find(a);
      if (known != distance.end() && (distance.count(b) == 0 || distance[b] > known->second + 1))
      {
        distance[b] = known->second + 1;
        changed = true;
      }
    }
  }
  Index least = static_cast<Index>(edges.size());
  for (const Index v : to)
  {
    least = std::min(least, distance.at(v));
  }
  return least;
}

void check(
  const TriangleMesh& mesh, const std::vector<Loop>& loops, std::size_t from, std::size_t to)
{
  const std::vector<Index> cut =
    hexsweep::shortestCut(mesh.triangles, mesh.points.rows(), loops[from], loops[to]);
  const Corners left = hexsweep::leftOfCut(mesh.triangles, cut);
  const auto form = differences(mesh, left);

  ASSERT_GE(cut.size(), 2u);
  EXPECT_EQ(static_cast<Index>(cut.size()) - 1, leastNumberOfEdges(form, loops[from], loops[to]));
  EXPECT_EQ(std::set<Index>(cut.begin(), cut.end()).size(), cut.size());
  for (std::size_t k = 0; k < cut.size(); ++k)
  {
    EXPECT_EQ(std::count(loops[from].begin(), loops[from].end(), cut[k]), k == 0 ? 1 : 0);
    EXPECT_EQ(std::count(loops[to].begin(), loops[to].end(), cut[k]), k + 1 == cut.size() ? 1 : 0);
    for (std::size_t l = 0; l < k; ++l)
    {
      EXPECT_EQ(form.count({ cut[l], cut[k] }), l + 1 == k ? 1u : 0u) << "no edge, or a shortcut";
    }
  }

  const std::set<Index> onCut(cut.begin(), cut.end());
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      EXPECT_TRUE(!left(t, c) || onCut.count(mesh.triangles(t, c)) == 1);
    }
  }
  // Both triangles at an edge see the same difference; over a triangle they sum to zero.
  for (const auto& [edge, steps] : form)
  {
    EXPECT_EQ(steps.front(), steps.back()) << edge.first << ", " << edge.second;
  }
  for (std::size_t p = 0; p < loops.size(); ++p)
  {
    EXPECT_EQ(period(form, loops[p]), p == to ? -1 : p == from ? 1 : 0) << "loop " << p;
  }
  // Left of the cut: the triangle on the left of its first edge is flagged, the right one is not.
  const auto flagged = [&](Index a, Index b) {
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      for (Index c = 0; c < 3; ++c)
      {
        if (mesh.triangles(t, c) == a && mesh.triangles(t, (c + 1) % 3) == b)
        {
          return left(t, c) && left(t, (c + 1) % 3);
        }
      }
    }
    return false;
  };
  EXPECT_TRUE(flagged(cut[0], cut[1]));
  EXPECT_FALSE(flagged(cut[1], cut[0]));
}

TEST(HoleCut, AnnuliOfSeveralTriangulations)
{
  std::mt19937 generator(1);
  for (const auto& [rings, around] :
    std::vector<std::pair<Index, Index>>{ { 2, 3 }, { 2, 7 }, { 3, 4 }, { 6, 12 }, { 9, 30 } })
  {
    for (std::mt19937* chance : { static_cast<std::mt19937*>(nullptr), &generator, &generator })
    {
      const TriangleMesh mesh = test::annulus(0.4, 1.0, rings, around, chance);
      const auto loops = test::loopsOf(mesh);
      check(mesh, loops, 1, 0);
      check(mesh, loops, 0, 1);
    }
  }
}

TEST(HoleCut, CapsWithManyHolesAndAnyNumbering)
{
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    TriangleMesh mesh = test::plate(12, test::threeHoles(), 0.3, seed);
    std::vector<Index> rank(static_cast<std::size_t>(mesh.points.rows()));
    std::iota(rank.begin(), rank.end(), Index(0));
    std::shuffle(rank.begin(), rank.end(), std::mt19937(seed));
    const hexsweep::Points old = mesh.points;
    for (Index i = 0; i < old.rows(); ++i)
    {
      mesh.points.row(rank[static_cast<std::size_t>(i)]) = old.row(i);
    }
    mesh.triangles =
      mesh.triangles.unaryExpr([&](Index i) { return rank[static_cast<std::size_t>(i)]; }).eval();
    const auto loops = test::loopsOf(mesh);
    for (std::size_t from = 0; from < loops.size(); ++from)
    {
      for (std::size_t to = 0; to < loops.size(); ++to)
      {
        if (from != to)
        {
          check(mesh, loops, from, to);
        }
      }
    }
  }
}

TEST(HoleCut, TheLowestIdsAmongEquals)
{
  // Every spoke of this annulus is a shortest path.
  const TriangleMesh mesh = test::annulus(0.4, 1.0, 4, 9);
  const auto loops = test::loopsOf(mesh);
  EXPECT_EQ(hexsweep::shortestCut(mesh.triangles, mesh.points.rows(), loops[1], loops[0]),
    (std::vector<Index>{ 0, 9, 18, 27 }));
}

TEST(HoleCut, PiecesHaveNoCut)
{
  TriangleMesh mesh = test::annulus(0.4, 1.0, 3, 8);
  const Index n = mesh.points.rows();
  const Index m = mesh.triangles.rows();
  const auto loops = test::loopsOf(mesh);
  mesh.triangles.conservativeResize(2 * m, 3);
  mesh.triangles.bottomRows(m) = mesh.triangles.topRows(m).array() + n;
  Loop other = loops[0];
  for (Index& v : other)
  {
    v += n;
  }
  test::expectInvalid(
    [&] { hexsweep::shortestCut(mesh.triangles, 2 * n, loops[1], other); }, "the cap is in pieces");
}
}

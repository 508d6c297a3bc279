// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/TrianglePairing.h"

#include "Support/CapMeshes.h"

namespace TestTrianglePairing
{
using test::Index;

test::Points upward(const test::TriangleMesh& mesh)
{
  test::Points normals = test::Points::Zero(mesh.points.rows(), 3);
  normals.col(2).setOnes();
  return normals;
}

/// Sets of edges, so that those of the quads can be looked for among those of the triangles.
template <typename Faces>
std::set<std::pair<Index, Index>> edgesOf(const Faces& faces)
{
  std::set<std::pair<Index, Index>> edges;
  for (Index f = 0; f < faces.rows(); ++f)
  {
    for (Index c = 0; c < faces.cols(); ++c)
    {
      edges.insert(std::minmax<Index>(faces(f, c), faces(f, (c + 1) % faces.cols())));
    }
  }
  return edges;
}

double quadArea(const test::Points& points, const test::Quads& quads)
{
  double area = 0.0;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    const Eigen::RowVector3d a = points.row(quads(q, 2)) - points.row(quads(q, 0));
    const Eigen::RowVector3d b = points.row(quads(q, 3)) - points.row(quads(q, 1));
    area += 0.5 * a.cross(b).z();
  }
  return area;
}

TEST(TrianglePairing, HalvedSquaresComeBack)
{
  const hexsweep::QuadMesh squares = test::quadPlate(12, test::threeHoles());
  const test::TriangleMesh halves = test::plate(12, test::threeHoles());
  const auto paired = hexsweep::pairTriangles(halves, upward(halves), {});
  EXPECT_EQ(paired.triangles.rows(), 0);
  EXPECT_EQ(paired.quads.rows(), squares.quads.rows());
  EXPECT_EQ(edgesOf(paired.quads), edgesOf(squares.quads));
}

TEST(TrianglePairing, EveryTriangleIsUsedOnceAndTheAreaKept)
{
  const test::TriangleMesh mesh = test::plate(12, test::threeHoles(), 0.3);
  const auto paired = hexsweep::pairTriangles(mesh, upward(mesh), {});
  EXPECT_EQ(2 * paired.quads.rows() + paired.triangles.rows(), mesh.triangles.rows());
  const double area =
    quadArea(mesh.points, paired.quads) + test::surfaceArea({ mesh.points, paired.triangles });
  EXPECT_NEAR(area, test::surfaceArea(mesh), 1e-12);
}

TEST(TrianglePairing, APathIsFollowedToTheLastPair)
{
  // A strip of four triangles whose best pair is the middle one: best first alone leaves two.
  test::TriangleMesh strip;
  strip.points.resize(6, 3);
  strip.points << -0.2, 1, 0, 0, 0, 0, 1, 1, 0, 1, 0, 0, 0, 1, 0, 1.2, 0, 0;
  strip.points.row(0) << -0.7, 0.3, 0;
  strip.points.row(5) << 1.7, 0.7, 0;
  strip.triangles.resize(4, 3);
  strip.triangles << 0, 1, 4, 1, 3, 4, 4, 3, 2, 3, 5, 2;
  const auto paired = hexsweep::pairTriangles(strip, upward(strip), {});
  EXPECT_EQ(paired.triangles.rows(), 0);
  EXPECT_EQ(paired.quads.rows(), 2);
  EXPECT_EQ(edgesOf(paired.quads).count({ 3, 4 }), 1u);
}

TEST(TrianglePairing, NoPairLiesAcrossAKeptEdge)
{
  test::TriangleMesh two;
  two.points.resize(4, 3);
  two.points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  two.triangles.resize(2, 3);
  two.triangles << 0, 1, 2, 0, 2, 3;
  EXPECT_EQ(hexsweep::pairTriangles(two, upward(two), {}).quads.rows(), 1);
  EXPECT_EQ(hexsweep::pairTriangles(two, upward(two), { { 2, 0 } }).quads.rows(), 0);
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/HalfEdgeTriangles.h"

#include "Support/CapMeshes.h"

namespace TestHalfEdgeTriangles
{
using hexsweep::HalfEdgeTriangles;
using test::Index;

/// The connectivity as one that is built anew from its triangles would have it.
void expectLikeNew(const HalfEdgeTriangles& mesh)
{
  const HalfEdgeTriangles fresh(mesh.triangles());
  ASSERT_EQ(mesh.numberOfHalfEdges(), fresh.numberOfHalfEdges());
  for (Index half = 0; half < mesh.numberOfHalfEdges(); ++half)
  {
    ASSERT_EQ(mesh.twin(half), fresh.twin(half)) << half;
  }
}

Index boundaryEdges(const HalfEdgeTriangles& mesh)
{
  Index count = 0;
  for (Index half = 0; half < mesh.numberOfHalfEdges(); ++half)
  {
    count += mesh.twin(half) < 0 ? 1 : 0;
  }
  return count;
}

/// Euler's characteristic of a mesh that uses all of its points.
Index euler(const HalfEdgeTriangles& mesh, Index points)
{
  const Index edges = (mesh.numberOfHalfEdges() + boundaryEdges(mesh)) / 2;
  return points - edges + mesh.numberOfTriangles();
}

TEST(HalfEdgeTriangles, TwinsRunTheOtherWay)
{
  const HalfEdgeTriangles mesh(test::plate(12, test::threeHoles()).triangles);
  Index boundary = 0;
  for (Index half = 0; half < mesh.numberOfHalfEdges(); ++half)
  {
    const Index twin = mesh.twin(half);
    EXPECT_EQ(mesh.next(mesh.previous(half)), half);
    if (twin >= 0)
    {
      EXPECT_EQ(mesh.twin(twin), half);
      EXPECT_EQ(mesh.from(twin), mesh.to(half));
      EXPECT_EQ(mesh.to(twin), mesh.from(half));
    }
    boundary += twin < 0 ? 1 : 0;
  }
  // 4 x 12 outside; 2 (2 + 2), 2 (3 + 2), 2 (2 + 3) round the holes.
  EXPECT_EQ(boundary, 48 + 8 + 10 + 10);
}

TEST(HalfEdgeTriangles, AFlipChangesTheDiagonal)
{
  test::Triangles two(2, 3);
  two << 0, 1, 2, 1, 0, 3;
  HalfEdgeTriangles mesh(two);
  mesh.flip(0);
  test::Triangles flipped(2, 3);
  flipped << 2, 0, 3, 3, 1, 2;
  EXPECT_EQ(mesh.triangles(), flipped);
  expectLikeNew(mesh);
}

TEST(HalfEdgeTriangles, SplitsKeepTheTopology)
{
  const test::TriangleMesh plate = test::plate(12, test::threeHoles());
  HalfEdgeTriangles mesh(plate.triangles);
  Index points = plate.points.rows();
  Index boundary = boundaryEdges(mesh);
  ASSERT_EQ(euler(mesh, points), 1 - 3); // a disk with three holes
  std::mt19937 generator(5);
  for (int step = 0; step < 200; ++step)
  {
    const Index half = static_cast<Index>(generator()) % mesh.numberOfHalfEdges();
    const Index triangles = mesh.numberOfTriangles();
    if (step % 2 == 0)
    {
      const bool outside = mesh.twin(half) < 0;
      mesh.splitEdge(half, points++);
      boundary += outside ? 1 : 0;
      EXPECT_EQ(mesh.numberOfTriangles(), triangles + (outside ? 1 : 2));
    }
    else
    {
      mesh.splitTriangle(half / 3, points++);
      EXPECT_EQ(mesh.numberOfTriangles(), triangles + 2);
    }
    ASSERT_EQ(boundaryEdges(mesh), boundary);
    ASSERT_EQ(euler(mesh, points), 1 - 3);
  }
  expectLikeNew(mesh);
}
}

// SPDX-License-Identifier: BSD-3-Clause
// Size, place and flatness of faces against closed forms.
#include "Core/Solids/FaceMeasures.h"

#include "Support/SolidShapes.h"

namespace TestFaceMeasures
{
using hexsweep::FaceMeasure;
using hexsweep::Index;
using hexsweep::makeSolidSurface;
using hexsweep::measureFaces;

TEST(FaceMeasures, OfABox)
{
  const auto faces = measureFaces(makeSolidSurface(test::box(2, 3, 4)));
  const double areas[6] = { 12, 12, 8, 8, 6, 6 };
  const Eigen::RowVector3d middle(1, 1.5, 2);
  std::vector<Index> ids;
  ASSERT_EQ(faces.size(), 6u);
  for (const FaceMeasure& face : faces)
  {
    const Index direction = face.id % 10;
    const Index axis = (direction - 1) / 2;
    Eigen::RowVector3d center = middle;
    center[axis] = direction % 2 == 0 ? 2 * middle[axis] : 0.0;
    EXPECT_NEAR(face.area, areas[direction - 1], 1e-14 * 12) << face.id;
    EXPECT_LT((face.center - center).norm(), 1e-14 * 4) << face.id;
    EXPECT_NEAR(face.flatness, 1.0, 1e-14) << face.id;
    EXPECT_EQ(face.triangles, static_cast<Index>(2 * areas[direction - 1])) << face.id;
    ids.push_back(face.id);
  }
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
}

TEST(FaceMeasures, OfFacesThatBendAndClose)
{
  // Two faces: the floor, and all the rest of the cube, whose area vectors sum to the floor's.
  test::SolidInput cube = test::box(1, 1, 1);
  for (Index& id : cube.faceIds)
  {
    id = id == 5 ? 1 : 2;
  }
  const auto faces = measureFaces(makeSolidSurface(cube));
  ASSERT_EQ(faces.size(), 2u);
  EXPECT_NEAR(faces[0].flatness, 1.0, 1e-14);
  EXPECT_NEAR(faces[1].area, 5.0, 1e-14 * 5);
  EXPECT_NEAR(faces[1].flatness, 1.0 / 5.0, 1e-14);
  EXPECT_LT((faces[1].center - Eigen::RowVector3d(0.5, 0.5, 0.6)).norm(), 1e-14);
}
}

// SPDX-License-Identifier: BSD-3-Clause
// The same solid in other guises: turned over, numbered in another way, reflected.
#include "BlockSolids.h"
#include "CapGrids.h"

#include <vtkIdTypeArray.h>

#include <algorithm>
#include <numeric>

namespace TestMirrorImages
{
using test::Grid;
using test::SolidSweep;

/// Points and cells numbered as chance has it; cell data go along.
Grid renumbered(vtkUnstructuredGrid* grid, unsigned seed)
{
  std::mt19937 random(seed);
  const auto shuffled = [&](vtkIdType n) {
    std::vector<vtkIdType> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), vtkIdType{ 0 });
    std::shuffle(order.begin(), order.end(), random);
    return order;
  };
  const std::vector<vtkIdType> points = shuffled(grid->GetNumberOfPoints());
  const std::vector<vtkIdType> cells = shuffled(grid->GetNumberOfCells());
  Grid result = Grid::New();
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  std::vector<vtkIdType> newId(points.size());
  for (const vtkIdType p : points)
  {
    newId[static_cast<std::size_t>(p)] = places->InsertNextPoint(grid->GetPoint(p));
  }
  result->SetPoints(places);
  result->GetCellData()->CopyAllocate(grid->GetCellData());
  vtkNew<vtkIdList> corners;
  for (const vtkIdType c : cells)
  {
    grid->GetCellPoints(c, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      corners->SetId(i, newId[static_cast<std::size_t>(corners->GetId(i))]);
    }
    const vtkIdType cell = result->InsertNextCell(grid->GetCellType(c), corners);
    result->GetCellData()->CopyData(grid->GetCellData(), c, cell);
  }
  return result;
}

using Signs = std::array<double, 3>;

Grid mirrored(vtkUnstructuredGrid* grid, const Signs& signs)
{
  return test::changedPoints(grid, [&](vtkIdType, std::array<double, 3>& p) {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      p[axis] *= signs[axis];
    }
  });
}

/// The mesh is that of another solid, reflected: bit for bit, and with the same numbers.
void expectMirrored(SolidSweep& first, SolidSweep& second, const Signs& signs)
{
  first.filter->Update();
  second.filter->Update();
  vtkUnstructuredGrid* a = first.hexes();
  vtkUnstructuredGrid* b = second.hexes();
  ASSERT_GT(a->GetNumberOfCells(), 0) << first.messages();
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints()) << second.messages();
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  vtkIdType different = 0;
  for (vtkIdType p = 0; p < a->GetNumberOfPoints(); ++p)
  {
    test::Point image = test::pointOf(a, p);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      image[axis] *= signs[axis];
    }
    different += image == test::pointOf(b, p) ? 0 : 1;
  }
  EXPECT_EQ(different, 0);
  EXPECT_EQ(test::report(b, hexsweep::reports::NotCertified), 0.0);
  for (vtkIdType h = 0; h < a->GetNumberOfCells(); ++h)
  {
    test::Corners corners = test::cornersOf(a, h);
    test::Corners others = test::cornersOf(b, h);
    std::sort(corners.begin(), corners.end());
    std::sort(others.begin(), others.end());
    ASSERT_EQ(corners, others) << h;
  }
  vtkUnstructuredGrid* boundary = second.boundary();
  EXPECT_NEAR(test::enclosedVolume(boundary), test::enclosedVolume(first.boundary()),
    1e-12 * test::enclosedVolume(boundary));
  EXPECT_EQ(test::areasById(first.boundary(), hexsweep::arrays::BoundaryId).size(),
    test::areasById(boundary, hexsweep::arrays::BoundaryId).size());
}

/// Each boundary quad is the side of its hexahedron that HexSide says, outward.
void expectRightSides(SolidSweep& sweep)
{
  constexpr int Sides[6][4] = { { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 },
    { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
  vtkUnstructuredGrid* boundary = sweep.boundary();
  for (vtkIdType q = 0; q < boundary->GetNumberOfCells(); ++q)
  {
    const auto value = [&](const char* name) {
      return static_cast<vtkIdType>(boundary->GetCellData()->GetArray(name)->GetTuple1(q));
    };
    const test::Corners hex = test::cornersOf(sweep.hexes(), value(hexsweep::arrays::HexId));
    const auto* side = Sides[value(hexsweep::arrays::HexSide) - 1];
    test::Corners expected;
    test::Corners found;
    for (int c = 0; c < 4; ++c)
    {
      expected.push_back(hex[static_cast<std::size_t>(side[c])]);
    }
    for (const vtkIdType p : test::cornersOf(boundary, q))
    {
      found.push_back(static_cast<vtkIdType>(
        boundary->GetPointData()->GetArray(hexsweep::arrays::HexPointIds)->GetTuple1(p)));
    }
    std::rotate(found.begin(), std::find(found.begin(), found.end(), expected[0]), found.end());
    ASSERT_EQ(found, expected) << q;
  }
}

class MirrorImages : public testing::TestWithParam<const char*>
{
};

TEST_P(MirrorImages, GiveTheMirrorImageOfTheMesh)
{
  const Grid solid = test::solidGrid(GetParam());
  for (const Signs& signs : { Signs{ -1.0, 1.0, 1.0 }, Signs{ 1.0, -1.0, -1.0 } })
  {
    SolidSweep given(solid);
    SolidSweep image(mirrored(solid, signs));
    expectMirrored(given, image, signs);
    expectRightSides(given);
    expectRightSides(image);
  }
}

TEST_P(MirrorImages, ASolidThatIsTurnedOverOrRenumberedGivesTheSameMesh)
{
  const Grid solid = test::solidGrid(GetParam());
  SolidSweep given(solid);
  SolidSweep turned(test::turnedOver(solid.GetPointer()));
  expectMirrored(given, turned, { 1.0, 1.0, 1.0 });
  SolidSweep other(renumbered(solid, 5));
  expectMirrored(given, other, { 1.0, 1.0, 1.0 });
}

INSTANTIATE_TEST_SUITE_P(Solids, MirrorImages, testing::Values("bracket", "elbow"));

TEST(MirrorImages, MessagesNameThePlacesOfTheUser)
{
  // A block whose far corner is missing a triangle.
  const test::SolidBlock block = test::blockOf({ 3, 3, 3 }, [](double x, double y, double z) {
    return test::Point{ 2.0 * x * x, y + 5.0, -z * z };
  });
  Grid solid = test::blockFaces(block, test::allFaces());
  Grid open = Grid::New();
  open->SetPoints(solid->GetPoints());
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 1; c < solid->GetNumberOfCells(); ++c)
  {
    solid->GetCellPoints(c, corners);
    open->InsertNextCell(solid->GetCellType(c), corners);
  }
  for (const Signs& signs : { Signs{ 1.0, 1.0, 1.0 }, Signs{ -1.0, 1.0, -1.0 } })
  {
    SolidSweep sweep(mirrored(open, signs));
    sweep.filter->Update();
    ASSERT_EQ(sweep.events.errors.size(), 1u);
    const std::string& text = sweep.events.errors.front();
    double place[3];
    const std::size_t at = text.find("at (");
    ASSERT_NE(at, std::string::npos) << text;
    ASSERT_EQ(
      std::sscanf(text.c_str() + at, "at (%lf, %lf, %lf)", &place[0], &place[1], &place[2]), 3)
      << text;
    // The middle of an edge of the triangle that is missing, as it lies in the file.
    double nearest = 1.0;
    solid->GetCellPoints(0, corners);
    for (vtkIdType i = 0; i < 3; ++i)
    {
      double middle = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double a = solid->GetPoint(corners->GetId(i))[axis];
        const double b = solid->GetPoint(corners->GetId((i + 1) % 3))[axis];
        const double d = 0.5 * (a + b) * signs[static_cast<std::size_t>(axis)] - place[axis];
        middle += d * d;
      }
      nearest = std::min(nearest, middle);
    }
    EXPECT_LT(nearest, 1e-12) << text;
  }
}
}

// SPDX-License-Identifier: BSD-3-Clause
// Solids from every kind of data set.
#include "HexSweepSolidReader.h"

#include "CapGrids.h"
#include "Support/SolidShapes.h"

#include "Core/Solids/FaceQuads.h"
#include "Core/Solids/SolidInput.h"
#include "Core/Solids/TargetFaces.h"
#include "HexSweepArrays.h"

#include <vtkAppendFilter.h>
#include <vtkCleanPolyData.h>
#include <vtkCubeSource.h>
#include <vtkCylinderSource.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDataSetTriangleFilter.h>
#include <vtkIntArray.h>
#include <vtkLongLongArray.h>
#include <vtkMath.h>
#include <vtkStripper.h>
#include <vtkTriangleFilter.h>

namespace TestSolidReader
{
using hexsweep::findSweepTopology;
using hexsweep::Index;
using hexsweep::makeSolidSurface;
using hexsweep::readSolid;
using hexsweep::SolidData;
using hexsweep::SolidSurface;
using hexsweep::SweepTopology;
using test::expectInvalid;
using test::Grid;
using test::volumeOf;
using Ids = std::vector<Index>;

/// A box of x * y * z hexahedra of edge 1.
Grid hexBox(int x, int y, int z)
{
  Grid grid = Grid::New();
  vtkNew<vtkPoints> points;
  for (int k = 0; k <= z; ++k)
  {
    for (int j = 0; j <= y; ++j)
    {
      for (int i = 0; i <= x; ++i)
      {
        points->InsertNextPoint(i, j, k);
      }
    }
  }
  grid->SetPoints(points);
  grid->Allocate();
  const auto id = [&](int i, int j, int k) -> vtkIdType { return (k * (y + 1) + j) * (x + 1) + i; };
  for (int k = 0; k < z; ++k)
  {
    for (int j = 0; j < y; ++j)
    {
      for (int i = 0; i < x; ++i)
      {
        const vtkIdType ids[8] = { id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k),
          id(i, j + 1, k), id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1),
          id(i, j + 1, k + 1) };
        grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
      }
    }
  }
  return grid;
}

void addIds(vtkDataSet* data, const char* name, const std::vector<int>& values)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  for (const int value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetCellData()->AddArray(array);
}

/// A mesh as gmsh writes it: vertices, lines, triangles and tetrahedra with CellEntityIds. Leaves
/// out `missing` triangles.
Grid gmshBox(int missing = 0)
{
  vtkNew<vtkDataSetTriangleFilter> tetrahedra;
  tetrahedra->SetInputData(hexBox(3, 2, 2));
  tetrahedra->Update();
  vtkUnstructuredGrid* volume = tetrahedra->GetOutput();
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(volume);
  surface->PassThroughPointIdsOn();
  surface->Update();
  vtkPolyData* boundary = surface->GetOutput();
  vtkDataArray* pointIds = boundary->GetPointData()->GetArray("vtkOriginalPointIds");
  Grid grid = Grid::New();
  grid->SetPoints(volume->GetPoints());
  grid->Allocate();
  std::vector<int> ids;
  const vtkIdType two[2] = { 0, 1 };
  grid->InsertNextCell(VTK_VERTEX, 1, two);
  grid->InsertNextCell(VTK_LINE, 2, two);
  ids.assign(2, 1);
  vtkNew<vtkIdList> points;
  for (vtkIdType c = missing; c < boundary->GetNumberOfCells(); ++c)
  {
    boundary->GetCellPoints(c, points);
    double bounds[6];
    boundary->GetCellBounds(c, bounds);
    for (vtkIdType i = 0; i < 3; ++i)
    {
      points->SetId(i, static_cast<vtkIdType>(pointIds->GetTuple1(points->GetId(i))));
    }
    grid->InsertNextCell(VTK_TRIANGLE, points);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (bounds[2 * axis] == bounds[2 * axis + 1])
      {
        ids.push_back(10 * static_cast<int>(bounds[2 * axis]) + 1 + axis);
      }
    }
  }
  for (vtkIdType c = 0; c < volume->GetNumberOfCells(); ++c)
  {
    volume->GetCellPoints(c, points);
    grid->InsertNextCell(VTK_TETRA, points);
    ids.push_back(1);
  }
  addIds(grid, hexsweep::arrays::CellEntityIds, ids);
  return grid;
}

TEST(SolidReader, PolygonsQuadsAndStrips)
{
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(12);
  cylinder->SetRadius(1.0);
  cylinder->SetHeight(2.0);
  cylinder->Update();
  const SolidData data = readSolid(cylinder->GetOutput());
  EXPECT_EQ(data.surface.quads.rows(), 12);
  EXPECT_TRUE(data.surface.faceIds.empty());
  EXPECT_EQ(data.faceIdArray, "");
  const SolidSurface solid = makeSolidSurface(data.surface);
  // Source and output of VTK are single precision.
  EXPECT_NEAR(volumeOf(solid), 12.0 * std::sin(hexsweep::Pi / 6.0), 1e-5);
  EXPECT_EQ(findSweepTopology(solid, { solid.faceIds.back() }).sides.size(), 1u);

  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(triangles->GetOutputPort());
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(clean->GetOutputPort());
  strips->Update();
  ASSERT_GT(strips->GetOutput()->GetNumberOfStrips(), 0);
  EXPECT_NEAR(volumeOf(makeSolidSurface(readSolid(strips->GetOutput()).surface)), 1.0, 1e-12);
}

TEST(SolidReader, QuadsOfAFace)
{
  // A cube with a point of its own at every corner of every face, and its ids.
  vtkNew<vtkCubeSource> source;
  source->SetXLength(2.0);
  source->Update();
  vtkPolyData* cube = source->GetOutput();
  addIds(cube, hexsweep::arrays::FaceId, { 1, 2, 3, 4, 5, 6 });
  // One face turned over.
  vtkNew<vtkIdList> corners;
  cube->GetCellPoints(5, corners);
  const vtkIdType turned[4] = { corners->GetId(3), corners->GetId(2), corners->GetId(1),
    corners->GetId(0) };
  cube->GetPolys()->ReplaceCellAtId(5, 4, turned);

  const SolidData data = readSolid(cube);
  const SolidSurface solid = makeSolidSurface(data.surface);
  EXPECT_EQ(solid.mergedPoints, 16);
  EXPECT_EQ(solid.turnedTriangles, 2);
  for (const Ids& faces : { Ids{ 6 }, Ids{ 1, 6 }, Ids{ 1, 2, 3, 4, 5, 6 } })
  {
    const auto quads = hexsweep::quadsOfFaces(data.surface, solid, faces);
    ASSERT_TRUE(quads);
    EXPECT_EQ(quads->mesh.quads.rows(), static_cast<Index>(faces.size()));
    EXPECT_EQ(quads->mesh.points.rows(), faces.size() == 1 ? 4 : faces.size() == 2 ? 6 : 8);
    for (std::size_t p = 0; p < quads->pointIds.size(); ++p)
    {
      Eigen::RowVector3d place;
      cube->GetPoint(quads->pointIds[p], place.data());
      EXPECT_EQ(place, quads->mesh.points.row(static_cast<Index>(p)));
    }
    for (Index q = 0; q < quads->mesh.quads.rows(); ++q)
    {
      EXPECT_EQ(
        quads->cellIds[static_cast<std::size_t>(q)], faces[static_cast<std::size_t>(q)] - 1);
      Eigen::Matrix<double, 4, 3> place;
      for (int c = 0; c < 4; ++c)
      {
        place.row(c) = quads->mesh.points.row(quads->mesh.quads(q, c));
      }
      // A rectangle, seen from outside: the normal leads away from the middle of the cube.
      EXPECT_EQ(place.row(0) + place.row(2), place.row(1) + place.row(3));
      const Eigen::RowVector3d normal = Eigen::RowVector3d(place.row(1) - place.row(0))
                                          .cross(Eigen::RowVector3d(place.row(2) - place.row(0)));
      EXPECT_GT(normal.dot(place.colwise().mean()), 0.1);
    }
    EXPECT_NO_THROW(
      hexsweep::checkSurface(quads->mesh.quads, quads->mesh.points.rows(), "quads of the faces"));
  }

  // A triangle among the cells of a face.
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(cube);
  triangles->Update();
  const SolidData other = readSolid(triangles->GetOutput());
  EXPECT_FALSE(hexsweep::quadsOfFaces(other.surface, makeSolidSurface(other.surface), { 6 }));
}

TEST(SolidReader, SurfaceCellsBesideVolumesKeepTheirIds)
{
  const Grid grid = gmshBox();
  const SolidData data = readSolid(grid);
  EXPECT_FALSE(data.fromVolume);
  EXPECT_EQ(data.faceIdArray, hexsweep::arrays::CellEntityIds);
  EXPECT_EQ(data.ignoredCells, 2);
  EXPECT_EQ(data.surface.points.rows(), grid->GetNumberOfPoints());
  const SolidSurface solid = makeSolidSurface(data.surface);
  EXPECT_NEAR(volumeOf(solid), 12.0, 1e-12);
  const SweepTopology topology = findSweepTopology(solid, { 3 });
  EXPECT_EQ(topology.targetFaceIds, Ids{ 23 });
  EXPECT_EQ(topology.sides[0].faceIds, (Ids{ 1, 2, 22, 31 }));
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const Index cell = solid.cellIds[static_cast<std::size_t>(t)];
    EXPECT_EQ(grid->GetCellType(cell), VTK_TRIANGLE);
  }
}

TEST(SolidReader, SurfaceCellsBetweenVolumesAreLeftOut)
{
  // A wall across the box, as between two regions of a mesh.
  const Grid grid = hexBox(4, 2, 2);
  Grid mesh = Grid::New();
  mesh->SetPoints(grid->GetPoints());
  mesh->Allocate();
  std::vector<int> ids;
  const auto add = [&](const std::vector<vtkIdType>& corners, int id) {
    mesh->InsertNextCell(VTK_QUAD, 4, corners.data());
    ids.push_back(id);
  };
  const auto point = [](int i, int j, int k) -> vtkIdType { return (k * 3 + j) * 5 + i; };
  for (int a = 0; a < 2; ++a)
  {
    for (int b = 0; b < 2; ++b)
    {
      for (const int i : { 0, 2, 4 })
      {
        add({ point(i, a, b), point(i, a + 1, b), point(i, a + 1, b + 1), point(i, a, b + 1) },
          10 + i);
      }
    }
    for (int i = 0; i < 4; ++i)
    {
      for (const int j : { 0, 2 })
      {
        add({ point(i, j, a), point(i + 1, j, a), point(i + 1, j, a + 1), point(i, j, a + 1) },
          20 + j);
        add({ point(i, a, j), point(i + 1, a, j), point(i + 1, a + 1, j), point(i, a + 1, j) },
          30 + j);
      }
    }
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCellPoints(c, corners);
    mesh->InsertNextCell(VTK_HEXAHEDRON, corners);
    ids.push_back(99);
  }
  addIds(mesh, hexsweep::arrays::CellEntityIds, ids);

  const SolidData data = readSolid(mesh);
  EXPECT_FALSE(data.fromVolume);
  EXPECT_EQ(data.ignoredSurfaces, 4);
  EXPECT_EQ(data.surface.quads.rows(), 40);
  const SolidSurface solid = makeSolidSurface(data.surface);
  EXPECT_NEAR(volumeOf(solid), 16.0, 1e-12);
  const SweepTopology topology = findSweepTopology(solid, { 10 });
  EXPECT_EQ(topology.targetFaceIds, Ids{ 14 });
  EXPECT_EQ(topology.sides[0].faceIds, (Ids{ 20, 22, 30, 32 }));
  const auto quads = hexsweep::quadsOfFaces(data.surface, solid, { 10 });
  ASSERT_TRUE(quads);
  EXPECT_EQ(quads->mesh.quads.rows(), 4);
}

TEST(SolidReader, AClosedSurfaceThatIsNotTheVolumesOwn)
{
  // Tetrahedra beside the coarse surface they were made from.
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(2.0);
  cube->SetYLength(2.0);
  cube->SetZLength(2.0);
  cube->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(triangles->GetOutputPort());
  clean->Update();
  addIds(clean->GetOutput(), hexsweep::arrays::FaceId, { 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6 });
  const Grid hexes = hexBox(2, 2, 2);
  addIds(hexes, hexsweep::arrays::FaceId, std::vector<int>(8, 7));
  vtkNew<vtkAppendFilter> both;
  both->AddInputData(clean->GetOutput());
  both->AddInputData(hexes);
  both->Update();
  const SolidData data = readSolid(both->GetOutput());
  EXPECT_FALSE(data.fromVolume);
  EXPECT_EQ(data.surface.triangles.rows(), 12);
  EXPECT_EQ(std::set<Index>(data.surface.faceIds.begin(), data.surface.faceIds.end()).size(), 6u);
}

TEST(SolidReader, VolumesGiveTheirBoundary)
{
  // The surface cells do not close: they are left alone.
  const SolidData open = readSolid(gmshBox(1));
  EXPECT_TRUE(open.fromVolume);
  EXPECT_TRUE(open.surface.faceIds.empty());
  EXPECT_GT(open.ignoredSurfaces, 10);
  EXPECT_NEAR(volumeOf(makeSolidSurface(open.surface)), 12.0, 1e-12);

  const Grid hexes = hexBox(3, 2, 2);
  const SolidData data = readSolid(hexes);
  EXPECT_TRUE(data.fromVolume);
  EXPECT_EQ(data.surface.quads.rows(), 2 * (6 + 6 + 4));
  const SolidSurface solid = makeSolidSurface(data.surface);
  EXPECT_NEAR(volumeOf(solid), 12.0, 1e-12);
  EXPECT_EQ(std::set<Index>(solid.faceIds.begin(), solid.faceIds.end()).size(), 6u);
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    // Points and cells of the mesh, not of its boundary.
    vtkNew<vtkIdList> corners;
    hexes->GetCellPoints(solid.cellIds[static_cast<std::size_t>(t)], corners);
    for (int c = 0; c < 3; ++c)
    {
      const Index p = solid.pointRows[static_cast<std::size_t>(solid.triangles(t, c))];
      EXPECT_GE(corners->IsId(p), 0);
    }
  }
  const auto quads = hexsweep::quadsOfFaces(data.surface, solid, { solid.faceIds[0] });
  ASSERT_TRUE(quads);
  EXPECT_GE(quads->mesh.quads.rows(), 4);
}

TEST(SolidReader, WhichArrayHasTheFaceIds)
{
  vtkNew<vtkCubeSource> source;
  source->Update();
  vtkPolyData* cube = source->GetOutput();
  addIds(cube, hexsweep::arrays::CellEntityIds, { 1, 2, 3, 4, 5, 6 });
  EXPECT_EQ(readSolid(cube).surface.faceIds.front(), 1);
  addIds(cube, hexsweep::arrays::FaceId, { 11, 12, 13, 14, 15, 16 });
  EXPECT_EQ(readSolid(cube).surface.faceIds.front(), 11);
  addIds(cube, "Other", { 21, 22, 23, 24, 25, 26 });
  EXPECT_EQ(readSolid(cube, "Other").surface.faceIds,
    (Ids{ 21, 21, 22, 22, 23, 23, 24, 24, 25, 25, 26, 26 }));
  EXPECT_EQ(readSolid(cube, "Other").faceIdArray, "Other");

  vtkNew<vtkDoubleArray> real;
  real->SetName("Real");
  vtkNew<vtkLongLongArray> large;
  large->SetName("Large");
  for (int i = 0; i < 6; ++i)
  {
    real->InsertNextValue(-3.0 + i);
    large->InsertNextValue((1LL << 60) + i);
  }
  cube->GetCellData()->AddArray(real);
  cube->GetCellData()->AddArray(large);
  EXPECT_EQ(readSolid(cube, "Real").surface.faceIds.front(), -3);
  EXPECT_EQ(readSolid(cube, "Large").surface.faceIds.back(), (1LL << 60) + 5);
  real->SetValue(4, 0.5);
  expectInvalid([&] { readSolid(cube, "Real"); }, "not whole: 0.5 in cell 4");
  real->SetValue(4, vtkMath::Nan());
  expectInvalid([&] { readSolid(cube, "Real"); }, "not whole: nan in cell 4");
}

TEST(SolidReader, ArraysThatAreNoFaceIds)
{
  vtkNew<vtkCubeSource> source;
  source->Update();
  vtkPolyData* cube = source->GetOutput();
  expectInvalid([&] { readSolid(cube, "Other"); }, "no cell array \"Other\"");
  expectInvalid([&] { readSolid(cube, "Other"); }, "it has no cell arrays");
  expectInvalid([&] { readSolid(cube, "Normals"); }, "are a point array");
  vtkNew<vtkStringArray> text;
  text->SetName("Text");
  text->SetNumberOfValues(6);
  cube->GetCellData()->AddArray(text);
  expectInvalid([&] { readSolid(cube, "Text"); }, "are no numbers");
  expectInvalid([&] { readSolid(cube, "Other"); }, "its cell arrays are: Text");
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(6);
  cube->GetCellData()->AddArray(vectors);
  expectInvalid([&] { readSolid(cube, "Vectors"); }, "have 3 components");
  addIds(cube, hexsweep::arrays::FaceId, { 1, 2, 3 });
  expectInvalid([&] { readSolid(cube); }, "have 3 entries for 6 cells");
  vtkNew<vtkIntArray> points;
  points->SetName(hexsweep::arrays::FaceId);
  points->SetNumberOfTuples(cube->GetNumberOfPoints());
  cube->GetCellData()->RemoveArray(hexsweep::arrays::FaceId);
  cube->GetPointData()->AddArray(points);
  expectInvalid([&] { readSolid(cube); }, "\"FaceId\" are a point array");
}

TEST(SolidReader, MissingOrEmpty)
{
  expectInvalid([] { readSolid(nullptr); }, "the solid is missing");
  expectInvalid([] { readSolid(vtkSmartPointer<vtkPolyData>::New()); }, "the solid is empty");
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  Grid lines = Grid::New();
  lines->SetPoints(points);
  const vtkIdType ids[2] = { 0, 1 };
  lines->InsertNextCell(VTK_LINE, 2, ids);
  expectInvalid([&] { readSolid(lines); }, "the solid is empty (no surface cells)");
}
}

// SPDX-License-Identifier: BSD-3-Clause
// From CAD solids to certified hexahedra in one filter.
#include "SolidGrids.h"

#include "HexSweepArrays.h"

#include <vtkIntArray.h>
#include <vtkMeshQuality.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPartitionedDataSetCollection.h>

namespace TestOneToOneSweep
{
using test::CadSolid;
using test::report;
using test::SolidSweep;

/// Nodes of each side of a hexahedron, zero-based, from the manual of Exodus II (sides 1 to 6).
constexpr int ExodusSides[6][4] = { { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 0, 4, 7, 3 },
  { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };

void expectCertified(vtkUnstructuredGrid* hexes)
{
  ASSERT_GT(hexes->GetNumberOfCells(), 0);
  vtkDataArray* validity = hexes->GetCellData()->GetArray(hexsweep::arrays::Validity);
  for (vtkIdType h = 0; h < hexes->GetNumberOfCells(); ++h)
  {
    EXPECT_EQ(validity->GetTuple1(h), 0.0) << h;
    EXPECT_GT(vtkMeshQuality::HexScaledJacobian(hexes->GetCell(h)), 0.0) << h;
  }
}

/**
 * All nodes of the boundary lie on the solid; those of the source quads count as given.
 *
 * The columns of a ruled sweep are straight lines, of which facets with nodes of their own are a
 * likeness only: there the caps lie on the solid, and what is between them on the lines.
 */
void expectOnSolid(vtkUnstructuredGrid* boundary, vtkUnstructuredGrid* solid)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(solid);
  locator->BuildLocator();
  const double size = test::sizeOf(solid);
  const auto onSolid = [&](const std::array<double, 3>& point) {
    double place[3];
    vtkIdType cell;
    int sub;
    double distance2;
    locator->FindClosestPoint(point.data(), place, cell, sub, distance2);
    return std::sqrt(distance2) < 1e-9 * size;
  };
  for (vtkIdType i = 0; i < boundary->GetNumberOfPoints(); ++i)
  {
    EXPECT_TRUE(onSolid(test::pointOf(boundary, i))) << i;
  }
}

void expectRuled(vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary,
  vtkUnstructuredGrid* solid, vtkIdType layers)
{
  const vtkIdType n = hexes->GetNumberOfPoints() / (layers + 1);
  vtkNew<vtkUnstructuredGrid> caps;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < boundary->GetNumberOfPoints(); ++i)
  {
    const auto id = static_cast<vtkIdType>(
      boundary->GetPointData()->GetArray(hexsweep::arrays::HexPointIds)->GetTuple1(i));
    if (id < n || id >= layers * n)
    {
      points->InsertNextPoint(boundary->GetPoint(i));
    }
  }
  caps->SetPoints(points);
  expectOnSolid(caps, solid);
  for (vtkIdType i = 0; i < hexes->GetNumberOfPoints(); ++i)
  {
    const std::array<double, 3> from = test::pointOf(hexes, i % n);
    const std::array<double, 3> to = test::pointOf(hexes, layers * n + i % n);
    const double along = static_cast<double>(i / n) / static_cast<double>(layers);
    std::array<double, 3> expected{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      expected[c] = (1.0 - along) * from[c] + along * to[c];
    }
    EXPECT_LT(test::distance(test::pointOf(hexes, i), expected), 1e-12 * test::sizeOf(solid)) << i;
  }
}

void expectNodesOf(SolidSweep& sweep, const test::CadSolid& cad, vtkUnstructuredGrid* solid)
{
  const bool isRuled = test::textReport(sweep.hexes(), hexsweep::reports::Method) == "Ruled";
  EXPECT_EQ(isRuled, std::string(cad.name) == "flange"); // the only prism among them
  if (isRuled)
  {
    expectRuled(sweep.hexes(), sweep.boundary(), solid, cad.layers);
  }
  else
  {
    expectOnSolid(sweep.boundary(), solid);
  }
}

/// The boundary quads are the outside of the hexahedra, each where it says it is.
void expectBoundaryOf(vtkUnstructuredGrid* boundary, vtkUnstructuredGrid* hexes)
{
  const std::map<vtkIdType, vtkIdType> unmatched = test::boundaryOf(boundary);
  EXPECT_TRUE(unmatched.empty()) << "the boundary is not closed";
  vtkDataArray* pointIds = boundary->GetPointData()->GetArray(hexsweep::arrays::HexPointIds);
  vtkDataArray* hexIds = boundary->GetCellData()->GetArray(hexsweep::arrays::HexId);
  vtkDataArray* sides = boundary->GetCellData()->GetArray(hexsweep::arrays::HexSide);
  std::set<std::pair<double, double>> seen;
  for (vtkIdType c = 0; c < boundary->GetNumberOfCells(); ++c)
  {
    seen.emplace(hexIds->GetTuple1(c), sides->GetTuple1(c));
    vtkCell* hex = hexes->GetCell(static_cast<vtkIdType>(hexIds->GetTuple1(c)));
    const int* corners = ExodusSides[static_cast<int>(sides->GetTuple1(c)) - 1];
    const test::Corners cell = test::cornersOf(boundary, c);
    std::array<vtkIdType, 4> expected;
    std::array<vtkIdType, 4> found;
    ASSERT_EQ(cell.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
    {
      expected[i] = hex->GetPointId(corners[i]);
      found[i] = static_cast<vtkIdType>(pointIds->GetTuple1(cell[i]));
    }
    // The same quad, the same way round (outward), from any corner.
    const auto start = std::find(found.begin(), found.end(), expected[0]);
    ASSERT_NE(start, found.end()) << c;
    std::rotate(found.begin(), start, found.end());
    EXPECT_EQ(found, expected) << c;
  }
  EXPECT_EQ(static_cast<vtkIdType>(seen.size()), boundary->GetNumberOfCells());
}

class CadSolids : public testing::TestWithParam<CadSolid>
{
};

TEST_P(CadSolids, GivenQuads)
{
  const CadSolid& solid = GetParam();
  const test::Grid surface = test::solidGrid(solid.name);
  const test::Grid quads = test::solidQuads(solid.name);
  SolidSweep sweep(surface, quads);
  sweep.name(solid.source, solid.target);
  sweep.filter->SetNumberOfLayers(solid.layers);
  sweep.filter->Update();
  EXPECT_EQ(sweep.messages(), "");
  vtkUnstructuredGrid* hexes = sweep.hexes();
  EXPECT_EQ(hexes->GetNumberOfCells(), quads->GetNumberOfCells() * solid.layers);
  EXPECT_EQ(hexes->GetNumberOfPoints(), quads->GetNumberOfPoints() * (solid.layers + 1));
  expectCertified(hexes);
  for (vtkIdType i = 0; i < quads->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(test::pointOf(hexes, i), test::pointOf(quads, i)) << i;
  }

  vtkUnstructuredGrid* boundary = sweep.boundary();
  EXPECT_EQ(
    boundary->GetNumberOfCells(), 2 * quads->GetNumberOfCells() + solid.loopNodes * solid.layers);
  expectNodesOf(sweep, solid, surface);
  expectBoundaryOf(boundary, hexes);
  EXPECT_EQ(report(hexes, hexsweep::reports::KeptEdges), static_cast<double>(solid.columnEdges));
  EXPECT_EQ(report(hexes, hexsweep::reports::LostEdges), 0.0);
  EXPECT_NEAR(test::enclosedVolume(boundary) / test::enclosedVolume(surface), 1.0, 0.02);

  // Every face of the solid is there, with about its area.
  const auto expected = test::areasById(surface, hexsweep::arrays::FaceId);
  const auto found = test::areasById(boundary, hexsweep::arrays::BoundaryId);
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [id, area] : expected)
  {
    ASSERT_EQ(found.count(id), 1u) << "face " << id;
    // Quads of a stacked or narrow face may lie across its border.
    EXPECT_NEAR(found.at(id) / area, 1.0, 0.12) << "face " << id;
  }
}

TEST_P(CadSolids, QuadsAreMade)
{
  const CadSolid& solid = GetParam();
  const test::Grid surface = test::solidGrid(solid.name);
  for (const bool swapped : { false, true })
  {
    SolidSweep sweep(surface);
    sweep.name(swapped ? solid.target : solid.source, {});
    sweep.filter->SetQuadSize(solid.quadSize);
    sweep.filter->SetNumberOfLayers(solid.layers);
    sweep.filter->Update();
    EXPECT_EQ(sweep.messages(), "") << swapped;
    expectCertified(sweep.hexes());
    expectNodesOf(sweep, solid, surface);
    expectBoundaryOf(sweep.boundary(), sweep.hexes());
    EXPECT_EQ(
      report(sweep.hexes(), hexsweep::reports::KeptEdges), static_cast<double>(solid.columnEdges));
    EXPECT_EQ(report(sweep.hexes(), hexsweep::reports::TargetFaceIds),
      static_cast<double>((swapped ? solid.source : solid.target).front()));
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, CadSolids, testing::ValuesIn(test::cadSolids()),
  [](const auto& solid) { return std::string(solid.param.name); });

TEST(OneToOneSweep, LayersAsAskedFor)
{
  const test::Grid surface = test::solidGrid("flange");
  const test::Grid quads = test::solidQuads("flange");
  const auto heights = [&](const std::function<void(vtkOneToOneSweep*)>& set) {
    SolidSweep sweep(surface, quads);
    sweep.name({ 3 }, { 2 });
    set(sweep.filter);
    sweep.filter->Update();
    std::set<double> reached; // of the first column, which is straight
    const vtkIdType n = quads->GetNumberOfPoints();
    for (vtkIdType i = 0; i < sweep.hexes()->GetNumberOfPoints(); i += n)
    {
      reached.insert(
        std::round(
          1e6 * test::distance(test::pointOf(sweep.hexes(), i), test::pointOf(sweep.hexes(), 0))) /
        1e6);
    }
    return std::vector<double>(reached.begin(), reached.end());
  };
  // About as high as the quads are wide.
  double area = 0.0;
  for (const auto& [id, part] : test::areasById(surface, "FaceId"))
  {
    area += id == 3 ? part : 0.0;
  }
  const double width = std::sqrt(area / static_cast<double>(quads->GetNumberOfCells()));
  EXPECT_EQ(
    static_cast<double>(heights([](vtkOneToOneSweep*) {}).size()), 1.0 + std::round(14.0 / width));
  EXPECT_EQ(heights([](vtkOneToOneSweep* f) { f->SetNumberOfLayers(10); }).size(), 11u);
  EXPECT_EQ(heights([](vtkOneToOneSweep* f) { f->SetLayerSize(2.0); }).size(), 8u); // 14 high
  const std::vector<double> placed = heights([](vtkOneToOneSweep* f) {
    f->AddLayerPosition(0.5);
    f->AddLayerPosition(0.75);
  });
  ASSERT_EQ(placed.size(), 4u);
  EXPECT_NEAR(placed[1] / placed[3], 0.5, 1e-3);
  EXPECT_NEAR(placed[2] / placed[3], 0.75, 1e-3);
  const std::vector<double> grown = heights([](vtkOneToOneSweep* f) {
    f->SetNumberOfLayers(4);
    f->SetGrowthRatio(2.0);
  });
  ASSERT_EQ(grown.size(), 5u);
  EXPECT_NEAR(grown[1] / grown[4], 1.0 / 15.0, 1e-3);
  const std::vector<double> both = heights([](vtkOneToOneSweep* f) {
    f->SetNumberOfLayers(4);
    f->SetGrowthRatio(2.0);
    f->GrowFromBothEndsOn();
  });
  ASSERT_EQ(both.size(), 5u);
  EXPECT_NEAR(both[1] / both[4], 1.0 / 6.0, 1e-3);
  EXPECT_NEAR(both[2] / both[4], 0.5, 1e-3);
}

TEST(OneToOneSweep, PointsRepeatedAlongEdgesAreMerged)
{
  const test::Grid surface = test::solidGrid("bracket");
  // As STL has it: each triangle with points of its own, in single precision.
  vtkNew<vtkUnstructuredGrid> soup;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetDataTypeToFloat();
  soup->SetPoints(points);
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    vtkIdType ids[3];
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = points->InsertNextPoint(surface->GetCell(c)->GetPoints()->GetPoint(i));
    }
    soup->InsertNextCell(VTK_TRIANGLE, 3, ids);
  }
  soup->GetCellData()->ShallowCopy(surface->GetCellData());
  SolidSweep sweep(soup);
  sweep.name({ 26 }, {});
  sweep.filter->SetNumberOfLayers(14);
  sweep.filter->Update();
  EXPECT_EQ(sweep.messages(), "");
  expectCertified(sweep.hexes());
  EXPECT_EQ(report(sweep.hexes(), hexsweep::reports::MergedPoints),
    static_cast<double>(soup->GetNumberOfPoints() - surface->GetNumberOfPoints()));
}

TEST(OneToOneSweep, DataAreCarried)
{
  const test::Grid surface = test::solidGrid("wing");
  const test::Grid quads = test::withData(test::solidQuads("wing"));
  surface->GetFieldData()->AddArray(test::numbers("VolumeNumber", 1, 17.0));
  SolidSweep sweep(surface, quads);
  sweep.name({ 3 }, { 4 });
  sweep.filter->SetNumberOfLayers(3);
  sweep.filter->Update();
  for (vtkUnstructuredGrid* grid : { sweep.hexes(), sweep.boundary() })
  {
    ASSERT_NE(grid->GetFieldData()->GetArray("VolumeNumber"), nullptr);
    EXPECT_EQ(grid->GetFieldData()->GetArray("VolumeNumber")->GetTuple1(0), 17.0);
  }
  const vtkIdType n = quads->GetNumberOfPoints();
  for (int a = 0; a < quads->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* from = quads->GetPointData()->GetArray(a);
    vtkDataArray* to = sweep.hexes()->GetPointData()->GetArray(from->GetName());
    ASSERT_NE(to, nullptr) << from->GetName();
    for (vtkIdType i = 0; i < sweep.hexes()->GetNumberOfPoints(); ++i)
    {
      EXPECT_EQ(to->GetTuple1(i), from->GetTuple1(i % n));
    }
  }
}

/// A right prism on a regular polygon that stands for a circle: one face round it, caps as fans.
test::Grid facettedCylinder(int sides, double radius, double height, int rows)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto grid = test::Grid::New();
  vtkNew<vtkIntArray> faces;
  faces->SetName(hexsweep::arrays::FaceId);
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c, int face) {
    const vtkIdType ids[3] = { a, b, c };
    grid->InsertNextCell(VTK_TRIANGLE, 3, ids);
    faces->InsertNextValue(face);
  };
  grid->SetPoints(points);
  for (int k = 0; k <= rows; ++k)
  {
    for (int j = 0; j < sides; ++j)
    {
      // Rows in between are turned by half a facet, as meshers do it.
      const double turn = k > 0 && k < rows && k % 2 == 1 ? 0.5 : 0.0;
      const double angle = 6.283185307179586 * (j + turn) / sides;
      points->InsertNextPoint(
        radius * std::cos(angle), radius * std::sin(angle), height * k / rows);
    }
  }
  const vtkIdType bottom = points->InsertNextPoint(0.0, 0.0, 0.0);
  const vtkIdType top = points->InsertNextPoint(0.0, 0.0, height);
  for (int j = 0; j < sides; ++j)
  {
    const int next = (j + 1) % sides;
    add(bottom, next, j, 1);
    add(top, rows * sides + j, rows * sides + next, 2);
    for (int k = 0; k < rows; ++k)
    {
      const vtkIdType a = k * sides + j;
      const vtkIdType b = k * sides + next;
      if (k % 2 == 0)
      {
        add(a, b, a + sides, 3);
        add(b, b + sides, a + sides, 3);
      }
      else
      {
        add(a, b, b + sides, 3);
        add(a, b + sides, a + sides, 3);
      }
    }
  }
  grid->GetCellData()->AddArray(faces);
  return grid;
}

TEST(OneToOneSweep, QuadsOnCoarseCurvesAreNotFinerThanTheirFacets)
{
  test::SolidSweep sweep(facettedCylinder(8, 2.0, 20.0, 7));
  sweep.name({ 1 }, {});
  sweep.filter->SetNumberOfLayers(6);
  sweep.filter->Update();
  EXPECT_EQ(sweep.messages(), "");
  expectCertified(sweep.hexes());
  // Edges of half a facet, 0.77, put some 21 quads on the cap of area 12.6.
  EXPECT_LT(sweep.hexes()->GetNumberOfCells(), 6 * 42);
  // Fine facets leave the size alone.
  test::SolidSweep fine(facettedCylinder(60, 2.0, 20.0, 40));
  fine.name({ 1 }, {});
  fine.filter->SetNumberOfLayers(2);
  fine.filter->Update();
  EXPECT_GT(fine.hexes()->GetNumberOfCells(), 2 * 500);
}

TEST(OneToOneSweep, ColumnsOfAThinPlateStandUpright)
{
  // The caps are triangulated differently: the target is made from other points.
  test::Grid plate = facettedCylinder(40, 10.0, 0.05, 1);
  test::SolidSweep sweep(plate);
  sweep.name({ 1 }, { 2 });
  sweep.filter->SetQuadSize(1.0);
  sweep.filter->SetNumberOfLayers(2);
  sweep.filter->Update();
  vtkUnstructuredGrid* hexes = sweep.hexes();
  ASSERT_GT(hexes->GetNumberOfCells(), 0);
  const vtkIdType n = hexes->GetNumberOfPoints() / 3;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const auto low = test::pointOf(hexes, i);
    const auto high = test::pointOf(hexes, i + 2 * n);
    EXPECT_LT(std::hypot(high[0] - low[0], high[1] - low[1]), 0.005) << i;
  }
  EXPECT_GT(report(hexes, hexsweep::reports::MinScaledJacobian), 0.3);
}

TEST(OneToOneSweep, AbortsWithEmptyOutputs)
{
  for (const double fraction : { 0.03, 0.1, 0.3, 0.6, 0.95 })
  {
    SolidSweep sweep(test::solidGrid("bracket"));
    sweep.name({ 26 }, {});
    test::expectEmptyWhenAborted(sweep.filter, fraction);
  }
}

TEST(OneToOneSweep, CollectionsAreSweptSolidBySolid)
{
  SolidSweep alone(test::solidGrid("flange"));
  alone.filter->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(3, test::solidGrid("flange"));
  SolidSweep inBlocks(blocks);
  inBlocks.filter->Update();
  test::expectSameBits(alone.filter->GetOutput(), inBlocks.filter->GetOutput());

  vtkNew<vtkPartitionedDataSetCollection> parts;
  parts->SetPartition(0, 0, test::solidGrid("flange"));
  parts->SetPartition(2, 0, test::solidGrid("wing"));
  SolidSweep ofParts(parts);
  ofParts.filter->Update();
  auto* hexes = ofParts.filter->GetOutput();
  vtkDataArray* volumes = hexes->GetCellData()->GetArray("VolumeId");
  ASSERT_TRUE(volumes);
  EXPECT_EQ(volumes->GetTuple1(0), 1.0);
  EXPECT_EQ(volumes->GetTuple1(hexes->GetNumberOfCells() - 1), 3.0);
  vtkDataArray* bad = hexes->GetFieldData()->GetArray("SweepReportNotCertified");
  ASSERT_EQ(bad->GetNumberOfTuples(), 2);
  EXPECT_EQ(bad->GetTuple1(0) + bad->GetTuple1(1), 0.0);

  vtkNew<vtkPartitionedDataSetCollection> none;
  SolidSweep ofNone(none);
  test::expectOneError(ofNone.filter, "solid");

  SolidSweep quadsOfParts(test::solidGrid("flange"), parts);
  quadsOfParts.name({ 3 }, {});
  test::expectOneError(quadsOfParts.filter, "source quads come as a composite");
}

TEST(OneToOneSweep, VolumeIdIsCarried)
{
  const auto volumeIds = [](vtkUnstructuredGrid* solid) {
    SolidSweep sweep(solid);
    sweep.name({ 26 }, {});
    sweep.filter->SetNumberOfLayers(2);
    sweep.filter->Update();
    std::set<double> ids;
    vtkDataArray* array = sweep.hexes()->GetCellData()->GetArray(hexsweep::arrays::VolumeId);
    for (vtkIdType c = 0; array && c < array->GetNumberOfTuples(); ++c)
    {
      ids.insert(array->GetTuple1(c));
    }
    return ids;
  };
  const test::Grid surface = test::solidGrid("bracket");
  EXPECT_EQ(volumeIds(surface), std::set<double>{});
  vtkNew<vtkDoubleArray> ids;
  ids->SetName(hexsweep::arrays::VolumeId);
  ids->SetNumberOfValues(surface->GetNumberOfCells());
  ids->Fill(7.0);
  surface->GetCellData()->AddArray(ids);
  EXPECT_EQ(volumeIds(surface), std::set<double>{ 7.0 });
  ids->SetValue(5, 8.0); // no one volume
  EXPECT_EQ(volumeIds(surface), std::set<double>{});
  // As gmsh writes it: the volume cells' own entity, beside those of the faces.
  surface->GetCellData()->RemoveArray(hexsweep::arrays::VolumeId);
  surface->GetCellData()
    ->GetArray(hexsweep::arrays::FaceId)
    ->SetName(hexsweep::arrays::CellEntityIds);
  const vtkIdType corners[4] = { 0, 1, 2, 3 };
  surface->InsertNextCell(VTK_TETRA, 4, corners);
  surface->GetCellData()->GetArray(hexsweep::arrays::CellEntityIds)->InsertNextTuple1(31.0);
  EXPECT_EQ(volumeIds(surface), std::set<double>{ 31.0 });
}
}

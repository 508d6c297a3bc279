// SPDX-License-Identifier: BSD-3-Clause
// The chain of single filters on the parts of CAD solids, beside the one filter for all.
#include "SolidGrids.h"

#include "Core/Solids/CanonicalSolid.h"
#include "HexSweepArrays.h"

#include <vtkCageHexInterior.h>
#include <vtkIntArray.h>
#include <vtkLinkingSideMesher.h>
#include <vtkSweepQuadProjector.h>

namespace TestLinkingSideMesher
{
using test::CadSolid;
using test::report;

/// Cells whose face id is (or is not) among some.
test::Grid facesOf(vtkUnstructuredGrid* solid, const std::vector<vtkIdType>& ids, bool wanted)
{
  vtkDataArray* faceIds = solid->GetCellData()->GetArray(hexsweep::arrays::FaceId);
  auto part = test::Grid::New();
  part->SetPoints(solid->GetPoints());
  vtkNew<vtkIntArray> kept;
  kept->SetName(hexsweep::arrays::FaceId);
  for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
  {
    const vtkIdType id = static_cast<vtkIdType>(faceIds->GetTuple1(c));
    if ((std::find(ids.begin(), ids.end(), id) != ids.end()) == wanted)
    {
      vtkNew<vtkIdList> points;
      solid->GetCellPoints(c, points);
      part->InsertNextCell(solid->GetCellType(c), points);
      kept->InsertNextValue(static_cast<int>(id));
    }
  }
  part->GetCellData()->AddArray(kept);
  return part;
}

/// A solid as the one filter places and numbers it, and quads on it reflected alike.
struct CanonicalGrids
{
  test::Grid solid = test::Grid::New();
  test::Grid quads;

  explicit CanonicalGrids(const CadSolid& cad)
  {
    const test::Grid given = test::solidGrid(cad.name);
    hexsweep::SolidInput input;
    input.points.resize(given->GetNumberOfPoints(), 3);
    for (vtkIdType p = 0; p < given->GetNumberOfPoints(); ++p)
    {
      given->GetPoint(p, input.points.row(p).data());
    }
    input.triangles.resize(given->GetNumberOfCells(), 3);
    for (vtkIdType c = 0; c < given->GetNumberOfCells(); ++c)
    {
      const test::Corners corners = test::cornersOf(given, c);
      input.triangles.row(c) << corners[0], corners[1], corners[2];
    }
    const hexsweep::CanonicalSolid canonical = hexsweep::canonicalSolid(input);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (hexsweep::Index p = 0; p < canonical.input.points.rows(); ++p)
    {
      points->InsertNextPoint(canonical.input.points.row(p).data());
    }
    this->solid->SetPoints(points);
    vtkNew<vtkIntArray> faceIds;
    faceIds->SetName(hexsweep::arrays::FaceId);
    for (hexsweep::Index t = 0; t < canonical.input.triangles.rows(); ++t)
    {
      const auto row = canonical.input.triangles.row(t);
      const bool turned = canonical.reflection.turnsOver(); // outward, as the files are
      const std::array<vtkIdType, 3> corners = { row[0], row[turned ? 2 : 1], row[turned ? 1 : 2] };
      this->solid->InsertNextCell(VTK_TRIANGLE, 3, corners.data());
      faceIds->InsertNextValue(
        static_cast<int>(given->GetCellData()
                           ->GetArray(hexsweep::arrays::FaceId)
                           ->GetTuple1(canonical.input.cellIds[static_cast<std::size_t>(t)])));
    }
    this->solid->GetCellData()->AddArray(faceIds);
    this->quads =
      test::changedPoints(test::solidQuads(cad.name), [&](vtkIdType, std::array<double, 3>& p) {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          p[axis] *= canonical.reflection.signs[static_cast<hexsweep::Index>(axis)];
        }
      });
  }
};

struct Parts
{
  test::Grid solid, quads, source, target, sides;

  explicit Parts(const CadSolid& cad)
    : Parts(cad, CanonicalGrids(cad))
  {
  }

private:
  Parts(const CadSolid& cad, const CanonicalGrids& grids)
    : solid(grids.solid)
    , quads(grids.quads)
    , source(facesOf(solid, cad.source, true))
    , target(facesOf(solid, cad.target, true))
  {
    std::vector<vtkIdType> caps = cad.source;
    caps.insert(caps.end(), cad.target.begin(), cad.target.end());
    this->sides = facesOf(this->solid, caps, false);
  }
};

class LinkingSideMesher : public testing::TestWithParam<CadSolid>
{
};

TEST_P(LinkingSideMesher, ChainGivesWhatTheOneFilterGives)
{
  const CadSolid& cad = GetParam();
  const Parts parts(cad);
  vtkNew<vtkLinkingSideMesher> mesher;
  test::Events mesherEvents(mesher);
  mesher->SetSourceQuadsData(parts.quads);
  mesher->SetLinkingSurfaceData(parts.sides);
  mesher->SetTargetSurfaceData(parts.target);
  mesher->SetNumberOfLayers(cad.layers);
  vtkNew<vtkSweepQuadProjector> projector;
  test::Events projectorEvents(projector);
  projector->SetInputData(0, parts.quads);
  projector->SetInputData(1, parts.target);
  projector->SetLinkingSidesConnection(mesher->GetOutputPort());
  projector->SetInputData(3, parts.source);
  vtkNew<vtkCageHexInterior> interior;
  test::Events interiorEvents(interior);
  interior->SetSourceQuadsData(parts.quads);
  interior->SetTargetQuadsConnection(projector->GetOutputPort());
  interior->SetLinkingSidesConnection(mesher->GetOutputPort());
  interior->Update();
  for (const test::Events* events : { &mesherEvents, &projectorEvents, &interiorEvents })
  {
    EXPECT_TRUE(events->errors.empty()) << events->errors.front();
    EXPECT_TRUE(events->warnings.empty()) << events->warnings.front();
  }
  auto* linking = vtkUnstructuredGrid::SafeDownCast(mesher->GetOutputDataObject(0));
  EXPECT_EQ(linking->GetNumberOfCells(), cad.loopNodes * cad.layers);
  EXPECT_EQ(report(linking, hexsweep::reports::KeptEdges), static_cast<double>(cad.columnEdges));

  test::SolidSweep sweep(parts.solid, parts.quads);
  sweep.name(cad.source, cad.target);
  sweep.filter->SetNumberOfLayers(cad.layers);
  sweep.filter->Update();
  auto* hexes = vtkUnstructuredGrid::SafeDownCast(interior->GetOutputDataObject(0));
  ASSERT_EQ(hexes->GetNumberOfCells(), sweep.hexes()->GetNumberOfCells());
  EXPECT_EQ(report(hexes, hexsweep::reports::NotCertified), 0.0);
  // The one filter sees the solid, and so that the flange is a prism; the chain does not.
  const bool isRuled = test::textReport(sweep.hexes(), hexsweep::reports::Method) == "Ruled";
  EXPECT_EQ(isRuled, std::string(cad.name) == "flange");
  if (!isRuled)
  {
    EXPECT_LT(test::greatestDistance(hexes, sweep.hexes()), 1e-6 * test::sizeOf(parts.solid));
  }

  // Face ids are those of the solid, with about their areas.
  const auto areas = test::areasById(parts.sides, hexsweep::arrays::FaceId);
  for (const auto& [id, area] : test::areasById(linking, hexsweep::arrays::BoundaryId))
  {
    ASSERT_EQ(areas.count(id), 1u);
    EXPECT_NEAR(area / areas.at(id), 1.0, 0.12) << id;
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, LinkingSideMesher, testing::ValuesIn(test::cadSolids()),
  [](const auto& solid) { return std::string(solid.param.name); });

TEST(LinkingSideMesher, SaysWhatIsMissing)
{
  const Parts parts(test::cadSolids()[0]);
  vtkNew<vtkLinkingSideMesher> mesher;
  mesher->SetSourceQuadsData(parts.quads);
  test::expectOneError(mesher, "the solid is missing");
  mesher->SetLinkingSurfaceData(parts.solid); // with both caps: no tubes
  test::expectOneError(mesher, "no tube");
  mesher->SetLinkingSurfaceData(facesOf(parts.solid, { 1 }, true)); // the outer side alone
  test::expectOneError(mesher, "8 boundary loops, but there are 1 linking sides");
  mesher->SetLinkingSurfaceData(parts.sides);
  mesher->SetNumberOfLayers(0);
  test::expectOneError(mesher, "number of layers is 0");
}

TEST(LinkingSideMesher, EdgesByAngleWithoutFaceIds)
{
  const CadSolid& loft = test::cadSolids()[2];
  const Parts parts(loft);
  parts.sides->GetCellData()->Initialize();
  vtkNew<vtkLinkingSideMesher> mesher;
  mesher->SetSourceQuadsData(parts.quads);
  mesher->SetLinkingSurfaceData(parts.sides);
  mesher->SetFeatureAngle(20.0);
  mesher->Update();
  // The edges of the square run out in the circle: they are sharp at the source only.
  EXPECT_EQ(report(vtkUnstructuredGrid::SafeDownCast(mesher->GetOutputDataObject(0)),
              hexsweep::reports::KeptEdges),
    0.0);
}

TEST(LinkingSideMesher, TargetThatIsElsewhereIsNoticed)
{
  const Parts parts(test::cadSolids()[0]);
  vtkNew<vtkLinkingSideMesher> mesher;
  test::Events events(mesher);
  mesher->SetSourceQuadsData(parts.quads);
  mesher->SetLinkingSurfaceData(parts.sides);
  mesher->SetTargetSurfaceData(parts.source); // the wrong cap
  mesher->Update();
  ASSERT_EQ(events.warnings.size(), 1u);
  EXPECT_NE(events.warnings[0].find("target surface"), std::string::npos);
}
}

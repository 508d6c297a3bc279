// SPDX-License-Identifier: BSD-3-Clause
// The table of a solid's faces, by ids and by angle.
#include "HexSweepArrays.h"
#include "SolidGrids.h"

#include <vtkSolidFaces.h>
#include <vtkTable.h>

namespace TestSolidFaces
{
using namespace test;

std::map<vtkIdType, double> areasIn(vtkTable* table)
{
  std::map<vtkIdType, double> areas;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    areas[table->GetValueByName(i, "FaceId").ToTypeInt64()] =
      table->GetValueByName(i, "Area").ToDouble();
  }
  return areas;
}

bool byAngle(vtkTable* table)
{
  return table->GetFieldData()->GetArray(hexsweep::reports::FacesByAngle)->GetTuple1(0) != 0.0;
}

void expectSame(const std::map<vtkIdType, double>& found, const std::map<vtkIdType, double>& truth)
{
  ASSERT_EQ(found.size(), truth.size());
  for (const auto& [id, area] : truth)
  {
    ASSERT_EQ(found.count(id), 1u) << id;
    EXPECT_NEAR(found.at(id), area, 1e-12 * area) << id;
  }
}

TEST(SolidFaces, AreThoseOfTheIds)
{
  for (const CadSolid& cad : cadSolids())
  {
    const Grid solid = solidGrid(cad.name);
    vtkNew<vtkSolidFaces> faces;
    Events events(faces);
    faces->SetInputData(solid);
    faces->Update();
    EXPECT_TRUE(events.errors.empty());
    expectSame(areasIn(faces->GetOutput()), areasById(solid, "FaceId"));
    EXPECT_FALSE(byAngle(faces->GetOutput()));
  }
}

/// The sweep counts faces that it finds by angle as the table does: its boundary tells.
TEST(SolidFaces, ByAngleAreThoseOfTheSweep)
{
  const Grid solid = solidGrid("flange");
  solid->GetCellData()->RemoveArray("FaceId");
  vtkNew<vtkSolidFaces> faces;
  faces->SetInputData(solid);
  faces->Update();
  vtkTable* table = faces->GetOutput();
  EXPECT_TRUE(byAngle(table));
  ASSERT_GT(table->GetNumberOfRows(), 2);
  vtkIdType cap = 0;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const bool larger =
      table->GetValueByName(i, "Area").ToDouble() > table->GetValueByName(cap, "Area").ToDouble();
    cap = larger && table->GetValueByName(i, "Flatness").ToDouble() > 0.9999 ? i : cap;
  }
  SolidSweep sweep(solid);
  sweep.name({ table->GetValueByName(cap, "FaceId").ToTypeInt64() }, {});
  sweep.filter->SetNumberOfLayers(2);
  sweep.filter->SetQuadSize(6.0);
  sweep.filter->Update();
  ASSERT_GT(sweep.hexes()->GetNumberOfCells(), 0) << sweep.messages();
  const auto swept = areasById(sweep.boundary(), "BoundaryId");
  const auto listed = areasIn(table);
  ASSERT_EQ(swept.size(), listed.size());
  for (const auto& [id, area] : listed)
  {
    EXPECT_NEAR(swept.at(id), area, 0.1 * area) << id; // chords of coarse quads
  }
}

TEST(SolidFaces, RefusesAsTheSweepDoes)
{
  const Grid open = solidGrid("wing");
  open->GetCellData()->RemoveArray("FaceId");
  vtkNew<vtkSolidFaces> faces;
  faces->SetInputData(open);
  faces->SetFeatureAngle(179.0);
  Events events(faces);
  SolidSweep sweep(open);
  sweep.filter->SetFeatureAngle(179.0);
  sweep.name({ 0 }, {});
  faces->Update();
  sweep.filter->Update();
  ASSERT_EQ(events.errors.size(), 1u);
  ASSERT_EQ(sweep.events.errors.size(), 1u);
  const auto said = [](const std::string& text) { return text.substr(text.find("): ")); };
  EXPECT_EQ(said(events.errors[0]), said(sweep.events.errors[0]));
  EXPECT_EQ(faces->GetOutput()->GetNumberOfRows(), 0);
}
}

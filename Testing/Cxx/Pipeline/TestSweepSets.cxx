// SPDX-License-Identifier: BSD-3-Clause
// Side sets and node sets of a swept mesh.
#include "SolidGrids.h"

#include "HexSweepArrays.h"

#include <vtkCompositeDataSet.h>
#include <vtkHexahedron.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkStringArray.h>
#include <vtkSweepSets.h>

namespace TestSweepSets
{
using namespace test;

/// The filter with its messages.
struct Sets
{
  vtkNew<vtkSweepSets> filter;
  Events events;

  Sets(vtkDataObject* hexes, vtkDataObject* boundary)
    : events(filter)
  {
    this->filter->SetHexesData(hexes);
    this->filter->SetBoundaryData(boundary);
  }

  std::map<std::string, vtkUnstructuredGrid*> of(unsigned int part)
  {
    std::map<std::string, vtkUnstructuredGrid*> grids;
    auto* sets = vtkMultiBlockDataSet::SafeDownCast(this->filter->GetOutput()->GetBlock(part));
    for (unsigned int i = 0; sets && i < sets->GetNumberOfBlocks(); ++i)
    {
      grids[sets->GetMetaData(i)->Get(vtkCompositeDataSet::NAME())] =
        vtkUnstructuredGrid::SafeDownCast(sets->GetBlock(i));
    }
    return grids;
  }
};

struct SweptWing
{
  SolidSweep sweep;
  Grid hexes = Grid::New();
  Grid boundary = Grid::New();

  explicit SweptWing(bool swapped = false)
    : sweep(solidGrid("wing"), swapped ? nullptr : solidQuads("wing"))
  {
    this->sweep.name({ swapped ? 4 : 3 }, {});
    this->sweep.filter->SetNumberOfLayers(3);
    this->sweep.filter->SetQuadSize(8.0);
    this->sweep.filter->Update();
    this->hexes->DeepCopy(this->sweep.hexes());
    this->boundary->DeepCopy(this->sweep.boundary());
  }
};

TEST(SweepSets, SidesAreThoseOfVtkHexahedron)
{
  for (const bool swapped : { false, true })
  {
    SweptWing wing(swapped);
    Sets sets(wing.hexes, wing.boundary);
    sets.filter->Update();
    EXPECT_TRUE(sets.events.errors.empty());
    std::set<std::pair<vtkIdType, int>> seen;
    for (const auto& [name, set] : sets.of(1))
    {
      vtkDataArray* elements = set->GetCellData()->GetArray("SourceElementId");
      vtkDataArray* sides = set->GetCellData()->GetArray("SourceElementSide");
      for (vtkIdType c = 0; c < set->GetNumberOfCells(); ++c)
      {
        const auto hex = static_cast<vtkIdType>(elements->GetTuple1(c));
        const auto side = static_cast<int>(sides->GetTuple1(c));
        vtkCell* face = wing.hexes->GetCell(hex)->GetFace(side);
        std::set<std::array<double, 3>> expected;
        std::set<std::array<double, 3>> found;
        for (int i = 0; i < 4; ++i)
        {
          expected.insert(pointOf(wing.hexes, face->GetPointId(i)));
          found.insert(pointOf(set, set->GetCell(c)->GetPointId(i)));
        }
        EXPECT_EQ(found, expected) << name << " " << c;
        seen.emplace(hex, side);
      }
    }
    EXPECT_EQ(static_cast<vtkIdType>(seen.size()), wing.boundary->GetNumberOfCells());
  }
}

TEST(SweepSets, NodesAreThoseOfTheHexahedra)
{
  SweptWing wing;
  Sets sets(wing.hexes, wing.boundary);
  sets.filter->Update();
  const auto nodeSets = sets.of(2);
  const vtkIdType layer = wing.hexes->GetNumberOfPoints() / 4; // three layers of hexahedra
  for (const auto& [name, set] : nodeSets)
  {
    vtkDataArray* ids = set->GetPointData()->GetArray("GlobalNodeId");
    std::set<vtkIdType> nodes;
    for (vtkIdType i = 0; i < set->GetNumberOfPoints(); ++i)
    {
      const auto node = static_cast<vtkIdType>(ids->GetTuple1(i)) - 1;
      nodes.insert(node);
      EXPECT_EQ(pointOf(set, i), pointOf(wing.hexes, node));
    }
    EXPECT_EQ(static_cast<vtkIdType>(nodes.size()), set->GetNumberOfPoints()) << name;
    if (name == "Source nodes" || name == "Target nodes")
    {
      const vtkIdType first = name == "Source nodes" ? 0 : 3 * layer;
      EXPECT_EQ(static_cast<vtkIdType>(nodes.size()), layer);
      EXPECT_EQ(*nodes.begin(), first);
      EXPECT_EQ(*nodes.rbegin(), first + layer - 1);
    }
  }
  EXPECT_EQ(nodeSets.count("Sides nodes"), 1u);
  EXPECT_EQ(nodeSets.count("Face nodes ID:13"), 1u);
}

TEST(SweepSets, RoleSetsCanBeLeftOut)
{
  SweptWing wing;
  Sets sets(wing.hexes, wing.boundary);
  sets.filter->RoleSetsOff();
  sets.filter->Update();
  for (const unsigned int part : { 1u, 2u })
  {
    const auto named = sets.of(part);
    EXPECT_EQ(named.size(), 4u) << part;
    for (const auto& [name, set] : named)
    {
      EXPECT_EQ(name.rfind("Face", 0), 0u) << name;
    }
  }
}

TEST(SweepSets, IdsThatDoNotFitStayInTheNames)
{
  SweptWing wing;
  auto* ids = vtkIdTypeArray::SafeDownCast(
    wing.boundary->GetCellData()->GetArray(hexsweep::arrays::BoundaryId));
  for (vtkIdType c = 0; c < ids->GetNumberOfValues(); ++c)
  {
    ids->SetValue(c, ids->GetValue(c) == 3 ? 5000000000 : -1);
  }
  Sets sets(wing.hexes, wing.boundary);
  sets.filter->Update();
  std::set<std::string> names;
  for (const auto& [name, set] : sets.of(1))
  {
    names.insert(name);
  }
  EXPECT_EQ(names,
    (std::set<std::string>{ "Face -1 ID:1", "Face 5000000000 ID:2", "Source", "Target", "Sides" }));
  EXPECT_EQ(sets.of(2).count("Face 5000000000 nodes ID:12"), 1u);
}

/// Of the wing's faces 1 to 4.
void nameFaces(vtkUnstructuredGrid* grid, const std::vector<std::string>& names)
{
  vtkNew<vtkStringArray> array;
  array->SetName("FaceNames");
  for (const std::string& name : names)
  {
    array->InsertNextValue(name);
  }
  grid->GetFieldData()->AddArray(array);
}

/// Name and id of each set, by the name of its block.
std::map<std::string, std::pair<std::string, int>> namesAndIds(Sets& sets, unsigned int part)
{
  std::map<std::string, std::pair<std::string, int>> result;
  for (const auto& [block, set] : sets.of(part))
  {
    auto* names = vtkStringArray::SafeDownCast(
      set->GetFieldData()->GetAbstractArray(hexsweep::arrays::SetName));
    vtkDataArray* ids = set->GetFieldData()->GetArray(hexsweep::arrays::SetId);
    result[block] = { names->GetValue(0), static_cast<int>(ids->GetTuple1(0)) };
  }
  return result;
}

TEST(SweepSets, NamesOfFacesAreTheSolids)
{
  SweptWing wing;
  // Face 1 and 3 share a name but for its case, face 2 has what would be read as an id, face 4
  // none.
  nameFaces(wing.boundary, { "nobody", "Skin", " Tip\n ID:7 ", "skin" });
  nameFaces(wing.hexes, { "", "not", "these" });
  Sets sets(wing.hexes, wing.boundary);
  sets.filter->Update();
  const auto sides = namesAndIds(sets, 1);
  const std::map<std::string, std::pair<std::string, int>> expected = {
    { "Skin 1 ID:1", { "Skin 1", 1 } }, { "Tip  ID 7 ID:2", { "Tip  ID 7", 2 } },
    { "skin 3 ID:3", { "skin 3", 3 } }, { "Face ID:4", { "Face 4", 4 } },
    { "Source", { "Source", 5 } }, { "Target", { "Target", 6 } }, { "Sides", { "Sides", 7 } }
  };
  EXPECT_EQ(sides, expected);
  const auto nodes = namesAndIds(sets, 2);
  EXPECT_EQ(nodes.at("Skin 1 nodes ID:11"), std::make_pair(std::string("Skin 1"), 11));
  EXPECT_EQ(nodes.at("Source nodes"), std::make_pair(std::string("Source"), 15));
}

TEST(SweepSets, IdsCanBeChosen)
{
  SweptWing wing;
  nameFaces(wing.hexes, { "", "Skin" });
  Sets sets(wing.hexes, wing.boundary);
  sets.filter->AddSetId("Skin", 30);
  sets.filter->AddSetId("Face 2", 12);
  sets.filter->AddSetId("Target", 1);
  sets.filter->Update();
  const auto sides = namesAndIds(sets, 1);
  const std::map<std::string, std::pair<std::string, int>> expected = { { "Skin ID:30",
                                                                          { "Skin", 30 } },
    { "Face 2 ID:12", { "Face 2", 12 } }, { "Face ID:3", { "Face 3", 3 } },
    { "Face ID:4", { "Face 4", 4 } }, { "Source ID:31", { "Source", 31 } },
    { "Target ID:1", { "Target", 1 } }, { "Sides ID:32", { "Sides", 32 } } };
  EXPECT_EQ(sides, expected);
  EXPECT_EQ(namesAndIds(sets, 2).count("Target nodes ID:101"), 1u);
}

TEST(SweepSets, IdsThatCannotBeAreNamed)
{
  SweptWing wing;
  const std::vector<std::pair<std::string, vtkIdType>> wrong = { { "Skin", 3 }, { "Source", 0 },
    { "Source", 100001 }, { "Source", 2 } };
  const char* said[] = { "no set is called \"Skin\"", "is 0", "is 100001", "both have the id 2" };
  for (std::size_t i = 0; i < wrong.size(); ++i)
  {
    Sets sets(wing.hexes, wing.boundary);
    sets.filter->AddSetId(wrong[i].first.c_str(), wrong[i].second);
    EXPECT_EQ(sets.filter->GetNumberOfSetIds(), 1);
    expectOneError(sets.filter, said[i]);
    sets.filter->RemoveAllSetIds();
    sets.filter->Update();
    EXPECT_EQ(sets.of(1).size(), 7u);
  }
}

TEST(SweepSets, WrongInputsAreNamed)
{
  SweptWing wing;
  {
    Sets sets(wing.hexes, nullptr);
    expectOneError(sets.filter, "boundary is not connected");
  }
  {
    Sets sets(wing.boundary, wing.hexes);
    expectOneError(sets.filter, "no hexahedron");
  }
  {
    Sets sets(wing.hexes, emptyGrid());
    expectOneError(sets.filter, "is empty");
  }
  {
    const Grid fewer = gridOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                                { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } },
      { { 0, 1, 2, 3, 4, 5, 6, 7 } }, VTK_HEXAHEDRON);
    Sets sets(fewer, wing.boundary);
    expectOneError(sets.filter, "not that of these hexahedra");
  }
  {
    // Of the same solid, but with the caps exchanged: all numbers are in range.
    SweptWing other(true);
    const bool isSmaller = other.hexes->GetNumberOfCells() < wing.hexes->GetNumberOfCells();
    Sets sets(isSmaller ? wing.hexes : other.hexes, isSmaller ? other.boundary : wing.boundary);
    expectOneError(sets.filter, "is not side");
  }
  wing.boundary->GetCellData()->RemoveArray(hexsweep::arrays::HexSide);
  Sets sets(wing.hexes, wing.boundary);
  expectOneError(sets.filter, "no array \"HexSide\"");
}
}

// SPDX-License-Identifier: BSD-3-Clause
// Side sets and node sets of a swept mesh.
#include "SolidGrids.h"

#include "HexSweepArrays.h"

#include <vtkCompositeDataSet.h>
#include <vtkHexahedron.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkSweepSets.h>

namespace
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

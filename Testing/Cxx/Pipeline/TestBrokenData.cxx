// SPDX-License-Identifier: BSD-3-Clause
// Data sets that do not hold together: each filter refuses them in words, and reads nothing past an
// end.
#include "EveryFilter.h"

#include <vtkIdTypeArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

namespace TestBrokenData
{
using namespace test;

/// Breaks a copy of one data set.
struct Damage
{
  const char* name;
  std::function<void(vtkUnstructuredGrid*)> apply;
  const char* message; ///< part of the error
};

vtkSmartPointer<vtkIdTypeArray> idsOf(const char* name, vtkIdType count)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name);
  ids->SetNumberOfValues(count);
  ids->FillValue(0);
  return ids;
}

void setConnectivity(
  vtkUnstructuredGrid* grid, const std::function<void(vtkIdTypeArray*, vtkIdTypeArray*)>& change)
{
  vtkNew<vtkIdTypeArray> offsets;
  offsets->DeepCopy(grid->GetCells()->GetOffsetsArray());
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->DeepCopy(grid->GetCells()->GetConnectivityArray());
  change(offsets, connectivity);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  vtkNew<vtkUnsignedCharArray> types;
  types->DeepCopy(grid->GetCellTypesArray());
  grid->SetCells(types, cells);
}

std::vector<Damage> damages()
{
  const auto corner = [](vtkIdType value) {
    return [value](vtkUnstructuredGrid* grid) {
      setConnectivity(grid, [value](vtkIdTypeArray*, vtkIdTypeArray* connectivity) {
        connectivity->SetValue(5, value);
      });
    };
  };
  return {
    { "cell array too short",
      [](vtkUnstructuredGrid* grid) { grid->GetCellData()->AddArray(idsOf("FaceId", 3)); },
      "the cell array \"FaceId\" has 3 entries for " },
    { "cell array too long",
      [](vtkUnstructuredGrid* grid) {
        grid->GetCellData()->AddArray(idsOf("Any", grid->GetNumberOfCells() + 1));
      },
      "the cell array \"Any\" has " },
    { "point array too short",
      [](vtkUnstructuredGrid* grid) { grid->GetPointData()->AddArray(idsOf("HexPointIds", 1)); },
      "the point array \"HexPointIds\" has 1 entry for " },
    { "array without a name or an entry",
      [](vtkUnstructuredGrid* grid) { grid->GetPointData()->AddArray(idsOf(nullptr, 0)); },
      "the point array \"\" has 0 entries for " },
    { "ghost flags too short",
      [](vtkUnstructuredGrid* grid) {
        vtkNew<vtkUnsignedCharArray> flags;
        flags->SetName(vtkDataSetAttributes::GhostArrayName());
        flags->InsertNextValue(0);
        grid->GetCellData()->AddArray(flags);
      },
      "the cell array \"vtkGhostType\" has 1 entry for " },
    { "corner that is no point", corner(1000000000), "has the corner 1000000000, but there are " },
    { "negative corner", corner(-1), "has the corner -1, but there are " },
    { "offsets that fall",
      [](vtkUnstructuredGrid* grid) {
        setConnectivity(
          grid, [](vtkIdTypeArray* offsets, vtkIdTypeArray*) { offsets->SetValue(2, 0); });
      },
      "cell 1 has its corners at places " },
    { "offsets past the end",
      [](vtkUnstructuredGrid* grid) {
        setConnectivity(grid, [](vtkIdTypeArray* offsets, vtkIdTypeArray*) {
          offsets->SetValue(offsets->GetNumberOfValues() - 1, 1 << 30);
        });
      },
      " of a list of " },
    { "cell with too few corners for its type",
      [](vtkUnstructuredGrid* grid) { grid->GetCellTypesArray()->SetValue(1, VTK_WEDGE); },
      "cell 1 is a vtkWedge of " },
    { "type that does not exist",
      [](vtkUnstructuredGrid* grid) { grid->GetCellTypesArray()->SetValue(1, 250); },
      "cell 1 is of type 250" },
    { "no points object", [](vtkUnstructuredGrid* grid) { grid->SetPoints(nullptr); },
      " cells, but no points." },
    { "too few points",
      [](vtkUnstructuredGrid* grid) {
        vtkNew<vtkPoints> points;
        points->InsertNextPoint(0.0, 0.0, 0.0);
        grid->SetPoints(points);
        grid->GetPointData()->Initialize();
      },
      "but there are 1 points." },
  };
}

/// The data set of a port, or the first block of it, broken.
vtkSmartPointer<vtkDataObject> broken(vtkDataObject* input, const Damage& damage)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(input))
  {
    const auto copy = deepCopy(blocks);
    damage.apply(vtkUnstructuredGrid::SafeDownCast(copy->GetBlock(0)));
    return copy;
  }
  const auto copy = deepCopy(vtkUnstructuredGrid::SafeDownCast(input));
  damage.apply(copy);
  return copy;
}

class BrokenData : public testing::TestWithParam<std::size_t>
{
};

TEST_P(BrokenData, IsRefusedOnEveryPort)
{
  const FilterUse& use = everyFilter()[GetParam()];
  SCOPED_TRACE(use.name);
  for (std::size_t port = 0; port < use.inputs.size(); ++port)
  {
    for (const Damage& damage : damages())
    {
      SCOPED_TRACE(damage.name + std::string(" on port ") + std::to_string(port));
      if (use.name == "HexValidity" && std::string(damage.message).find(" array \"") < 20 &&
        std::string(damage.message).find("vtkGhostType") == std::string::npos)
      {
        continue; // arrays that it passes by
      }
      const vtkSmartPointer<vtkAlgorithm> filter = use.on(port, broken(use.inputs[port], damage));
      Events events(filter);
      filter->Update();
      ASSERT_EQ(events.errors.size(), 1u);
      EXPECT_NE(events.errors[0].find(damage.message), std::string::npos) << events.errors[0];
      EXPECT_FALSE(hasOutput(filter));
      // The same filter works on good data next.
      filter->SetInputDataObject(static_cast<int>(port), use.inputs[port]);
      filter->Update();
      EXPECT_EQ(events.errors.size(), 1u) << events.errors.back();
      EXPECT_TRUE(hasOutput(filter));
    }
  }
}

TEST_P(BrokenData, IsNotWhatTheOthersAreMadeFrom)
{
  const vtkSmartPointer<vtkAlgorithm> filter = everyFilter()[GetParam()].on();
  Events events(filter);
  filter->Update();
  EXPECT_TRUE(events.errors.empty()) << events.errors.front();
  EXPECT_TRUE(hasOutput(filter));
}

INSTANTIATE_TEST_SUITE_P(Filters, BrokenData, testing::Range<std::size_t>(0, 13));

TEST(BrokenData, AllFiltersAreTried)
{
  EXPECT_EQ(everyFilter().size(), 13u);
}
}

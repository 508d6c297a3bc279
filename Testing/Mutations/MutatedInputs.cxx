// SPDX-License-Identifier: BSD-3-Clause
#include "MutatedInputs.h"

#include "Core/Interior/InteriorStarts.h"

#include <vtkAssemblySweep.h>
#include <vtkCageHexInterior.h>
#include <vtkHarmonicDiskMap.h>
#include <vtkIdTypeArray.h>
#include <vtkLinkingSideMesher.h>
#include <vtkManyToManySweep.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOneToOneSweep.h>
#include <vtkSolidFaces.h>
#include <vtkSweepCandidates.h>
#include <vtkSweepQuadProjector.h>
#include <vtkSweepSets.h>
#include <vtkUnsignedCharArray.h>

#include <iterator>
#include <limits>

namespace test
{
Chance::Chance(std::uint64_t number)
{
  std::seed_seq seed = { static_cast<std::uint32_t>(number),
    static_cast<std::uint32_t>(number >> 32) };
  this->Generator.seed(seed);
}

vtkIdType Chance::below(vtkIdType count)
{
  return std::uniform_int_distribution<vtkIdType>(0, std::max<vtkIdType>(1, count) - 1)(
    this->Generator);
}

double Chance::real(double from, double to)
{
  return std::uniform_real_distribution<double>(from, to)(this->Generator);
}

double Chance::extreme()
{
  constexpr double Numbers[] = { 0.0, -0.0, 1.0, -1.0, 1e-15, 1e15, 1e49, 1e155, 1e300, -1e300,
    1e-155, 1e-300, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max(),
    std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 3.5e38,
    0.5 };
  return Numbers[this->below(static_cast<vtkIdType>(std::size(Numbers)))];
}

namespace
{
using CellList = std::vector<Corners>;

/// Copies a tuple of each array that has it; the last one of those that an earlier mutation left
/// with fewer.
void appendTuple(vtkDataSetAttributes* to, vtkDataSetAttributes* from, vtkIdType tuple)
{
  for (int a = 0; a < to->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* given = from->GetAbstractArray(a);
    if (given->GetNumberOfTuples() > 0)
    {
      to->GetAbstractArray(a)->InsertNextTuple(
        std::min(tuple, given->GetNumberOfTuples() - 1), given);
    }
  }
}

/// The grid on other cells; cell data where there are as many.
Grid onCells(vtkUnstructuredGrid* grid, const CellList& cells, const std::vector<int>& types)
{
  const Grid changed = deepCopy(grid);
  vtkNew<vtkCellArray> array;
  vtkNew<vtkUnsignedCharArray> typeArray;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    array->InsertNextCell(static_cast<vtkIdType>(cells[c].size()), cells[c].data());
    typeArray->InsertNextValue(static_cast<unsigned char>(types[c]));
  }
  changed->SetCells(typeArray, array);
  if (changed->GetNumberOfCells() != grid->GetNumberOfCells())
  {
    vtkNew<vtkCellData> data;
    for (int a = 0; a < grid->GetCellData()->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* given = grid->GetCellData()->GetAbstractArray(a);
      const vtkSmartPointer<vtkAbstractArray> copy = vtk::TakeSmartPointer(given->NewInstance());
      copy->SetName(given->GetName());
      copy->SetNumberOfComponents(given->GetNumberOfComponents());
      data->AddArray(copy);
    }
    for (vtkIdType c = 0; c < changed->GetNumberOfCells(); ++c)
    {
      appendTuple(data, grid->GetCellData(), c);
    }
    changed->GetCellData()->ShallowCopy(data);
  }
  return changed;
}

/// Drops, doubles, turns over, welds or retypes a cell.
Grid withOtherCells(vtkUnstructuredGrid* grid, Chance& chance)
{
  CellList cells;
  std::vector<int> types;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    cells.push_back(cornersOf(grid, c));
    types.push_back(grid->GetCellType(c));
  }
  const auto some = static_cast<std::size_t>(chance.below(grid->GetNumberOfCells()));
  switch (chance.below(6))
  {
    case 0:
      cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(some));
      types.erase(types.begin() + static_cast<std::ptrdiff_t>(some));
      break;
    case 1:
      cells.push_back(Corners(cells[some]));
      types.push_back(int(types[some]));
      break;
    case 2:
      std::reverse(cells[some].begin(), cells[some].end());
      break;
    case 3:
      cells[some][static_cast<std::size_t>(chance.below(3))] =
        chance.below(grid->GetNumberOfPoints());
      break;
    case 4:
    {
      const int other[] = { VTK_EMPTY_CELL, VTK_POLYGON, VTK_TETRA, VTK_LINE, VTK_PIXEL, VTK_VERTEX,
        VTK_QUADRATIC_TRIANGLE, VTK_TRIANGLE_STRIP, VTK_POLY_LINE, 99 };
      types[some] = other[chance.below(10)];
      break;
    }
    default: // all the same, in another order
      std::rotate(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(some), cells.end());
  }
  return onCells(grid, cells, types);
}

/// A corner torn off its neighbours.
Grid torn(vtkUnstructuredGrid* grid, Chance& chance)
{
  const Grid changed = deepCopy(grid);
  const vtkIdType cell = chance.below(grid->GetNumberOfCells());
  const vtkIdType from = cornersOf(grid, cell).front();
  const vtkIdType to = changed->GetPoints()->InsertNextPoint(grid->GetPoint(from));
  appendTuple(changed->GetPointData(), grid->GetPointData(), from);
  return changedCells(changed, [&](vtkIdType c, Corners& corners) {
    if (c == cell)
    {
      corners.front() = to;
    }
  });
}

Grid withOtherPoints(vtkUnstructuredGrid* grid, Chance& chance)
{
  const vtkIdType some = chance.below(grid->GetNumberOfPoints());
  const vtkIdType other = chance.below(grid->GetNumberOfPoints());
  const vtkIdType axis = chance.below(3);
  const vtkIdType kind = chance.below(8);
  const double extreme = chance.extreme();
  const double amount = std::pow(10.0, chance.real(-8.0, 0.5));
  const double shift = std::pow(10.0, chance.real(0.0, 16.0));
  return changedPoints(grid, [&](vtkIdType i, std::array<double, 3>& place) {
    double& coordinate = place[static_cast<std::size_t>(axis)];
    switch (kind)
    {
      case 0:
        coordinate = i == some ? extreme : coordinate;
        return;
      case 1:
        place = i == some ? pointOf(grid, other) : place;
        return;
      case 2:
        coordinate += shift;
        return;
      case 3:
        coordinate *= extreme;
        return;
      case 4:
        coordinate += i == some ? amount : 0.0;
        return;
      case 5:
        coordinate = std::round(coordinate / amount) * amount;
        return;
      case 6:
        std::transform(
          place.begin(), place.end(), place.begin(), [&](double x) { return x * shift; });
        return;
      default:
        coordinate += amount * chance.real(-1.0, 1.0);
    }
  });
}

/// Arrays of wrong lengths, types, numbers of components and values.
Grid withOtherArrays(vtkUnstructuredGrid* grid, Chance& chance)
{
  const Grid changed = deepCopy(grid);
  const bool ofPoints = chance.oneIn(2);
  vtkDataSetAttributes* data = ofPoints
    ? static_cast<vtkDataSetAttributes*>(changed->GetPointData())
    : static_cast<vtkDataSetAttributes*>(changed->GetCellData());
  const char* names[] = { "FaceId", "CellEntityIds", "VolumeId", "HexId", "HexSide", "HexPointIds",
    "BoundaryId", "BoundaryPart", "DiskCoordinates", "vtkGhostType", "Validity" };
  const char* name = names[chance.below(11)];
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(chance.oneIn(2) ? VTK_DOUBLE
      : chance.oneIn(2)                                             ? VTK_UNSIGNED_CHAR
                                                                    : VTK_ID_TYPE));
  array->SetName(name);
  array->SetNumberOfComponents(chance.oneIn(4) ? 3 : 1);
  const vtkIdType count = ofPoints ? changed->GetNumberOfPoints() : changed->GetNumberOfCells();
  array->SetNumberOfTuples(chance.oneIn(4) ? chance.below(count) : count);
  const bool isReal = array->GetDataType() == VTK_DOUBLE;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetComponent(i / array->GetNumberOfComponents(),
      static_cast<int>(i % array->GetNumberOfComponents()),
      isReal && chance.oneIn(3) ? chance.extreme() : static_cast<double>(chance.below(5)));
  }
  data->AddArray(array);
  return changed;
}

vtkSmartPointer<vtkDataObject> mutated(vtkDataObject* input, Chance& chance)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(input))
  {
    const auto copy = deepCopy(blocks);
    const auto b = static_cast<unsigned int>(chance.below(blocks->GetNumberOfBlocks()));
    const vtkSmartPointer<vtkDataObject> block = mutated(copy->GetBlock(b), chance);
    copy->SetBlock(b, chance.oneIn(20) ? nullptr : block.Get());
    return copy;
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (!grid || grid->GetNumberOfCells() < 2)
  {
    return input;
  }
  switch (chance.below(9))
  {
    case 0:
    case 1:
    case 2:
      return withOtherCells(grid, chance);
    case 3:
      return torn(grid, chance);
    case 4:
      return withOtherArrays(grid, chance);
    case 5:
      return chance.oneIn(4) ? emptyGrid() : singlePrecision(grid);
    default:
      return withOtherPoints(grid, chance);
  }
}

/// One setting of a filter that has the property, if chance has it.
template <typename Filter>
struct Settings
{
  Filter* filter;
  Chance& chance;

  void real(void (Filter::*set)(double))
  {
    if (this->filter && this->chance.oneIn(8))
    {
      (this->filter->*set)(
        this->chance.oneIn(2) ? this->chance.extreme() : this->chance.real(-0.1, 1.0));
    }
  }
  template <typename Whole>
  void whole(void (Filter::*set)(Whole), vtkIdType count)
  {
    if (this->filter && this->chance.oneIn(6))
    {
      (this->filter->*set)(static_cast<Whole>(this->chance.below(count + 2) - 1));
    }
  }
  void flag(void (Filter::*set)(bool))
  {
    if (this->filter && this->chance.oneIn(4))
    {
      (this->filter->*set)(this->chance.oneIn(2));
    }
  }
};

template <typename Filter>
Settings<Filter> settingsOf(vtkAlgorithm* filter, Chance& chance)
{
  return { Filter::SafeDownCast(filter), chance };
}

void setSizes(vtkAlgorithm* filter, Chance& chance)
{
  auto layered = settingsOf<vtkLayeredSweepAlgorithm>(filter, chance);
  layered.real(&vtkLayeredSweepAlgorithm::SetLayerSize);
  layered.real(&vtkLayeredSweepAlgorithm::SetGrowthRatio);
  layered.flag(&vtkLayeredSweepAlgorithm::SetGrowFromBothEnds);
  layered.whole(&vtkLayeredSweepAlgorithm::SetNumberOfLayers, 5);
  auto one = settingsOf<vtkOneToOneSweep>(filter, chance);
  one.real(&vtkOneToOneSweep::SetSize);
  one.real(&vtkOneToOneSweep::SetQuadSize);
  one.real(&vtkOneToOneSweep::SetChordTolerance);
  one.real(&vtkOneToOneSweep::SetFeatureAngle);
  auto many = settingsOf<vtkManyToManySweep>(filter, chance);
  many.real(&vtkManyToManySweep::SetSize);
  many.real(&vtkManyToManySweep::SetChordTolerance);
  many.real(&vtkManyToManySweep::SetDraftAngle);
  many.real(&vtkManyToManySweep::SetImprintTolerance);
  settingsOf<vtkAssemblySweep>(filter, chance).real(&vtkAssemblySweep::SetSize);
  settingsOf<vtkSolidFaces>(filter, chance).real(&vtkSolidFaces::SetFeatureAngle);
  settingsOf<vtkSweepCandidates>(filter, chance).real(&vtkSweepCandidates::SetFeatureAngle);
}

void setMethods(vtkAlgorithm* filter, Chance& chance)
{
  const int methods = static_cast<int>(hexsweep::interiorMethodNames().size());
  auto one = settingsOf<vtkOneToOneSweep>(filter, chance);
  one.whole(&vtkOneToOneSweep::SetMethod, methods);
  one.whole(&vtkOneToOneSweep::SetProjectionMethod, 3);
  one.whole(&vtkOneToOneSweep::SetWeights, 2);
  one.whole(&vtkOneToOneSweep::SetImproveTriangulation, 3);
  one.whole(&vtkOneToOneSweep::SetOutputPointsPrecision, 3);
  one.flag(&vtkOneToOneSweep::SetEnsureValid);
  one.flag(&vtkOneToOneSweep::SetImproveQuality);
  one.flag(&vtkOneToOneSweep::SetFailIfInvalid);
  one.whole(&vtkOneToOneSweep::AddSourceFaceId, 7);
  one.whole(&vtkOneToOneSweep::AddTargetFaceId, 7);
  auto cage = settingsOf<vtkCageHexInterior>(filter, chance);
  cage.whole(&vtkCageHexInterior::SetMethod, methods);
  cage.whole(&vtkCageHexInterior::SetOutputPointsPrecision, 3);
  cage.flag(&vtkCageHexInterior::SetEnsureValid);
  cage.flag(&vtkCageHexInterior::SetImproveQuality);
  cage.flag(&vtkCageHexInterior::SetGenerateTopologicalModel);
  auto projector = settingsOf<vtkSweepQuadProjector>(filter, chance);
  projector.whole(&vtkSweepQuadProjector::SetMethod, 3);
  projector.whole(&vtkSweepQuadProjector::SetDiskMaps, 2);
  projector.whole(&vtkSweepQuadProjector::SetImproveTriangulation, 3);
  projector.flag(&vtkSweepQuadProjector::SetEnsureValid);
  projector.flag(&vtkSweepQuadProjector::SetImproveQuality);
  auto map = settingsOf<vtkHarmonicDiskMap>(filter, chance);
  map.whole(&vtkHarmonicDiskMap::SetWeights, 2);
  map.whole(&vtkHarmonicDiskMap::SetHoleTreatment, 3);
  map.whole(&vtkHarmonicDiskMap::SetImproveTriangulation, 3);
  map.flag(&vtkHarmonicDiskMap::SetOutputDisk);
}
}

vtkSmartPointer<vtkAlgorithm> mutatedFilter(const FilterUse& use, Chance& chance)
{
  std::vector<vtkSmartPointer<vtkDataObject>> inputs = use.inputs;
  for (vtkIdType count = 1 + chance.below(4); count > 0; --count)
  {
    auto& input =
      inputs[static_cast<std::size_t>(chance.below(static_cast<vtkIdType>(inputs.size())))];
    input = mutated(input, chance);
  }
  const vtkSmartPointer<vtkAlgorithm> filter = use.make();
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    filter->SetInputDataObject(static_cast<int>(port), inputs[port]);
  }
  if (chance.oneIn(2))
  {
    setSizes(filter, chance);
    setMethods(filter, chance);
  }
  return filter;
}
}

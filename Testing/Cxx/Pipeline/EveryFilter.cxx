// SPDX-License-Identifier: BSD-3-Clause
#include "EveryFilter.h"

#include "BlockSolids.h"

#include <vtkAssemblySweep.h>
#include <vtkCageHexInterior.h>
#include <vtkHarmonicDiskMap.h>
#include <vtkHexValidity.h>
#include <vtkLinkingSideMesher.h>
#include <vtkManyToManySweep.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkOneToOneSweep.h>
#include <vtkSolidFaces.h>
#include <vtkSweepCandidates.h>
#include <vtkSweepQuadProjector.h>
#include <vtkSweepSets.h>
#include <vtkTable.h>

#include <stdexcept>

namespace test
{
namespace
{
template <typename Filter>
FilterUse useOf(const std::string& name, std::vector<vtkSmartPointer<vtkDataObject>> inputs,
  const std::function<void(Filter*)>& set = {})
{
  const auto make = [set]() -> vtkSmartPointer<vtkAlgorithm> {
    auto filter = vtkSmartPointer<Filter>::New();
    if (set)
    {
      set(filter);
    }
    return filter;
  };
  return { name, make, std::move(inputs) };
}

Grid smallBlock(double from)
{
  return blockFaces(blockOf({ 2, 2, 3 },
                      [from](double x, double y, double z) {
                        return Point{ from + x, y, 1.5 * z };
                      }),
    allFaces());
}

std::vector<FilterUse> makeUses()
{
  const SweepGrids plate = plateSweep(1);
  vtkNew<vtkSweepQuadProjector> projector;
  projector->SetSourceQuadsData(plate.sourceQuads);
  projector->SetTargetSurfaceData(plate.targetSurface);
  projector->SetLinkingSidesData(plate.linkingSides);
  projector->Update();
  const Grid block = smallBlock(0.0);
  vtkNew<vtkOneToOneSweep> sweep;
  sweep->SetSolidData(block);
  sweep->SetSize(0.3);
  sweep->Update();
  vtkNew<vtkMultiBlockDataSet> pair;
  pair->SetBlock(0, block);
  pair->SetBlock(1, smallBlock(1.0));
  const Grid targetQuads = deepCopy(projector->GetOutput());
  const Grid hexes = deepCopy(vtkUnstructuredGrid::SafeDownCast(sweep->GetOutputDataObject(0)));
  const Grid boundary = deepCopy(vtkUnstructuredGrid::SafeDownCast(sweep->GetOutputDataObject(1)));
  const auto size = [](auto* filter) { filter->SetSize(0.3); };
  return { useOf<vtkHarmonicDiskMap>("HarmonicDiskMap", { plate.sourceSurface }),
    useOf<vtkHarmonicDiskMap>("HarmonicDiskMap with partner",
      { plate.sourceSurface, plate.targetSurface, plate.linkingSides }),
    useOf<vtkSweepQuadProjector>("SweepQuadProjector",
      { plate.sourceQuads, plate.targetSurface, plate.linkingSides, plate.sourceSurface }),
    useOf<vtkSweepQuadProjector>(
      "SweepQuadProjector by shape", { plate.sourceQuads, plate.targetSurface }),
    useOf<vtkLinkingSideMesher>("LinkingSideMesher",
      { plate.sourceQuads, plate.linkingSides, plate.targetSurface },
      [](vtkLinkingSideMesher* filter) { filter->SetNumberOfLayers(2); }),
    useOf<vtkCageHexInterior>(
      "CageHexInterior", { plate.sourceQuads, targetQuads, plate.linkingSides }),
    useOf<vtkOneToOneSweep>("OneToOneSweep", { block }, size),
    useOf<vtkManyToManySweep>("ManyToManySweep", { block }, size),
    useOf<vtkAssemblySweep>("AssemblySweep", { pair }, size),
    useOf<vtkSweepCandidates>("SweepCandidates", { block }),
    useOf<vtkSolidFaces>("SolidFaces", { block }), useOf<vtkHexValidity>("HexValidity", { hexes }),
    useOf<vtkSweepSets>("SweepSets", { hexes, boundary }) };
}
}

vtkSmartPointer<vtkAlgorithm> FilterUse::on(
  std::size_t port, const vtkSmartPointer<vtkDataObject>& replacement) const
{
  const vtkSmartPointer<vtkAlgorithm> filter = this->make();
  for (std::size_t p = 0; p < this->inputs.size(); ++p)
  {
    if (vtkDataObject* input = p == port && replacement ? replacement : this->inputs[p])
    {
      filter->SetInputDataObject(static_cast<int>(p), input);
    }
  }
  return filter;
}

const std::vector<FilterUse>& everyFilter()
{
  static const std::vector<FilterUse> uses = makeUses();
  return uses;
}

const FilterUse& filterUse(const std::string& name)
{
  const auto found = std::find_if(everyFilter().begin(), everyFilter().end(),
    [&](const FilterUse& use) { return use.name == name; });
  if (found == everyFilter().end())
  {
    throw std::out_of_range("no use of a filter is called " + name);
  }
  return *found;
}

bool hasOutput(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    auto* table = vtkTable::SafeDownCast(output); // without a row where there is nothing to list
    if ((table && table->GetNumberOfColumns() > 0) ||
      (output && output->GetNumberOfElements(vtkDataObject::CELL) > 0))
    {
      return true;
    }
  }
  return false;
}
}

// SPDX-License-Identifier: BSD-3-Clause

#include "QuadProjection.h"

#include <vtkHarmonicDiskMap.h>

namespace test
{
QuadProjection::QuadProjection(const SweepGrids& sweep)
  : events(filter)
{
  const vtkSmartPointer<vtkUnstructuredGrid> ports[4] = { sweep.sourceQuads, sweep.targetSurface,
    sweep.linkingSides, sweep.sourceSurface };
  for (int port = 0; port < 4; ++port)
  {
    if (ports[port])
    {
      this->filter->SetInputData(port, ports[port]);
    }
  }
}

QuadProjection& QuadProjection::raw()
{
  this->filter->EnsureValidOff();
  this->filter->ImproveQualityOff();
  return *this;
}

vtkUnstructuredGrid* QuadProjection::run()
{
  this->filter->Update();
  EXPECT_TRUE(this->events.errors.empty()) << this->events.errors[0];
  return this->filter->GetOutput();
}

std::map<std::array<double, 3>, std::array<double, 3>> columnEnds(const SweepGrids& sweep)
{
  vtkUnstructuredGrid* linking = sweep.linkingSides;
  // Points that coincide are one.
  std::map<std::array<double, 3>, vtkIdType> numbers;
  std::vector<std::array<double, 3>> places;
  std::vector<Corners> quads;
  for (vtkIdType c = 0; c < linking->GetNumberOfCells(); ++c)
  {
    quads.emplace_back();
    for (const vtkIdType p : cornersOf(linking, c))
    {
      const auto place = pointOf(linking, p);
      const auto known = numbers.emplace(place, static_cast<vtkIdType>(places.size()));
      if (known.second)
      {
        places.push_back(place);
      }
      quads.back().push_back(known.first->second);
    }
  }
  std::map<vtkIdType, std::set<vtkIdType>> neighbors;
  std::map<vtkIdType, std::set<std::size_t>> quadsAt;
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      const vtkIdType a = quads[q][i];
      const vtkIdType b = quads[q][(i + 1) % 4];
      neighbors[a].insert(b);
      neighbors[b].insert(a);
      quadsAt[a].insert(q);
    }
  }
  std::set<vtkIdType> first;
  for (const auto& side : boundaryOf(sweep.sourceQuads))
  {
    const auto found = numbers.find(pointOf(sweep.sourceQuads, side.first));
    EXPECT_NE(found, numbers.end());
    first.insert(found->second);
  }
  std::map<std::array<double, 3>, std::array<double, 3>> ends;
  for (const vtkIdType start : first)
  {
    std::set<vtkIdType> before = first;
    vtkIdType last = -1;
    vtkIdType here = start;
    for (;;)
    {
      // Straight on: no ring-mate of the first ring, no quad in common with where we came from.
      vtkIdType next = -1;
      for (const vtkIdType n : neighbors[here])
      {
        bool straight = !first.count(n);
        if (last >= 0)
        {
          for (const std::size_t q : quadsAt[n])
          {
            straight = straight && !quadsAt[last].count(q);
          }
          straight = straight && n != last;
        }
        next = straight ? n : next;
      }
      if (next < 0)
      {
        break;
      }
      last = here;
      here = next;
    }
    ends[places[static_cast<std::size_t>(start)]] = places[static_cast<std::size_t>(here)];
  }
  return ends;
}

SweepGrids withMaps(const SweepGrids& sweep)
{
  SweepGrids mapped = sweep;
  vtkNew<vtkHarmonicDiskMap> source;
  source->SetInputData(0, sweep.sourceSurface);
  source->SetInputData(1, sweep.targetSurface);
  source->SetInputData(2, sweep.linkingSides);
  source->Update();
  mapped.sourceSurface = source->GetOutput();
  vtkNew<vtkHarmonicDiskMap> target;
  target->SetInputData(0, sweep.targetSurface);
  target->SetInputData(1, sweep.sourceSurface);
  target->SetInputData(2, sweep.linkingSides);
  target->Update();
  mapped.targetSurface = target->GetOutput();
  return mapped;
}
}

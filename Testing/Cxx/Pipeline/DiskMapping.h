// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkHarmonicDiskMap with its messages, and what is true of all its results.
 */
#ifndef DiskMapping_h
#define DiskMapping_h

#include "CapGrids.h"

#include <vtkHarmonicDiskMap.h>

namespace test
{
struct DiskMapping
{
  vtkNew<vtkHarmonicDiskMap> filter;
  Events events;

  explicit DiskMapping(
    vtkDataObject* input, vtkDataObject* partner = nullptr, vtkDataObject* linking = nullptr);

  /// The mapped surface; neither error nor warning is expected.
  vtkUnstructuredGrid* run();
};

std::array<double, 3> diskPoint(vtkDataSet* output, vtkIdType i);

/// Between points of the same number.
double greatestDiskDistance(vtkDataSet* a, vtkDataSet* b);

/// Entry of an array of ids; -2 if there is no such array.
vtkIdType idOf(vtkDataSetAttributes* data, const char* name, vtkIdType i);

/// Every triangle is part of the input cell that it names; original points come first.
void expectOriginals(vtkUnstructuredGrid* output, vtkDataSet* input);
}

#endif

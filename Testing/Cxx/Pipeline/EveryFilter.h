// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Every filter with small inputs, for what must hold of all of them.
 */
#ifndef EveryFilter_h
#define EveryFilter_h

#include "CapGrids.h"

namespace test
{
/// A filter, and inputs on which it succeeds.
struct FilterUse
{
  std::string name;
  std::function<vtkSmartPointer<vtkAlgorithm>()> make;
  std::vector<vtkSmartPointer<vtkDataObject>> inputs; ///< by port; nullptr: nothing is connected

  /// The filter with these inputs, one of them replaced.
  vtkSmartPointer<vtkAlgorithm> on(
    std::size_t port = 0, const vtkSmartPointer<vtkDataObject>& replacement = nullptr) const;
};

const std::vector<FilterUse>& everyFilter();

/// The one of that name. @throw std::out_of_range
const FilterUse& filterUse(const std::string& name);

/// A copy that shares nothing with the data set.
template <typename Data>
vtkSmartPointer<Data> deepCopy(Data* data)
{
  auto copy = vtkSmartPointer<Data>::Take(data->NewInstance());
  copy->DeepCopy(data);
  return copy;
}

/// Whether a filter has an output: with a cell, or a table with columns.
bool hasOutput(vtkAlgorithm* filter);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Memory for VTK's arrays, which end the process where it cannot be had: asked for before.
 * Private to the module.
 */
#ifndef HexSweepMemory_h
#define HexSweepMemory_h

#include "Core/Common/MemoryBudget.h"

#include <vtkAbstractArray.h>
#include <vtkDataObject.h>
#include <vtkDataSetAttributes.h>
#include <vtkType.h>

namespace hexsweep
{
/// array->SetNumberOfTuples(). @throw std::bad_alloc.
template <typename Array>
void setTuples(Array* array, vtkIdType tuples)
{
  requireMemory(static_cast<double>(tuples) * static_cast<double>(array->GetNumberOfComponents()) *
    static_cast<double>(array->GetDataTypeSize()));
  array->SetNumberOfTuples(tuples);
}

/// to->CopyAllocate(). @throw std::bad_alloc.
inline void allocateTuples(vtkDataSetAttributes* from, vtkIdType tuples, vtkDataSetAttributes* to)
{
  double bytes = 0.0;
  for (int a = 0; a < from->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = from->GetAbstractArray(a);
    bytes += static_cast<double>(array->GetNumberOfComponents()) *
      static_cast<double>(array->GetDataTypeSize());
  }
  requireMemory(bytes * static_cast<double>(tuples));
  to->CopyAllocate(from, tuples);
}

/// Asks for some times what a data set takes, before VTK's filters work on it. @throw
/// std::bad_alloc.
inline void requireCopies(vtkDataObject* data, double times)
{
  requireMemory(times * 1024.0 * static_cast<double>(data->GetActualMemorySize()));
}
}

#endif

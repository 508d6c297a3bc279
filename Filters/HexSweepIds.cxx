// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepIds.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkDataArray.h>
#include <vtkVariant.h>

#include <cmath>
#include <limits>

namespace hexsweep
{
WholeNumbers::WholeNumbers(vtkDataArray* array)
  : Array(array)
  , Components(array->GetNumberOfComponents())
  , IsReal(array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE)
  , IsUnsignedLong(
      array->GetDataType() == VTK_UNSIGNED_LONG || array->GetDataType() == VTK_UNSIGNED_LONG_LONG)
{
  if (auto* ints = vtkAOSDataArrayTemplate<int>::FastDownCast(array))
  {
    this->Ints = ints->GetPointer(0);
  }
  else if (auto* longs = vtkAOSDataArrayTemplate<long>::FastDownCast(array))
  {
    this->Longs = longs->GetPointer(0);
  }
  else if (auto* longLongs = vtkAOSDataArrayTemplate<long long>::FastDownCast(array))
  {
    this->LongLongs = longLongs->GetPointer(0);
  }
}

std::optional<Index> WholeNumbers::at(Index tuple) const
{
  const Index value = tuple * this->Components;
  if (this->Ints)
  {
    return this->Ints[value];
  }
  if (this->Longs)
  {
    return this->Longs[value];
  }
  if (this->LongLongs)
  {
    return this->LongLongs[value];
  }
  if (this->IsReal)
  {
    constexpr double Largest = 9007199254740992.0; // 2^53: whole numbers up to here are exact
    const double real = this->Array->GetComponent(tuple, 0);
    return std::abs(real) <= Largest && std::floor(real) == real
      ? std::optional<Index>(static_cast<Index>(real))
      : std::nullopt;
  }
  const vtkVariant number = this->Array->GetVariantValue(value);
  if (this->IsUnsignedLong &&
    number.ToUnsignedLongLong() >
      static_cast<unsigned long long>(std::numeric_limits<Index>::max()))
  {
    return std::nullopt;
  }
  return static_cast<Index>(number.ToLongLong());
}
}

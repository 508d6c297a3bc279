// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Ids in arrays of any number type, exactly. Private to the module.
 */
#ifndef HexSweepIds_h
#define HexSweepIds_h

#include "Core/Common/Mesh.h"

#include <optional>

class vtkDataArray;

namespace hexsweep
{
/**
 * The first component of an array as whole numbers, without the way through double on which those
 * beyond 2^53 are rounded to each other.
 */
class WholeNumbers
{
public:
  /// @param array is kept, not copied.
  explicit WholeNumbers(vtkDataArray* array);

  /// Nothing where the number is not whole (of real numbers: or beyond 2^53, where all are whole)
  /// or does not fit into an Index. @param tuple in the array.
  std::optional<Index> at(Index tuple) const;

  /// The same of a number that is known to be whole.
  Index operator[](Index tuple) const { return *this->at(tuple); }

private:
  vtkDataArray* Array;
  int Components;
  bool IsReal;
  bool IsUnsignedLong;
  const int* Ints = nullptr;
  const long* Longs = nullptr;
  const long long* LongLongs = nullptr;
};
}

#endif

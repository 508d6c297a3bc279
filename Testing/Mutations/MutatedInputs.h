// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Inputs and settings of filters, damaged by chance.
 */
#ifndef MutatedInputs_h
#define MutatedInputs_h

#include "EveryFilter.h"

#include <cstdint>

namespace test
{
/// The source of all chance of one run, which its number decides.
class Chance
{
public:
  explicit Chance(std::uint64_t number);

  /// In [0, count).
  vtkIdType below(vtkIdType count);
  bool oneIn(vtkIdType count) { return this->below(count) == 0; }
  /// In [from, to].
  double real(double from, double to);
  /// A number that programs stumble over.
  double extreme();

private:
  std::mt19937 Generator;
};

/// A filter on inputs of which some are damaged, and with some settings that make no sense.
vtkSmartPointer<vtkAlgorithm> mutatedFilter(const FilterUse& use, Chance& chance);
}

#endif

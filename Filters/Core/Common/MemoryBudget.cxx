// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/MemoryBudget.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace hexsweep
{
namespace
{
/// Of the machine; infinite where it cannot be asked.
double physicalBytes()
{
#if defined(_SC_PHYS_PAGES) && defined(_SC_PAGESIZE)
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long pageSize = sysconf(_SC_PAGESIZE);
  if (pages > 0 && pageSize > 0)
  {
    return static_cast<double>(pages) * static_cast<double>(pageSize);
  }
#endif
  return std::numeric_limits<double>::infinity();
}

bool isGranted(std::size_t bytes)
{
  // Volatile: a block that nobody writes to is not asked for otherwise.
  void* volatile block = std::malloc(bytes);
  const bool granted = block != nullptr;
  std::free(block);
  return granted;
}
}

bool fitsIntoMemory(double bytes)
{
  constexpr double Greatest = static_cast<double>(PTRDIFF_MAX);
  return bytes < std::min(Greatest, physicalBytes()) &&
    isGranted(static_cast<std::size_t>(std::max(bytes, 1.0)));
}

void requireMemory(double bytes)
{
  if (!fitsIntoMemory(bytes))
  {
    throw std::bad_alloc();
  }
}

void checkHexBudget(double hexes, const std::string& mend)
{
  const double bytes = BytesPerHex * hexes;
  if (!fitsIntoMemory(bytes))
  {
    // To three digits: it is an estimate.
    const auto rounded = [](double value) {
      const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
      return describe(std::isfinite(value) && unit > 0.0 ? std::round(value / unit) * unit : value);
    };
    throw InvalidInput("the mesh would have about " + rounded(hexes) + " hexahedra, which take " +
      rounded(bytes / 1e9) + " gigabytes: more than there are. " + mend);
  }
}
}

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Names of sets, each of them different and short enough for a file format.
 */
#ifndef hexsweep_UniqueNames_h
#define hexsweep_UniqueNames_h

#include <cstddef>
#include <string>
#include <vector>

namespace hexsweep
{
/**
 * Appends to every name that another one equals, but for the case of ASCII letters, its own suffix:
 * to all of them, so that no name depends on the order. Those without a suffix stay as they are.
 *
 * @param suffixes as many as names; no two that are not empty are the same.
 * @param longest  bytes that a name may have; longer ones lose their end, before the suffix and
 *                 between two characters of UTF-8.
 */
std::vector<std::string> uniqueNames(const std::vector<std::string>& names,
  const std::vector<std::string>& suffixes, std::size_t longest);
}

#endif

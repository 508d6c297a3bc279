// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whether a mesh fits into memory, before any of it is taken.
 */
#ifndef hexsweep_MemoryBudget_h
#define hexsweep_MemoryBudget_h

#include <string>

namespace hexsweep
{
/// An estimate of what a hexahedron takes where its making needs most, with all arrays and polish.
constexpr double BytesPerHex = 400.0;

/// Whether so many bytes can be had: no more than the machine has, and a block of that size that is
/// asked for (and given back) is granted.
bool fitsIntoMemory(double bytes);

/// Asks for so many bytes and gives them back. @throw std::bad_alloc where they are not to be had.
void requireMemory(double bytes);

/**
 * Refuses a mesh that is too large. Libraries end the program where memory is not to be had in the
 * middle of their work, so that it must be asked for before.
 *
 * @param hexes an estimate; @param mend how to ask for fewer, a sentence or more.
 * @throw InvalidInput with the number of hexahedra and the gigabytes that they take.
 */
void checkHexBudget(double hexes, const std::string& mend);
}

#endif

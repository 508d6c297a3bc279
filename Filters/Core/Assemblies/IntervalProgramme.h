// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whole numbers nearest to wishes that satisfy linear equations.
 *
 * The number of edges on each curve of a model that is to have a structured or a swept mesh:
 * opposite sides of a patch have as many \cite TamArmstrong1993.
 */
#ifndef hexsweep_IntervalProgramme_h
#define hexsweep_IntervalProgramme_h

#include "Core/Common/Mesh.h"

#include <string>
#include <utility>

namespace hexsweep
{
struct IntervalWish
{
  double number = 1.0; ///< wanted, > 0
  Index least = 1;
  Index most = 0;    ///< 0: any number
  bool even = false; ///< only even numbers will do
  bool free = false; ///< any number is as good: it follows from the others
};

/// The sum of the first numbers is that of the second ones.
struct IntervalEquation
{
  std::vector<Index> left; ///< rows of wishes; one that is there twice counts twice
  std::vector<Index> right;
  std::string words; ///< what it is about: "opposite sides of face 3"
};

struct IntervalProgramme
{
  std::vector<IntervalWish> wishes;
  std::vector<IntervalEquation> equations;
};

/**
 * Minimises the sum of the numbers' differences from the wishes, each over the wish.
 *
 * Numbers that must be equal are contracted first; what is left without an equation takes the
 * weighted median of its wishes, everything else is an integer programme, solved by branch and cut
 * (COIN-OR Cbc) within a number of nodes that depends on its size alone.
 *
 * @return one number a wish.
 * @throw InvalidInput for a wish of more than 10^9; where there are no such numbers, with the words
 * of a smallest set of equations that contradict each other; where a programme is left and HexSweep
 * was built without Cbc.
 */
std::vector<Index> solveIntervals(const IntervalProgramme& programme);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sets of numbers that are joined step by step.
 */
#ifndef hexsweep_DisjointSets_h
#define hexsweep_DisjointSets_h

#include "Core/Common/Mesh.h"

#include <algorithm>
#include <numeric>

namespace hexsweep
{
/**
 * Partition of the numbers from 0 to size - 1 (union-find), at first each one by itself.
 *
 * A set goes by its smallest member, whatever the order in which it was joined.
 */
class DisjointSets
{
public:
  explicit DisjointSets(Index size)
    : Parent(static_cast<std::size_t>(size))
  {
    std::iota(this->Parent.begin(), this->Parent.end(), Index(0));
  }

  /// The smallest member of the set that i is in.
  Index find(Index i)
  {
    while (this->at(i) != i)
    {
      this->at(i) = this->at(this->at(i));
      i = this->at(i);
    }
    return i;
  }

  void join(Index a, Index b)
  {
    a = this->find(a);
    b = this->find(b);
    this->at(std::max(a, b)) = std::min(a, b);
  }

private:
  Index& at(Index i) { return this->Parent[static_cast<std::size_t>(i)]; }
  std::vector<Index> Parent;
};
}

#endif

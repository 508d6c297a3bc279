// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The sides of faces, sorted so that those of one edge stand next to each other.
 */
#ifndef hexsweep_FaceSides_h
#define hexsweep_FaceSides_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// The side of a face that runs from corner `corner` to the next one; one entry a face of an edge.
struct FaceSide
{
  Index low;  ///< the lower of the two point ids
  Index high; ///< the higher one (the same where a collapsed face repeats it)
  Index face;
  Index corner;
  bool forward; ///< runs from low to high
};

/**
 * All sides, by lower point, then higher, face, corner.
 *
 * @param faces m x 3 or m x 4 point ids in [0, numberOfPoints).
 * @return one entry a face and corner.
 */
std::vector<FaceSide> sortedSides(const FacesRef& faces, Index numberOfPoints);

/// Calls visit(first, last) for each edge: sides[first] to sides[last - 1] are its sides.
template <typename Visit>
void forEachEdge(const std::vector<FaceSide>& sides, Visit visit)
{
  for (std::size_t first = 0; first < sides.size();)
  {
    std::size_t last = first + 1;
    while (last < sides.size() && sides[last].low == sides[first].low &&
      sides[last].high == sides[first].high)
    {
      ++last;
    }
    visit(first, last);
    first = last;
  }
}

/// Ids of the points on edges with one side, rising, each once.
std::vector<Index> boundaryPoints(const std::vector<FaceSide>& sides);
}

#endif

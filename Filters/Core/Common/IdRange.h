// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Checks that the ids of a mesh are those of points.
 */
#ifndef hexsweep_IdRange_h
#define hexsweep_IdRange_h

#include "Core/Common/Mesh.h"

#include <string>

namespace hexsweep
{
/**
 * @param cells  one a row.
 * @param points how many there are.
 * @param what   a cell in messages, e.g. "hexahedron".
 * @throw InvalidInput naming the first row with an id that is not in [0, points).
 */
void checkIds(const FacesRef& cells, Index points, const std::string& what);
}

#endif

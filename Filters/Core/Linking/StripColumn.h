// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief CAD edges as columns of a linking side.
 */
#ifndef hexsweep_StripColumn_h
#define hexsweep_StripColumn_h

#include "Core/Common/Mesh.h"

namespace hexsweep
{
/// A CAD edge that leads from the source loop to the target loop.
struct StripColumn
{
  std::vector<Index> points; ///< from source to target
  std::vector<double> u;     ///< of each point: its height in the strip, rising from 0 to 1
  double v = 0.0;
};
}

#endif

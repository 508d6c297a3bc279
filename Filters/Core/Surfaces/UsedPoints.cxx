// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/UsedPoints.h"

namespace hexsweep
{
std::vector<bool> usedPoints(const FacesRef& faces, Index numberOfPoints)
{
  std::vector<bool> used(static_cast<std::size_t>(numberOfPoints), false);
  for (Index f = 0; f < faces.rows(); ++f)
  {
    for (Index c = 0; c < faces.cols(); ++c)
    {
      used[static_cast<std::size_t>(faces(f, c))] = true;
    }
  }
  return used;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/IdRange.h"

#include "Core/Common/Errors.h"

namespace hexsweep
{
void checkIds(const FacesRef& cells, Index points, const std::string& what)
{
  // Nearly always all is well: one pass over the whole first.
  if (cells.size() == 0 || (cells.minCoeff() >= 0 && cells.maxCoeff() < points))
  {
    return;
  }
  for (Index row = 0; row < cells.rows(); ++row)
  {
    for (Index corner = 0; corner < cells.cols(); ++corner)
    {
      const Index id = cells(row, corner);
      if (id < 0 || id >= points)
      {
        throw InvalidInput(what + " " + std::to_string(row) + " has the point " +
          std::to_string(id) + " as a corner, and there are " + std::to_string(points) +
          " points, numbered from 0. Ids are rows of the points.");
      }
    }
  }
}
}

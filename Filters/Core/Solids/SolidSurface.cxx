// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SolidSurface.h"

#include <algorithm>

namespace hexsweep
{
std::vector<Index> facesOfTriangles(const SolidSurface& solid, const std::vector<Index>& triangles)
{
  std::vector<Index> ids;
  for (const Index t : triangles)
  {
    const Index id = solid.faceIds[static_cast<std::size_t>(t)];
    if (ids.empty() || ids.back() != id)
    {
      ids.push_back(id);
    }
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::vector<Index> trianglesOfFaces(const SolidSurface& solid, const std::vector<Index>& faceIds)
{
  std::vector<Index> wanted = faceIds;
  std::sort(wanted.begin(), wanted.end());
  std::vector<Index> triangles;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    if (std::binary_search(
          wanted.begin(), wanted.end(), solid.faceIds[static_cast<std::size_t>(t)]))
    {
      triangles.push_back(t);
    }
  }
  return triangles;
}
}

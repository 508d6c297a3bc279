// SPDX-License-Identifier: BSD-3-Clause
#include "Core/CapQuads/MidpointSubdivision.h"

#include <algorithm>

namespace hexsweep
{
SubdividedFaces subdivideAtMidpoints(
  const PointsRef& points, const QuadsRef& quads, const TrianglesRef& triangles)
{
  SubdividedFaces result;
  const auto forEachFace = [&](const auto& visit) {
    for (Index q = 0; q < quads.rows(); ++q)
    {
      visit(quads.row(q).data(), Index{ 4 });
    }
    for (Index t = 0; t < triangles.rows(); ++t)
    {
      visit(triangles.row(t).data(), Index{ 3 });
    }
  };
  auto& edges = result.edges;
  forEachFace([&](const Index* face, Index corners) {
    for (Index c = 0; c < corners; ++c)
    {
      edges.push_back(std::minmax(face[c], face[(c + 1) % corners]));
    }
  });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  const Index given = points.rows();
  const Index firstFace = given + static_cast<Index>(edges.size());
  result.mesh.points.resize(firstFace + quads.rows() + triangles.rows(), 3);
  result.mesh.points.topRows(given) = points;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    result.mesh.points.row(given + static_cast<Index>(e)) =
      0.5 * (points.row(edges[e].first) + points.row(edges[e].second));
  }
  const auto middle = [&](Index a, Index b) {
    const std::pair<Index, Index> edge = std::minmax(a, b);
    return given + (std::lower_bound(edges.begin(), edges.end(), edge) - edges.begin());
  };
  result.mesh.quads.resize(4 * quads.rows() + 3 * triangles.rows(), 4);
  Index quad = 0;
  Index center = firstFace;
  forEachFace([&](const Index* face, Index corners) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (Index c = 0; c < corners; ++c)
    {
      sum += points.row(face[c]);
      result.mesh.quads.row(quad++) << face[c], middle(face[c], face[(c + 1) % corners]), center,
        middle(face[(c + corners - 1) % corners], face[c]);
    }
    result.mesh.points.row(center++) = sum / static_cast<double>(corners);
  });
  return result;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/FaceGrid.h"

#include "Core/Assemblies/FaceRims.h"
#include "Core/Assemblies/PolygonGrid.h"
#include "Core/Assemblies/TubeGrid.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
void meshQuadrilateral(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const SideFace& side, AssemblyMesh& mesh)
{
  // Chains run round the face: bottom to the right, up, top to the left, down.
  const FaceRim bottom = faceRim(mesh, side.chains[0], false);
  const FaceRim right = faceRim(mesh, side.chains[1], false);
  const FaceRim top = faceRim(mesh, side.chains[2], true);
  const FaceRim left = faceRim(mesh, side.chains[3], true);
  const Index n = static_cast<Index>(bottom.nodes.size()) - 1;
  const Index m = static_cast<Index>(left.nodes.size()) - 1;
  if (top.nodes.size() != bottom.nodes.size() || right.nodes.size() != left.nodes.size())
  {
    throw InvalidInput(nameOf(complex.faces[at(side.face)]) +
      " has different numbers of edges on opposite sides: " + std::to_string(n) + " and " +
      std::to_string(top.nodes.size() - 1) + ", " + std::to_string(m) + " and " +
      std::to_string(right.nodes.size() - 1) + ".");
  }
  const FaceProjection project(complex, geometry, side.face);
  NodeGrid grid(m + 1, n + 1);
  const auto corner = [&](const FaceRim& rim, bool last) {
    return rim.places.row(last ? rim.places.rows() - 1 : 0);
  };
  for (Index k = 0; k <= m; ++k)
  {
    for (Index j = 0; j <= n; ++j)
    {
      if (k == 0 || k == m)
      {
        grid(k, j) = (k == 0 ? bottom : top).nodes[at(j)];
        continue;
      }
      if (j == 0 || j == n)
      {
        grid(k, j) = (j == 0 ? left : right).nodes[at(k)];
        continue;
      }
      // Where the lines between the chains' fractions cross.
      const double a = bottom.fractions[at(j)];
      const double b = top.fractions[at(j)] - a;
      const double c = left.fractions[at(k)];
      const double d = right.fractions[at(k)] - c;
      const double s = (a + c * b) / (1.0 - b * d);
      const double t = c + s * d;
      const Eigen::RowVector3d place = (1.0 - t) * bottom.places.row(j) + t * top.places.row(j) +
        (1.0 - s) * left.places.row(k) + s * right.places.row(k) -
        (1.0 - s) * (1.0 - t) * corner(bottom, false) - s * (1.0 - t) * corner(bottom, true) -
        (1.0 - s) * t * corner(top, false) - s * t * corner(top, true);
      const double reach = std::max((bottom.places.row(j) - bottom.places.row(j - 1)).norm(),
        (left.places.row(k) - left.places.row(k - 1)).norm());
      grid(k, j) = mesh.nodes.add(project(place, reach));
    }
  }
  mesh.faces[at(side.face)] = gridQuads(grid, false);
}
}

void meshSideFace(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const SideFace& side, const AssemblyIntervals& intervals, AssemblyMesh& mesh)
{
  const Index begin = mesh.nodes.size();
  if (side.isTube())
  {
    meshTube(complex, geometry, side, intervals.tubeLayers[at(side.face)], mesh);
  }
  else if (side.isPolygon())
  {
    meshPolygon(complex, geometry, side, intervals.inside[at(side.face)], mesh);
  }
  else
  {
    meshQuadrilateral(complex, geometry, side, mesh);
  }
  mesh.blocks.push_back({ side.face, begin, mesh.nodes.size() - begin });
}
}

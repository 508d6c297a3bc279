// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Cap.h"

#include "Core/Surfaces/SurfaceTopology.h"

namespace hexsweep
{
Cap makeCap(TriangleMesh mesh, const std::string& what)
{
  mesh.triangles = orientFaces(mesh.triangles, what);
  SurfaceTopology topology = checkSurface(mesh.triangles, mesh.points.rows(), what);
  checkCap(topology, what);
  return { std::move(mesh), std::move(topology.loops) };
}
}

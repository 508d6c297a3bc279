// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangulations of the plane in coordinates that integers take exactly.
 */
#ifndef PlaneMeshes_h
#define PlaneMeshes_h

#include "Core/Common/Mesh.h"

#include <vector>

namespace test
{
using hexsweep::Index;
using hexsweep::PlanePoints;
using hexsweep::TriangleMesh;
using hexsweep::Triangles;

/// Coordinates of meshes are multiples of 2 / GridSteps and those of points of 1 / GridSteps:
/// half-way between two of them lies such a point.
constexpr double GridSteps = 1 << 22;

struct PlaneMesh
{
  PlanePoints points;
  Triangles triangles;
};

/// To multiples of a step.
PlanePoints rounded(const PlanePoints& points, double step);

/// The mesh seen from above, its coordinates rounded.
PlaneMesh onGrid(const TriangleMesh& mesh);

/// Points and triangles by chance; row t of the result is row origin[t] of the mesh.
struct ShuffledMesh
{
  PlaneMesh mesh;
  std::vector<Index> origin;
};

ShuffledMesh shuffled(const PlaneMesh& mesh, unsigned seed);
}

#endif

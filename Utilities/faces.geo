// SPDX-License-Identifier: BSD-3-Clause
// Lets gmsh write the number of its CAD face with each triangle (CellEntityIds in .vtk files).
s() = Surface{:};
For i In {0 : #s() - 1}
  Physical Surface(s(i)) = {s(i)};
EndFor
// At least 24 edges round a full circle: facets must not be coarser than the quads.
Mesh.MeshSizeFromCurvature = 24;

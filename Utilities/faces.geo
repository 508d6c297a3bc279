// SPDX-License-Identifier: BSD-3-Clause
// Lets gmsh write the number of its CAD face with each triangle (CellEntityIds in .vtk files).
s() = Surface{:};
For i In {0 : #s() - 1}
  Physical Surface(s(i)) = {s(i)};
EndFor

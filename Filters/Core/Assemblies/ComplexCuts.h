// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief New points on edges of an assembly's triangles.
 */
#ifndef hexsweep_ComplexCuts_h
#define hexsweep_ComplexCuts_h

#include "Core/Assemblies/AssemblyComplex.h"

#include <array>
#include <map>
#include <utility>

namespace hexsweep
{
/// New points on edges, from the lower end of each on.
using CutEdges = std::map<std::pair<Index, Index>, std::vector<Index>>;

/// The triangles of a complex while some are replaced.
class TriangleList
{
public:
  void add(const std::array<Index, 3>& triangle, Index face)
  {
    this->Corners.push_back(triangle);
    this->FaceOf.push_back(face);
  }
  /// A triangle, in pieces where its edges are cut.
  void addCut(const std::array<Index, 3>& triangle, Index face, const CutEdges& cut);
  /// Gives these triangles to a complex in place of its own, and traces its curves.
  void moveTo(AssemblyComplex& complex);

private:
  std::vector<std::array<Index, 3>> Corners;
  std::vector<Index> FaceOf;
};

/// Cuts all triangles at new points of their edges.
void cutTriangles(const CutEdges& cut, AssemblyComplex& complex);
}

#endif

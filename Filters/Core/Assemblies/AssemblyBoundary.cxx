// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblyBoundary.h"

#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <map>
#include <utility>

namespace hexsweep
{
namespace
{
/// Corners of the sides of VTK_HEXAHEDRON, in the order of Exodus II.
constexpr std::array<std::array<int, 4>, 6> HexSides = { { { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
  { 2, 3, 7, 6 }, { 3, 0, 4, 7 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } } };

std::array<Index, 4> sorted(std::array<Index, 4> nodes)
{
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// The sides of a volume's hexahedra all of whose nodes lie on faces of the assembly.
std::map<std::array<Index, 4>, HexAtQuad> outerSides(
  const SweptVolume& volume, Index row, Index boundaryNodes)
{
  std::map<std::array<Index, 4>, HexAtQuad> sides;
  const Hexes& hexes = volume.hexes.hexes;
  for (Index h = 0; h < hexes.rows(); ++h)
  {
    for (std::size_t s = 0; s < HexSides.size(); ++s)
    {
      std::array<Index, 4> nodes{};
      for (std::size_t c = 0; c < 4; ++c)
      {
        nodes[c] = volume.nodes[at(hexes(h, HexSides[s][c]))];
      }
      if (*std::max_element(nodes.begin(), nodes.end()) < boundaryNodes)
      {
        sides[sorted(nodes)] = { row, h, static_cast<int>(s) + 1 };
      }
    }
  }
  return sides;
}
}

std::vector<AssemblyQuad> assemblyBoundary(const AssemblySweep& sweep)
{
  std::vector<AssemblyQuad> result;
  std::vector<std::size_t> begins;
  for (std::size_t f = 0; f < sweep.boundary.faces.size(); ++f)
  {
    begins.push_back(result.size());
    const Quads& quads = sweep.boundary.faces[f];
    for (Index q = 0; q < quads.rows(); ++q)
    {
      result.push_back(
        { { quads(q, 0), quads(q, 1), quads(q, 2), quads(q, 3) }, static_cast<Index>(f), {} });
    }
  }
  begins.push_back(result.size());
  for (std::size_t v = 0; v < sweep.volumes.size(); ++v)
  {
    const Index row = static_cast<Index>(v);
    const auto sides = outerSides(sweep.volumes[v], row, sweep.boundary.nodes.size());
    for (const Index face : sweep.planned.complex.volumes[v].faces)
    {
      const std::size_t place =
        sweep.planned.complex.faces[at(face)].volumes.front() == row ? 0 : 1;
      for (std::size_t q = begins[at(face)]; q < begins[at(face) + 1]; ++q)
      {
        const auto found = sides.find(sorted(result[q].nodes));
        if (found != sides.end())
        {
          result[q].hexes[place] = found->second;
        }
      }
    }
  }
  return result;
}
}

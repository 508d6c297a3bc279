// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblyMesh.h"

#include "Core/CapQuads/CapCurves.h"
#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <map>
#include <utility>

namespace hexsweep
{
namespace
{
/// Of the edges beside it: no node moves farther to reach a CAD edge.
constexpr double FarthestEdge = 0.5;
/// Of the same: a vertex this near to a CAD edge is on it.
constexpr double OnEdge = 1e-7;

/// Where each vertex belongs: borders that were cut have vertices on chords of CAD edges.
std::map<Index, Eigen::RowVector3d> placesOfVertices(const AssemblyComplex& complex,
  const AssemblyGeometry& geometry, const std::vector<Index>& counts)
{
  struct Nearest
  {
    Eigen::RowVector3d place;
    double distance;
  };
  std::map<Index, Nearest> nearest;
  for (std::size_t c = 0; c < complex.curves.size(); ++c)
  {
    const ComplexCurve& curve = complex.curves[c];
    const double spacing = lengthOf(complex, curve) / static_cast<double>(counts[c]);
    for (const Index point : { curve.points.front(), curve.points.back() })
    {
      const Eigen::RowVector3d given = complex.points.row(point);
      Nearest& own =
        nearest.try_emplace(point, Nearest{ given, FarthestEdge * spacing }).first->second;
      const std::optional<Eigen::RowVector3d> found = geometry.onEdge(static_cast<Index>(c), given);
      const double distance = found ? (*found - given).norm() : own.distance;
      if (distance < own.distance)
      {
        own = { distance > OnEdge * spacing ? *found : given, distance };
      }
    }
  }
  std::map<Index, Eigen::RowVector3d> places;
  for (const auto& [point, own] : nearest)
  {
    places[point] = own.place;
  }
  return places;
}
}

Points NodeTable::placesOf(const std::vector<Index>& nodes) const
{
  Points places(static_cast<Index>(nodes.size()), 3);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    places.row(static_cast<Index>(i)) = (*this)[nodes[i]];
  }
  return places;
}

AssemblyMesh divideCurves(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const std::vector<Index>& counts)
{
  AssemblyMesh mesh;
  mesh.faces.assign(complex.faces.size(), Quads(0, 4));
  const std::map<Index, Eigen::RowVector3d> places = placesOfVertices(complex, geometry, counts);
  std::map<Index, Index> nodeOfVertex;
  const auto vertex = [&](Index point) {
    const auto [known, isNew] = nodeOfVertex.try_emplace(point, mesh.nodes.size());
    if (isNew)
    {
      mesh.nodes.add(places.at(point));
    }
    return known->second;
  };
  for (std::size_t c = 0; c < complex.curves.size(); ++c)
  {
    const ComplexCurve& curve = complex.curves[c];
    const ArcLengthChain chain(placesOf(complex, curve));
    const Index count = counts[c];
    MeshedCurve divided;
    for (Index k = 0; k <= count; ++k)
    {
      const double fraction = static_cast<double>(k) / static_cast<double>(count);
      divided.fractions.push_back(fraction);
      if (k == 0 || k == count)
      {
        divided.nodes.push_back(vertex(k == 0 ? curve.points.front() : curve.points.back()));
        continue;
      }
      Eigen::RowVector3d place = chain.at(fraction * chain.length());
      const std::optional<Eigen::RowVector3d> onEdge =
        geometry.onCurve(static_cast<Index>(c), place);
      const double spacing = chain.length() / static_cast<double>(count);
      if (onEdge && (*onEdge - place).norm() < FarthestEdge * spacing)
      {
        place = *onEdge;
      }
      divided.nodes.push_back(mesh.nodes.add(place));
    }
    mesh.curves.push_back(std::move(divided));
  }
  mesh.curveNodes = mesh.nodes.size();
  return mesh;
}

std::vector<Index> nodesAlong(const AssemblyMesh& mesh, const std::vector<CurveUse>& chain)
{
  std::vector<Index> nodes;
  for (const CurveUse& use : chain)
  {
    std::vector<Index> own = mesh.curves[at(use.curve)].nodes;
    if (use.reversed)
    {
      std::reverse(own.begin(), own.end());
    }
    nodes.insert(nodes.end(), own.begin() + (nodes.empty() ? 0 : 1), own.end());
  }
  if (nodes.size() > 1 && nodes.front() == nodes.back())
  {
    nodes.pop_back();
  }
  return nodes;
}
}

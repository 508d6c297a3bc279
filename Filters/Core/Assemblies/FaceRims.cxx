// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/FaceRims.h"

#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <optional>

namespace hexsweep
{
namespace
{
/// Fractions of the length that is passed at each place of a chain.
std::vector<double> passed(const Points& places)
{
  std::vector<double> fractions(1, 0.0);
  for (Index k = 1; k < places.rows(); ++k)
  {
    fractions.push_back(fractions.back() + (places.row(k) - places.row(k - 1)).norm());
  }
  const double length = fractions.back();
  for (double& fraction : fractions)
  {
    fraction /= length;
  }
  return fractions;
}
}

std::string nameOf(const ComplexFace& face)
{
  return "face " + std::to_string(face.id);
}

FaceRim faceRim(const AssemblyMesh& mesh, const std::vector<CurveUse>& chain, bool backwards)
{
  FaceRim rim;
  rim.nodes = nodesAlong(mesh, chain);
  if (backwards)
  {
    std::reverse(rim.nodes.begin(), rim.nodes.end());
  }
  rim.places = mesh.nodes.placesOf(rim.nodes);
  rim.fractions = passed(rim.places);
  return rim;
}

FaceProjection::FaceProjection(
  const AssemblyComplex& complex, const AssemblyGeometry& geometry, Index face)
  : Geometry(geometry)
  , Face(face)
  , Surface(meshOfFaces(complex, complex.faces[at(face)].volumes.front(), { face }))
{
}

double FaceProjection::distance(const Eigen::RowVector3d& place) const
{
  return (this->Surface.project(place, -1).point - place).norm();
}

Eigen::RowVector3d FaceProjection::operator()(const Eigen::RowVector3d& place, double reach) const
{
  const Eigen::RowVector3d near = this->Surface.project(place, -1).point;
  const std::optional<Eigen::RowVector3d> exact = this->Geometry.onFace(this->Face, near);
  return exact && (*exact - near).norm() < reach ? *exact : near;
}

Quads gridQuads(const NodeGrid& grid, bool closed)
{
  const Index columns = grid.cols() - (closed ? 0 : 1);
  Quads quads((grid.rows() - 1) * columns, 4);
  for (Index k = 0; k + 1 < grid.rows(); ++k)
  {
    for (Index j = 0; j < columns; ++j)
    {
      const Index next = (j + 1) % grid.cols();
      quads.row(k * columns + j) << grid(k, j), grid(k, next), grid(k + 1, next), grid(k + 1, j);
    }
  }
  return quads;
}
}

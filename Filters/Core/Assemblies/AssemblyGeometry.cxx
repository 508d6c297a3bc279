// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblyGeometry.h"

#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <utility>

namespace hexsweep
{
AssemblyGeometry::AssemblyGeometry(const AssemblyComplex& complex, Solids solids)
  : Complex(complex)
  , OfVolumes(std::move(solids))
{
}

const ModelGeometry* AssemblyGeometry::of(Index volume) const
{
  return this->OfVolumes.empty() ? nullptr : this->OfVolumes[at(volume)].get();
}

std::vector<AssemblyGeometry::VolumeEdge> AssemblyGeometry::edgesBetween(
  const ComplexFace& one, const ComplexFace& other) const
{
  std::vector<VolumeEdge> edges;
  for (const Index volume : one.volumes)
  {
    const ModelGeometry* const geometry = this->of(volume);
    for (const Index otherVolume : other.volumes)
    {
      // Pieces of one solid have one geometry; parts of one face meet at no edge of it.
      if (!geometry || this->of(otherVolume) != geometry ||
        one.idIn(volume) == other.idIn(otherVolume))
      {
        continue;
      }
      for (const Index edge : geometry->edgesBetween(one.idIn(volume), other.idIn(otherVolume)))
      {
        edges.push_back({ volume, edge });
      }
    }
  }
  return edges;
}

std::optional<Eigen::RowVector3d> AssemblyGeometry::onFace(
  Index face, const Eigen::RowVector3d& place) const
{
  const ComplexFace& own = this->Complex.faces[at(face)];
  const ModelGeometry* const geometry = this->of(own.volumes.front());
  return geometry ? geometry->closestOnFace(own.id, place) : std::nullopt;
}

std::optional<Eigen::RowVector3d> AssemblyGeometry::onEdge(
  Index curve, const Eigen::RowVector3d& place) const
{
  std::optional<Eigen::RowVector3d> best;
  const std::vector<Index>& faces = this->Complex.curves[at(curve)].faces;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (std::size_t j = i + 1; j < faces.size(); ++j)
    {
      const ComplexFace& one = this->Complex.faces[at(faces[i])];
      const ComplexFace& other = this->Complex.faces[at(faces[j])];
      for (const VolumeEdge& edge : this->edgesBetween(one, other))
      {
        const std::optional<Eigen::RowVector3d> found =
          this->of(edge.volume)->closestOnEdge(edge.id, place);
        if (found && (!best || (*found - place).norm() < (*best - place).norm()))
        {
          best = found;
        }
      }
    }
  }
  return best;
}

std::optional<Eigen::RowVector3d> AssemblyGeometry::onCurve(
  Index curve, const Eigen::RowVector3d& place) const
{
  if (std::optional<Eigen::RowVector3d> edge = this->onEdge(curve, place))
  {
    return edge;
  }
  const std::vector<Index>& faces = this->Complex.curves[at(curve)].faces;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (std::size_t j = i + 1; j < faces.size(); ++j)
    {
      // The face was cut: the curve lies on it and on no CAD edge.
      if (this->Complex.faces[at(faces[i])].id == this->Complex.faces[at(faces[j])].id)
      {
        return this->onFace(faces[i], place);
      }
    }
  }
  return std::nullopt;
}
}

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The true surfaces of an assembly, by the rows of its complex.
 */
#ifndef hexsweep_AssemblyGeometry_h
#define hexsweep_AssemblyGeometry_h

#include "Core/Assemblies/AssemblyComplex.h"
#include "Core/Geometry/ModelGeometry.h"

#include <memory>
#include <optional>

namespace hexsweep
{
/// Asks the geometry of a volume that has the face or curve. Without geometry it finds nothing.
class AssemblyGeometry
{
public:
  using Solids = std::vector<std::shared_ptr<const ModelGeometry>>;

  /// @param complex must outlive this. @param solids one a volume, nullptr where it is not known;
  /// or empty.
  AssemblyGeometry(const AssemblyComplex& complex, Solids solids);

  /// The point of a face nearest to a place, see ModelGeometry::closestOnFace().
  std::optional<Eigen::RowVector3d> onFace(Index face, const Eigen::RowVector3d& place) const;

  /// The point of the CAD edges behind a curve nearest to a place.
  std::optional<Eigen::RowVector3d> onCurve(Index curve, const Eigen::RowVector3d& place) const;

  /// The same, of curves that are (on) CAD edges alone.
  std::optional<Eigen::RowVector3d> onEdge(Index curve, const Eigen::RowVector3d& place) const;

private:
  struct VolumeEdge
  {
    Index volume;
    Index id;
  };
  std::vector<VolumeEdge> edgesBetween(const ComplexFace& one, const ComplexFace& other) const;
  const ModelGeometry* of(Index volume) const;

  const AssemblyComplex& Complex;
  Solids OfVolumes;
};
}

#endif

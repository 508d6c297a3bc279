// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One solid of a CAD model as Core's ModelGeometry. Private to the module.
 */
#ifndef HexSweepCADGeometry_h
#define HexSweepCADGeometry_h

#include "Core/Geometry/ModelGeometry.h"
#include "HexSweepCADSurface.h"

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include <map>
#include <mutex>
#include <utility>

namespace hexsweep
{
/// A solid and the ids of its parts.
struct NumberedSolid
{
  TopoDS_Shape shape;
  std::vector<Index> faceIds; ///< by number of TopExp::MapShapes() - 1
  std::vector<Index> edgeIds; ///< likewise; 0: an edge without length
};

class CADGeometry : public ModelGeometry
{
public:
  /// @throw InvalidInput when the ids do not belong to the shape.
  explicit CADGeometry(NumberedSolid solid);

  std::optional<Eigen::RowVector3d> closestOnFace(
    Index faceId, const Eigen::RowVector3d& place) const override;
  std::optional<Eigen::RowVector3d> normalOnFace(
    Index faceId, const Eigen::RowVector3d& place) const override;
  std::string surfaceType(Index faceId) const override;
  std::vector<Index> edgesBetween(Index faceId, Index otherFaceId) const override;
  std::optional<Eigen::RowVector3d> closestOnEdge(
    Index edgeId, const Eigen::RowVector3d& place) const override;
  Points endsOfEdge(Index edgeId) const override;
  std::optional<ModelFacets> facets(
    double deflection, double angle, const Progress& progress) const override;

  const NumberedSolid& solid() const { return this->Solid; }

private:
  const CADSurface* surface(Index faceId) const;
  const CADCurve* curve(Index edgeId) const;

  NumberedSolid Solid;
  double Scale = 0.0;
  std::map<Index, CADSurface> Surfaces;
  std::map<Index, CADCurve> Curves;
  std::map<std::pair<Index, Index>, std::vector<Index>> Between;
};
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/ReflectedGeometry.h"

#include <utility>

namespace hexsweep
{
namespace
{
using Place = Eigen::RowVector3d;

class ReflectedGeometry : public ModelGeometry
{
public:
  ReflectedGeometry(std::shared_ptr<const ModelGeometry> geometry, const Reflection& reflection)
    : Geometry(std::move(geometry))
    , Mirror(reflection)
  {
  }

  std::optional<Place> closestOnFace(Index faceId, const Place& place) const override
  {
    return this->turned(this->Geometry->closestOnFace(faceId, this->turned(place)));
  }

  std::optional<Place> normalOnFace(Index faceId, const Place& place) const override
  {
    return this->turned(this->Geometry->normalOnFace(faceId, this->turned(place)));
  }

  std::string surfaceType(Index faceId) const override
  {
    return this->Geometry->surfaceType(faceId);
  }

  std::vector<Index> edgesBetween(Index faceId, Index otherFaceId) const override
  {
    return this->Geometry->edgesBetween(faceId, otherFaceId);
  }

  std::optional<Place> closestOnEdge(Index edgeId, const Place& place) const override
  {
    return this->turned(this->Geometry->closestOnEdge(edgeId, this->turned(place)));
  }

  Points endsOfEdge(Index edgeId) const override
  {
    return reflected(this->Geometry->endsOfEdge(edgeId), this->Mirror);
  }

  std::optional<ModelFacets> facets(
    double deflection, double angle, const Progress& progress) const override
  {
    std::optional<ModelFacets> facets = this->Geometry->facets(deflection, angle, progress);
    if (facets)
    {
      facets->points = reflected(std::move(facets->points), this->Mirror);
      if (this->Mirror.turnsOver())
      {
        facets->triangles.col(1).swap(facets->triangles.col(2));
      }
    }
    return facets;
  }

private:
  Place turned(const Place& place) const { return place.cwiseProduct(this->Mirror.signs); }

  std::optional<Place> turned(const std::optional<Place>& place) const
  {
    return place ? std::optional<Place>(this->turned(*place)) : std::nullopt;
  }

  std::shared_ptr<const ModelGeometry> Geometry;
  Reflection Mirror;
};
}

std::shared_ptr<const ModelGeometry> reflectedGeometry(
  std::shared_ptr<const ModelGeometry> geometry, const Reflection& reflection)
{
  if (!geometry || (reflection.signs.array() > 0.0).all())
  {
    return geometry;
  }
  return std::make_shared<const ReflectedGeometry>(std::move(geometry), reflection);
}
}

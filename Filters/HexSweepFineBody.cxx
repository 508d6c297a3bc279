// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepFineBody.h"

#include "Core/CapQuads/CapMeshing.h"
#include "Core/Common/Constants.h"
#include "Core/Solids/SolidInput.h"
#include "Core/Surfaces/SurfacePart.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
/// Of the size of the hexahedra.
constexpr double Deflection = 0.01;
constexpr double Angle = Pi / 15.0;
/// Of the size of the solid: finer facets are more than a sweep needs.
constexpr double LeastDeflection = 1e-7;
/// Of the size of the solid: points that are further off were moved.
constexpr double OffGeometry = 1e-4;
constexpr Index Looked = 200; ///< triangles, for that

double sizeOf(const Points& points)
{
  return (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}
}

std::optional<ReadBody> refinedBody(const ReadBody& body, double size, double chordTolerance,
  bool partTouching, const Progress& progress)
{
  // An edge of the quads turns by eight times this.
  const double angle = chordTolerance > 0.0 ? std::min(Angle, 4.0 * chordTolerance) : Angle;
  const double deflection =
    std::max(Deflection * size, LeastDeflection * sizeOf(body.surface.points));
  try
  {
    std::optional<ModelFacets> facets = body.geometry->facets(deflection, angle, progress);
    if (!facets)
    {
      return std::nullopt;
    }
    ReadBody result;
    result.volumeId = body.volumeId;
    result.name = body.name;
    result.geometry = body.geometry;
    SolidInput input;
    input.points = std::move(facets->points);
    input.triangles = std::move(facets->triangles);
    input.faceIds = std::move(facets->faceIds);
    result.solid = canonicalSolid(input, Reflection());
    // They were made where the body had been put already.
    result.solid.reflection = body.solid.reflection;
    SolidOptions options;
    options.featureAngle = body.surface.featureAngle;
    options.partTouching = partTouching;
    result.surface = makeSolidSurface(result.solid.input, options);
    return result;
  }
  catch (const InvalidInput&)
  {
    return std::nullopt;
  }
}

std::optional<FineBody> fineBody(const ReadBody& body, const SweepTopology& topology, double size,
  double chordTolerance, const Progress& progress)
{
  if (body.solid.input.quads.rows() > 0)
  {
    return std::nullopt;
  }
  const SolidSurface& coarse = body.surface;
  try
  {
    if (!(size > 0.0) || !std::isfinite(size))
    {
      size = defaultQuadSize(
        surfacePart(coarse.points, coarse.triangles, topology.sourceTriangles).mesh);
    }
    std::optional<ReadBody> refined = refinedBody(body, size, chordTolerance, false, progress);
    if (!refined)
    {
      return std::nullopt;
    }
    FineBody result;
    result.body = std::move(*refined);
    result.topology =
      sweepBetween(result.body.surface, topology.sourceFaceIds, topology.targetFaceIds);
    return result;
  }
  catch (const InvalidInput&)
  {
    return std::nullopt;
  }
}

bool liesOnGeometry(const ReadBody& body)
{
  const SolidSurface& surface = body.surface;
  const Index triangles = surface.triangles.rows();
  const double most = OffGeometry * sizeOf(surface.points);
  const Index step = std::max<Index>(1, triangles / Looked);
  for (Index t = 0; t < triangles; t += step)
  {
    const Index faceId = surface.faceIds[static_cast<std::size_t>(t)];
    for (int c = 0; c < 3; ++c)
    {
      const Eigen::RowVector3d corner = surface.points.row(surface.triangles(t, c));
      const std::optional<Eigen::RowVector3d> place = body.geometry->closestOnFace(faceId, corner);
      if (!place || !((*place - corner).norm() <= most))
      {
        return false;
      }
    }
  }
  return true;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/InteriorStarts.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/BlendInterior.h"
#include "Core/Interior/BoundaryErrorInterior.h"
#include "Core/Interior/GreenCoordinates.h"
#include "Core/Interior/HarmonicCoordinates.h"
#include "Core/Interior/LayerMarch.h"
#include "Core/Interior/MeanValueCoordinates.h"

namespace hexsweep
{
namespace
{
using Interior = Points (*)(
  const PointsRef&, const PointsRef&, const QuadsRef&, const SweepBoundary&, const Progress&);
using ThreadedInterior = Points (*)(const PointsRef&, const PointsRef&, const QuadsRef&,
  const SweepBoundary&, const Progress&, const ParallelFor&);

InteriorStart start(const char* name, Interior interior)
{
  return { name, [interior](const SweepCage& cage, const Progress& progress) {
            return interior(cage.source, cage.target, cage.quads, cage.boundary, progress);
          } };
}

InteriorStart start(const char* name, ThreadedInterior interior, const ParallelFor& parallelFor)
{
  return { name, [interior, parallelFor](const SweepCage& cage, const Progress& progress) {
            return interior(
              cage.source, cage.target, cage.quads, cage.boundary, progress, parallelFor);
          } };
}
}

std::vector<InteriorStart> interiorStarts(InteriorKind kind, const ParallelFor& parallelFor)
{
  const InteriorStart blend = start("Blend", blendInterior, parallelFor);
  const InteriorStart fading = start("Blend with fading bulges", fadingBlendInterior, parallelFor);
  const InteriorStart march = start("LayerMarch", layerMarchInterior);
  switch (kind)
  {
    case InteriorKind::Automatic:
      return { blend, fading, march };
    case InteriorKind::Blend:
      return { blend };
    case InteriorKind::HarmonicCoordinates:
      return { start("HarmonicCoordinates", harmonicInterior, parallelFor) };
    case InteriorKind::MeanValueCoordinates:
      return { start("MeanValueCoordinates", meanValueInterior, parallelFor) };
    case InteriorKind::GreenCoordinates:
      return { start("GreenCoordinates", greenInterior, parallelFor) };
    case InteriorKind::LayerMarch:
      return { march };
    case InteriorKind::AffineBoundaryError:
      return { start("AffineBoundaryError", boundaryErrorInterior) };
  }
  throw InvalidInput("Method " + std::to_string(static_cast<int>(kind)) +
    " does not exist. Use AUTOMATIC (0), BLEND (1), HARMONIC_COORDINATES (2), "
    "MEAN_VALUE_COORDINATES (3), GREEN_COORDINATES (4), LAYER_MARCH (5) or "
    "AFFINE_BOUNDARY_ERROR (6).");
}
}

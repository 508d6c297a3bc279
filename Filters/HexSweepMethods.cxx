// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepMethods.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/BlendInterior.h"
#include "Core/Interior/BoundaryErrorInterior.h"
#include "Core/Interior/GreenCoordinates.h"
#include "Core/Interior/HarmonicCoordinates.h"
#include "Core/Interior/LayerMarch.h"
#include "Core/Interior/MeanValueCoordinates.h"
#include "HexSweepRun.h"
#include "vtkCageHexInterior.h"

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

InteriorStart threadedStart(const char* name, ThreadedInterior interior)
{
  return { name, [interior](const SweepCage& cage, const Progress& progress) {
            return interior(
              cage.source, cage.target, cage.quads, cage.boundary, progress, smpFor());
          } };
}
}

std::vector<InteriorStart> interiorStarts(int method)
{
  const InteriorStart blend = threadedStart("Blend", blendInterior);
  const InteriorStart fading = threadedStart("Blend with fading bulges", fadingBlendInterior);
  const InteriorStart march = start("LayerMarch", layerMarchInterior);
  switch (method)
  {
    case vtkCageHexInterior::AUTOMATIC:
      return { blend, fading, march };
    case vtkCageHexInterior::BLEND:
      return { blend };
    case vtkCageHexInterior::HARMONIC_COORDINATES:
      return { threadedStart("HarmonicCoordinates", harmonicInterior) };
    case vtkCageHexInterior::MEAN_VALUE_COORDINATES:
      return { threadedStart("MeanValueCoordinates", meanValueInterior) };
    case vtkCageHexInterior::GREEN_COORDINATES:
      return { threadedStart("GreenCoordinates", greenInterior) };
    case vtkCageHexInterior::LAYER_MARCH:
      return { march };
    case vtkCageHexInterior::AFFINE_BOUNDARY_ERROR:
      return { start("AffineBoundaryError", boundaryErrorInterior) };
    default:
      throw InvalidInput("Method " + std::to_string(method) +
        " does not exist. Use AUTOMATIC (0), BLEND (1), HARMONIC_COORDINATES (2), "
        "MEAN_VALUE_COORDINATES (3), GREEN_COORDINATES (4), LAYER_MARCH (5) or "
        "AFFINE_BOUNDARY_ERROR (6).");
  }
}
}

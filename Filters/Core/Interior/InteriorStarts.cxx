// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Interior/InteriorStarts.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/BlendInterior.h"
#include "Core/Interior/BoundaryErrorInterior.h"
#include "Core/Interior/GreenCoordinates.h"
#include "Core/Interior/HarmonicCoordinates.h"
#include "Core/Interior/LayerMarch.h"
#include "Core/Interior/MeanValueCoordinates.h"
#include "Core/Interior/RuledInterior.h"

namespace hexsweep
{
std::vector<InteriorStart> interiorStarts(InteriorKind kind, bool isRuled)
{
  switch (kind)
  {
    case InteriorKind::Automatic:
    {
      std::vector<InteriorStart> starts;
      if (isRuled)
      {
        starts.push_back({ "Ruled", ruledInterior, true });
      }
      starts.push_back({ "Blend", blendInterior });
      starts.push_back({ "Blend with fading bulges", fadingBlendInterior });
      starts.push_back({ "LayerMarch", layerMarchInterior });
      return starts;
    }
    case InteriorKind::Blend:
      return { { "Blend", blendInterior } };
    case InteriorKind::HarmonicCoordinates:
      return { { "HarmonicCoordinates", harmonicInterior } };
    case InteriorKind::MeanValueCoordinates:
      return { { "MeanValueCoordinates", meanValueInterior } };
    case InteriorKind::GreenCoordinates:
      return { { "GreenCoordinates", greenInterior } };
    case InteriorKind::LayerMarch:
      return { { "LayerMarch", layerMarchInterior } };
    case InteriorKind::AffineBoundaryError:
      return { { "AffineBoundaryError", boundaryErrorInterior } };
  }
  throw InvalidInput("Method " + std::to_string(static_cast<int>(kind)) +
    " does not exist. Use AUTOMATIC (0), BLEND (1), HARMONIC_COORDINATES (2), "
    "MEAN_VALUE_COORDINATES (3), GREEN_COORDINATES (4), LAYER_MARCH (5) or "
    "AFFINE_BOUNDARY_ERROR (6).");
}
}

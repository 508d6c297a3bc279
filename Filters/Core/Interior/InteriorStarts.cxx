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
#include "Core/Interior/SectionInterior.h"

#include <iterator>
#include <string>

namespace hexsweep
{
namespace
{
struct NamedMethod
{
  const char* name;
  Points (*method)(const SweepCage&, const Progress&, const ParallelFor&); ///< nullptr: several
};

/// By InteriorKind.
constexpr NamedMethod Methods[] = {
  { "Automatic", nullptr },
  { "Blend", blendInterior },
  { "HarmonicCoordinates", harmonicInterior },
  { "MeanValueCoordinates", meanValueInterior },
  { "GreenCoordinates", greenInterior },
  { "LayerMarch", layerMarchInterior },
  { "AffineBoundaryError", boundaryErrorInterior },
};
constexpr int Count = static_cast<int>(std::size(Methods));

/// Turns of loops, in radians, from which layers are carried when all else fails, and at once.
constexpr double LeastWinding = 0.5;
constexpr double FarWinding = 2.4;

std::vector<InteriorStart> automaticStarts(bool isRuled, double winding)
{
  std::vector<InteriorStart> starts;
  if (winding > FarWinding)
  {
    starts.push_back({ "Sections", sectionInterior });
  }
  if (isRuled)
  {
    starts.push_back({ "Ruled", ruledInterior, true });
  }
  starts.push_back({ "Blend", blendInterior });
  // Inside a rounded body its layers stand squarer than any blend's.
  starts.push_back({ "HarmonicCoordinates", harmonicInterior, false, capsBulgeApart });
  starts.push_back({ "Blend with fading bulges", fadingBlendInterior, false, capsBulgeApart });
  starts.push_back({ "LayerMarch", layerMarchInterior });
  if (winding > LeastWinding && winding <= FarWinding)
  {
    starts.push_back({ "Sections", sectionInterior });
  }
  return starts;
}
}

std::vector<std::string> interiorMethodNames()
{
  std::vector<std::string> names;
  for (const NamedMethod& method : Methods)
  {
    names.emplace_back(method.name);
  }
  return names;
}

std::vector<InteriorStart> interiorStarts(InteriorKind kind, bool isRuled, double winding)
{
  const int number = static_cast<int>(kind);
  if (number < 0 || number >= Count)
  {
    throw InvalidInput("Method " + std::to_string(number) + " does not exist. Methods go from 0 (" +
      Methods[0].name + ") to " + std::to_string(Count - 1) + " (" + Methods[Count - 1].name +
      ").");
  }
  const NamedMethod& chosen = Methods[number];
  return chosen.method ? std::vector<InteriorStart>{ { chosen.name, chosen.method } }
                       : automaticStarts(isRuled, winding);
}
}

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Borders between the faces of a target cap, carried back to the source cap, so that quads
 * made there have edges along them.
 */
#ifndef hexsweep_CapImprint_h
#define hexsweep_CapImprint_h

#include "Core/Assemblies/AssemblyPlan.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/AffineMap.h"

#include <optional>
#include <string>

namespace hexsweep
{
/// A volume whose target has a border that finds no place on its source.
class ImprintFailure : public InvalidInput
{
public:
  ImprintFailure(Index volume, const std::string& what)
    : InvalidInput(what)
    , Volume(volume)
  {
  }
  Index volume() const { return this->Volume; }

private:
  Index Volume;
};

/// The affine map from the source to the target cap, see findAffineSweep(). @return nothing where
/// there is none.
std::optional<AffineMap> capMapOf(const AssemblyComplex& complex, Index volume,
  const SweepLayout& layout, const SolidSurface& solid);

/**
 * Cuts source faces along the images of the borders of their targets, from the ends of the stacks
 * of volumes back to their beginnings: each cut of a source cuts the target of the volume before.
 * Then lays out all sweeps anew; those that needed it get SweepLayout::carried.
 *
 * @param complex faces are cut: parts of a face keep its id; triangles of neighbours are split
 * where a border ends on their curve.
 * @param solids  one a volume, as makeAssemblyComplex() had them.
 * @param size    wanted length of edges: borders nearer to each other than a fiftieth become one.
 * @throw ImprintFailure naming the volume and faces where a border has no place on the source.
 */
void imprintTargets(const std::vector<const SolidSurface*>& solids, double size,
  AssemblyComplex& complex, AssemblyPlan& plan);
}

#endif

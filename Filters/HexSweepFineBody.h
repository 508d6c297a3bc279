// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A body whose true surfaces are known, divided as finely as its hexahedra ask for. Private
 * to the module.
 */
#ifndef HexSweepFineBody_h
#define HexSweepFineBody_h

#include "Core/Solids/SweepTopology.h"
#include "HexSweepBodies.h"

#include <optional>

namespace hexsweep
{
struct FineBody
{
  ReadBody body;
  SweepTopology topology; ///< the same caps
};

/**
 * Divides the surfaces of a body so that facets stay within a hundredth of the hexahedra's size:
 * nodes then move little when they are put on the surfaces, however coarse the given triangles are.
 *
 * @param body with `geometry`. @param size of the hexahedra; 0: of the default.
 * @param chordTolerance of the source quads, see CapQuadOptions: facets turn less than these.
 * @return nothing where the given triangles have to do: they are quads already, or the kernel does
 *         not give a closed surface that can be swept between these caps.
 * @throw Aborted.
 */
std::optional<FineBody> fineBody(const ReadBody& body, const SweepTopology& topology, double size,
  double chordTolerance, const Progress& progress = {});

/**
 * The same without caps.
 *
 * @param size of the hexahedra, > 0. @param partTouching see SolidOptions.
 * @return nothing where the kernel does not give a closed surface.
 * @throw Aborted.
 */
std::optional<ReadBody> refinedBody(const ReadBody& body, double size, double chordTolerance,
  bool partTouching, const Progress& progress = {});

/**
 * Whether the triangles lie on the geometry, as they do not when they were moved since they were
 * read.
 */
bool liesOnGeometry(const ReadBody& body);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the quads of a solid's source cap come from. Private to the module.
 */
#ifndef HexSweepSolidQuads_h
#define HexSweepSolidQuads_h

#include "Core/CapQuads/QuadProjection.h"
#include "Core/Solids/AffineSweep.h"
#include "Core/Solids/SweepTopology.h"
#include "HexSweepHexOutput.h"
#include "HexSweepSolidSweep.h"

#include <optional>
#include <string>
#include <vector>

namespace hexsweep
{
struct SourceCapQuads
{
  QuadMesh mesh;
  SourceAttributes attributes;
  std::string origin;               ///< for the report: "SourceQuads", "Solid" or "made"
  Index inverted = 0;               ///< of quads that were made here
  double size = 0.0;                ///< edge length that these were to have
  std::vector<FixedNode> imprinted; ///< see SourceQuads
  std::string imprintWarning;       ///< see SourceQuads
};

/**
 * The quads of the input, else those that the solid has on its source faces, else new ones.
 *
 * @param withBorders whether new quads keep the borders between the target's faces.
 * @param chordTolerance of new quads, see CapQuadOptions.
 * @param affine see findAffineSweep().
 * @param size of new quads; 0: see defaultQuadSize().
 * @throw InvalidInput when the input is no quad mesh, or for a size out of range.
 */
SourceCapQuads sourceQuads(const SolidToSweep& solid, const SweepTopology& topology, double size,
  double chordTolerance, const std::optional<AffineSweep>& affine, const Progress& progress,
  bool withBorders);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Quads for the source cap of a solid that brings none.
 */
#ifndef hexsweep_SourceQuads_h
#define hexsweep_SourceQuads_h

#include "Core/CapQuads/QuadProjection.h"
#include "Core/Solids/AffineSweep.h"
#include "Core/Solids/SolidInput.h"
#include "Core/Solids/SweepTopology.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hexsweep
{
struct SourceQuads
{
  QuadMesh mesh;      ///< outward
  Index inverted = 0; ///< of these quads
  double least = 0.0; ///< scaled Jacobian of these quads
  double size = 0.0;  ///< edge length that they were to have
  /// Nodes on the borders between faces of the target, those on loops where borders end included,
  /// and where they belong on the target.
  std::vector<FixedNode> imprinted;
  /// Which borders of the target the quads do not keep, and why; empty: they keep all.
  std::string imprintWarning;
};

/**
 * Meshes the source cap so that the quads fit the sides: borders between faces of the sides begin
 * at nodes, and edges at which quads of the sides begin are kept.
 *
 * Where the target consists of several faces and is an affine image of the source (see
 * findAffineSweep()), the borders between them become edges of the quads like those between source
 * faces. Borders of the two that are nearer to each other than a fiftieth of the quads, or than
 * their facets explain, become one. Where this would invert quads, the target's borders are left
 * out.
 *
 * @param input what `solid` was made from.
 * @param size  edge length; 0: that of the edges that are kept, else see defaultQuadSize(), no less
 *              than half a facet of the cap's curves.
 * @param chordTolerance see CapQuadOptions.
 * @param known what findAffineSweep() gave, where it was asked already.
 * @throw InvalidInput for a size that is negative or not finite, and as meshCapWithQuads().
 * @throw Aborted.
 */
SourceQuads makeSourceQuads(const SolidInput& input, const SolidSurface& solid,
  const SweepTopology& topology, double size, const Progress& progress = {},
  bool withBorders = true, const ParallelFor& parallelFor = {}, double chordTolerance = 0.0,
  const std::optional<AffineSweep>* known = nullptr);

/// Where the borders between the faces of linking sides begin: points of the solid on the loops of
/// the source cap.
std::vector<Index> edgeStarts(const SolidSurface& solid, const SweepTopology& topology);

/// Edges of the source cap at which quads of the sides begin, as pairs of points of the solid.
std::vector<std::pair<Index, Index>> meshedEdges(
  const SolidInput& input, const SolidSurface& solid, const SweepTopology& topology);

/// Degrees: by how much the loops of the source cap turn at most, but for borders between faces;
/// 0 where that is less than 10.
double greatestFacetTurn(const SolidSurface& solid, const SweepTopology& topology);
}

#endif

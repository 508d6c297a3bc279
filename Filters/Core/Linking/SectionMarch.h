// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Carries the quads of the source cap from section to section, along the sides.
 */
#ifndef hexsweep_SectionMarch_h
#define hexsweep_SectionMarch_h

#include "Core/Linking/SweepSections.h"

namespace hexsweep
{
struct CarriedQuads
{
  /// The nodes in the plane of each section, boundary nodes on its ring; layers[0] is the source.
  std::vector<PlanePoints> layers;
  /// Corners that are inverted in each, those between fixed edges not counted.
  std::vector<Index> inverted;

  bool valid() const;
};

/**
 * Moves quads from ring to ring in the planes of the sections.
 *
 * A step is harmonic on the quads as they lie (so that all steps add up to a flow, which winds as
 * the sides do), divided where it would change an edge by more than a quarter. Quads that it folds
 * are untangled at once, the others relaxed towards the shapes that they have on the caps, so
 * that every layer is nearly the least distorted one of its winding and a layer hardly differs from
 * the one before but by what its ring did. A single map between the caps knows nothing of the way:
 * it takes the shortest turn.
 *
 * Serial; the work is bounded by layers, parts of a step and rounds.
 *
 * @param source n x 3.
 * @param target n x 3: what the quads are to look like at the end, if that is known. Layers on the
 *        way are given shapes between both, in proportion to `fractions`; the last layer comes near
 *        to the target.
 * @param fractions how far each section is on the way, see SweepBoundary::fractions.
 * @param quads  m x 4, counter-clockwise about the normal of the first frame.
 * @throw Aborted, SolverFailure (a layer has collapsed).
 */
CarriedQuads carryQuads(const PointsRef& source, const PointsRef& target,
  const std::vector<double>& fractions, const QuadsRef& quads, const SweepSections& sections,
  const Progress& progress = {});

/// The same where nothing is known of the target.
CarriedQuads carryQuads(const PointsRef& source, const QuadsRef& quads,
  const SweepSections& sections, const Progress& progress = {});
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The source quads carried along the sides to the plane of the last ring.
 */
#ifndef hexsweep_CarriedSource_h
#define hexsweep_CarriedSource_h

#include "Core/DiskMaps/CapDisk.h"
#include "Core/Linking/SweepSections.h"

#include <optional>

namespace hexsweep
{
/// Turns beyond which a map between the caps alone may take the other way round, in radians: it
/// goes wrong at half a turn, and near it leaves quads that no untangling unwinds.
constexpr double FarWinding = 2.4;

/// What stands for the source once the winding of the sides is behind it.
struct CarriedSource
{
  QuadMesh quads;     ///< in the plane of the last ring
  RingStack linking;  ///< one layer, from there to the last ring itself
  SectionFrame frame; ///< of the last ring
};

/**
 * Carries the quads along the sides, see carryQuads().
 *
 * @return nothing where a layer collapses.
 * @throw Aborted.
 */
std::optional<CarriedSource> carrySource(const QuadMesh& source, const RingStack& rings,
  const SweepSections& sections, const Progress& progress = {});

/// Two caps by their places in the plane of a section, as maps to one domain.
struct PlaneDisks
{
  CapDisk source;
  CapDisk target;
};

/**
 * The plane itself as the domain: nearer to the target than any harmonic map where the target is
 * flat, and quads that are sheared far are not asked for another metric.
 *
 * @param target consistently oriented, either way.
 * @return nothing where a triangle of the target is turned over in the plane.
 */
std::optional<PlaneDisks> planeDisks(const CarriedSource& source, const TriangleMesh& target);

/// A hole of the target that quads lead to by whole turns too many or too few.
struct MissedHole
{
  Eigen::RowVector3d place;
  Index turns;
};

/// See missedTurns(). @param target points of the source quads on the target cap.
std::vector<MissedHole> missedHoles(
  const QuadMesh& source, const Points& target, const SweepSections& sections);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Conformal map of a cap to the unit disk with circular holes (paper section 3.1.2).
 */
#ifndef hexsweep_KoebeMap_h
#define hexsweep_KoebeMap_h

#include "Core/DiskMaps/FilledDiskMap.h"

namespace hexsweep
{
/// One round over all holes.
struct KoebeRound
{
  std::vector<Circle> holes;
  /// Sum over the holes of the squared changes of centre and radius since the round before (the
  /// paper's step 6); infinite in the first one.
  double change = 0.0;
};

struct KoebeMap
{
  std::vector<Circle> holes;
  /// places[p]: a row a node of loops[p], on its circle to rounding.
  std::vector<PlanePoints> places;
  std::vector<KoebeRound> rounds;
  bool converged = false;
  /// One number a loop: greatest deviation of its image from its circle, over the radius, before
  /// the nodes were put onto it.
  std::vector<double> circularity;
};

/// When the iteration ends.
struct KoebeLimits
{
  double tolerance = 1e-10; ///< of KoebeRound::change; lengths are in radii of the disk
  /// Many more than 40 end where the last 20 gained nothing.
  int maximumRounds = 20;
};

/**
 * The circle domain of a cap with holes, and where the nodes of its loops go.
 *
 * One hole: the conformal annulus (see conformalAnnulus()), exact in one round.
 *
 * More: Koebe's iteration on a closed surface. All holes, and the outside, are filled with round
 * disks (see GluedSphere), with the cap's own weights throughout. The paper opens one hole after
 * the other to find the angles at which its disk is to be glued; here all of them change at once,
 * towards the angles of the image and as far again beyond: a wrong gluing moves the map on both of
 * its sides alike, so that the image shows half of the error. (The highest frequencies, which
 * finite elements show whole, are not overshot; what the holes do to each other is extrapolated
 * after D. G. Anderson \cite Anderson1965.) A round is two such changes; all of them share one
 * factor.
 *
 * The result is normalised by a Moebius map of the unit disk: the outer loop's nodes, weighted by
 * their lengths on the surface, have their mean at the origin, and the first of them has angle 0.
 * With one hole the circles are concentric instead.
 *
 * @param points, triangles consistently oriented cap; points that no triangle uses are ignored.
 * @param loops outer first, in the direction of the triangles, two or more.
 * @param weights of two holes and more: cotangent or intrinsic (mean value ones are no metric's and
 *        count as cotangent).
 * @throw InvalidInput when a loop's image does not wind round its hole (triangulation too coarse or
 *        too distorted), SolverFailure, Aborted.
 */
KoebeMap koebeMap(const PointsRef& points, const TrianglesRef& triangles,
  const std::vector<Loop>& loops, const KoebeLimits& limits = {}, const Progress& progress = {},
  Weights weights = Weights::Cotangent);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From a cage to hexahedra that are all proved valid: methods, untangling, polish.
 */
#ifndef hexsweep_SweepInterior_h
#define hexsweep_SweepInterior_h

#include "Core/Hexahedra/FixedCorners.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Hexahedra/HexUntangling.h"
#include "Core/Interior/SweepCage.h"

#include <string>

namespace hexsweep
{
/// A start of the cascade.
struct InteriorStart
{
  std::string name;
  InteriorMethod method;
  /// Nothing betters what it gives where that is certified: no polish.
  bool isBest = false;
  /**
   * Makes it a rival of the start before: where that does not reach what the boundary allows, and
   * this says that they differ, both are made, and the better goes first into untangling and
   * polish. Empty: it has its turn when those before it have failed.
   */
  std::function<bool(const SweepCage& cage)> rivals = {};
};

/// Begins where an interior is. @param points of it; must outlive the start.
InteriorStart startAt(const std::string& name, const Points& points);

struct InteriorOptions
{
  /// Untangle locally what is not valid.
  bool ensureValid = true;
  /// Go on with other starts, and untangle again after the polish, where the most promising start
  /// cannot be certified. Off is for meshes that are only compared: to fail takes longest.
  bool persists = true;
  /// Polish what is valid: at the most this often round the mesh.
  int polishingRounds = 4;
  /// Hand on what was found out about the result's hexahedra, so that nobody needs to judge them
  /// again: three numbers a hexahedron.
  bool keepQualities = false;
  /// That of the result: rounded at the end, and untangled again where that made hexahedra bad.
  Precision precision = Precision::Double;
  ParallelFor parallelFor = {};
};

/// What one step of the cascade did to the mesh that it was given.
struct InteriorStep
{
  std::string name;
  /// Hexahedra that are not Certified after it; 0 where nobody looked.
  Index notCertified;
  /// How many fewer they are than before the step; 0 for a start.
  Index mended;
  double seconds;
};

struct SweepInterior
{
  /// (L + 1) n x 3, row k n + i is source point i on layer k.
  Points points;
  /// Which way round the hexahedra were judged, see sourceIsBottom().
  bool sourceIsBottom;
  /// The start that was kept and what followed, e.g. "Blend + untangling + polish".
  std::string method;
  std::vector<InteriorStep> steps;
  /// Of the hexahedra of sweptHexes(). Not looked for where nothing was to be untangled or
  /// polished.
  FixedCorners fixed;
  /// Of the hexahedra of sweptHexes() as `points` has them, certified; empty where nobody looked or
  /// they were not to be kept.
  std::vector<HexQuality> qualities;
  /// How many more hexahedra are not Certified than before the coordinates were rounded.
  Index lostByRounding = 0;
};

/**
 * Tries the starts in order and stops at the first that is certified, by itself or after local
 * untangling (untangleHexes()); otherwise keeps the best: fewest hexahedra that are not Certified,
 * then the highest least scaled Jacobian. Of rivals (InteriorStart::rivals) the one with fewer
 * hexahedra that are not Certified is tried first, or with as many the one whose least and mean
 * scaled Jacobian are higher together. Where more than 50 hexahedra and one in 5000 would have
 * to be untangled in all of them the starts that come next are rivals as well: to make one takes
 * less.
 *
 * A certified mesh's minimum is raised up to what the boundary allows (raiseMinimum()), and by
 * patches up to 0.4 where single nodes are stuck before (raiseLowHexes()). Then follows the polish
 * (polishHexes(); not of a certified start that InteriorStart::isBest), which never lowers the
 * minimum nor loses a certificate, and is kept unless the mean falls. What is not certified even
 * then is untangled and polished again, as long as that mends something, twice at the most. No step
 * leaves a worse mesh than it was given.
 *
 * Hexahedra that caps and linking sides alone make bad (SweepInterior::fixed) do not keep the
 * cascade going.
 *
 * @param starts at least one. Without ensureValid the first is returned as it is, and polished.
 * @throw InvalidInput without a start, or where the parts of the cage do not belong together.
 * @throw what the first start throws; later ones that fail are passed over.
 */
SweepInterior sweepInterior(const SweepCage& cage, const std::vector<InteriorStart>& starts,
  const InteriorOptions& options, const Progress& progress = {});
}

#endif

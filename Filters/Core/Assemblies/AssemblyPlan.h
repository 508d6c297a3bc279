// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How the volumes of an assembly are swept: caps, directions and order, so that each shared
 * face has one mesh.
 */
#ifndef hexsweep_AssemblyPlan_h
#define hexsweep_AssemblyPlan_h

#include "Core/Assemblies/SideLayout.h"

#include <functional>
#include <string>

namespace hexsweep
{
/// A way to sweep a volume. Which cap is the source is up to the plan, unless it is named.
struct SweepOption
{
  SweepLayout layout;
  double score = 0.0; ///< see SweepCandidate
  bool fixed = false; ///< the source cap is named: the sweep is not turned
};

/// All ways for a volume, best first.
struct VolumeOptions
{
  std::vector<SweepOption> options; ///< none: the volume is left out
  std::vector<std::string> refused; ///< why others are none
};

/// What the user says of a volume.
struct NamedSweep
{
  std::vector<Index> sourceFaceIds; ///< empty: any
  std::vector<Index> targetFaceIds; ///< empty: any
  Index layers = 0;                 ///< 0: by size
  bool eitherWay = false;           ///< the caps may change places
};

/**
 * The sweeps of a volume that findSweepCandidates() gives and whose sides are patches, see
 * layOutSides().
 *
 * @param solid the volume's surface.
 * @throw InvalidInput where there is none, and where named caps cannot be swept between.
 */
VolumeOptions sweepOptions(const AssemblyComplex& complex, Index volume, const SolidSurface& solid,
  const NamedSweep& named = {});

struct AssemblyPlan
{
  std::vector<SweepLayout> sweeps; ///< one a volume
  /// All volumes in the order in which their caps are meshed: a volume whose source cap has faces
  /// of another's target comes after it.
  std::vector<Index> order;
  /// One a volume: the first volume of those that are joined to it cap to cap, the stack.
  std::vector<Index> stackOf;
};

/// Whether borders of a volume's target cap can be carried to its source cap.
using CanCarry = std::function<bool(Index volume, const SweepLayout& layout)>;

/**
 * Chooses an option for each volume and turns it, so that
 *  - a face that is a side of one volume and in a cap of another is structured, and that cap is the
 *    source;
 *  - of volumes that are stacked cap on cap each one but the first begins where another ends;
 *  - a target cap of several faces that go on to other volumes can be carried back: as few as
 *    possible are to be (see imprintTargets()).
 *
 * Tries combinations in the order of their scores, a number of them that depends on the size of the
 * assembly alone.
 *
 * @throw InvalidInput naming the volumes and faces that no combination brings together.
 */
AssemblyPlan planAssembly(const AssemblyComplex& complex, const std::vector<VolumeOptions>& volumes,
  const CanCarry& canCarry);

/// Whether a target cap has several faces, one of which goes on to another volume at least.
bool needsImprint(const AssemblyComplex& complex, const std::vector<Index>& targets);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Work on the quads around bad ones, patch by patch.
 */
#ifndef hexsweep_QuadPatchWork_h
#define hexsweep_QuadPatchWork_h

#include "Core/CapQuads/CapCorners.h"
#include "Core/Common/CellPatches.h"

#include <functional>

namespace hexsweep
{
/// Keeps what it was made of: these must stay.
class QuadPatchWork
{
public:
  /// Moves the free nodes of a patch; points and source points are the patch's as well. Called from
  /// any thread.
  using Work =
    std::function<ImprovedQuads(const CapCorners&, const Points&, const PointsRef& source)>;

  /// @param source n x 3, see untangleQuads().
  QuadPatchWork(const CapCorners& cap, const PointsRef& source);

  /**
   * Where movable corners are not above the floor.
   *
   * @param rings of quads around these.
   * @param most  of the quads, by number, in patches: with more nothing is done.
   * @return whether it was.
   * @throw Aborted.
   */
  bool run(ImprovedQuads& quads, double floor, int rings, double most, const Work& work,
    const Progress& progress) const;

private:
  const CapCorners& Cap;
  const PointsRef& Source;
  CellsAtNodes AtNodes;
  std::vector<bool> Fixed;
};
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Two caps whose loops are tied by linking sides or by shape, mapped to one domain.
 */
#ifndef hexsweep_LinkedCaps_h
#define hexsweep_LinkedCaps_h

#include "Core/DiskMaps/CommonDiskMap.h"
#include "Core/Geometry/BoundarySearch.h"

#include <optional>
#include <string>
#include <vector>

namespace hexsweep
{
/// Two caps and how their loops were matched.
struct LinkedDisks : CommonDisks
{
  /// See MatchedLoops; empty with linking sides.
  std::vector<double> startFractions;
  std::vector<std::string> doubts;
  BoundaryMismatch mismatch; ///< of the linking sides and the (first) cap
};

/**
 * Maps a cap together with its partner; `first` of the result is the cap, `second` the partner.
 *
 * @param linking structured quads between the two; without them loops are matched by shape.
 */
LinkedDisks mapLinkedCaps(const TriangleMesh& cap, const TriangleMesh& partner,
  const std::optional<QuadMesh>& linking, Weights weights, double matchTolerance,
  const Progress& progress = {},
  TriangulationImprovement improvement = TriangulationImprovement::Off);

/// commonDiskMap() of caps in either order. @param linked swapped where `partner` comes first.
CommonDisks mapPairs(const Cap& cap, const Cap& partner, const LinkedLoops& linked, Weights weights,
  double matchTolerance, const Progress& progress, const CapNames& names,
  TriangulationImprovement improvement);

/// Of a cap and what is to lie on its loops; nothing where no rings are given.
BoundaryMismatch mismatchOf(
  const Cap& cap, const std::vector<Points>& rings, double matchTolerance);
}

#endif

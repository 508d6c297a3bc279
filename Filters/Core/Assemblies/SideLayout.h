// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which way the layers of a sweep run over the faces of its sides: each face a structured
 * patch between its neighbours.
 */
#ifndef hexsweep_SideLayout_h
#define hexsweep_SideLayout_h

#include "Core/Assemblies/AssemblyComplex.h"

#include <array>

namespace hexsweep
{
/// A curve of a patch with more than four corners, and which way the grid runs along it.
struct DirectedUse
{
  CurveUse use;
  int direction = 0; ///< 0 along the rows, with layers above it; 1 up, 2 back, 3 down
};

/**
 * A face of a linking side as a patch of structured quads.
 *
 * The chains run round the face: chains[0] lies nearer to the source cap, chains[2] nearer to the
 * target cap; 1 and 3 lead along the sweep. A tube has the loops 0 and 2 alone. A patch with more
 * corners, or with a patch inside it, has rims instead: the outer one first.
 */
struct SideFace
{
  Index face = -1; ///< row of AssemblyComplex::faces
  std::array<std::vector<CurveUse>, 4> chains;
  std::vector<std::vector<DirectedUse>> rims;

  bool isPolygon() const { return !this->rims.empty(); }
  bool isTube() const { return !this->isPolygon() && this->chains[1].empty(); }
};

/// All curves of a patch with a direction, see DirectedUse.
std::vector<DirectedUse> curvesAlong(const SideFace& side, int direction);

/// Sum of the chords of curves.
Eigen::RowVector3d chordOf(const AssemblyComplex& complex, const std::vector<DirectedUse>& uses);

/// A border between faces of the target cap, and its image on the source cap.
struct CarriedCurve
{
  std::vector<CurveUse> source; ///< curves of the source cap, one after the other
  CurveUse target;              ///< run in the same direction
};

/// The sweep of a volume between two caps.
struct SweepLayout
{
  std::vector<Index> sources; ///< rows of faces, rising
  std::vector<Index> targets;
  std::vector<SideFace> sides;            ///< from the source on
  std::vector<CarriedCurve> carried = {}; ///< see imprintTargets()
};

/**
 * Walks from the loops of the source cap to those of the target cap over the side faces, each of
 * which must be a quadrilateral (four corners), a tube, or a polygon whose angles are multiples of
 * a right one, with one such polygon inside it at most.
 *
 * @param sources, targets faces of the volume, rows, rising.
 * @throw InvalidInput naming the face that is neither, or on which layers would meet crosswise.
 */
SweepLayout layOutSides(const AssemblyComplex& complex, Index volume, std::vector<Index> sources,
  std::vector<Index> targets);
}

#endif

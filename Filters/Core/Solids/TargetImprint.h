// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The borders between the faces of a target cap, put onto the source cap, so that quads made
 * there have edges along them.
 */
#ifndef hexsweep_TargetImprint_h
#define hexsweep_TargetImprint_h

#include "Core/CapQuads/CapMeshing.h"
#include "Core/CapQuads/QuadProjection.h"
#include "Core/Surfaces/BorderImprint.h"

#include <functional>
#include <optional>

namespace hexsweep
{
/// Where the sweep takes points of one cap on the other: n x 3 in, n x 3 out, the images on or near
/// the other surface.
struct CapMaps
{
  std::function<Points(const PointsRef&)> toTarget;
  std::function<Points(const PointsRef&)> toSource;
};

/// Maps through a common domain. @param source, target must outlive the result.
CapMaps mapsThroughDisks(const CapDisk& source, const CapDisk& target);

/// A target cap of several faces.
struct FacedCap
{
  TriangleMesh surface;
  std::vector<Index> faceIds; ///< one a triangle
};

/// The source cap, cut along the target's borders as well.
struct TargetImprint
{
  ImprintedSurface cap;
  /// One a triangle of cap: the same where both the source face and the target face are.
  std::vector<Index> labels;
  std::vector<Index> hiddenFaces; ///< of the target: too narrow to have triangles here, rising
  BorderLines lines;              ///< the borders, on the target
  std::vector<Index> curveOf;     ///< one a piece of lines
  std::vector<Index> ends;        ///< points of lines where curves end or have corners
  /// Points of cap at these, which are to be nodes.
  std::vector<Index> keep() const;
};

/**
 * @param source  the source cap, see ImprintBase.
 * @param reach   half the length of what counts as a fillet, see traceCapCurves().
 * @param longest length of pieces into which borders are cut before they are mapped; 0: as they
 *                are, which is enough for an affine map.
 * @return nothing where a border finds no way over the source cap, or there is none.
 */
std::optional<TargetImprint> imprintTarget(const ImprintBase& source, const FacedCap& target,
  const CapMaps& maps, double reach, double longest = 0.0);

/**
 * Where the target's nodes on its borders belong.
 *
 * @param quads     made on imprint.cap with imprint.labels.
 * @param endNodes  nodes of the quads at imprint.keep(), in this order.
 * @return inner nodes, and those on loops where borders end, by their number, each with its place
 *         on the target's border.
 */
std::vector<FixedNode> nodesOnBorders(const TargetImprint& imprint, const CapQuads& quads,
  const std::vector<Index>& endNodes, const CapMaps& maps);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which faces of a solid run along a direction and which lie across it.
 */
#ifndef hexsweep_CapLikeFaces_h
#define hexsweep_CapLikeFaces_h

#include "Core/Solids/SolidSurface.h"

#include <string>
#include <vector>

namespace hexsweep
{
/// How a face of a solid lies to a direction.
enum class StackFaceKind
{
  Side,   ///< along the direction everywhere
  Top,    ///< a height field over the plane across the direction, the solid below it
  Bottom, ///< the same, the solid above it
  Neither ///< in the way
};

struct StackFace
{
  Index id = 0;
  StackFaceKind kind = StackFaceKind::Neither;
  double area = 0.0;
  std::string problem; ///< of one that is neither: why, after "face 3 "
};

/// The faces of a solid, seen along a direction.
struct CapLikeFaces
{
  Eigen::RowVector3d direction;    ///< unit
  std::vector<StackFace> faces;    ///< rising ids
  std::vector<std::size_t> faceOf; ///< one a triangle of the solid: place in `faces`
  /// Sets of caps of one kind that border on each other.
  Index tops = 0;
  Index bottoms = 0;
  double refusedArea = 0.0; ///< of the faces that are neither
  /// Mean sine of the angle of the sides' triangles off the direction, by area.
  double sideLean = 0.0;
  /// Sides that lean: the mean of their normals is more than a quarter of a degree off the plane
  /// across, which facets of an upright side do not make it.
  std::vector<Index> leaning; ///< ids, rising

  bool isStack() const { return this->refusedArea == 0.0; }
  /// Whether a sweep from one cap to one other does.
  bool isPlain() const { return this->isStack() && this->tops == 1 && this->bottoms == 1; }
};

/**
 * Tells the faces apart by the normals of their triangles.
 *
 * A side's normals are across the direction but for `draft` and 2 degrees that facets may take away
 * (their mean; a single triangle may lean by 10 degrees more; of a face without points inside,
 * whose triangles lean to both sides, by up to 40). A cap's are at least 8 degrees off that, all to
 * one end of the direction. Triangles without a hundred-thousandth of the face's area do not count.
 *
 * @param direction of any length but 0.
 * @param draft     radians, in [0, pi/4]: how far sides may lean.
 */
CapLikeFaces capLikeFaces(
  const SolidSurface& solid, const Eigen::RowVector3d& direction, double draft = 0.0);

/// What to tell about the faces that are neither, and what to do. @param limit faces named at most.
std::string describeRefusedFaces(const CapLikeFaces& faces, std::size_t limit = 5);

/**
 * The ways along which a solid may be a stack, the best first: normals of its plane faces and axes
 * of faces whose normals lie in a plane. Those along which all faces are sides and caps come first,
 * of these those without leaning sides, then those with the fewest caps; the others by the area in
 * the way.
 *
 * @return at most 12, each as it stands and not reversed.
 */
std::vector<CapLikeFaces> stackDirections(const SolidSurface& solid, double draft = 0.0);
}

#endif

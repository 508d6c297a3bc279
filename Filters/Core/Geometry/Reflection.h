// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Reflections in the coordinate planes, which rounding does not touch.
 */
#ifndef hexsweep_Reflection_h
#define hexsweep_Reflection_h

#include "Core/Common/Mesh.h"

#include <string>

namespace hexsweep
{
/// Turns the signs of some coordinates. Its own inverse.
struct Reflection
{
  Eigen::RowVector3d signs{ 1.0, 1.0, 1.0 }; ///< 1 or -1 each

  /// Whether it makes a right hand a left one: outward normals then point inward.
  bool turnsOver() const { return this->signs.prod() < 0.0; }
};

/// The image of n points (n x 3), exactly. Zeros come out positive.
Points reflected(Points points, const Reflection& reflection);

/// A message of which each place "(x, y, z)", as describe() writes it, is reflected.
std::string reflectedPlaces(const std::string& text, const Reflection& reflection);
}

#endif

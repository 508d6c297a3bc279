// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Numbers and places as text, for messages to the user.
 */
#ifndef hexsweep_Describe_h
#define hexsweep_Describe_h

#include <Eigen/Core>

#include <cmath>
#include <cstdio>
#include <string>

namespace hexsweep
{
/// Shortest text with up to 9 significant digits, e.g. "0.25" or "1e-06"; "nan", whose sign means
/// nothing.
inline std::string describe(double value)
{
  if (std::isnan(value))
  {
    return "nan";
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%.9g", value);
  return text;
}

/// The verb after a mesh's name: "the source quads are", "the target surface is".
inline std::string verb(
  const std::string& name, const std::string& singular, const std::string& plural)
{
  return !name.empty() && name.back() == 's' ? plural : singular;
}

/// "(x, y, z)". Messages write places in no other way, so that reflectedPlaces() finds them.
inline std::string describe(const Eigen::Ref<const Eigen::RowVector3d>& point)
{
  return "(" + describe(point[0]) + ", " + describe(point[1]) + ", " + describe(point[2]) + ")";
}
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The true geometry of a solid that was reflected.
 */
#ifndef hexsweep_ReflectedGeometry_h
#define hexsweep_ReflectedGeometry_h

#include "Core/Geometry/ModelGeometry.h"
#include "Core/Geometry/Reflection.h"

#include <memory>

namespace hexsweep
{
/// Answers as `geometry` would if it lay where `reflection` puts it. A reflection that changes
/// nothing gives `geometry` itself.
std::shared_ptr<const ModelGeometry> reflectedGeometry(
  std::shared_ptr<const ModelGeometry> geometry, const Reflection& reflection);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What vtkSweepQuadProjector reports of its work. Private to the module.
 */
#ifndef HexSweepProjectionReport_h
#define HexSweepProjectionReport_h

#include "Core/CapQuads/SweepProjection.h"

#include <string>
#include <vector>

class vtkFieldData;

namespace hexsweep
{
/// @param method name of the method, for `SweepReportMethod`.
void addProjectionReport(
  vtkFieldData* field, const SweepProjection& projection, const std::string& method);

/**
 * What the user should know: flipped triangles, a Nitsche bound that is violated, loops that were
 * hard to match, inputs that do not meet, inverted quads.
 *
 * @param quads of the source cap.
 */
std::vector<std::string> projectionWarnings(
  const SweepProjection& projection, const QuadsRef& quads);
}

#endif

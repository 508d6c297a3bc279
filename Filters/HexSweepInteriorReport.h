// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What vtkCageHexInterior reports of its work. Private to the module.
 */
#ifndef HexSweepInteriorReport_h
#define HexSweepInteriorReport_h

#include "Core/Common/Stopwatch.h"
#include "Core/Interior/SweepInterior.h"

#include <string>
#include <vector>

class vtkFieldData;

namespace hexsweep
{
/// The time that each step took.
std::vector<Stage> stagesOf(const std::vector<InteriorStep>& steps);

/// `SweepReportStages` and `SweepReportSeconds`.
void addStageReport(vtkFieldData* fieldData, const StageClock& clock);

/// What the cascade did, step by step, and what no interior could have done; nothing where nobody
/// looked at the hexahedra on the way.
void addStepReport(
  vtkFieldData* fieldData, const SweepInterior& interior, const InteriorOptions& options);

/// Names of what addStepReport() may write.
std::vector<std::string> interiorReports();

/// The settings that decide what else may help.
struct InteriorSettings
{
  bool ensureValid;
  bool automatic; ///< all methods one after the other
  /// How many hexahedra are bad because coordinates are stored in single precision.
  Index lostByRounding = 0;
};

/**
 * What to do about bad hexahedra, for describeInverted(): what the boundary alone makes bad, where
 * and how to mend it; then what settings or other meshes may do.
 *
 * @param points         (L + 1) n x 3. @param pointsPerLayer n.
 * @param bad            how many hexahedra are not valid.
 */
std::string interiorAdvice(const PointsRef& points, Index pointsPerLayer, Index bad,
  const FixedCorners& fixed, const InteriorSettings& settings);
}

#endif

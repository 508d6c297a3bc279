// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What filters tell of the linking sides that they mesh. Private to the module.
 */
#ifndef HexSweepLinkingReport_h
#define HexSweepLinkingReport_h

#include "Core/LinkingSides.h"

#include <string>
#include <vector>

class vtkFieldData;

namespace hexsweep
{
/// What the user should know: edges and corners without nodes, meshed parts that were not kept.
std::vector<std::string> linkingWarnings(const LinkingSidesMesh& linking);

/// `SweepReportLayers`, `...KeptEdges`, `...LostEdges` and `...MeanColumnLength`.
void addLinkingReport(vtkFieldData* fieldData, const LinkingSidesMesh& linking);
}

#endif

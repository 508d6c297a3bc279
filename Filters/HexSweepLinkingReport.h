// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What filters tell of the linking sides that they mesh. Private to the module.
 */
#ifndef HexSweepLinkingReport_h
#define HexSweepLinkingReport_h

#include "Core/Linking/LinkingSides.h"

#include <string>
#include <vector>

class vtkFieldData;

namespace hexsweep
{
/// What the user should know: edges and corners without nodes, meshed parts that were not kept.
std::vector<std::string> linkingWarnings(const LinkingMesh& linking);

/// `SweepReportLayers`, `...KeptEdges`, `...LostEdges` and `...MeanColumnLength`.
void addLinkingReport(vtkFieldData* fieldData, const LinkingMesh& linking);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepLinkingReport.h"

#include "Core/Common/Describe.h"
#include "HexSweepArrays.h"
#include "HexSweepWriter.h"

namespace hexsweep
{
namespace
{
constexpr std::size_t PlacesToName = 10;

/// " at (0, 1, 0), (0, 2, 0), ..."
std::string listPlaces(const std::vector<Eigen::RowVector3d>& places)
{
  std::string text = " at ";
  for (std::size_t i = 0; i < places.size() && i < PlacesToName; ++i)
  {
    text += (i > 0 ? ", " : "") + describe(places[i]);
  }
  return text + (places.size() > PlacesToName ? ", ..." : "");
}

}

std::vector<std::string> linkingWarnings(const LinkingMesh& linking)
{
  std::vector<std::string> warnings = linking.refusedPatches;
  if (!linking.lostEdges.empty())
  {
    warnings.push_back(std::to_string(linking.lostEdges.size()) +
      " edges of the solid lead from the source to the target cap, but no node of the source quads "
      "lies where they begin:" +
      listPlaces(linking.lostEdges) +
      ". They are cut off by quads that lie across them. Put a node of the source quads there.");
  }
  if (!linking.lostCorners.empty())
  {
    warnings.push_back(std::to_string(linking.lostCorners.size()) +
      " corners of the target cap have no node, since there are fewer columns than corners:" +
      listPlaces(linking.lostCorners) + ". Refine the source quads.");
  }
  if (linking.flipped > 0)
  {
    warnings.push_back("the map of the linking sides flips " + std::to_string(linking.flipped) +
      " of their triangles; nodes near them may lie unevenly. Remesh the solid without slivers.");
  }
  return warnings;
}

void addLinkingReport(vtkFieldData* fieldData, const LinkingMesh& linking)
{
  addReport(fieldData, reports::Layers, linking.rings.numberOfLayers());
  addReport(fieldData, reports::KeptEdges, linking.keptEdges);
  addReport(fieldData, reports::LostEdges, static_cast<Index>(linking.lostEdges.size()));
  addReport(fieldData, reports::MeanColumnLength, linking.meanColumnLength);
}
}

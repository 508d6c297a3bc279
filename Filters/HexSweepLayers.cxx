// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepLayers.h"

#include "Core/Linking/LayerSpacing.h"
#include "vtkLayeredSweepAlgorithm.h"

#include <algorithm>

namespace hexsweep
{
LayerRequest requestedLayers(vtkLayeredSweepAlgorithm* filter, bool mayBeFree)
{
  LayerRequest request;
  request.layers = filter->GetNumberOfLayers();
  request.size = filter->GetLayerSize();
  request.growth = filter->GetGrowthRatio();
  request.bothEnds = filter->GetGrowFromBothEnds();
  for (int i = 0; i < filter->GetNumberOfLayerPositions(); ++i)
  {
    request.positions.push_back(filter->GetLayerPosition(i));
  }
  // For the errors that they throw, before there is work that takes long.
  if (!request.positions.empty())
  {
    layerFractions(request.positions);
  }
  else if (request.size != 0.0)
  {
    layersOfSize(request.size, request.size);
    layerFractions(1, request.growth, request.bothEnds);
  }
  else
  {
    const bool isFree = mayBeFree && request.layers == 0;
    // How many can be made depends on the cap.
    constexpr Index Tried = 1000;
    layerFractions(isFree ? 1 : std::min(request.layers, Tried), request.growth, request.bothEnds);
  }
  return request;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLayeredSweepAlgorithm.h"

#include "HexSweepLists.h"

//------------------------------------------------------------------------------
void vtkLayeredSweepAlgorithm::AddLayerPosition(double position)
{
  hexsweep::addToList(this, this->LayerPositions, position);
}

//------------------------------------------------------------------------------
void vtkLayeredSweepAlgorithm::RemoveAllLayerPositions()
{
  hexsweep::clearList(this, this->LayerPositions);
}

//------------------------------------------------------------------------------
double vtkLayeredSweepAlgorithm::GetLayerPosition(int i) const
{
  return this->LayerPositions.at(static_cast<std::size_t>(i));
}

//------------------------------------------------------------------------------
void vtkLayeredSweepAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  hexsweep::printList(os, indent, "LayerPositions", this->LayerPositions);
  os << indent << "NumberOfLayers: " << this->NumberOfLayers << "\n";
  os << indent << "LayerSize: " << this->LayerSize << "\n";
  os << indent << "GrowthRatio: " << this->GrowthRatio << "\n";
  os << indent << "GrowFromBothEnds: " << (this->GrowFromBothEnds ? "On" : "Off") << "\n";
}

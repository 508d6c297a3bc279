// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLayeredSweepAlgorithm
 * @brief What filters that make the layers of a sweep have in common: how many, and how thick.
 *
 * Numbers out of range are errors when the filter runs.
 */
#ifndef vtkLayeredSweepAlgorithm_h
#define vtkLayeredSweepAlgorithm_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <vector> // For the layer positions

class VTKFILTERSHEXSWEEP_EXPORT vtkLayeredSweepAlgorithm : public vtkUnstructuredGridAlgorithm
{
public:
  vtkTypeMacro(vtkLayeredSweepAlgorithm, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Layers of cells between source and target, >= 1; 10 by default. vtkOneToOneSweep: 0 (its
  /// default) leaves them to Size.
  vtkSetMacro(NumberOfLayers, vtkIdType);
  vtkGetMacro(NumberOfLayers, vtkIdType);
  ///@}

  ///@{
  /// Wanted mean thickness of the layers, in the unit of the coordinates; where it is not 0 (the
  /// default) it counts instead of NumberOfLayers.
  vtkSetMacro(LayerSize, double);
  vtkGetMacro(LayerSize, double);
  ///@}

  ///@{
  /// Thickness of a layer over that of the one before it, from source to target, > 0; 1 by default.
  vtkSetMacro(GrowthRatio, double);
  vtkGetMacro(GrowthRatio, double);
  ///@}

  ///@{
  /// Let layers grow from both caps to the middle. Off by default.
  vtkSetMacro(GrowFromBothEnds, bool);
  vtkGetMacro(GrowFromBothEnds, bool);
  vtkBooleanMacro(GrowFromBothEnds, bool);
  ///@}

  ///@{
  /// Where the layers meet, strictly rising in (0, 1): fractions of each column's length from the
  /// source. Where there are any they count instead of the number, size and growth of layers.
  void AddLayerPosition(double position);
  void RemoveAllLayerPositions();
  int GetNumberOfLayerPositions() const { return static_cast<int>(this->LayerPositions.size()); }
  double GetLayerPosition(int i) const;
  ///@}

protected:
  vtkLayeredSweepAlgorithm() = default;
  ~vtkLayeredSweepAlgorithm() override = default;

private:
  vtkLayeredSweepAlgorithm(const vtkLayeredSweepAlgorithm&) = delete;
  void operator=(const vtkLayeredSweepAlgorithm&) = delete;

  std::vector<double> LayerPositions;
  vtkIdType NumberOfLayers = 10;
  double LayerSize = 0.0;
  double GrowthRatio = 1.0;
  bool GrowFromBothEnds = false;
};

#endif

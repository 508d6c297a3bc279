// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cell arrays and the report in which filters say how good hexahedra are. Private to the
 * module.
 */
#ifndef HexSweepQualityArrays_h
#define HexSweepQualityArrays_h

#include "Core/Hexahedra/HexQuality.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

class vtkDataSetAttributes;
class vtkFieldData;

namespace hexsweep
{
/// `ScaledJacobian`, `JacobianLowerBound` and `Validity` of each cell.
class QualityArrays
{
public:
  explicit QualityArrays(vtkIdType cells);

  void set(vtkIdType cell, const HexQuality& quality)
  {
    this->ScaledJacobian->SetValue(cell, quality.scaledJacobian);
    this->LowerBound->SetValue(cell, quality.jacobianLowerBound);
    this->Verdict->SetValue(cell, static_cast<unsigned char>(quality.validity));
  }

  /// As set, but for HexQuality::insideOut.
  HexQuality quality(vtkIdType cell) const;

  void addTo(vtkDataSetAttributes* cellData) const;

private:
  vtkNew<vtkDoubleArray> ScaledJacobian;
  vtkNew<vtkDoubleArray> LowerBound;
  vtkNew<vtkUnsignedCharArray> Verdict;
};

/// The `SweepReport*` entries of a summary, from `SweepReportHexes` on.
void addQualityReport(vtkFieldData* fieldData, const HexQualitySummary& summary);
}

#endif

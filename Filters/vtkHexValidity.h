// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexValidity
 * @brief Judges every hexahedron of a data set.
 *
 * The output is the input with two more cell arrays:
 *
 * - `ScaledJacobian` (double): the least over the corners and the centre, as Verdict defines it
 *   (SAND2007-1751), in [-1, 1]; 0 or less where an edge has no length, not a number for cells
 *   that are not judged and for coordinates that are not finite.
 * - `Validity` (unsigned char): 1 a corner Jacobian is not positive, 2 positive corners but not
 *   positive at the centre, 3 undecided (positive corners prove nothing about the inside), 4
 *   degenerate (an edge without length, a coordinate that is not finite), 5 not a cell type that
 *   is judged. 0, certified, needs a proof and is not given by these tests.
 *
 * Hexahedra (VTK_HEXAHEDRON) and voxels (VTK_VOXEL) are judged; the hidden cells and ghost copies
 * of a distributed data set are left out of the report.
 *
 * Field data: `SweepReportHexes`, `SweepReportInverted` (Validity 1 and 2),
 * `SweepReportDegenerate`, `SweepReportNotCertified` (everything but 0),
 * `SweepReportMinScaledJacobian`, `SweepReportMeanScaledJacobian`.
 *
 * Inverted or degenerate hexahedra raise a warning that says how many, where the first ten are and
 * what to do; a mesh that is inside out as a whole is named as such.
 */
#ifndef vtkHexValidity_h
#define vtkHexValidity_h

#include "vtkDataSetAlgorithm.h"
#include "vtkFiltersHexSweepModule.h" // For export macro

class VTKFILTERSHEXSWEEP_EXPORT vtkHexValidity : public vtkDataSetAlgorithm
{
public:
  static vtkHexValidity* New();
  vtkTypeMacro(vtkHexValidity, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of the cell array `Validity`.
  enum ValidityType
  {
    CERTIFIED = 0,
    INVERTED_CORNER = 1,
    INVERTED_INSIDE = 2,
    UNDECIDED = 3,
    DEGENERATE = 4,
    NOT_JUDGED = 5
  };

  ///@{
  /**
   * Raise an error and return an empty output where a hexahedron is inverted or degenerate,
   * instead of a warning. Off by default.
   */
  vtkSetMacro(FailIfInvalid, bool);
  vtkGetMacro(FailIfInvalid, bool);
  vtkBooleanMacro(FailIfInvalid, bool);
  ///@}

protected:
  vtkHexValidity() = default;
  ~vtkHexValidity() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHexValidity(const vtkHexValidity&) = delete;
  void operator=(const vtkHexValidity&) = delete;

  bool FailIfInvalid = false;
};

#endif

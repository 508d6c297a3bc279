// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexValidity
 * @brief Judges every hexahedron of a data set, with a proof.
 *
 * A hexahedron is valid when the Jacobian of its trilinear map is positive at every point, which
 * positive corners do not prove. Here the Jacobian is written in Bezier form and bisected until its
 * coefficients prove the one or the other (A. Johnen, J.-C. Weill, J.-F. Remacle, "Robust and
 * efficient validation of the linear hexahedral element", Procedia Engineering 203, 2017). Rounding
 * is accounted for: the verdicts hold in exact arithmetic for the coordinates as they are stored.
 *
 * The output is the input with three more cell arrays:
 *
 * - `Validity` (unsigned char): 0 certified, the Jacobian is positive everywhere; 1 a corner
 *   Jacobian is not positive; 2 positive corners, but not positive somewhere between; 3 undecided,
 *   the Jacobian touches zero or comes so near to it that 400 bisections do not tell; 4 degenerate
 *   (an edge without length, a coordinate that is not finite); 5 not a cell type that is judged.
 * - `ScaledJacobian` (double): the least over the corners and the centre, as Verdict defines it
 *   (SAND2007-1751), in [-1, 1]; 0 or less where an edge has no length, not a number for cells
 *   that are not judged and for coordinates that are not finite.
 * - `JacobianLowerBound` (double, length^3): a bound from below of the least Jacobian over the
 *   hexahedron, as a map of the unit cube (for a box, its volume). Never above the true minimum,
 *   and within 1 % of it but where the minimum nearly vanishes; not a number for 4 and 5.
 *
 * Hexahedra (VTK_HEXAHEDRON) and voxels (VTK_VOXEL) are judged; the hidden cells and ghost copies
 * of a distributed data set are left out of the report.
 *
 * Field data: `SweepReportHexes`, `SweepReportInverted` (Validity 1 and 2),
 * `SweepReportInvertedInside` (2), `SweepReportDegenerate`, `SweepReportUndecided`,
 * `SweepReportNotCertified` (everything but 0), `SweepReportMinScaledJacobian`,
 * `SweepReportMeanScaledJacobian`, `SweepReportMinJacobianLowerBound`.
 *
 * Inverted or degenerate hexahedra raise a warning that says how many, where the first ten are and
 * what to do, and so do undecided ones; a mesh that is inside out as a whole is named as such.
 *
 * Runs on the threads of vtkSMPTools; the result does not depend on their number.
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

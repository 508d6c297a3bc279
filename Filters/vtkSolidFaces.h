// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSolidFaces
 * @brief A table of the faces of a solid, to choose the source cap from.
 *
 * Takes the solid that vtkOneToOneSweep takes and finds its faces as that filter does: by the cell
 * array with the face ids, see SetInputArrayToProcess(), or, where there is none, by the angle
 * between neighbouring triangles.
 *
 * The output has one row a face, in the order of the ids, with the columns
 * - `FaceId`,
 * - `Triangles`: how many,
 * - `Area`, and `Center` (3 components): the area's centroid, in the unit of the coordinates,
 * - `Flatness`, in [0, 1]: 1 for a plane face, 0 for one that closes round,
 * - `VolumeId`: the body,
 * - `Name` and `Surface`: what a CAD file calls the face, and its kind of surface ("plane",
 *   "cylinder", ...); empty where they are not known.
 * Its field data tell whether the faces were found by angle (`SweepReportFacesByAngle`, 0 or 1).
 *
 * A surface that does not bound a solid raises one error, as in vtkOneToOneSweep.
 */
#ifndef vtkSolidFaces_h
#define vtkSolidFaces_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkTableAlgorithm.h"

class VTKFILTERSHEXSWEEP_EXPORT vtkSolidFaces : public vtkTableAlgorithm
{
public:
  static vtkSolidFaces* New();
  vtkTypeMacro(vtkSolidFaces, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// See vtkOneToOneSweep; 30 degrees by default.
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /// See vtkOneToOneSweep; in [0, 0.1], 1e-6 by default.
  vtkSetClampMacro(MatchTolerance, double, 0.0, 0.1);
  vtkGetMacro(MatchTolerance, double);
  ///@}

protected:
  vtkSolidFaces() = default;
  ~vtkSolidFaces() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSolidFaces(const vtkSolidFaces&) = delete;
  void operator=(const vtkSolidFaces&) = delete;

  double FeatureAngle = 30.0;
  double MatchTolerance = 1e-6;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSweepCandidates
 * @brief A table of the ways in which a solid can be swept, best first, without meshing it.
 *
 * Takes the solid that vtkOneToOneSweep takes, finds its faces as that filter does, and ranks the
 * pairs of caps between which it can be swept: caps that stand upright on their sides and are alike
 * in area and shape, sides along one direction, a short way, few edges across it. The first row is
 * what vtkOneToOneSweep meshes where no face is named.
 *
 * The output has one row a candidate, with the columns
 * - `Rank`, from 1,
 * - `SourceFaceIds` and `TargetFaceIds`: text, ids with blanks between,
 * - `Score`, in [0, 1],
 * - `Verdict`: "fits", "poor" (it can be swept, but a wide shoulder is in the way; see `Reasons`)
 * or "refused",
 * - `Reasons`, in words.
 * Its field data tell whether there were more caps than were tried (`SweepReportCandidatesCut`, 0
 * or 1).
 *
 * A surface that does not bound a solid raises one error, as in vtkOneToOneSweep.
 */
#ifndef vtkSweepCandidates_h
#define vtkSweepCandidates_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <vector> // For lists of ids

class VTKFILTERSHEXSWEEP_EXPORT vtkSweepCandidates : public vtkTableAlgorithm
{
public:
  static vtkSweepCandidates* New();
  vtkTypeMacro(vtkSweepCandidates, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Ids of the faces that are the source cap, in any order. None (the default): all pairs of caps
  /// are ranked, else the targets of this one.
  void AddSourceFaceId(vtkIdType id);
  void RemoveAllSourceFaceIds();
  int GetNumberOfSourceFaceIds() const { return static_cast<int>(this->SourceFaceIds.size()); }
  vtkIdType GetSourceFaceId(int i) const;
  ///@}

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
  vtkSweepCandidates() = default;
  ~vtkSweepCandidates() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSweepCandidates(const vtkSweepCandidates&) = delete;
  void operator=(const vtkSweepCandidates&) = delete;

  std::vector<vtkIdType> SourceFaceIds;
  double FeatureAngle = 30.0;
  double MatchTolerance = 1e-6;
};

#endif

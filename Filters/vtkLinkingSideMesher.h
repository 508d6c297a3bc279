// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkLinkingSideMesher
 * @brief Meshes the linking sides of a swept volume with structured quads.
 *
 * Step (3) of the introduction of S. Cai and T. J. Tautges, "Robust One-to-One Sweeping with
 * Harmonic S-T Mappings and Cages", 22nd International Meshing Roundtable, 2013. Each linking side,
 * a tube between a loop of the source cap and a loop of the target cap, is mapped harmonically to a
 * strip, in which the quads are laid out by transfinite interpolation. Their nodes lie on the given
 * triangles, the first ring on the nodes of the source quads.
 *
 * Inputs, vtkUnstructuredGrid or vtkPolyData (vertex and line cells are ignored):
 * - port 0 `SourceQuads`: quads of the source cap;
 * - port 1 `LinkingSurface`: the sides, one piece a loop (points may be repeated along edges). The
 *   borders between faces (cell array, see SetInputArrayToProcess(); `FaceId`, then `CellEntityIds`
 *   by default; without one, edges sharper than FeatureAngle) that lead from source to target
 * become columns of the quads where a node of the source quads begins them. Faces that are meshed
 * with structured quads from source to target already keep their nodes;
 * - port 2 `TargetSurface`, optional: the target cap, to check that the sides end there.
 *
 * Output: the quads of one side after the other. Point arrays `SourcePointIds` (the source point
 * that the column begins at) and `SweepLayer` (the ring); cell arrays `SweepLayer`, `LoopId` (loop
 * of the source quads) and `BoundaryId` (face id, where there are any). Field data
 * `SweepReportLayers`, `SweepReportKeptEdges`, `SweepReportLostEdges`,
 * `SweepReportMeanColumnLength`, `SweepReportIgnoredCells` (of the source quads),
 * `SweepReportStages` and `SweepReportSeconds`.
 */
#ifndef vtkLinkingSideMesher_h
#define vtkLinkingSideMesher_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkLayeredSweepAlgorithm.h"

class VTKFILTERSHEXSWEEP_EXPORT vtkLinkingSideMesher : public vtkLayeredSweepAlgorithm
{
public:
  static vtkLinkingSideMesher* New();
  vtkTypeMacro(vtkLinkingSideMesher, vtkLayeredSweepAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Quads of the source cap: port 0.
  void SetSourceQuadsConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(0, output); }
  void SetSourceQuadsData(vtkDataObject* data) { this->SetInputData(0, data); }
  ///@}

  ///@{
  /// The tessellated linking sides: port 1.
  void SetLinkingSurfaceConnection(vtkAlgorithmOutput* output)
  {
    this->SetInputConnection(1, output);
  }
  void SetLinkingSurfaceData(vtkDataObject* data) { this->SetInputData(1, data); }
  ///@}

  ///@{
  /// The target cap: port 2, optional.
  void SetTargetSurfaceConnection(vtkAlgorithmOutput* output)
  {
    this->SetInputConnection(2, output);
  }
  void SetTargetSurfaceData(vtkDataObject* data) { this->SetInputData(2, data); }
  ///@}

  ///@{
  /// Degrees, in (0, 180): without face ids, edges at which the surface bends by more are edges of
  /// the solid. 30 by default.
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /// Distance up to which points count as the same, relative to the local edge length, in [0, 0.1].
  /// 1e-6 by default.
  vtkSetClampMacro(MatchTolerance, double, 0.0, 0.1);
  vtkGetMacro(MatchTolerance, double);
  ///@}

  ///@{
  /// A vtkAlgorithm::DesiredOutputPrecision; DEFAULT_PRECISION (the default) means double.
  vtkSetMacro(OutputPointsPrecision, int);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

protected:
  vtkLinkingSideMesher();
  ~vtkLinkingSideMesher() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkLinkingSideMesher(const vtkLinkingSideMesher&) = delete;
  void operator=(const vtkLinkingSideMesher&) = delete;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs);

  double FeatureAngle = 30.0;
  double MatchTolerance = 1e-6;
  int OutputPointsPrecision = DEFAULT_PRECISION;
};

#endif

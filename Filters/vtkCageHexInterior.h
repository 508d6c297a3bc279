// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCageHexInterior
 * @brief Fills a swept volume with hexahedra between its meshed caps and linking sides.
 *
 * The last step of one-to-one sweeping, section 4 of S. Cai and T. J. Tautges, "Robust One-to-One
 * Sweeping with Harmonic S-T Mappings and Cages", 22nd International Meshing Roundtable, 2013:
 * source quads, target quads and linking sides form a cage; the interior nodes are placed in it.
 *
 * Inputs, vtkUnstructuredGrid or vtkPolyData (vertex and line cells are ignored):
 * - port 0 `SourceQuads`: the quads of the source cap, oriented consistently, either way;
 * - port 1 `TargetQuads`: the same points and cells in the same order on the target cap (see
 *   vtkSweepQuadProjector), of any orientation;
 * - port 2 `LinkingSides`: structured quads between the loops, of any orientation; patches may
 *   repeat the points of their seams.
 *
 * Output port 0, N source points, M source quads, L layers: hexahedron k*M + j is source quad j in
 * layer k, point k*N + i is source point i on layer k (0 the source, L the target). Hexahedra are
 * right-handed whichever way the quads face. Points that no quad uses keep their place in the
 * numbering. Output port 1: the topological model, see SetGenerateTopologicalModel().
 *
 * Arrays: point `SourcePointIds`, `SweepLayer`; cell `SourceCellIds`, `SweepLayer`,
 * `ScaledJacobian`, `JacobianLowerBound` and `Validity` (see vtkHexValidity, whose report is in the
 * field data as well); point and cell data of the source quads on every layer; field data of source
 * and target quads. Reported in the field data besides: `SweepReportMethod` (what really ran, e.g.
 * "Blend + untangling + polish"), `SweepReportStages` and `SweepReportSeconds`; with EnsureValid
 * also `SweepReportSteps` with `SweepReportStepNotCertified` (how many hexahedra are not certified
 * after each step) and `SweepReportStepMended` (how many fewer than before it),
 * `SweepReportFloorScaledJacobian` (the least scaled Jacobian of corners whose four nodes are on
 * the boundary: no interior can be better) and `SweepReportCornerConflicts` (hexahedra that caps
 * and linking sides alone make bad, by corners that contradict each other, folds, columns that run
 * back or points that coincide).
 *
 * Inverted or degenerate hexahedra raise a warning that says how many, where the first ten are and
 * what to do. Input that cannot be swept raises one error, and the output is empty.
 *
 * Methods, weights and other choices take any number; one that means nothing is an error when the
 * filter runs, which names those that do.
 */
#ifndef vtkCageHexInterior_h
#define vtkCageHexInterior_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKFILTERSHEXSWEEP_EXPORT vtkCageHexInterior : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkCageHexInterior* New();
  vtkTypeMacro(vtkCageHexInterior, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The quads of the source cap: port 0.
  void SetSourceQuadsConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(0, output); }
  void SetSourceQuadsData(vtkDataObject* data) { this->SetInputData(0, data); }
  ///@}

  ///@{
  /// The same quads on the target cap: port 1.
  void SetTargetQuadsConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetTargetQuadsData(vtkDataObject* data) { this->SetInputData(1, data); }
  ///@}

  ///@{
  /// The structured quads of the linking sides: port 2.
  void SetLinkingSidesConnection(vtkAlgorithmOutput* output)
  {
    this->SetInputConnection(2, output);
  }
  void SetLinkingSidesData(vtkDataObject* data) { this->SetInputData(2, data); }
  ///@}

  /// How the interior nodes are placed.
  enum MethodType
  {
    AUTOMATIC = 0,              ///< from cheap to strong, up to the first that is certified
    BLEND = 1,                  ///< affine images of both caps blended, corrected harmonically
    HARMONIC_COORDINATES = 2,   ///< the paper's: harmonic coordinates of the topological model
    MEAN_VALUE_COORDINATES = 3, ///< mean value coordinates (Ju, Schaefer, Warren 2005)
    GREEN_COORDINATES = 4,      ///< Green coordinates (Lipman, Levin, Cohen-Or 2008)
    LAYER_MARCH = 5,            ///< layer by layer from both ends
    AFFINE_BOUNDARY_ERROR = 6   ///< affine maps and residuals by inverse distance, for comparison
  };

  ///@{
  /**
   * The method; AUTOMATIC by default: BLEND; where the caps bulge in different ways,
   * HARMONIC_COORDINATES or BLEND with bulges that fade into the volume, if one of these promises
   * more; where its hexahedra are not all certified, even after EnsureValid, the others of them and
   * LAYER_MARCH; the best is kept. Where loops turn by more than 137 degrees about each other on
   * the way, source quads carried along the sides come first ("Sections"), by more than 30 degrees
   * last. `SweepReportMethod` in the field data of the output says what ran.
   *
   * A named method gives that method; EnsureValid then untangles locally and nothing else is done.
   * MEAN_VALUE_COORDINATES and GREEN_COORDINATES visit every triangle of the boundary for every
   * interior node: minutes for some ten thousand hexahedra.
   */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  void SetMethodToAutomatic() { this->SetMethod(AUTOMATIC); }
  void SetMethodToBlend() { this->SetMethod(BLEND); }
  void SetMethodToHarmonicCoordinates() { this->SetMethod(HARMONIC_COORDINATES); }
  void SetMethodToMeanValueCoordinates() { this->SetMethod(MEAN_VALUE_COORDINATES); }
  void SetMethodToGreenCoordinates() { this->SetMethod(GREEN_COORDINATES); }
  void SetMethodToLayerMarch() { this->SetMethod(LAYER_MARCH); }
  void SetMethodToAffineBoundaryError() { this->SetMethod(AFFINE_BOUNDARY_ERROR); }
  ///@}

  ///@{
  /**
   * Distance up to which a loop node and a linking node count as the same point, relative to the
   * shortest mesh edge at the node, in [0, 0.1]. 1e-6 by default; the rounding of single precision
   * files is allowed for on top of it. Nodes so matched are snapped to the caps.
   */
  vtkSetClampMacro(MatchTolerance, double, 0.0, 0.1);
  vtkGetMacro(MatchTolerance, double);
  ///@}

  ///@{
  /**
   * Precision of the output points, a vtkAlgorithm::DesiredOutputPrecision. DEFAULT_PRECISION (the
   * default) means double. Quality is judged on the coordinates as stored.
   */
  vtkSetMacro(OutputPointsPrecision, int);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * Untangle the hexahedra that are not certified: patches of three rings around them are optimised
   * (Garanzha et al., "Foldover-free maps in 50 lines of code", 2021), all else stays as it is. On
   * by default. Off returns what the method gives; other methods are compared with it off.
   */
  vtkSetMacro(EnsureValid, bool);
  vtkGetMacro(EnsureValid, bool);
  vtkBooleanMacro(EnsureValid, bool);
  ///@}

  ///@{
  /**
   * With the method AUTOMATIC and EnsureValid: raise the least scaled Jacobian up to what the
   * boundary allows (`SweepReportFloorScaledJacobian`), then the others, a fixed number of times
   * round the mesh. No certificate is lost, and the least scaled Jacobian never
   * falls. On by default.
   */
  vtkSetMacro(ImproveQuality, bool);
  vtkGetMacro(ImproveQuality, bool);
  vtkBooleanMacro(ImproveQuality, bool);
  ///@}

  ///@{
  /**
   * Prove for each hexahedron that it is valid at every point, or that it is not (`Validity`, as
   * vtkHexValidity gives it). On by default. Off: `Validity` tells what corners and centre tell, 3
   * (undecided) where they are positive, and there is no `JacobianLowerBound` (not a number).
   */
  vtkSetMacro(Certify, bool);
  vtkGetMacro(Certify, bool);
  vtkBooleanMacro(Certify, bool);
  ///@}

  ///@{
  /**
   * Fill output port 1 with the topological model: the target quads translated against the sweeping
   * direction, section 4.2 (1) of the paper, numbered as the hexahedra. Off by default.
   */
  vtkSetMacro(GenerateTopologicalModel, bool);
  vtkGetMacro(GenerateTopologicalModel, bool);
  vtkBooleanMacro(GenerateTopologicalModel, bool);
  ///@}

  ///@{
  /**
   * Raise an error and return an empty output where a hexahedron is inverted or degenerate, instead
   * of a warning. Off by default.
   */
  vtkSetMacro(FailIfInvalid, bool);
  vtkGetMacro(FailIfInvalid, bool);
  vtkBooleanMacro(FailIfInvalid, bool);
  ///@}

protected:
  vtkCageHexInterior();
  ~vtkCageHexInterior() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCageHexInterior(const vtkCageHexInterior&) = delete;
  void operator=(const vtkCageHexInterior&) = delete;

  int Method = AUTOMATIC;
  double MatchTolerance = 1e-6;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  bool EnsureValid = true;
  bool ImproveQuality = true;
  bool Certify = true;
  bool GenerateTopologicalModel = false;
  bool FailIfInvalid = false;
};

#endif

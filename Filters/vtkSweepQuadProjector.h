// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSweepQuadProjector
 * @brief Carries the quad mesh of the source cap to the target cap of a swept volume.
 *
 * Both caps are mapped harmonically to a domain that they share; each interior node goes from the
 * source surface through the domain to the target surface, each boundary node to the end of its
 * column of the linking sides. Section 3.2 of S. Cai, T. J. Tautges, "Robust One-to-One Sweeping
 * with Harmonic S-T Mappings and Cages", 22nd International Meshing Roundtable, 2013.
 *
 * That section pins the source cap to the canonical domain of the target cap instead;
 * PAPER_HARMONIC does so to the letter, for comparison. Its map folds where a hole grows or turns
 * too much. For one hole that is the Nitsche bound: with the hole's radius r in the annulus that
 * the source cap is conformal to (outer radius 1), rho in that of the target cap, and the angle
 * theta by which the hole turns against the outer loop, the map is one-to-one only if rho < 2 r
 * cos(theta) / (1 + r^2). To stay below is no promise where columns run unevenly along the loops,
 * and for more holes no closed form is known; flips are counted and reported as for HARMONIC.
 *
 * A map between the caps takes the shortest turn. Where loops turn further about each other, or
 * against the outer loop, on their way along the linking sides (more than 137 degrees, or where
 * HARMONIC leaves folds), the quads are carried from ring to ring instead, in the planes of the
 * outer rings, so that they wind as the sides do. Quads that are too coarse for that raise a
 * warning which names the holes. Disk maps that are given (DiskMaps = FROM_INPUT) are used as they
 * are.
 *
 * Inputs (vtkUnstructuredGrid or vtkPolyData):
 * - 0 SourceQuads: all-quad mesh of the source cap, consistently oriented.
 * - 1 TargetSurface: the target cap (polygons and strips are triangulated).
 * - 2 LinkingSides (optional): structured quads between the caps; the first ring's nodes are the
 *   boundary nodes of the source quads. Without them loops are matched by shape, corner on corner
 *   where that fits and by arc length in between; `SweepReportLoopStarts` then tells where each
 *   loop of the source begins on the target (a fraction of the length of the target's loop from its
 *   first node), and close calls, which may twist the sweep, raise a warning.
 * - 3 SourceSurface (optional): triangulation of the source cap; the quads' own otherwise.
 *
 * Outputs:
 * - 0 the quads on the target cap: the points of the source quads in the same order, the same
 *   cells with the same data, and the cell array `ScaledJacobian`, measured against the normal of
 *   the target surface. Field data: `SweepReportMethod` (the method), `SweepReportWeights` (of
 *   the target cap's map, as vtkHarmonicDiskMap reports them), `SweepReportInvertedQuads` and
 *   `SweepReportInvertedBefore` (as projected, before EnsureValid), `SweepReportRounds` (descents),
 *   `SweepReportMinScaledJacobian`, `SweepReportMeanScaledJacobian`,
 *   `SweepReportFloorScaledJacobian`: the least scaled Jacobian of the corners whose own node and
 *   both neighbours are boundary nodes, in [-1, 1], 1 where there is no such corner. The boundary
 *   alone decides it, and no placement of the inner nodes has a higher minimum: a result at it is
 *   as good as the worst quad can be. `SweepReportFixedInvertedQuads`: quads with such a corner
 *   <= 0 (180 degrees or more between two boundary edges), which EnsureValid cannot cure; they are
 *   part of `SweepReportInvertedQuads`, and a warning names them.
 *   `SweepReportMaximumSourceDistance` (of interior nodes from the source surface),
 *   `SweepReportMaximumBoundaryDistance` (of the last ring from the boundary of the target surface;
 *   more than facets of a curve explain raises a warning, more than a quarter of an edge is an
 *   error), `SweepReportIgnoredCells`,
 *   `SweepReportOutside` (nodes that lay in no triangle of the target's disk map),
 *   `SweepReportFlipsBefore`, `SweepReportFlipsAfter` (both caps), and for PAPER_HARMONIC with one
 *   hole `SweepReportNitscheRatio`: 2 r cos(theta) / ((1 + r^2) rho), at 1 and below the map folds.
 *   `SweepReportWinding`: where the quads were carried along the sides, how far loops turn about
 *   each other on the way, in degrees.
 * - 1, 2 source and target cap in their disk, as vtkHarmonicDiskMap gives them; empty for
 *   AFFINE_LEAST_SQUARES, and where the quads were carried along the sides.
 *
 * The unit of length, the axes and the origin do not matter: with HARMONIC and all other settings
 * at their defaults, points agree to 3e-13 of the model's size at 1e-6 and 1e6 times the size and
 * after a rotation (measured on 16 sweeps). Far from the origin the rounding of the input itself
 * shows: d sizes away points agree to about 5e-16 d, which is below 1e-9 a million sizes away;
 * untangling multiplies that by up to a few hundred, which leaves 1e-9 ten thousand sizes away.
 *
 * Inverted quads, flipped triangles and a violated Nitsche bound raise warnings.
 *
 * Methods, weights and other choices take any number; one that means nothing is an error when the
 * filter runs, which names those that do.
 */
#ifndef vtkSweepQuadProjector_h
#define vtkSweepQuadProjector_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKFILTERSHEXSWEEP_EXPORT vtkSweepQuadProjector : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkSweepQuadProjector* New();
  vtkTypeMacro(vtkSweepQuadProjector, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How interior nodes find their place.
  enum MethodType
  {
    HARMONIC = 0,            ///< through harmonic maps to a common domain
    PAPER_HARMONIC = 1,      ///< the source cap pinned to the target's own domain; may fold
    AFFINE_LEAST_SQUARES = 2 ///< affine map fitted to the loops, then along the normal
  };

  /// Where the disk maps of HARMONIC come from.
  enum DiskMapsType
  {
    AUTOMATIC = 0, ///< made here
    FROM_INPUT = 1 ///< `DiskCoordinates` of TargetSurface and SourceSurface
  };

  ///@{
  /// HARMONIC by default.
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  void SetMethodToHarmonic() { this->SetMethod(HARMONIC); }
  void SetMethodToPaperHarmonic() { this->SetMethod(PAPER_HARMONIC); }
  void SetMethodToAffineLeastSquares() { this->SetMethod(AFFINE_LEAST_SQUARES); }
  ///@}

  ///@{
  /// AUTOMATIC by default. FROM_INPUT needs both surfaces from vtkHarmonicDiskMap, each mapped with
  /// the other as its partner; it is an error with PAPER_HARMONIC, which has maps of its own.
  vtkSetMacro(DiskMaps, int);
  vtkGetMacro(DiskMaps, int);
  void SetDiskMapsToAutomatic() { this->SetDiskMaps(AUTOMATIC); }
  void SetDiskMapsToFromInput() { this->SetDiskMaps(FROM_INPUT); }
  ///@}

  ///@{
  /// Edge weights of the harmonic maps, a vtkHarmonicDiskMap::WeightsType; COTANGENT (0) by
  /// default. Without effect on AFFINE_LEAST_SQUARES and on disk maps from the input.
  vtkSetMacro(Weights, int);
  vtkGetMacro(Weights, int);
  void SetWeightsToCotangent() { this->SetWeights(0); }
  void SetWeightsToMeanValue() { this->SetWeights(1); }
  ///@}

  ///@{
  /// Whether the triangulations of the caps may be changed for their maps, a
  /// vtkHarmonicDiskMap::ImproveTriangulationType; AUTOMATIC (1) by default. Without effect as
  /// Weights.
  vtkSetMacro(ImproveTriangulation, int);
  vtkGetMacro(ImproveTriangulation, int);
  void SetImproveTriangulationToOff() { this->SetImproveTriangulation(0); }
  void SetImproveTriangulationToAutomatic() { this->SetImproveTriangulation(1); }
  void SetImproveTriangulationToOn() { this->SetImproveTriangulation(2); }
  ///@}

  ///@{
  /// Move inner nodes over the target surface until no quad is inverted (foldover-free
  /// optimisation), but for corners between two boundary edges, which inner nodes do not reach (see
  /// `SweepReportFixedInvertedQuads`). The result is never worse than the projection. On by
  /// default.
  vtkSetMacro(EnsureValid, bool);
  vtkGetMacro(EnsureValid, bool);
  vtkBooleanMacro(EnsureValid, bool);
  ///@}

  ///@{
  /// Improve the quads afterwards, the worst first, then the mean; never lowers the least scaled
  /// Jacobian of the corners that inner nodes reach. On by default. Meshes with inverted quads are
  /// left as they are, unless these are inverted by their boundary nodes alone.
  vtkSetMacro(ImproveQuality, bool);
  vtkGetMacro(ImproveQuality, bool);
  vtkBooleanMacro(ImproveQuality, bool);
  ///@}

  ///@{
  /// Distance up to which nodes of different inputs are one, relative to the local edge length.
  /// 1e-6 by default, in [0, 0.1].
  vtkSetClampMacro(MatchTolerance, double, 0.0, 0.1);
  vtkGetMacro(MatchTolerance, double);
  ///@}

  ///@{
  /// vtkAlgorithm::DesiredOutputPrecision of the points; the default precision is double.
  vtkSetMacro(OutputPointsPrecision, int);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /// The ports by name.
  void SetSourceQuadsConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(0, output); }
  void SetSourceQuadsData(vtkDataObject* data) { this->SetInputData(0, data); }
  void SetTargetSurfaceConnection(vtkAlgorithmOutput* output)
  {
    this->SetInputConnection(1, output);
  }
  void SetTargetSurfaceData(vtkDataObject* data) { this->SetInputData(1, data); }
  void SetLinkingSidesConnection(vtkAlgorithmOutput* output)
  {
    this->SetInputConnection(2, output);
  }
  void SetLinkingSidesData(vtkDataObject* data) { this->SetInputData(2, data); }
  void SetSourceSurfaceConnection(vtkAlgorithmOutput* output)
  {
    this->SetInputConnection(3, output);
  }
  void SetSourceSurfaceData(vtkDataObject* data) { this->SetInputData(3, data); }
  ///@}

protected:
  vtkSweepQuadProjector();
  ~vtkSweepQuadProjector() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSweepQuadProjector(const vtkSweepQuadProjector&) = delete;
  void operator=(const vtkSweepQuadProjector&) = delete;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs);

  int Method = HARMONIC;
  int DiskMaps = AUTOMATIC;
  int Weights = 0;
  int ImproveTriangulation = 1;
  bool EnsureValid = true;
  bool ImproveQuality = true;
  double MatchTolerance = 1e-6;
  int OutputPointsPrecision = DEFAULT_PRECISION;
};

#endif

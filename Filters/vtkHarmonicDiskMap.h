// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHarmonicDiskMap
 * @brief Maps a cap of a swept volume to the unit disk.
 *
 * A cap is a surface of genus 0 with one or more boundary loops. Its longest loop goes to the unit
 * circle, the interior is harmonic in the surface's own metric. Section 3.1 of S. Cai, T. J.
 * Tautges, "Robust One-to-One Sweeping with Harmonic S-T Mappings and Cages", 22nd International
 * Meshing Roundtable, 2013.
 *
 * Alone, this is the disk map of one cap. With the other cap of the sweep as Partner it is the map
 * into a domain that both share, and vtkSweepQuadProjector (DiskMaps = FromInput) carries quads
 * from output port 0 to output port 1. The shared domain is the unit disk (one loop), an annulus
 * (two), or the disk with circular holes.
 *
 * Inputs (vtkUnstructuredGrid or vtkPolyData; polygons and strips are triangulated):
 * - 0 Input: the cap.
 * - 1 Partner (optional): the other cap.
 * - 2 LinkingSides (optional, used with a partner): structured quads between the two caps. Without
 *   them loops are matched by shape; close calls raise a warning.
 *
 * Output port 0, "Mapped Surface": the triangles of the cap with the point arrays `DiskCoordinates`
 * (3 components, z = 0), `OriginalPointIds` (-1 on points that were added at the end: where the
 * partner has a boundary node, on chords, and for ImproveTriangulation) and the cell array
 * `OriginalCellIds`. Field data: `DiskMapDomain` (Disk, Annulus or Circles), `HoleCircles` (centre
 * x, y, radius), `SweepReportWeights` (the weights that were used in the end: Cotangent,
 * IntrinsicCotangent or MeanValue; `SweepReportMethod` is another name of the same),
 * `SweepReportFlipsBefore` and `SweepReportFlipsAfter` (triangles
 * flipped with the wanted weights, and in the result), `SweepReportEdgeFlips` and
 * `SweepReportAddedPoints` (what ImproveTriangulation did), `SweepReportIgnoredCells` (vertices and
 * lines), `SweepReportLoops`, `SweepReportDirichletEnergy` (no less than the area of the image,
 * which it equals for a conformal map), `SweepReportWorstAngleDistortion` and
 * `SweepReportMeanAngleDistortion` (corners of triangles, in degrees). After Koebe's iteration also
 * `SweepReportKoebeRounds`, `SweepReportKoebeConverged`, `SweepReportKoebeChanges` (a number a
 * round from the second on, see Tolerance) and `SweepReportCircularity` (a number a loop: how far
 * its image was from a circle, over the radius, before its nodes were put onto it). With a partner
 * but no linking sides `SweepReportLoopStarts` (see vtkSweepQuadProjector).
 *
 * Output port 1, "Partner": the same of the other cap, but for `SweepReportLoopStarts`; empty
 * without a partner. With linking sides it is, bit for bit, port 0 of a filter that maps the
 * partner with this cap as its partner. Flips in it raise no warning, see its
 * `SweepReportFlipsAfter`.
 *
 * In an annulus the map is linear in (log r, angle) over each triangle; flips are counted there.
 * Flips that remain raise a warning.
 *
 * Methods, weights and other choices take any number; one that means nothing is an error when the
 * filter runs, which names those that do.
 */
#ifndef vtkHarmonicDiskMap_h
#define vtkHarmonicDiskMap_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKFILTERSHEXSWEEP_EXPORT vtkHarmonicDiskMap : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkHarmonicDiskMap* New();
  vtkTypeMacro(vtkHarmonicDiskMap, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Edge weights of the harmonic energy.
  enum WeightsType
  {
    COTANGENT = 0, ///< exact for the metric; mean value weights replace them where they fold
    MEAN_VALUE = 1 ///< positive on every triangulation
  };

  /// Where holes go when a cap is mapped alone.
  enum HoleTreatmentType
  {
    KOEBE = 0,      ///< the circles that the cap is conformal to
    ARC_LENGTH = 1, ///< circles; nodes on them by arc length
    FILLED = 2      ///< wherever the harmonic map of the cap with filled holes puts them
  };

  /// Whether the cap's triangulation may be changed for its map.
  enum ImproveTriangulationType
  {
    OFF = 0,       ///< never
    AUTOMATIC = 1, ///< where triangles are stretched, inner nodes are missing, or the map flips
    ON = 2         ///< always
  };

  ///@{
  /// COTANGENT by default.
  vtkSetMacro(Weights, int);
  vtkGetMacro(Weights, int);
  void SetWeightsToCotangent() { this->SetWeights(COTANGENT); }
  void SetWeightsToMeanValue() { this->SetWeights(MEAN_VALUE); }
  ///@}

  ///@{
  /// KOEBE by default. Without a partner only.
  vtkSetMacro(HoleTreatment, int);
  vtkGetMacro(HoleTreatment, int);
  void SetHoleTreatmentToKoebe() { this->SetHoleTreatment(KOEBE); }
  void SetHoleTreatmentToArcLength() { this->SetHoleTreatment(ARC_LENGTH); }
  void SetHoleTreatmentToFilled() { this->SetHoleTreatment(FILLED); }
  ///@}

  ///@{
  /// Koebe's iteration ends when a round changes the centres and radii of the holes by no more
  /// than this: the sum of the squares, in a disk of radius 1 (step 6 of the paper's section
  /// 3.1.2). 1e-10 by default.
  vtkSetClampMacro(Tolerance, double, 0.0, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// It ends after this many rounds in any case; a warning says so. 20 by default.
  vtkSetClampMacro(MaximumIterations, int, 1, 1000);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /**
   * AUTOMATIC by default. The surface, its boundary and its points stay as they are: edges between
   * coplanar triangles are flipped, weights come from the intrinsic Delaunay triangulation, and
   * points are added on edges (OriginalPointIds -1) where nothing less keeps triangles from being
   * flipped in the disk, and inside caps that have no inner nodes. A flipped edge's triangles get
   * the OriginalCellIds of the cell that contains their middle. Use the same value for a cap and
   * its partner.
   */
  vtkSetMacro(ImproveTriangulation, int);
  vtkGetMacro(ImproveTriangulation, int);
  void SetImproveTriangulationToOff() { this->SetImproveTriangulation(OFF); }
  void SetImproveTriangulationToAutomatic() { this->SetImproveTriangulation(AUTOMATIC); }
  void SetImproveTriangulationToOn() { this->SetImproveTriangulation(ON); }
  ///@}

  ///@{
  /// Put the output points in the disk and the surface's own in the point array `SurfacePoints`.
  /// Off by default.
  vtkSetMacro(OutputDisk, bool);
  vtkGetMacro(OutputDisk, bool);
  vtkBooleanMacro(OutputDisk, bool);
  ///@}

  ///@{
  /// Distance up to which nodes of a cap and of the linking sides are one, relative to the local
  /// edge length. 1e-6 by default, in [0, 0.1].
  vtkSetClampMacro(MatchTolerance, double, 0.0, 0.1);
  vtkGetMacro(MatchTolerance, double);
  ///@}

  ///@{
  /// vtkAlgorithm::DesiredOutputPrecision of the points; the default precision is double.
  vtkSetMacro(OutputPointsPrecision, int);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /// Ports 1 and 2 by name.
  void SetPartnerConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetPartnerData(vtkDataObject* data) { this->SetInputData(1, data); }
  void SetLinkingSidesConnection(vtkAlgorithmOutput* output)
  {
    this->SetInputConnection(2, output);
  }
  void SetLinkingSidesData(vtkDataObject* data) { this->SetInputData(2, data); }
  ///@}

protected:
  vtkHarmonicDiskMap();
  ~vtkHarmonicDiskMap() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHarmonicDiskMap(const vtkHarmonicDiskMap&) = delete;
  void operator=(const vtkHarmonicDiskMap&) = delete;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs);

  int Weights = COTANGENT;
  int HoleTreatment = KOEBE;
  double Tolerance = 1e-10;
  int MaximumIterations = 20;
  int ImproveTriangulation = AUTOMATIC;
  bool OutputDisk = false;
  double MatchTolerance = 1e-6;
  int OutputPointsPrecision = DEFAULT_PRECISION;
};

#endif

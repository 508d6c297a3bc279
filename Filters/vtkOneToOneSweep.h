// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkOneToOneSweep
 * @brief Meshes a solid with hexahedra by sweeping the quads of one face to another.
 *
 * Give it the boundary of a solid as triangles with face ids, as CAD systems and gmsh export it,
 * and, if you like, name the source face. Everything else is found or made: the source face, the
 * target face, the sides between the two and which of their loops belong together, structured quads
 * on the sides, the quads of the source face on the target face, the interior. The method is that
 * of S. Cai and T. J. Tautges, "Robust One-to-One Sweeping with Harmonic S-T Mappings and Cages",
 * 22nd International Meshing Roundtable, 2013.
 *
 * Inputs, vtkUnstructuredGrid or vtkPolyData, the solid also as a collection of them (of
 * vtkCADReader, say), one solid a data set:
 * - port 0 `Solid`: a closed surface (points may be repeated along edges), or a volume mesh, whose
 *   boundary is taken. The faces are told apart by a cell array, see SetInputArrayToProcess();
 *   without one by the angle between neighbouring triangles.
 * - port 1 `SourceQuads`, optional: quads on the source face. Without it: quad cells on the source
 *   face of the solid, where it is meshed with these; otherwise quads are made, see SetSize().
 * - ports 2 `SourceSelection` and 3 `TargetSelection`, optional, vtkSelection: lists of cells of
 * the solid, whose faces are the source and the target cap. For those who pick faces in a view
 * instead of naming ids.
 *
 * A solid of several bodies is swept body by body: those with one `VolumeId` (a cell array of
 * surface cells), without it pieces that are not connected, numbered from 1 on. Their meshes come
 * after each other, with `VolumeId`s on hexahedra and boundary; they need not fit together. A face
 * that is named counts for the bodies that have it; where none is named, a body's sweep is found.
 *
 * The mesh depends on the solid's shape alone: the same solid numbered in another way, turned
 * inside out or reflected in a coordinate plane gives the same mesh, reflected.
 *
 * Where the solid brings its true surfaces (vtkCADReader, vtkModelGeometry), the boundary nodes of
 * the mesh are put on them, see SetSnapToGeometry(). Reported as `SweepReportSnappedNodes`,
 * `SweepReportUnsnappedNodes` and `SweepReportGreatestSnap`. `SweepReportMaximumSideDistance` is
 * how far the middles of the side quads are from the solid's sides.
 *
 * Faces on the sides that are meshed with structured quads from source to target keep their nodes,
 * so that neighbouring volumes fit together.
 *
 * Output port 0: the hexahedra, numbered and with the arrays as vtkCageHexInterior's; where all
 * cells of the solid have one `VolumeId` (or all volume cells one `CellEntityIds`, as gmsh writes
 * them) this is their cell array `VolumeId`. Output port
 * 1, `Boundary`: their outer quads (those of the source cap first, then the target cap, then the
 * sides), facing outward, with the point array `HexPointIds` (the point of output 0) and the cell
 * arrays `BoundaryId` (face id of the solid), `BoundaryPart` (0 source, 1 target, 2 side), `HexId`
 * (the hexahedron behind) and `HexSide` (which of its sides, 1 to 6 in the order of Exodus II).
 * vtkSweepSets makes side sets and node sets of them, for an Exodus file.
 *
 * Field data of both outputs: those of the solid; on output 0 the reports of the other filters'
 * (`SweepReport*`) as well: stages with their seconds, `SweepReportSourceFaceIds`,
 * `SweepReportTargetFaceIds`, `SweepReportCandidates` (the ways to sweep the solid, best first, in
 * words), `SweepReportSize`, `SweepReportVolumeIds` (of several bodies, in the order of whose
 * values the other reports are), `SweepReportKeptEdges` (CAD edges that are columns),
 * `SweepReportLostEdges`, quality of the source quads that were made, ...
 *
 * A solid that cannot be swept raises one error that says which face or loop is in the way; both
 * outputs are then empty.
 *
 * Methods, weights and other choices take any number; one that means nothing is an error when the
 * filter runs, which names those that do.
 */
#ifndef vtkOneToOneSweep_h
#define vtkOneToOneSweep_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkLayeredSweepAlgorithm.h"

#include <vector> // For lists of ids

class VTKFILTERSHEXSWEEP_EXPORT vtkOneToOneSweep : public vtkLayeredSweepAlgorithm
{
public:
  static vtkOneToOneSweep* New();
  vtkTypeMacro(vtkOneToOneSweep, vtkLayeredSweepAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The solid: port 0. Its face ids: SetInputArrayToProcess(0, 0, 0,
  /// vtkDataObject::FIELD_ASSOCIATION_CELLS, name); `FaceId`, then `CellEntityIds` by default.
  void SetSolidConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(0, output); }
  void SetSolidData(vtkDataObject* data) { this->SetInputData(0, data); }
  ///@}

  ///@{
  /// Quads on the source cap: port 1, optional.
  void SetSourceQuadsConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetSourceQuadsData(vtkDataObject* data) { this->SetInputData(1, data); }
  ///@}

  ///@{
  /// Cells of the solid that were selected in a view: ports 2 and 3, optional. Their faces are caps
  /// as if they were named below.
  void SetSourceSelectionConnection(vtkAlgorithmOutput* output)
  {
    this->SetInputConnection(2, output);
  }
  void SetSourceSelectionData(vtkDataObject* data) { this->SetInputData(2, data); }
  void SetTargetSelectionConnection(vtkAlgorithmOutput* output)
  {
    this->SetInputConnection(3, output);
  }
  void SetTargetSelectionData(vtkDataObject* data) { this->SetInputData(3, data); }
  ///@}

  ///@{
  /// Ids of the faces that are the source cap, in any order. None (the default): the sweep is
  /// found, see vtkSweepCandidates. Up to three (five where something grave speaks against all) are
  /// meshed roughly, and swept in the order of what these meshes are worth until all hexahedra are
  /// certified.
  void AddSourceFaceId(vtkIdType id);
  void RemoveAllSourceFaceIds();
  int GetNumberOfSourceFaceIds() const { return static_cast<int>(this->SourceFaceIds.size()); }
  vtkIdType GetSourceFaceId(int i) const;
  ///@}

  ///@{
  /// Ids of the faces that are the target cap. None (the default): the best one is found.
  void AddTargetFaceId(vtkIdType id);
  void RemoveAllTargetFaceIds();
  int GetNumberOfTargetFaceIds() const { return static_cast<int>(this->TargetFaceIds.size()); }
  vtkIdType GetTargetFaceId(int i) const;
  ///@}

  ///@{
  /// Ids of the volumes to sweep, where the solid consists of several bodies, see `VolumeId` above.
  /// None (the default): all.
  void AddVolumeId(vtkIdType id);
  void RemoveAllVolumeIds();
  int GetNumberOfVolumeIds() const { return static_cast<int>(this->VolumeIds.size()); }
  vtkIdType GetVolumeId(int i) const;
  ///@}

  ///@{
  /// Edge length of the hexahedra, in the unit of the coordinates: sets the size of quads that are
  /// made and of layers where QuadSize, LayerSize, NumberOfLayers (0: the default here) and
  /// LayerPositions do not. 0 (the default): about a thousand quads, more where holes are small,
  /// layers as thick as these are wide, at least one, and at most a quarter of a million hexahedra.
  vtkSetMacro(Size, double);
  vtkGetMacro(Size, double);
  ///@}

  ///@{
  /// Edge length of the source quads where they are made here; 0 (the default): see SetSize().
  vtkSetMacro(QuadSize, double);
  vtkGetMacro(QuadSize, double);
  ///@}

  ///@{
  /// How high curves and surfaces of the source cap may rise above the edges of quads that are
  /// made, over the edges' length, in [0, 0.5]: where they bend more, quads are smaller than asked
  /// for, down to a fiftieth. 0.05 puts 16 edges on a circle. Some edges inside the cap (one in ten
  /// or fewer) rise higher, up to twice as high. 0 (the default): any height.
  vtkSetMacro(ChordTolerance, double);
  vtkGetMacro(ChordTolerance, double);
  ///@}

  ///@{
  /// Degrees, in (0, 180): where there are no face ids, neighbouring triangles whose normals differ
  /// by less are on one face. 30 by default.
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
  /// How the interior is placed: a vtkCageHexInterior::MethodType, AUTOMATIC (0) by default.
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  void SetMethodToAutomatic() { this->SetMethod(0); }
  void SetMethodToBlend() { this->SetMethod(1); }
  void SetMethodToHarmonicCoordinates() { this->SetMethod(2); }
  void SetMethodToMeanValueCoordinates() { this->SetMethod(3); }
  void SetMethodToGreenCoordinates() { this->SetMethod(4); }
  void SetMethodToLayerMarch() { this->SetMethod(5); }
  void SetMethodToAffineBoundaryError() { this->SetMethod(6); }
  ///@}

  ///@{
  /// How the quads come to the target cap: a vtkSweepQuadProjector::MethodType, HARMONIC (0) by
  /// default. Reported as `SweepReportProjection`.
  vtkSetMacro(ProjectionMethod, int);
  vtkGetMacro(ProjectionMethod, int);
  void SetProjectionMethodToHarmonic() { this->SetProjectionMethod(0); }
  void SetProjectionMethodToPaperHarmonic() { this->SetProjectionMethod(1); }
  void SetProjectionMethodToAffineLeastSquares() { this->SetProjectionMethod(2); }
  ///@}

  ///@{
  /// Edge weights of the harmonic maps, a vtkHarmonicDiskMap::WeightsType; COTANGENT (0) by
  /// default. Without effect where ProjectionMethod is AFFINE_LEAST_SQUARES.
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
  /// Untangle quads on the target cap and hexahedra that are not valid, locally. On by default. Off
  /// returns what the methods give.
  vtkSetMacro(EnsureValid, bool);
  vtkGetMacro(EnsureValid, bool);
  vtkBooleanMacro(EnsureValid, bool);
  ///@}

  ///@{
  /// Raise the quality of the quads on the target cap, and with the method AUTOMATIC and
  /// EnsureValid that of the hexahedra; no least value falls and no certificate is lost. On by
  /// default.
  vtkSetMacro(ImproveQuality, bool);
  vtkGetMacro(ImproveQuality, bool);
  vtkBooleanMacro(ImproveQuality, bool);
  ///@}

  ///@{
  /// Raise the lowest scaled Jacobians by moves of boundary nodes as well, each along its face of
  /// the solid: nodes of the caps' rims, of CAD edges and of given quads stay. Costs several times
  /// the interior. Reported as `SweepReportMovedBoundaryNodes` and
  /// `SweepReportGreatestBoundaryMove`. Needs EnsureValid. Off by default.
  vtkSetMacro(MoveBoundaryNodes, bool);
  vtkGetMacro(MoveBoundaryNodes, bool);
  vtkBooleanMacro(MoveBoundaryNodes, bool);
  ///@}

  ///@{
  /// Where the solid comes with its true surfaces: divide these as finely as the hexahedra ask for,
  /// and put the nodes of caps and sides on them, nodes of CAD edges on their curves, vertices
  /// exactly. A node whose quads would be turned over stays on the facets and is counted in a
  /// warning. On by default. Off uses the triangles as they are.
  vtkSetMacro(SnapToGeometry, bool);
  vtkGetMacro(SnapToGeometry, bool);
  vtkBooleanMacro(SnapToGeometry, bool);
  ///@}

  ///@{
  /// Prove of each hexahedron that it is valid at every point, or that it is not. On by default.
  vtkSetMacro(Certify, bool);
  vtkGetMacro(Certify, bool);
  vtkBooleanMacro(Certify, bool);
  ///@}

  ///@{
  /// Raise an error and return nothing where a hexahedron is inverted or degenerate, instead of a
  /// warning. Off by default.
  vtkSetMacro(FailIfInvalid, bool);
  vtkGetMacro(FailIfInvalid, bool);
  vtkBooleanMacro(FailIfInvalid, bool);
  ///@}

  ///@{
  /// A vtkAlgorithm::DesiredOutputPrecision; DEFAULT_PRECISION (the default) means double.
  vtkSetMacro(OutputPointsPrecision, int);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

protected:
  vtkOneToOneSweep();
  ~vtkOneToOneSweep() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkOneToOneSweep(const vtkOneToOneSweep&) = delete;
  void operator=(const vtkOneToOneSweep&) = delete;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs);

  std::vector<vtkIdType> SourceFaceIds;
  std::vector<vtkIdType> TargetFaceIds;
  std::vector<vtkIdType> VolumeIds;
  double Size = 0.0;
  double QuadSize = 0.0;
  double ChordTolerance = 0.0;
  double FeatureAngle = 30.0;
  double MatchTolerance = 1e-6;
  int Method = 0;
  int ProjectionMethod = 0;
  int Weights = 0;
  int ImproveTriangulation = 1;
  bool EnsureValid = true;
  bool ImproveQuality = true;
  bool MoveBoundaryNodes = false;
  bool SnapToGeometry = true;
  bool Certify = true;
  bool FailIfInvalid = false;
  int OutputPointsPrecision = DEFAULT_PRECISION;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkManyToManySweep
 * @brief Meshes a solid with hexahedra between several source and target caps along one direction.
 *
 * For solids whose faces all run along one direction (sides) or lie across it (caps: flat, tilted
 * or curved, each over its own part of the plane across the direction): stepped shafts, plates with
 * counterbored holes, bosses and pockets. The borders of all caps are projected along the direction
 * into one plane, which is meshed once with quads that have edges along all of them; over each part
 * of it hexahedra stand in columns between the caps. Layers go through all material that they meet,
 * so the mesh conforms by construction.
 *
 * The same round an axis, where all faces run round it or lie across (stepped pipes that bend):
 * then nodes are on the facets of the sides.
 *
 * A body with one source cap and one target cap along some direction is swept as vtkOneToOneSweep
 * does it, and so is one that cannot be swept along a straight direction.
 *
 * Ports 1 `SourceSelection` and 2 `TargetSelection`, optional, vtkSelection: lists of cells of the
 * solid, whose faces are to be caps at the lower and the upper end. They decide which direction is
 * found, and which way round it is taken; a body without such faces goes its own way.
 *
 * Input and outputs are those of vtkOneToOneSweep, but for source quads, which are made here. Of
 * the boundary's `BoundaryPart`s 0 is a cap at the lower end of the direction, 1 one at the upper
 * end, 2 a side. Field data has `SweepReportSweepDirection`, `SweepReportRegions` and
 * `SweepReportLevels` as well.
 *
 * Refused, with the ids of the faces: what leans or bends from along the direction to across it (as
 * bores across it and fillets between caps and sides do), and caps that run out into each other. To
 * cut such a part into pieces that can be swept is the way.
 */
#ifndef vtkManyToManySweep_h
#define vtkManyToManySweep_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkLayeredSweepAlgorithm.h"

#include <vector> // For lists of ids

class VTKFILTERSHEXSWEEP_EXPORT vtkManyToManySweep : public vtkLayeredSweepAlgorithm
{
public:
  static vtkManyToManySweep* New();
  vtkTypeMacro(vtkManyToManySweep, vtkLayeredSweepAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The solid, see vtkOneToOneSweep.
  void SetSolidConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(0, output); }
  void SetSolidData(vtkDataObject* data) { this->SetInputData(0, data); }
  ///@}

  ///@{
  /// Cells of the solid that were selected in a view: ports 1 and 2, optional.
  void SetSourceSelectionConnection(vtkAlgorithmOutput* output)
  {
    this->SetInputConnection(1, output);
  }
  void SetSourceSelectionData(vtkDataObject* data) { this->SetInputData(1, data); }
  void SetTargetSelectionConnection(vtkAlgorithmOutput* output)
  {
    this->SetInputConnection(2, output);
  }
  void SetTargetSelectionData(vtkDataObject* data) { this->SetInputData(2, data); }
  ///@}

  ///@{
  /// Direction of the sweep, of any length. (0, 0, 0), the default: it is found.
  vtkSetVector3Macro(SweepDirection, double);
  vtkGetVector3Macro(SweepDirection, double);
  ///@}

  ///@{
  /// A sweep round an axis: a point of it (x, y, z), then its direction. All 0 (the default): none
  /// is given; where no straight direction does, an axis is looked for in which planes of caps
  /// meet.
  vtkSetVector6Macro(Axis, double);
  vtkGetVector6Macro(Axis, double);
  ///@}

  ///@{
  /// Degrees, in [0, 30], by which sides may lean. 0 by default (and 2 more, for facets).
  vtkSetMacro(DraftAngle, double);
  vtkGetMacro(DraftAngle, double);
  ///@}

  ///@{
  /// Over the size of the hexahedra, in [0, 0.5]: curves of caps that are nearer to each other than
  /// this, seen along the direction, become one. 0.05 by default.
  vtkSetMacro(ImprintTolerance, double);
  vtkGetMacro(ImprintTolerance, double);
  ///@}

  ///@{
  /// Ids of the volumes to sweep, see vtkOneToOneSweep. None (the default): all.
  void AddVolumeId(vtkIdType id);
  void RemoveAllVolumeIds();
  int GetNumberOfVolumeIds() const { return static_cast<int>(this->VolumeIds.size()); }
  vtkIdType GetVolumeId(int i) const;
  ///@}

  ///@{
  /// Edge length of the hexahedra, in the unit of the coordinates. 0 (the default): by the area of
  /// the plane and the shortest curves in it, and at most a quarter of a million hexahedra.
  vtkSetMacro(Size, double);
  vtkGetMacro(Size, double);
  ///@}

  ///@{
  /// See vtkOneToOneSweep, of the plane across the sweep.
  vtkSetMacro(ChordTolerance, double);
  vtkGetMacro(ChordTolerance, double);
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

  ///@{
  /// Untangle hexahedra that are not valid, locally. On by default.
  vtkSetMacro(EnsureValid, bool);
  vtkGetMacro(EnsureValid, bool);
  vtkBooleanMacro(EnsureValid, bool);
  ///@}

  ///@{
  /// Raise low scaled Jacobians; no certificate is lost. On by default.
  vtkSetMacro(ImproveQuality, bool);
  vtkGetMacro(ImproveQuality, bool);
  vtkBooleanMacro(ImproveQuality, bool);
  ///@}

  ///@{
  /// Where the solid comes with its true surfaces: put nodes on them, see vtkOneToOneSweep. On by
  /// default.
  vtkSetMacro(SnapToGeometry, bool);
  vtkGetMacro(SnapToGeometry, bool);
  vtkBooleanMacro(SnapToGeometry, bool);
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
  vtkManyToManySweep();
  ~vtkManyToManySweep() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkManyToManySweep(const vtkManyToManySweep&) = delete;
  void operator=(const vtkManyToManySweep&) = delete;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs);

  std::vector<vtkIdType> VolumeIds;
  double SweepDirection[3] = { 0.0, 0.0, 0.0 };
  double Axis[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  double DraftAngle = 0.0;
  double ImprintTolerance = 0.05;
  double Size = 0.0;
  double ChordTolerance = 0.0;
  double FeatureAngle = 30.0;
  double MatchTolerance = 1e-6;
  bool EnsureValid = true;
  bool ImproveQuality = true;
  bool SnapToGeometry = true;
  bool FailIfInvalid = false;
  int OutputPointsPrecision = DEFAULT_PRECISION;
};

#endif

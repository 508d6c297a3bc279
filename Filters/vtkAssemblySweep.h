// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkAssemblySweep
 * @brief One conforming mesh of hexahedra of several solids that touch.
 *
 * Takes a collection of closed surfaces (vtkCADReader puts out such a collection, imprinted on each
 * other), surface cells with the array `VolumeId`, surfaces of which more than two meet at edges
 * (as gmsh meshes all faces of a model: the regions that they enclose are the volumes), or volume
 * cells, told apart by `VolumeId` or `CellEntityIds`. Volumes share what they have the same
 * triangles of. Each volume is swept one to one; one with caps at several heights (a headed bolt, a
 * counterbored plate) is first cut along the planes of its flat caps into pieces that can be, and
 * put together again in the output. The filter finds the caps of all of them, so that
 * each shared face gets one mesh: layers and rows of quads on the sides, quads of one cap carried
 * through a stack of volumes, quads of a side as the cap of a volume that stands on it. The numbers
 * of edges on all curves follow from one size, by an integer programme where sides ask for sums of
 * them. Volumes that do not touch are in the same mesh, too.
 *
 * Output 0 is a vtkPartitionedDataSetCollection: a partitioned data set a volume, with its name,
 * in the order of the input; with Merged, one with all hexahedra, whose volumes share points. All
 * have the cell arrays `VolumeId` (from 1 on), `ScaledJacobian`, `JacobianLowerBound`, `Validity`
 * (see vtkHexValidity), the point array `GlobalNodeIds` (global ids: the same for points that
 * volumes share), the cell array `GlobalCellIds` and the report of vtkHexValidity in their field
 * data. The plan is there, too: `SweepReportVolumeIds`, `SweepReportPieces` and
 * `SweepReportLayers`, one a volume, `SweepReportPlannedSources` and `SweepReportPlannedTargets`,
 * face ids as text, one a volume; of volumes in pieces the layers are 0 and the texts empty.
 * Given back as volume sources, targets and layers it is repeated. `SweepReportUnmeshedVolumes` has
 * the ids of volumes without hexahedra, where there are any.
 *
 * Output 1 are the quads of all faces, each once, with the arrays of vtkOneToOneSweep's boundary
 * (`BoundaryId`, the face; `BoundaryPart`, `HexId`, `HexSide`, `HexPointIds`: of the first volume,
 * in the numbers of the merged mesh), so that vtkSweepSets takes both outputs, and with two
 * components each `VolumeIds` (both volumes of the face, the second 0 on the skin), `HexIds` and
 * `HexSides` (-1 and 0 where there is none).
 *
 * Under MPI the first rank's input counts: it is sent to the others, each of which makes the plan
 * and the faces that it needs, and fills its share of the volumes (stack after stack, the most work
 * first). Global ids are those of one rank alone, bit for bit, like the places; a quad between
 * volumes of two ranks is on the rank of the first, without the hexahedron of the second.
 *
 * Nodes lie on the true surfaces where the input brings them, see
 * vtkOneToOneSweep::SetSnapToGeometry().
 *
 * A volume that cannot be filled is named in a warning, and the others are there. One error says
 * which volumes cannot be brought together, why, and what to do.
 */
#ifndef vtkAssemblySweep_h
#define vtkAssemblySweep_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

#include <map>    // For caps by volume
#include <vector> // For lists of ids

#ifndef __VTK_WRAP__
namespace hexsweep
{
struct AssemblySweep;
struct AssemblyVolume;
struct PlannedAssembly;
class Ranks;
}
#endif

class VTKFILTERSHEXSWEEP_EXPORT vtkAssemblySweep : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkAssemblySweep* New();
  vtkTypeMacro(vtkAssemblySweep, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Wanted length of edges, in the input's unit. 0 (the default): one that suits the finest cap,
  /// but gives no more than some 400000 hexahedra.
  vtkSetMacro(Size, double);
  vtkGetMacro(Size, double);
  ///@}

  ///@{
  /**
   * Caps of volumes, where they are not to be found: face ids with the volume's id before them. A
   * volume whose source alone is named gets the best target.
   */
  void AddVolumeSource(vtkIdType volumeId, vtkIdType faceId);
  void AddVolumeTarget(vtkIdType volumeId, vtkIdType faceId);
  void RemoveAllVolumeSources();
  void RemoveAllVolumeTargets();
  ///@}

  ///@{
  /// Numbers of layers of volumes, where they do not follow from the size; 1 or more. Volumes whose
  /// sides are shared have as many.
  void AddVolumeLayers(vtkIdType volumeId, vtkIdType layers);
  void RemoveAllVolumeLayers();
  ///@}

  ///@{
  /// Whether output 0 is one grid with all hexahedra. Off by default.
  vtkSetMacro(Merged, bool);
  vtkGetMacro(Merged, bool);
  vtkBooleanMacro(Merged, bool);
  ///@}

  ///@{
  /// See vtkOneToOneSweep; on by default.
  vtkSetMacro(SnapToGeometry, bool);
  vtkGetMacro(SnapToGeometry, bool);
  vtkBooleanMacro(SnapToGeometry, bool);
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
  vtkAssemblySweep();
  ~vtkAssemblySweep() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkAssemblySweep(const vtkAssemblySweep&) = delete;
  void operator=(const vtkAssemblySweep&) = delete;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs);
#ifndef __VTK_WRAP__
  hexsweep::AssemblySweep Sweep(const std::vector<hexsweep::AssemblyVolume>& volumes,
    hexsweep::PlannedAssembly planned, const std::vector<bool>& isMine,
    const hexsweep::Ranks& ranks);
#endif

  std::map<vtkIdType, std::vector<vtkIdType>> Sources;
  std::map<vtkIdType, std::vector<vtkIdType>> Targets;
  std::map<vtkIdType, vtkIdType> Layers;
  double Size = 0.0;
  double FeatureAngle = 30.0;
  double MatchTolerance = 1e-6;
  bool Merged = false;
  bool SnapToGeometry = true;
};

#endif

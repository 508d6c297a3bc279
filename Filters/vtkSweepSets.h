// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSweepSets
 * @brief A swept mesh as blocks, side sets and node sets, ready to be written as an Exodus II file.
 *
 * Takes the two outputs of vtkOneToOneSweep and arranges them as vtkExodusIIReader arranges a
 * file, so that vtkExodusIIWriter, or Save Data in ParaView, writes the sets as well:
 *
 *     vtkNew<vtkSweepSets> sets;
 *     sets->SetHexesConnection(sweep->GetOutputPort(0));
 *     sets->SetBoundaryConnection(sweep->GetOutputPort(1));
 *     vtkNew<vtkExodusIIWriter> writer;
 *     writer->SetInputConnection(sets->GetOutputPort());
 *     writer->SetFileName("solid.ex2");
 *     writer->Write();
 *
 * In pvpython:
 *
 *     sets = SweepSets(Hexes=sweep, Boundary=OutputPort(sweep, 1))
 *     SaveData('solid.ex2', proxy=sets)
 *
 * Inputs, vtkUnstructuredGrid:
 * - port 0 `Hexes`: hexahedra.
 * - port 1 `Boundary`: quads of their boundary with the arrays `HexPointIds`, `BoundaryId`,
 *   `BoundaryPart`, `HexId` and `HexSide` of vtkOneToOneSweep.
 *
 * The output has three blocks:
 * - `Element Blocks`: the hexahedra, those on the boundary first, which spares vtkExodusIIWriter
 *   a long search; their numbers in the input, from 1 on, are their ids in the file. The file has
 *   one block a volume: its id is the cell array `VolumeId` (1 where there is none, or where an id
 *   does not fit: below 1 or over 2^31 - 1), its name that in the field data array `VolumeName`,
 *   else "Volume" and the id ("Volumes" for all of several).
 * - `Side Sets`: one a face of the solid, "Face ID:3" for face 3, whose id it has; then, see
 *   SetRoleSets(), "Source", "Target" and "Sides" with the ids that follow. Where a face id is
 * below 1 or over 100000, the faces are numbered from 1 on in the order of their ids instead, which
 * stay in the names.
 * - `Node Sets`: the same sets as nodes, with names and ids of their own: "Face nodes ID:103" for
 *   face 3 (what is added is the least power of ten above the ids of all side sets), "Source nodes"
 *   and so on.
 *
 * Point, cell and field data stay on the hexahedra, but for field data that are text or reports
 * (`SweepReport*`), which go to the output itself: Exodus files have no place for them.
 */
#ifndef vtkSweepSets_h
#define vtkSweepSets_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

class VTKFILTERSHEXSWEEP_EXPORT vtkSweepSets : public vtkMultiBlockDataSetAlgorithm
{
public:
  static vtkSweepSets* New();
  vtkTypeMacro(vtkSweepSets, vtkMultiBlockDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The hexahedra: port 0.
  void SetHexesConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(0, output); }
  void SetHexesData(vtkDataObject* data) { this->SetInputData(0, data); }
  ///@}

  ///@{
  /// The quads of their boundary: port 1.
  void SetBoundaryConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetBoundaryData(vtkDataObject* data) { this->SetInputData(1, data); }
  ///@}

  ///@{
  /// Whether the source cap, the target cap and the sides are sets as well. On by default.
  vtkSetMacro(RoleSets, bool);
  vtkGetMacro(RoleSets, bool);
  vtkBooleanMacro(RoleSets, bool);
  ///@}

protected:
  vtkSweepSets();
  ~vtkSweepSets() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSweepSets(const vtkSweepSets&) = delete;
  void operator=(const vtkSweepSets&) = delete;

  bool RoleSets = true;
};

#endif

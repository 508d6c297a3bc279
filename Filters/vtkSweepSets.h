// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSweepSets
 * @brief A swept mesh as blocks, side sets and node sets, ready to be written to a file.
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
 * vtkSweepAbaqusWriter and vtkSweepGmshWriter write the same for Abaqus, CalculiX and gmsh.
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
 * - `Side Sets`: one a face of the solid; then, see SetRoleSets(), "Source", "Target" and "Sides".
 * - `Node Sets`: the same sets as nodes.
 *
 * Names and ids of sets, the same in every format that is written of this:
 * - A set has the name of its face: the text at the face's id in the field data array `FaceNames`
 * of the boundary (else of the hexahedra), or "Face 3" where that is empty or missing. Faces whose
 *   names are the same, whatever their case, have their ids behind it ("Hole 4", "Hole 7"). Control
 *   characters become blanks, and more than 80 bytes are cut.
 * - A side set has the face's id; where a face id is below 1 or over 100000, the faces are numbered
 *   from 1 on in the order of their ids instead. The sets of source, target and sides have the ids
 *   that follow on from the greatest. AddSetId() gives a set another id.
 * - A node set has that id and the least power of ten above the ids of all side sets: 103 for 3
 *   where there are less than a hundred.
 * - Each set holds its name and id in the field data arrays `SetName` and `SetId`. The block is
 * called so that vtkExodusIIWriter, which reads an id from there, writes these: "Face ID:3" and
 *   "Face nodes ID:103" for face 3, "Inlet ID:3" and "Inlet nodes ID:103" where it is called Inlet.
 *
 * Point, cell and field data stay on the hexahedra, but for field data that are text or reports
 * (`SweepReport*`), which go to the output itself: Exodus files have no place for them.
 */
#ifndef vtkSweepSets_h
#define vtkSweepSets_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkMultiBlockDataSetAlgorithm.h"

#include <string>  // For names of sets
#include <utility> // For names with ids
#include <vector>  // For lists of them

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

  ///@{
  /// Gives the set of that name the id, in [1, 100000], in place of its own. A name that no set has
  /// and an id that two sets would have are errors when the filter runs.
  void AddSetId(const char* name, vtkIdType id);
  void RemoveAllSetIds();
  int GetNumberOfSetIds() const { return static_cast<int>(this->SetIds.size()); }
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
  std::vector<std::pair<std::string, vtkIdType>> SetIds;
};

#endif

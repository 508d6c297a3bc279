// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSweepGmshWriter
 * @brief Writes a swept mesh as a mesh of gmsh (.msh), versions 2.2 and 4.1, text or binary.
 *
 * Hexahedra come first, with the numbers of vtkOneToOneSweep and 1, then the quads of the boundary,
 * facing outward. Volumes and faces are physical groups with the names and ids of vtkSweepSets
 * (three- and two-dimensional). In version 4.1 source, target and sides are groups as well, of the
 * same surfaces; in version 2.2 an element has one group, that of its volume or face, so that
 * there these are left out.
 *
 * In names double quotes become single ones.
 */
#ifndef vtkSweepGmshWriter_h
#define vtkSweepGmshWriter_h

#include "vtkSweepMeshWriter.h"

class VTKIOHEXSWEEPMESH_EXPORT vtkSweepGmshWriter : public vtkSweepMeshWriter
{
public:
  static vtkSweepGmshWriter* New();
  vtkTypeMacro(vtkSweepGmshWriter, vtkSweepMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// 41 (the default) or 22: version 4.1 or 2.2 of the format.
  vtkSetMacro(FileVersion, int);
  vtkGetMacro(FileVersion, int);
  void SetFileVersionTo22() { this->SetFileVersion(22); }
  void SetFileVersionTo41() { this->SetFileVersion(41); }
  ///@}

  ///@{
  /// Whether numbers are written as the machine holds them instead of as text. Off by default.
  vtkSetMacro(Binary, bool);
  vtkGetMacro(Binary, bool);
  vtkBooleanMacro(Binary, bool);
  ///@}

protected:
  vtkSweepGmshWriter() = default;
  ~vtkSweepGmshWriter() override = default;

  void WriteMesh(const hexsweep::MeshSets& mesh, hexsweep::OutputFile& file,
    const std::function<bool(double)>& progress) override;

private:
  vtkSweepGmshWriter(const vtkSweepGmshWriter&) = delete;
  void operator=(const vtkSweepGmshWriter&) = delete;

  int FileVersion = 41;
  bool Binary = false;
};

#endif

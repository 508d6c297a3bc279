// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSweepMeshWriter
 * @brief What the writers of swept meshes have in common.
 *
 * The input is the output of vtkSweepSets, whose names and ids of volumes, side sets and node sets
 * are written; numbers of nodes and hexahedra are those of vtkOneToOneSweep and 1. Numbers are
 * written so that they read back as the same numbers, where nothing else is said.
 *
 * A file that cannot be written as a whole is removed, with an error and an error code.
 */
#ifndef vtkSweepMeshWriter_h
#define vtkSweepMeshWriter_h

#include "vtkIOHexSweepMeshModule.h" // For export macro
#include "vtkWriter.h"

#include <functional> // For progress

namespace hexsweep
{
struct MeshSets;
class OutputFile;
}

class VTKIOHEXSWEEPMESH_EXPORT vtkSweepMeshWriter : public vtkWriter
{
public:
  vtkAbstractTypeMacro(vtkSweepMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to write.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkSweepMeshWriter() = default;
  ~vtkSweepMeshWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  /// @param progress takes the fraction done, and says whether to go on.
  virtual void WriteMesh(const hexsweep::MeshSets& mesh, hexsweep::OutputFile& file,
    const std::function<bool(double)>& progress) = 0;

private:
  vtkSweepMeshWriter(const vtkSweepMeshWriter&) = delete;
  void operator=(const vtkSweepMeshWriter&) = delete;

  char* FileName = nullptr;
};

#endif

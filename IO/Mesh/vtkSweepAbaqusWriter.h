// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSweepAbaqusWriter
 * @brief Writes a swept mesh as an input file of Abaqus and CalculiX (.inp).
 *
 * The mesh alone, to be included in an input file with materials, steps and loads:
 *
 * - `*NODE`, and for each volume `*ELEMENT, TYPE=C3D8, ELSET=` with its name.
 * - For each set, under its name: `*NSET` with its nodes, `*ELSET` with the hexahedra behind it,
 * and
 *   `*SURFACE, TYPE=ELEMENT` with their sides S1 to S6.
 *
 * Names begin with a letter and consist of letters, digits and underscores, which stand for all
 * other characters; names that are then the same, whatever their case, have their ids behind them.
 * A coordinate has at most 20 characters, as CalculiX reads no more: all 17 digits of a double, but
 * for some numbers that begin with zeros, which may lose the last three.
 */
#ifndef vtkSweepAbaqusWriter_h
#define vtkSweepAbaqusWriter_h

#include "vtkSweepMeshWriter.h"

class VTKIOHEXSWEEPMESH_EXPORT vtkSweepAbaqusWriter : public vtkSweepMeshWriter
{
public:
  static vtkSweepAbaqusWriter* New();
  vtkTypeMacro(vtkSweepAbaqusWriter, vtkSweepMeshWriter);

protected:
  vtkSweepAbaqusWriter() = default;
  ~vtkSweepAbaqusWriter() override = default;

  void WriteMesh(const hexsweep::MeshSets& mesh, hexsweep::OutputFile& file,
    const std::function<bool(double)>& progress) override;

private:
  vtkSweepAbaqusWriter(const vtkSweepAbaqusWriter&) = delete;
  void operator=(const vtkSweepAbaqusWriter&) = delete;
};

#endif

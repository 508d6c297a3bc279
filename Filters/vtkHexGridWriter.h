// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexGridWriter
 * @brief vtkXMLUnstructuredGridWriter on all threads of vtkSMPTools.
 *
 * The file is the same, byte for byte. Where the data are binary and inline (DataMode) and there
 * is a compressor, the blocks of an array are compressed side by side and encoded by table: VTK's
 * writer spends most of its time on base64, four characters at a time, and much of the rest on the
 * ranges of whole numbers, which are found in one pass here. Everything else is VTK's, but that
 * data which do not hold together and memory that is not to be had are errors, without a file.
 *
 * Measured on a million hexahedra with LZ4: see Documentation/Benchmarks.md.
 */
#ifndef vtkHexGridWriter_h
#define vtkHexGridWriter_h

#include "vtkFiltersHexSweepModule.h" // For export macro
#include "vtkXMLUnstructuredGridWriter.h"

class VTKFILTERSHEXSWEEP_EXPORT vtkHexGridWriter : public vtkXMLUnstructuredGridWriter
{
public:
  static vtkHexGridWriter* New();
  vtkTypeMacro(vtkHexGridWriter, vtkXMLUnstructuredGridWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkHexGridWriter() = default;
  ~vtkHexGridWriter() override = default;

  int WriteInternal() override;
  void WriteArrayInline(vtkAbstractArray* array, vtkIndent indent,
    const char* alternateName = nullptr, int writeNumTuples = 0) override;
  void WriteInlineData(vtkAbstractArray* array, vtkIndent indent) override;

private:
  vtkHexGridWriter(const vtkHexGridWriter&) = delete;
  void operator=(const vtkHexGridWriter&) = delete;

  bool IsWrittenInBlocks(vtkAbstractArray* array);
};

#endif

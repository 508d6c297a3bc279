// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Meshes of gmsh: https://gmsh.info/doc/texinfo/gmsh.html#Gmsh-file-formats. Private to the
 * module.
 */
#ifndef HexSweepGmsh_h
#define HexSweepGmsh_h

#include "Core/Common/Mesh.h"

#include "HexSweepOutputFile.h"

namespace hexsweep
{
struct MeshSets;

/// Records of numbers in a section: lines of text, or as the machine holds them.
class GmshRecords
{
public:
  GmshRecords(OutputFile& file, bool binary)
    : File(file)
    , Binary(binary)
  {
  }

  bool isBinary() const { return this->Binary; }

  /// Lines that are text in any case.
  OutputFile& text() { return this->File; }

  /// A number of the record; its type is that of the binary format.
  template <typename Number>
  GmshRecords& operator<<(Number number)
  {
    if (this->Binary)
    {
      this->File.binary(number);
    }
    else
    {
      this->File << (this->Begun ? " " : "") << number;
      this->Begun = true;
    }
    return *this;
  }

  void end()
  {
    if (!this->Binary)
    {
      this->File << '\n';
      this->Begun = false;
    }
  }

  /// After the last record of a section.
  void endSection(std::string_view name)
  {
    this->File << (this->Binary ? "\n" : "") << name << '\n';
  }

private:
  OutputFile& File;
  bool Binary;
  bool Begun = false;
};

/// The sections before the nodes that both versions have.
void writeGmshHead(
  const MeshSets& mesh, std::string_view version, bool partsToo, GmshRecords& records);

void writeGmsh22(const MeshSets& mesh, GmshRecords& records, const Progress& progress);
void writeGmsh41(const MeshSets& mesh, GmshRecords& records, const Progress& progress);
}

#endif

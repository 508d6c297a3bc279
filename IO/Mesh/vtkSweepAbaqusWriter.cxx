// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSweepAbaqusWriter.h"

#include "Core/Common/Errors.h"
#include "Core/Common/UniqueNames.h"

#include "HexSweepMeshSets.h"
#include "HexSweepOutputFile.h"

#include <vtkObjectFactory.h>

#include <algorithm>

vtkStandardNewMacro(vtkSweepAbaqusWriter);

namespace
{
using hexsweep::MeshSet;
using hexsweep::MeshSets;
using hexsweep::MeshSide;
using hexsweep::MeshVolume;
using hexsweep::OutputFile;

constexpr std::size_t LongestName = 80;
/// What CalculiX reads of a number.
constexpr std::size_t LongestReal = 20;
constexpr std::size_t IdsPerLine = 10;
constexpr vtkIdType RowsPerReport = 1 << 16;
/// Side of C3D8, from 1 on, of each face of vtkHexahedron.
constexpr int AbaqusSides[6] = { 6, 4, 3, 5, 1, 2 };

bool isLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string label(const std::string& name)
{
  std::string result;
  for (const char c : name)
  {
    const bool goesOn = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; // within a character
    if (!goesOn)
    {
      result += isLetter(c) || (c >= '0' && c <= '9') ? c : '_';
    }
  }
  return !result.empty() && isLetter(result.front()) ? result : "N_" + result;
}

/// Of volumes, then of sets: both are element sets, so that no two may be the same.
std::vector<std::string> labels(const MeshSets& mesh)
{
  std::vector<std::string> names;
  std::vector<std::string> suffixes;
  for (const MeshVolume& volume : mesh.volumes)
  {
    names.push_back(label(volume.name));
    suffixes.push_back("_V" + std::to_string(volume.id));
  }
  for (const MeshSet* set : mesh.sets())
  {
    names.push_back(label(set->name));
    suffixes.push_back("_" + std::to_string(set->id));
  }
  return hexsweep::uniqueNames(names, suffixes, LongestName);
}

void writeNodes(const MeshSets& mesh, OutputFile& file, const hexsweep::Progress& progress)
{
  file << "*NODE\n";
  for (vtkIdType node = 0; node < mesh.nodeCount(); ++node)
  {
    file << node + 1;
    for (const double x : mesh.node(node))
    {
      file << ", ";
      file.shortened(x, LongestReal);
    }
    file << '\n';
    if (node % RowsPerReport == 0)
    {
      hexsweep::reportProgress(
        progress, static_cast<double>(node) / static_cast<double>(mesh.nodeCount()));
    }
  }
}

void writeHexes(const MeshSets& mesh, const MeshVolume& volume, OutputFile& file,
  const hexsweep::Progress& progress)
{
  for (const vtkIdType hex : volume.hexes)
  {
    file << hex + 1;
    for (const vtkIdType node : mesh.hex(hex))
    {
      file << ", " << node + 1;
    }
    file << '\n';
    if (hex % RowsPerReport == 0)
    {
      hexsweep::reportProgress(
        progress, static_cast<double>(hex) / static_cast<double>(mesh.hexCount()));
    }
  }
}

/// @param numbers from 0 on.
void writeIds(const std::vector<vtkIdType>& numbers, OutputFile& file)
{
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const bool ends = (i + 1) % IdsPerLine == 0 || i + 1 == numbers.size();
    file << numbers[i] + 1 << (ends ? "\n" : ", ");
  }
}

void writeSet(const MeshSet& set, const std::string& name, OutputFile& file)
{
  file << "*NSET, NSET=" << name << '\n';
  writeIds(set.nodes, file);

  std::vector<vtkIdType> hexes;
  for (const MeshSide& side : set.sides)
  {
    hexes.push_back(side.hex);
  }
  std::sort(hexes.begin(), hexes.end());
  hexes.erase(std::unique(hexes.begin(), hexes.end()), hexes.end());
  file << "*ELSET, ELSET=" << name << '\n';
  writeIds(hexes, file);

  file << "*SURFACE, NAME=" << name << ", TYPE=ELEMENT\n";
  for (const MeshSide& side : set.sides)
  {
    file << side.hex + 1 << ", S" << AbaqusSides[side.side] << '\n';
  }
}
}

//------------------------------------------------------------------------------
void vtkSweepAbaqusWriter::WriteMesh(const hexsweep::MeshSets& mesh, hexsweep::OutputFile& file,
  const std::function<bool(double)>& progress)
{
  const std::vector<std::string> names = labels(mesh);
  auto name = names.begin();
  file << "*HEADING\n"
       << "Hexahedra by HexSweep: " << mesh.nodeCount() << " nodes, " << mesh.hexCount()
       << " elements\n";
  writeNodes(mesh, file, hexsweep::progressPart(progress, 0.0, 0.4));
  for (const MeshVolume& volume : mesh.volumes)
  {
    file << "*ELEMENT, TYPE=C3D8, ELSET=" << *name++ << '\n';
    writeHexes(mesh, volume, file, hexsweep::progressPart(progress, 0.4, 1.0));
  }
  for (const MeshSet* set : mesh.sets())
  {
    writeSet(*set, *name++, file);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/Errors.h"

#include "HexSweepGmsh.h"
#include "HexSweepMeshSets.h"

namespace hexsweep
{
namespace
{
constexpr int Quad = 3;
constexpr int Hexahedron = 5;
constexpr int Tags = 2;
constexpr vtkIdType RowsPerReport = 1 << 16;

int gmshId(vtkIdType number)
{
  return static_cast<int>(number) + 1;
}

void writeNodes(const MeshSets& mesh, GmshRecords& records, const Progress& progress)
{
  records.text() << "$Nodes\n" << mesh.nodeCount() << '\n';
  for (vtkIdType node = 0; node < mesh.nodeCount(); ++node)
  {
    records << gmshId(node);
    for (const double x : mesh.node(node))
    {
      records << x;
    }
    records.end();
    if (node % RowsPerReport == 0)
    {
      reportProgress(progress, static_cast<double>(node) / static_cast<double>(mesh.nodeCount()));
    }
  }
  records.endSection("$EndNodes");
}

/// In the binary format a type is told once for all elements that follow, before their ids.
void beginElements(int type, std::size_t count, GmshRecords& records)
{
  if (records.isBinary())
  {
    records << type << static_cast<int>(count) << Tags;
  }
}

template <typename Nodes>
void writeElement(
  vtkIdType number, int type, vtkIdType group, const Nodes& nodes, GmshRecords& records)
{
  records << gmshId(number);
  if (!records.isBinary())
  {
    records << type << Tags;
  }
  records << static_cast<int>(group) << static_cast<int>(group);
  for (const vtkIdType node : nodes)
  {
    records << gmshId(node);
  }
  records.end();
}

void writeElements(const MeshSets& mesh, GmshRecords& records, const Progress& progress)
{
  vtkIdType count = mesh.hexCount();
  for (const MeshSet& face : mesh.faces)
  {
    count += static_cast<vtkIdType>(face.sides.size());
  }
  records.text() << "$Elements\n" << count << '\n';
  for (const MeshVolume& volume : mesh.volumes)
  {
    beginElements(Hexahedron, volume.hexes.size(), records);
    for (const vtkIdType hex : volume.hexes)
    {
      writeElement(hex, Hexahedron, volume.id, mesh.hex(hex), records);
      if (hex % RowsPerReport == 0)
      {
        reportProgress(progress, static_cast<double>(hex) / static_cast<double>(count));
      }
    }
  }
  vtkIdType number = mesh.hexCount();
  for (const MeshSet& face : mesh.faces)
  {
    beginElements(Quad, face.sides.size(), records);
    for (const MeshSide& side : face.sides)
    {
      writeElement(number++, Quad, face.id, mesh.quad(side), records);
    }
  }
  records.endSection("$EndElements");
}
}

void writeGmsh22(const MeshSets& mesh, GmshRecords& records, const Progress& progress)
{
  writeGmshHead(mesh, "2.2", false, records);
  writeNodes(mesh, records, progressPart(progress, 0.0, 0.4));
  writeElements(mesh, records, progressPart(progress, 0.4, 1.0));
}
}

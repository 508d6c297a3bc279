// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepGmsh.h"

#include "HexSweepMeshSets.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
std::string quoted(std::string name)
{
  std::replace(name.begin(), name.end(), '"', '\'');
  return '"' + name + '"';
}
}

void writeGmshHead(
  const MeshSets& mesh, std::string_view version, bool partsToo, GmshRecords& records)
{
  OutputFile& file = records.text();
  file << "$MeshFormat\n" << version << (records.isBinary() ? " 1 8\n" : " 0 8\n");
  if (records.isBinary())
  {
    records << 1; // by which readers tell the order of bytes
    file << '\n';
  }
  file << "$EndMeshFormat\n$PhysicalNames\n";
  file << mesh.faces.size() + (partsToo ? mesh.parts.size() : 0) + mesh.volumes.size() << '\n';
  for (const std::vector<MeshSet>* sets : { &mesh.faces, &mesh.parts })
  {
    for (const MeshSet& set : *sets)
    {
      if (sets == &mesh.faces || partsToo)
      {
        file << "2 " << set.id << ' ' << quoted(set.name) << '\n';
      }
    }
  }
  for (const MeshVolume& volume : mesh.volumes)
  {
    file << "3 " << volume.id << ' ' << quoted(volume.name) << '\n';
  }
  file << "$EndPhysicalNames\n";
}
}

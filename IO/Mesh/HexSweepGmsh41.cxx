// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/Errors.h"

#include "HexSweepGmsh.h"
#include "HexSweepMeshSets.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace hexsweep
{
namespace
{
constexpr int Quad = 3;
constexpr int Hexahedron = 5;

/// What gmsh calls an entity: its elements, and the nodes that no entity before it has.
struct Entity
{
  int dimension;
  int tag;
  std::vector<int> groups;
  std::vector<MeshSide> sides;  ///< of a surface
  std::vector<vtkIdType> hexes; ///< of a volume
  std::vector<int> surfaces;    ///< of a volume: tags
  std::vector<vtkIdType> nodes;
};

/// Surfaces: sides that are in the same sets.
std::vector<Entity> surfacesOf(const MeshSets& mesh)
{
  const std::vector<const MeshSet*> sets = mesh.sets();
  std::map<std::pair<vtkIdType, int>, std::vector<std::size_t>> setsOf;
  vtkIdType greatest = 0;
  for (std::size_t s = 0; s < sets.size(); ++s)
  {
    greatest = std::max(greatest, sets[s]->id);
    for (const MeshSide& side : sets[s]->sides)
    {
      setsOf[{ side.hex, side.side }].push_back(s);
    }
  }
  std::map<std::vector<std::size_t>, std::vector<MeshSide>> together;
  for (const auto& [side, own] : setsOf)
  {
    together[own].push_back({ side.first, side.second });
  }
  std::vector<Entity> surfaces;
  std::set<vtkIdType> taken;
  for (auto& [own, sides] : together)
  {
    // A surface has the id of its face, unless the face is in several parts.
    const vtkIdType face = sets[own.front()]->id;
    const vtkIdType tag = taken.insert(face).second ? face : ++greatest;
    Entity surface{ 2, static_cast<int>(tag), {}, std::move(sides), {}, {}, {} };
    for (const std::size_t s : own)
    {
      surface.groups.push_back(static_cast<int>(sets[s]->id));
    }
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

/// Surfaces, then volumes, as nodes on the boundary are those of surfaces.
std::vector<Entity> entitiesOf(const MeshSets& mesh)
{
  std::vector<Entity> entities = surfacesOf(mesh);
  const std::size_t surfaceCount = entities.size();
  std::vector<std::size_t> volumeOf(static_cast<std::size_t>(mesh.hexCount()));
  for (const MeshVolume& volume : mesh.volumes)
  {
    const int id = static_cast<int>(volume.id);
    for (const vtkIdType hex : volume.hexes)
    {
      volumeOf[static_cast<std::size_t>(hex)] = entities.size();
    }
    entities.push_back({ 3, id, { id }, {}, volume.hexes, {}, {} });
  }
  for (std::size_t s = 0; s < surfaceCount; ++s)
  {
    std::set<std::size_t> bounded;
    for (const MeshSide& side : entities[s].sides)
    {
      bounded.insert(volumeOf[static_cast<std::size_t>(side.hex)]);
    }
    for (const std::size_t volume : bounded)
    {
      entities[volume].surfaces.push_back(entities[s].tag);
    }
  }
  return entities;
}

void shareNodes(const MeshSets& mesh, std::vector<Entity>& entities)
{
  std::vector<bool> taken(static_cast<std::size_t>(mesh.nodeCount()), false);
  for (Entity& entity : entities)
  {
    const auto take = [&](vtkIdType node) {
      if (!taken[static_cast<std::size_t>(node)])
      {
        taken[static_cast<std::size_t>(node)] = true;
        entity.nodes.push_back(node);
      }
    };
    for (const MeshSide& side : entity.sides)
    {
      const auto corners = mesh.quad(side);
      std::for_each(corners.begin(), corners.end(), take);
    }
    for (const vtkIdType hex : entity.hexes)
    {
      const auto corners = mesh.hex(hex);
      std::for_each(corners.begin(), corners.end(), take);
    }
    std::sort(entity.nodes.begin(), entity.nodes.end());
  }
}

/// Of all nodes of the entity's elements.
std::array<double, 6> boundsOf(const MeshSets& mesh, const Entity& entity)
{
  constexpr double Far = std::numeric_limits<double>::max();
  std::array<double, 6> bounds = { Far, Far, Far, -Far, -Far, -Far };
  const auto add = [&](vtkIdType node) {
    const std::array<double, 3> place = mesh.node(node);
    for (std::size_t k = 0; k < 3; ++k)
    {
      bounds[k] = std::min(bounds[k], place[k]);
      bounds[3 + k] = std::max(bounds[3 + k], place[k]);
    }
  };
  for (const MeshSide& side : entity.sides)
  {
    const auto corners = mesh.quad(side);
    std::for_each(corners.begin(), corners.end(), add);
  }
  for (const vtkIdType hex : entity.hexes)
  {
    const auto corners = mesh.hex(hex);
    std::for_each(corners.begin(), corners.end(), add);
  }
  return bounds;
}

void writeEntities(const MeshSets& mesh, const std::vector<Entity>& entities, GmshRecords& records)
{
  records.text() << "$Entities\n";
  const std::size_t volumes = mesh.volumes.size();
  records << std::size_t{ 0 } << std::size_t{ 0 } << entities.size() - volumes << volumes;
  records.end();
  for (const Entity& entity : entities)
  {
    records << entity.tag;
    for (const double bound : boundsOf(mesh, entity))
    {
      records << bound;
    }
    for (const std::vector<int>* tags : { &entity.groups, &entity.surfaces })
    {
      records << tags->size();
      for (const int tag : *tags)
      {
        records << tag;
      }
    }
    records.end();
  }
  records.endSection("$EndEntities");
}

std::size_t gmshId(vtkIdType number)
{
  return static_cast<std::size_t>(number) + 1;
}

void writeNodes(const MeshSets& mesh, const std::vector<Entity>& entities, GmshRecords& records,
  const Progress& progress)
{
  const auto count = static_cast<std::size_t>(mesh.nodeCount());
  records.text() << "$Nodes\n";
  records << entities.size() << count << std::size_t{ 1 } << count;
  records.end();
  std::size_t done = 0;
  for (const Entity& entity : entities)
  {
    records << entity.dimension << entity.tag << 0 << entity.nodes.size();
    records.end();
    for (const vtkIdType node : entity.nodes)
    {
      records << gmshId(node);
      records.end();
    }
    for (const vtkIdType node : entity.nodes)
    {
      for (const double x : mesh.node(node))
      {
        records << x;
      }
      records.end();
    }
    done += entity.nodes.size();
    reportProgress(progress, static_cast<double>(done) / static_cast<double>(count));
  }
  records.endSection("$EndNodes");
}

template <typename Nodes>
void writeElement(std::size_t id, const Nodes& nodes, GmshRecords& records)
{
  records << id;
  for (const vtkIdType node : nodes)
  {
    records << gmshId(node);
  }
  records.end();
}

void writeElements(const MeshSets& mesh, const std::vector<Entity>& entities, GmshRecords& records,
  const Progress& progress)
{
  std::size_t count = 0;
  for (const Entity& entity : entities)
  {
    count += entity.sides.size() + entity.hexes.size();
  }
  records.text() << "$Elements\n";
  records << entities.size() << count << std::size_t{ 1 } << count;
  records.end();
  std::size_t quad = gmshId(mesh.hexCount());
  for (const Entity& entity : entities)
  {
    const bool isVolume = entity.dimension == 3;
    records << entity.dimension << entity.tag << (isVolume ? Hexahedron : Quad)
            << (isVolume ? entity.hexes.size() : entity.sides.size());
    records.end();
    for (const vtkIdType hex : entity.hexes)
    {
      writeElement(gmshId(hex), mesh.hex(hex), records);
    }
    for (const MeshSide& side : entity.sides)
    {
      writeElement(quad++, mesh.quad(side), records);
    }
    reportProgress(progress, static_cast<double>(quad) / static_cast<double>(count + 1));
  }
  records.endSection("$EndElements");
}
}

void writeGmsh41(const MeshSets& mesh, GmshRecords& records, const Progress& progress)
{
  std::vector<Entity> entities = entitiesOf(mesh);
  shareNodes(mesh, entities);
  writeGmshHead(mesh, "4.1", true, records);
  writeEntities(mesh, entities, records);
  writeNodes(mesh, entities, records, progressPart(progress, 0.0, 0.4));
  writeElements(mesh, entities, records, progressPart(progress, 0.4, 1.0));
}
}

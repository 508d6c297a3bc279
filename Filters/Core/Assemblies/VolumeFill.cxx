// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/VolumeFill.h"

#include "Core/Assemblies/CapFaces.h"
#include "Core/Assemblies/QuadMatch.h"
#include "Core/CapQuads/ImageProjection.h"
#include "Core/CapQuads/SweepProjection.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/SurfaceSearch.h"
#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/RingCollapse.h"
#include "Core/Interior/SectionInterior.h"
#include "Core/Interior/SweptHexes.h"
#include "Core/Linking/LinkingRings.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
/// Nodes of a volume, numbered as they come.
class LocalNodes
{
public:
  Index of(Index node)
  {
    const auto [known, isNew] = this->Numbers.try_emplace(node, this->size());
    if (isNew)
    {
      this->Nodes.push_back(node);
    }
    return known->second;
  }
  Quads of(Quads quads)
  {
    for (Index i = 0; i < quads.size(); ++i)
    {
      quads.data()[i] = this->of(quads.data()[i]);
    }
    return quads;
  }
  Index size() const { return static_cast<Index>(this->Nodes.size()); }
  const std::vector<Index>& nodes() const { return this->Nodes; }

private:
  std::map<Index, Index> Numbers;
  std::vector<Index> Nodes;
};

/// Quads of some faces, all turned outward from the volume.
Quads quadsOfFaces(const AssemblyComplex& complex, const AssemblyMesh& mesh, Index volume,
  const std::vector<Index>& faces)
{
  Index count = 0;
  for (const Index face : faces)
  {
    count += mesh.faces[at(face)].rows();
  }
  Quads quads(count, 4);
  Index row = 0;
  for (const Index face : faces)
  {
    const Quads& own = mesh.faces[at(face)];
    const bool turned = complex.faces[at(face)].volumes.front() != volume;
    for (Index q = 0; q < own.rows(); ++q, ++row)
    {
      quads.row(row) = own.row(q);
      if (turned)
      {
        std::swap(quads(row, 1), quads(row, 3));
      }
    }
  }
  return quads;
}

std::vector<Index> facesOf(const SweepLayout& layout)
{
  std::vector<Index> faces;
  for (const SideFace& side : layout.sides)
  {
    faces.push_back(side.face);
  }
  return faces;
}

std::string idsOf(const AssemblyComplex& complex, const std::vector<Index>& faces)
{
  std::string ids;
  for (const Index face : faces)
  {
    ids += (ids.empty() ? "" : ", ") + std::to_string(complex.faces[at(face)].id);
  }
  return (faces.size() == 1 ? "face " : "faces ") + ids;
}

/// Of the edges beside it: a target node this far from the image of its source node is not it.
constexpr double FarFromImage = 0.25;
/// Of a layer's thickness: columns that leave their straight lines by less are straight.
constexpr double StraightColumn = 1e-3;

/// Whether the known target nodes are the images of their source nodes.
bool areImages(const QuadMesh& source, const AffineMap& map, const std::vector<Index>& known,
  const AssemblyMesh& mesh)
{
  const Points images = map.apply(source.points);
  for (Index q = 0; q < source.quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      const Index a = source.quads(q, c);
      const Index b = source.quads(q, (c + 1) % 4);
      const double edge = (images.row(b) - images.row(a)).norm();
      for (const Index end : { a, b })
      {
        const Index node = known[at(end)];
        if (node >= 0 && (mesh.nodes[node] - images.row(end)).norm() > FarFromImage * edge)
        {
          return false;
        }
      }
    }
  }
  return true;
}

/// Whether all columns of the sides are straight lines, with layers at the same shares of them.
bool areStraight(const SweepBoundary& boundary)
{
  const Points& first = boundary.rings.front();
  const Points& last = boundary.rings.back();
  const double tolerance =
    StraightColumn * boundary.meanColumnLength / static_cast<double>(boundary.numberOfLayers());
  for (std::size_t k = 1; k + 1 < boundary.rings.size(); ++k)
  {
    const double along = boundary.fractions[k];
    const Points straight = (1.0 - along) * first + along * last;
    if ((boundary.rings[k] - straight).rowwise().norm().maxCoeff() > tolerance)
    {
      return false;
    }
  }
  return true;
}

/// Target nodes where no face of the target has quads yet.
/// @param known nodes on loops and borders, -1 inside. @param isOnLoop which of them are on loops.
std::vector<Index> projectToTarget(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  Index volume, const SweepLayout& layout, const std::optional<AffineMap>& map,
  const QuadMesh& source, const RingStack& rings, const std::vector<Index>& known,
  const std::vector<bool>& isOnLoop, AssemblyMesh& mesh, const Progress& progress,
  const ParallelFor& parallelFor)
{
  SweepProjectionInput input;
  input.source = source;
  input.target = meshOfFaces(complex, volume, layout.targets);
  input.sourceSurface = meshOfFaces(complex, volume, layout.sources);
  input.linking = rings;
  input.ensureValid = true;
  input.improveQuality = true;
  input.parallelFor = parallelFor;
  for (std::size_t i = 0; i < known.size(); ++i)
  {
    if (known[i] >= 0 && !isOnLoop[i])
    {
      input.borders.push_back({ static_cast<Index>(i), mesh.nodes[known[i]] });
    }
  }
  Points points;
  if (map && areImages(source, *map, known, mesh))
  {
    std::vector<FixedNode> boundary;
    for (std::size_t i = 0; i < known.size(); ++i)
    {
      if (known[i] >= 0 && isOnLoop[i])
      {
        boundary.push_back({ static_cast<Index>(i), mesh.nodes[known[i]] });
      }
    }
    SweepProjection image =
      projectToImage(source, *map, boundary, input.borders, input.target, false, parallelFor);
    if (image.quality.inverted == 0)
    {
      points = std::move(image.quads.points);
    }
  }
  if (points.rows() == 0)
  {
    points = projectSweep(input, progress).quads.points;
  }
  std::vector<bool> isFixed(known.size(), false);
  for (std::size_t i = 0; i < known.size(); ++i)
  {
    if (known[i] >= 0)
    {
      isFixed[i] = true;
      points.row(static_cast<Index>(i)) = mesh.nodes[known[i]];
    }
  }
  snapToFaces(complex, geometry, volume, layout.targets, source.quads, isFixed, points);
  const Index begin = mesh.nodes.size();
  std::vector<Index> nodes = known;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (nodes[i] < 0)
    {
      nodes[i] = mesh.nodes.add(points.row(static_cast<Index>(i)));
    }
  }
  mesh.blocks.push_back(
    { static_cast<Index>(complex.faces.size()) + volume, begin, mesh.nodes.size() - begin });
  return nodes;
}

/// Of quads: the first quad of the part between the target's borders that each is in.
std::vector<Index> partsBetweenBorders(
  const SweepLayout& layout, const Quads& quads, const AssemblyMesh& mesh)
{
  std::set<std::pair<Index, Index>> borders;
  for (const CarriedCurve& curve : layout.carried)
  {
    const std::vector<Index>& nodes = mesh.curves[at(curve.target.curve)].nodes;
    for (std::size_t k = 1; k < nodes.size(); ++k)
    {
      borders.insert(std::minmax(nodes[k - 1], nodes[k]));
    }
  }
  DisjointSets parts(quads.rows());
  std::map<std::pair<Index, Index>, Index> quadAt;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (Index c = 0; c < 4; ++c)
    {
      const std::pair<Index, Index> edge = std::minmax({ quads(q, c), quads(q, (c + 1) % 4) });
      const auto [known, isNew] = quadAt.try_emplace(edge, q);
      // Without borders each quad is a part: the faces' borders are no edges of the quads.
      if (!isNew && !borders.empty() && borders.count(edge) == 0)
      {
        parts.join(known->second, q);
      }
    }
  }
  std::vector<Index> result;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    result.push_back(parts.find(q));
  }
  return result;
}

/// Rows of the target's quads by the face that most of their part lie on.
std::map<Index, std::vector<Index>> rowsByFace(const AssemblyComplex& complex, Index volume,
  const SweepLayout& layout, const Quads& quads, const AssemblyMesh& mesh)
{
  const std::vector<Index> triangles = trianglesOfFaces(complex, layout.targets);
  const SurfaceSearch surface(partOfVolume(complex, volume, triangles).mesh);
  const std::vector<Index> parts = partsBetweenBorders(layout, quads, mesh);
  std::map<Index, std::map<Index, Index>> votes; // by part and face
  Index near = -1;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (Index c = 0; c < 4; ++c)
    {
      middle += 0.25 * mesh.nodes[quads(q, c)];
    }
    near = surface.project(middle, near).triangle;
    ++votes[parts[at(q)]][complex.faceOf[at(triangles[at(near)])]];
  }
  std::map<Index, std::vector<Index>> rows;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    const std::map<Index, Index>& own = votes[parts[at(q)]];
    const auto most = std::max_element(own.begin(), own.end(),
      [](const auto& one, const auto& other) { return one.second < other.second; });
    rows[most->first].push_back(q);
  }
  return rows;
}

/// Stores the target's quads with the faces that they lie on.
void keepTarget(const AssemblyComplex& complex, Index volume, const SweepLayout& layout,
  const Quads& source, const std::vector<Index>& nodes, AssemblyMesh& mesh)
{
  const Quads target = source.unaryExpr([&](Index point) { return nodes[at(point)]; });
  std::map<Index, std::vector<Index>> rowsOfFace;
  if (layout.targets.size() == 1)
  {
    std::vector<Index>& rows = rowsOfFace[layout.targets.front()];
    rows.resize(at(source.rows()));
    std::iota(rows.begin(), rows.end(), Index(0));
  }
  else
  {
    rowsOfFace = rowsByFace(complex, volume, layout, target, mesh);
  }
  for (const auto& [face, rows] : rowsOfFace)
  {
    // Outward at the source is inward at the target.
    const bool turned = complex.faces[at(face)].volumes.front() == volume;
    Quads quads(static_cast<Index>(rows.size()), 4);
    for (std::size_t r = 0; r < rows.size(); ++r)
    {
      for (Index c = 0; c < 4; ++c)
      {
        quads(static_cast<Index>(r), turned ? (4 - c) % 4 : c) = target(rows[r], c);
      }
    }
    mesh.faces[at(face)] = std::move(quads);
  }
}
}

VolumeCage carryToTarget(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  Index volume, const SweepLayout& layout, const std::optional<AffineMap>& map, AssemblyMesh& mesh,
  const Progress& progress, const ParallelFor& parallelFor)
{
  LocalNodes local;
  QuadMesh source;
  source.quads = local.of(quadsOfFaces(complex, mesh, volume, layout.sources));
  const Index count = local.size();
  source.points = mesh.nodes.placesOf(local.nodes());
  const Quads sides = local.of(quadsOfFaces(complex, mesh, volume, facesOf(layout)));
  const SurfaceTopology topology = checkSurface(source.quads, count, "source quads");
  checkCap(topology, "source quads");
  const RingStack rings =
    walkLinkingRings(mesh.nodes.placesOf(local.nodes()), sides, topology.loops);
  const Index layers = rings.numberOfLayers();

  VolumeCage result;
  result.nodes.setConstant(layers + 1, count, -1);
  for (std::size_t l = 0; l < rings.loops.size(); ++l)
  {
    for (Index k = 0; k <= layers; ++k)
    {
      for (std::size_t j = 0; j < rings.loops[l].size(); ++j)
      {
        result.nodes(k, rings.loops[l][j]) =
          local.nodes()[at(rings.tables[l](k, static_cast<Index>(j)))];
      }
    }
  }
  std::vector<Index> target(at(count));
  for (Index i = 0; i < count; ++i)
  {
    result.nodes(0, i) = local.nodes()[at(i)];
    target[at(i)] = result.nodes(layers, i);
  }
  std::vector<bool> isOnLoop(at(count));
  for (std::size_t i = 0; i < target.size(); ++i)
  {
    isOnLoop[i] = target[i] >= 0;
  }
  for (const CarriedCurve& curve : layout.carried)
  {
    const std::vector<Index> from = nodesAlong(mesh, curve.source);
    const std::vector<Index> to = nodesAlong(mesh, { curve.target });
    for (std::size_t k = 0; k < from.size(); ++k)
    {
      Index& node = target[at(local.of(from[k]))];
      node = node < 0 ? to[k] : node;
    }
  }
  const Quads given = quadsOfFaces(complex, mesh, volume, layout.targets);
  if (given.rows() == 0)
  {
    target = projectToTarget(complex, geometry, volume, layout, map, source, rings, target,
      isOnLoop, mesh, progress, parallelFor);
    keepTarget(complex, volume, layout, source.quads, target, mesh);
  }
  else
  {
    const std::optional<std::vector<Index>> matched = matchQuads(source.quads, given, target);
    if (!matched)
    {
      throw InvalidInput("both caps (" + idsOf(complex, layout.sources) + " and " +
        idsOf(complex, layout.targets) +
        ") have the quads of other volumes, and these are not the same. Sweep the volume between "
        "other caps.");
    }
    target = *matched;
  }
  for (Index i = 0; i < count; ++i)
  {
    result.nodes(layers, i) = target[at(i)];
  }
  result.cage.source = source.points;
  result.cage.target = mesh.nodes.placesOf(target);
  result.cage.quads = source.quads;
  result.cage.boundary = gatherSweepBoundary(result.cage.source, result.cage.target, rings);
  checkRings(result.cage.boundary, topology.loops);
  result.cage.isRuled = map && areStraight(result.cage.boundary);
  return result;
}

VolumeHexes fillVolume(
  const VolumeCage& volume, const Progress& progress, const ParallelFor& parallelFor)
{
  const SweepCage& cage = volume.cage;
  InteriorOptions options;
  options.keepQualities = true;
  options.parallelFor = parallelFor;
  SweepInterior interior = sweepInterior(cage,
    interiorStarts(InteriorKind::Automatic, cage.isRuled, windingOf(cage.boundary)), options,
    progress);
  VolumeHexes result;
  result.hexes =
    sweptHexes(cage.quads, interior.points, cage.boundary.numberOfLayers(), parallelFor);
  result.qualities = !interior.qualities.empty()
    ? std::move(interior.qualities)
    : hexQualities(interior.points, result.hexes, true, parallelFor);
  result.points = std::move(interior.points);
  result.method = std::move(interior.method);
  return result;
}
}

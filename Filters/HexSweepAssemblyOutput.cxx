// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepAssemblyOutput.h"

#include "Core/Assemblies/AssemblyBoundary.h"
#include "HexSweepArrays.h"
#include "HexSweepQualityArrays.h"
#include "HexSweepWriter.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkCompositeDataSet.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
void setQualities(const std::vector<HexQuality>& qualities, vtkUnstructuredGrid* grid)
{
  QualityArrays arrays(static_cast<vtkIdType>(qualities.size()));
  for (std::size_t h = 0; h < qualities.size(); ++h)
  {
    arrays.set(static_cast<vtkIdType>(h), qualities[h]);
  }
  arrays.addTo(grid->GetCellData());
  grid->GetCellData()->SetActiveScalars(arrays::ScaledJacobian);
  addQualityReport(grid->GetFieldData(), summarize(qualities));
}

void setPoints(const Points& points, vtkUnstructuredGrid* grid)
{
  grid->SetPoints(
    vtkSmartPointer<vtkPoints>::Take(newPoints(points, vtkAlgorithm::DEFAULT_PRECISION)));
}

std::string textOf(const std::vector<Index>& ids)
{
  std::string text;
  for (const Index id : ids)
  {
    text += (text.empty() ? "" : " ") + std::to_string(id);
  }
  return text;
}

/// The pieces of each body: rows of AssemblySweep::volumes. Bodies are in the order of the labels.
std::vector<std::vector<std::size_t>> piecesOf(const AssemblySweep& sweep)
{
  std::vector<std::vector<std::size_t>> bodies;
  for (std::size_t v = 0; v < sweep.volumes.size(); ++v)
  {
    if (sweep.planned.bodyOf[v] == static_cast<Index>(v))
    {
      bodies.emplace_back();
    }
    bodies.back().push_back(v);
  }
  return bodies;
}

/// The label of each volume's body.
std::vector<std::size_t> labelsOf(const AssemblySweep& sweep)
{
  std::vector<std::size_t> labelOf(sweep.volumes.size());
  const std::vector<std::vector<std::size_t>> bodies = piecesOf(sweep);
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    for (const std::size_t v : bodies[b])
    {
      labelOf[v] = b;
    }
  }
  return labelOf;
}

/// The plan of some bodies. One in pieces has no caps that could be named again.
void addPlan(const AssemblySweep& sweep, const std::vector<std::vector<std::size_t>>& bodies,
  const std::vector<Index>& ids, vtkUnstructuredGrid* grid)
{
  std::vector<Index> layers;
  std::vector<Index> pieces;
  std::vector<std::string> sources;
  std::vector<std::string> targets;
  for (const std::vector<std::size_t>& body : bodies)
  {
    const bool isWhole = body.size() == 1;
    const std::size_t v = body.front();
    const SweepLayout& layout = sweep.planned.plan.sweeps[v];
    const auto textOfCap = [&](const std::vector<Index>& faces) {
      return isWhole ? textOf(idsOfFaces(sweep.planned.complex, static_cast<Index>(v), faces))
                     : std::string();
    };
    pieces.push_back(static_cast<Index>(body.size()));
    layers.push_back(isWhole ? sweep.planned.intervals.layers[v] : 0);
    sources.push_back(textOfCap(layout.sources));
    targets.push_back(textOfCap(layout.targets));
  }
  addIds(grid->GetFieldData(), reports::VolumeIds, ids);
  addIds(grid->GetFieldData(), reports::Layers, layers);
  addIds(grid->GetFieldData(), reports::Pieces, pieces);
  addReport(grid->GetFieldData(), reports::PlannedSources, sources);
  addReport(grid->GetFieldData(), reports::PlannedTargets, targets);
}

void addReports(const AssemblySweep& sweep, vtkUnstructuredGrid* grid)
{
  addReport(grid->GetFieldData(), reports::Size, sweep.planned.size);
  std::vector<std::string> names;
  std::vector<double> seconds;
  for (const Stage& stage : sweep.stages)
  {
    names.push_back(stage.name);
    seconds.push_back(stage.seconds);
  }
  addReport(grid->GetFieldData(), reports::Stages, names);
  addReport(grid->GetFieldData(), reports::Seconds, seconds);
}

/// Numbers of nodes.
std::vector<Index> numbersOf(const NumberedAssembly& assembly, const std::vector<Index>& nodes)
{
  std::vector<Index> numbers;
  for (const Index node : nodes)
  {
    numbers.push_back(assembly.numbers.nodes[static_cast<std::size_t>(node)]);
  }
  return numbers;
}

/// Numbers of a volume's hexahedra.
std::vector<Index> hexNumbers(const NumberedAssembly& assembly, std::size_t volume)
{
  std::vector<Index> numbers(assembly.sweep.volumes[volume].hexes.qualities.size());
  std::iota(numbers.begin(), numbers.end(), assembly.numbers.firstHexes[volume]);
  return numbers;
}

vtkSmartPointer<vtkIdTypeArray> globalIds(const char* name, const std::vector<Index>& ids)
{
  vtkSmartPointer<vtkIdTypeArray> array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), ids[i]);
  }
  return array;
}

void addGrid(
  const std::string& name, vtkUnstructuredGrid* grid, vtkPartitionedDataSetCollection* output)
{
  const unsigned int place = output->GetNumberOfPartitionedDataSets();
  vtkNew<vtkPartitionedDataSet> parts;
  if (grid)
  {
    parts->SetPartition(0, grid);
  }
  output->SetPartitionedDataSet(place, parts);
  output->GetMetaData(place)->Set(vtkCompositeDataSet::NAME(), name.c_str());
}

/// Two ids a tuple.
class PairArray
{
public:
  explicit PairArray(const char* name)
  {
    this->Ids->SetName(name);
    this->Ids->SetNumberOfComponents(2);
  }
  void add(const std::array<Index, 2>& pair)
  {
    this->Ids->InsertNextValue(pair[0]);
    this->Ids->InsertNextValue(pair[1]);
  }
  vtkIdTypeArray* array() const { return this->Ids; }

private:
  vtkNew<vtkIdTypeArray> Ids;
};

/// What a face is to a volume: 0 source, 1 target, 2 side.
unsigned char partOf(const AssemblySweep& sweep, Index volume, Index face)
{
  const SweepLayout& layout = sweep.planned.plan.sweeps[static_cast<std::size_t>(volume)];
  const auto has = [face](const std::vector<Index>& faces) {
    return std::binary_search(faces.begin(), faces.end(), face);
  };
  return has(layout.sources) ? 0 : has(layout.targets) ? 1 : 2;
}

/// Whether a face lies between two pieces of one body.
bool isCutFace(const AssemblySweep& sweep, const ComplexFace& face)
{
  const std::vector<Index>& bodyOf = sweep.planned.bodyOf;
  return face.volumes.size() > 1 &&
    bodyOf[static_cast<std::size_t>(face.volumes[0])] ==
    bodyOf[static_cast<std::size_t>(face.volumes[1])];
}

std::vector<Index> noPoints(const AssemblySweep& sweep)
{
  return std::vector<Index>(static_cast<std::size_t>(sweep.nodes.rows()), -1);
}

/// The points of a mesh of some volumes: nodes of faces whose volumes could not be filled are none.
struct MergedPoints
{
  std::vector<Index> pointOf; ///< one a node; -1: none
  std::vector<Index> nodes;   ///< one a point
};

/// @param pointOf one -1 a node; given back by giveBack().
MergedPoints mergedPoints(
  const AssemblySweep& sweep, const std::vector<std::size_t>& volumes, std::vector<Index> pointOf)
{
  MergedPoints merged;
  merged.pointOf = std::move(pointOf);
  for (const std::size_t v : volumes)
  {
    for (const Index node : sweep.volumes[v].nodes)
    {
      Index& point = merged.pointOf[static_cast<std::size_t>(node)];
      if (point < 0)
      {
        point = static_cast<Index>(merged.nodes.size());
        merged.nodes.push_back(node);
      }
    }
  }
  return merged;
}

std::vector<Index> giveBack(MergedPoints merged)
{
  for (const Index node : merged.nodes)
  {
    merged.pointOf[static_cast<std::size_t>(node)] = -1;
  }
  return std::move(merged.pointOf);
}

std::vector<std::size_t> allVolumes(const AssemblySweep& sweep)
{
  std::vector<std::size_t> all(sweep.volumes.size());
  std::iota(all.begin(), all.end(), std::size_t{ 0 });
  return all;
}

std::string methodOf(const AssemblySweep& sweep, const std::vector<std::size_t>& body)
{
  std::set<std::string> methods;
  std::string text;
  for (const std::size_t v : body)
  {
    const std::string& own = sweep.volumes[v].hexes.method;
    if (methods.insert(own).second)
    {
      text += (text.empty() ? "" : ", ") + own;
    }
  }
  return text;
}

/// The hexahedra of some volumes with their points and qualities. @param labelOf see labelsOf().
void setHexes(const NumberedAssembly& assembly, const std::vector<std::size_t>& labelOf,
  const std::vector<std::size_t>& volumes, const MergedPoints& merged, vtkUnstructuredGrid* grid)
{
  const auto& [sweep, numbers, labels] = assembly;
  Index count = 0;
  for (const std::size_t v : volumes)
  {
    count += sweep.volumes[v].hexes.hexes.rows();
  }
  Hexes hexes(count, 8);
  std::vector<Index> volumeIds;
  std::vector<HexQuality> qualities;
  std::vector<Index> hexIds;
  Index row = 0;
  for (const std::size_t v : volumes)
  {
    const SweptVolume& volume = sweep.volumes[v];
    for (Index h = 0; h < volume.hexes.hexes.rows(); ++h, ++row)
    {
      for (Index c = 0; c < 8; ++c)
      {
        const Index node = volume.nodes[static_cast<std::size_t>(volume.hexes.hexes(h, c))];
        hexes(row, c) = merged.pointOf[static_cast<std::size_t>(node)];
      }
      volumeIds.push_back(labels.ids[labelOf[v]]);
    }
    qualities.insert(qualities.end(), volume.hexes.qualities.begin(), volume.hexes.qualities.end());
    const std::vector<Index> own = hexNumbers(assembly, v);
    hexIds.insert(hexIds.end(), own.begin(), own.end());
  }
  // Those that volumes share have the same bits in all of them.
  Points places(static_cast<Index>(merged.nodes.size()), 3);
  for (std::size_t i = 0; i < merged.nodes.size(); ++i)
  {
    places.row(static_cast<Index>(i)) = sweep.nodes.row(merged.nodes[i]);
  }
  setPoints(places, grid);
  setCells(grid, hexes, VTK_HEXAHEDRON);
  grid->GetPointData()->SetGlobalIds(
    globalIds(arrays::GlobalNodeIds, numbersOf(assembly, merged.nodes)));
  grid->GetCellData()->SetGlobalIds(globalIds(arrays::GlobalCellIds, hexIds));
  addIds(grid->GetCellData(), arrays::VolumeId, volumeIds);
  setQualities(qualities, grid);
}

vtkSmartPointer<vtkUnstructuredGrid> bodyGrid(const NumberedAssembly& assembly,
  const std::vector<std::size_t>& labelOf, const std::vector<std::size_t>& body,
  vtkFieldData* fields, std::vector<Index>& pointOf)
{
  const auto& [sweep, numbers, labels] = assembly;
  const std::size_t label = labelOf[body.front()];
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->GetFieldData()->PassData(fields);
  grid->GetFieldData()->RemoveArray(arrays::VolumeNames);
  vtkNew<vtkStringArray> name;
  name->SetName(arrays::VolumeName);
  name->InsertNextValue(labels.names[label]);
  grid->GetFieldData()->AddArray(name);
  if (!sweep.volumes[body.front()].problem.empty())
  {
    return grid;
  }
  MergedPoints merged = mergedPoints(sweep, body, std::move(pointOf));
  setHexes(assembly, labelOf, body, merged, grid);
  pointOf = giveBack(std::move(merged));
  addReport(grid->GetFieldData(), reports::Method, methodOf(sweep, body));
  addPlan(sweep, { body }, { labels.ids[label] }, grid);
  addReports(sweep, grid);
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> mergedGrid(
  const NumberedAssembly& assembly, vtkFieldData* fields)
{
  const auto& [sweep, numbers, labels] = assembly;
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->GetFieldData()->PassData(fields);
  const std::vector<std::size_t> all = allVolumes(sweep);
  setHexes(assembly, labelsOf(sweep), all, mergedPoints(sweep, all, noPoints(sweep)), grid);
  const std::vector<std::vector<std::size_t>> bodies = piecesOf(sweep);
  std::vector<std::string> methods;
  std::vector<Index> unmeshed;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    methods.push_back(methodOf(sweep, bodies[b]));
    if (!sweep.volumes[bodies[b].front()].problem.empty())
    {
      unmeshed.push_back(labels.ids[b]);
    }
  }
  addReport(grid->GetFieldData(), reports::Method, methods);
  if (!unmeshed.empty())
  {
    addIds(grid->GetFieldData(), reports::UnmeshedVolumes, unmeshed);
  }
  addPlan(sweep, bodies, labels.ids, grid);
  addReports(sweep, grid);
  return grid;
}
}

void writeAssembly(const NumberedAssembly& assembly, bool merged, vtkFieldData* fields,
  vtkPartitionedDataSetCollection* output)
{
  if (merged)
  {
    addGrid("Assembly", mergedGrid(assembly, fields), output);
    return;
  }
  const std::vector<std::vector<std::size_t>> bodies = piecesOf(assembly.sweep);
  const std::vector<std::size_t> labelOf = labelsOf(assembly.sweep);
  std::vector<Index> pointOf = noPoints(assembly.sweep);
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    addGrid(assembly.labels.names[b],
      assembly.sweep.volumes[bodies[b].front()].isMine
        ? bodyGrid(assembly, labelOf, bodies[b], fields, pointOf)
        : nullptr,
      output);
  }
}

void writeAssemblyBoundary(const NumberedAssembly& assembly, vtkUnstructuredGrid* output)
{
  const auto& [sweep, numbers, labels] = assembly;
  std::vector<Index> firstHex;
  Index hexes = 0;
  for (const SweptVolume& volume : sweep.volumes)
  {
    firstHex.push_back(hexes);
    hexes += volume.hexes.hexes.rows();
  }
  const MergedPoints merged = mergedPoints(sweep, allVolumes(sweep), noPoints(sweep));
  const std::vector<std::size_t> labelOf = labelsOf(sweep);
  std::vector<Index> pointOf(static_cast<std::size_t>(sweep.boundary.nodes.size()), -1);
  std::vector<Index> nodes;
  std::vector<Index> hexPoints;
  std::vector<std::array<Index, 4>> quads;
  std::vector<Index> faceIds;
  std::vector<Index> hexIds;
  vtkNew<vtkUnsignedCharArray> sides;
  sides->SetName(arrays::HexSide);
  vtkNew<vtkUnsignedCharArray> parts;
  parts->SetName(arrays::BoundaryPart);
  PairArray volumePairs(arrays::VolumeIds);
  PairArray hexPairs(arrays::HexIds);
  PairArray sidePairs(arrays::HexSides);
  for (const AssemblyQuad& quad : assemblyBoundary(sweep))
  {
    const ComplexFace& face = sweep.planned.complex.faces[static_cast<std::size_t>(quad.face)];
    if (isCutFace(sweep, face))
    {
      continue;
    }
    std::array<Index, 2> volumes{ 0, 0 };
    std::array<Index, 2> pair{ -1, -1 };
    for (std::size_t s = 0; s < face.volumes.size(); ++s)
    {
      const HexAtQuad& hex = quad.hexes[s];
      const auto volume = static_cast<std::size_t>(face.volumes[s]);
      volumes[s] = labels.ids[labelOf[volume]];
      pair[s] = hex.volume < 0 ? -1 : numbers.firstHexes[volume] + hex.hex;
    }
    // A quad between volumes of two ranks is the rank's that has the first one.
    const auto first = static_cast<std::size_t>(face.volumes.front());
    const std::size_t own = sweep.volumes[first].problem.empty() ? 0 : 1;
    if (quad.hexes[own].volume < 0)
    {
      continue;
    }
    quads.emplace_back();
    for (std::size_t c = 0; c < 4; ++c)
    {
      Index& point = pointOf[static_cast<std::size_t>(quad.nodes[c])];
      if (point < 0)
      {
        point = static_cast<Index>(nodes.size());
        nodes.push_back(quad.nodes[c]);
        hexPoints.push_back(merged.pointOf[static_cast<std::size_t>(quad.nodes[c])]);
      }
      quads.back()[c] = point;
    }
    faceIds.push_back(face.id);
    hexIds.push_back(
      firstHex[static_cast<std::size_t>(quad.hexes[own].volume)] + quad.hexes[own].hex);
    sides->InsertNextValue(static_cast<unsigned char>(quad.hexes[own].side));
    parts->InsertNextValue(partOf(sweep, face.volumes[own], quad.face));
    volumePairs.add(volumes);
    hexPairs.add(pair);
    sidePairs.add({ quad.hexes[0].side, quad.hexes[1].side });
  }
  Points places(static_cast<Index>(nodes.size()), 3);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    places.row(static_cast<Index>(i)) = sweep.boundary.nodes[nodes[i]];
  }
  setPoints(places, output);
  setCells(output,
    Eigen::Map<const Quads>(
      quads.empty() ? nullptr : quads.front().data(), static_cast<Index>(quads.size()), 4),
    VTK_QUAD);
  output->GetPointData()->SetGlobalIds(
    globalIds(arrays::GlobalNodeIds, numbersOf(assembly, nodes)));
  addIds(output->GetPointData(), arrays::HexPointIds, hexPoints);
  vtkCellData* cellData = output->GetCellData();
  addIds(cellData, arrays::BoundaryId, faceIds);
  addIds(cellData, arrays::HexId, hexIds);
  cellData->AddArray(sides);
  cellData->AddArray(parts);
  cellData->AddArray(volumePairs.array());
  cellData->AddArray(hexPairs.array());
  cellData->AddArray(sidePairs.array());
  cellData->SetActiveScalars(arrays::BoundaryId);
}
}

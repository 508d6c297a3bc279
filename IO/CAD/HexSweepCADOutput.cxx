// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADOutput.h"

#include "Core/Common/Errors.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Surfaces/FaceSides.h"
#include "HexSweepArrays.h"
#include "HexSweepCADArchive.h"
#include "HexSweepCADFacets.h"
#include "HexSweepCADLoad.h"
#include "HexSweepCADRepair.h"
#include "HexSweepCADRun.h"

#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataAssembly.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <map>

namespace hexsweep
{
namespace
{
/// Greatest size of all geometries together that is written into field data.
constexpr std::size_t MostBytes = std::size_t{ 64 } << 20;

vtkSmartPointer<vtkPoints> newPoints(const Points& points)
{
  vtkSmartPointer<vtkPoints> result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataTypeToDouble();
  result->SetNumberOfPoints(points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    result->SetPoint(i, points(i, 0), points(i, 1), points(i, 2));
  }
  return result;
}

vtkSmartPointer<vtkPolyData> trianglesOf(const ModelFacets& facets)
{
  vtkSmartPointer<vtkPolyData> result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(newPoints(facets.points));
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdTypeArray> faceIds;
  faceIds->SetName(arrays::FaceId);
  for (Index t = 0; t < facets.triangles.rows(); ++t)
  {
    const vtkIdType corners[3] = { facets.triangles(t, 0), facets.triangles(t, 1),
      facets.triangles(t, 2) };
    cells->InsertNextCell(3, corners);
    faceIds->InsertNextValue(facets.faceIds[static_cast<std::size_t>(t)]);
  }
  result->SetPolys(cells);
  result->GetCellData()->AddArray(faceIds);
  return result;
}

/// Edges as lines, each with the points that it uses.
vtkSmartPointer<vtkPolyData> linesOf(const CADSolidFacets& solid)
{
  vtkSmartPointer<vtkPolyData> result = vtkSmartPointer<vtkPolyData>::New();
  std::map<Index, vtkIdType> ids;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdTypeArray> edgeIds;
  edgeIds->SetName(arrays::EdgeId);
  vtkNew<vtkIdTypeArray> faceIds;
  faceIds->SetName(arrays::EdgeFaceIds);
  faceIds->SetNumberOfComponents(2);
  for (const CADEdgeFacets& edge : solid.edges)
  {
    cells->InsertNextCell(static_cast<int>(edge.points.size()));
    for (const Index point : edge.points)
    {
      const auto [place, isNew] = ids.try_emplace(point, points->GetNumberOfPoints());
      if (isNew)
      {
        const Eigen::RowVector3d at = solid.facets.points.row(point);
        points->InsertNextPoint(at.data());
      }
      cells->InsertCellPoint(place->second);
    }
    edgeIds->InsertNextValue(edge.edgeId);
    const double beside[2] = { static_cast<double>(edge.faceIds.front()),
      static_cast<double>(edge.faceIds.back()) };
    faceIds->InsertNextTuple(beside);
  }
  result->SetPoints(points);
  result->SetLines(cells);
  result->GetCellData()->AddArray(edgeIds);
  result->GetCellData()->AddArray(faceIds);
  return result;
}

vtkSmartPointer<vtkStringArray> newText(const char* name, const std::vector<std::string>& values)
{
  vtkSmartPointer<vtkStringArray> array = vtkSmartPointer<vtkStringArray>::New();
  array->SetName(name);
  for (const std::string& value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

/// By face id, which begin with 1.
template <typename Value>
std::vector<Value> byFaceId(std::vector<Value> values)
{
  values.insert(values.begin(), Value());
  return values;
}

vtkSmartPointer<vtkDoubleArray> newColors(const std::vector<std::optional<CADColor>>& colors)
{
  vtkSmartPointer<vtkDoubleArray> array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(arrays::FaceColors);
  array->SetNumberOfComponents(3);
  for (const std::optional<CADColor>& color : colors)
  {
    const CADColor value = color ? *color : CADColor{ -1.0, -1.0, -1.0 };
    array->InsertNextTuple(value.data());
  }
  return array;
}

/// The product structure: a node a product, the solids below theirs.
vtkSmartPointer<vtkDataAssembly> assemblyOf(const CADModel& model)
{
  vtkSmartPointer<vtkDataAssembly> assembly = vtkSmartPointer<vtkDataAssembly>::New();
  assembly->SetRootNodeName("Products");
  const auto addNode = [&](const std::string& label, int parent) {
    const std::string name = vtkDataAssembly::MakeValidNodeName(label.c_str());
    const int node = assembly->AddNode(name.empty() ? "Product" : name.c_str(), parent);
    assembly->SetAttribute(node, "label", label.c_str());
    return node;
  };
  std::vector<int> nodes;
  for (const CADProduct& product : model.products)
  {
    const int parent = product.parent < 0 ? 0 : nodes[static_cast<std::size_t>(product.parent)];
    nodes.push_back(addNode(product.name.empty() ? "Product" : product.name, parent));
  }
  for (std::size_t s = 0; s < model.solids.size(); ++s)
  {
    const CADSolid& solid = model.solids[s];
    const int parent = solid.products.empty() ? 0 : nodes[solid.products.back()];
    assembly->AddDataSetIndex(addNode(solid.name, parent), static_cast<unsigned int>(s));
  }
  return assembly;
}

void setPart(vtkPartitionedDataSetCollection* collection, std::size_t solid,
  const std::string& name, vtkPolyData* data)
{
  const auto number = static_cast<unsigned int>(solid);
  vtkNew<vtkPartitionedDataSet> parts;
  parts->SetPartition(0, data);
  collection->SetPartitionedDataSet(number, parts);
  collection->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), name.c_str());
}

/// Edges that have not two triangles: a surface that bounds a volume has none.
Index loneEdges(const ModelFacets& facets)
{
  Index count = 0;
  const std::vector<FaceSide> sides = sortedSides(facets.triangles, facets.points.rows());
  forEachEdge(
    sides, [&](std::size_t first, std::size_t last) { count += last - first == 2 ? 0 : 1; });
  return count;
}

void complainOfEdges(Index edges, CADModel& model, const std::string& solid)
{
  if (edges > 0)
  {
    model.complaints.push_back("\"" + solid + "\" is open, or touches or crosses itself: " +
      countOf(static_cast<std::size_t>(edges), "edge") +
      " of its triangles would have to be shared by two and are not. Mend it in the CAD system, or "
      "try HealGeometry.");
  }
}

void complainOfFaces(const std::vector<Index>& faces, CADModel& model, const std::string& solid)
{
  if (faces.empty())
  {
    return;
  }
  std::vector<std::string> words;
  for (const Index face : faces)
  {
    words.push_back(std::to_string(face));
  }
  model.complaints.push_back("the CAD kernel cannot divide face " + listWords(words) + " of \"" +
    solid +
    "\" into triangles: the solid is open there. Mend it in the CAD system, or try "
    "HealGeometry.");
}

vtkModelGeometry::Maker geometryMaker(NumberedSolid solid, const std::string& name)
{
  return [solid = std::move(solid), name](std::string& problem) -> vtkModelGeometry::Geometry {
    try
    {
      return callCAD("the geometry of \"" + name + "\" cannot be used",
        [&] { return std::make_shared<const CADGeometry>(solid); });
    }
    catch (const std::exception& error)
    {
      problem = error.what();
      return nullptr;
    }
  };
}
}

void writeCADModel(CADModel& model, const CADOutputSettings& settings, const Progress& progress,
  vtkPartitionedDataSetCollection* solids, vtkPartitionedDataSetCollection* edges)
{
  const SilencedCAD silenced;
  const std::size_t count = model.solids.size();
  if (!settings.structureOnly)
  {
    TopoDS_Compound all;
    const BRep_Builder builder;
    builder.MakeCompound(all);
    for (const CADSolid& solid : model.solids)
    {
      builder.Add(all, solid.shape);
    }
    divideShape(all, settings.deflection, settings.angle, progressPart(progress, 0.0, 0.6));
  }
  std::vector<NumberedSolid> numbered;
  std::vector<std::string> binaries;
  std::size_t bytes = 0;
  for (std::size_t s = 0; s < count; ++s)
  {
    numbered.push_back(numberedSolid(model, s));
    binaries.push_back(bytes < MostBytes ? binaryOf(numbered.back()) : std::string());
    bytes += binaries.back().size();
  }
  CADOrigin origin{ settings.file, "", settings.settings, 0 };
  if (bytes >= MostBytes)
  {
    binaries.assign(count, "");
    origin.checksum = checksumOf(settings.file);
  }
  const auto names = newText(arrays::FaceNames, byFaceId(faceNames(model)));
  const auto colors = newColors(byFaceId(faceColors(model)));
  const auto unit = newText(arrays::LengthUnit, { model.lengthUnit });
  for (std::size_t s = 0; s < count; ++s)
  {
    reportProgress(progress, 0.6 + 0.4 * static_cast<double>(s) / static_cast<double>(count));
    const CADSolid& solid = model.solids[s];
    if (settings.structureOnly)
    {
      setPart(solids, s, solid.name, nullptr);
      setPart(edges, s, solid.name, nullptr);
      continue;
    }
    const CADSolidFacets facets = facetsOfSolid(solid.shape, model.faces, model.edges);
    complainOfFaces(facets.emptyFaces, model, solid.name);
    if (facets.emptyFaces.empty())
    {
      complainOfEdges(loneEdges(facets.facets), model, solid.name);
    }
    const vtkSmartPointer<vtkPolyData> data = trianglesOf(facets.facets);
    vtkFieldData* fields = data->GetFieldData();
    fields->AddArray(newText(arrays::VolumeName, { solid.name }));
    fields->AddArray(names);
    fields->AddArray(colors);
    fields->AddArray(unit);
    origin.solid = static_cast<Index>(s);
    writeGeometry(numbered[s], binaries[s], origin, fields);
    vtkNew<vtkModelGeometry> geometry;
    geometry->SetMaker(geometryMaker(std::move(numbered[s]), solid.name));
    data->GetInformation()->Set(vtkModelGeometry::MODEL_GEOMETRY(), geometry);
    setPart(solids, s, solid.name, data);
    setPart(edges, s, solid.name, linesOf(facets));
  }
  const auto assembly = assemblyOf(model);
  solids->SetDataAssembly(assembly);
  edges->SetDataAssembly(assembly);
  reportProgress(progress, 1.0);
}
}

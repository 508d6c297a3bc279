// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepGrid.h"

#include "Core/Common/StoppablePieces.h"
#include "Core/Geometry/CoordinateRange.h"
#include "HexSweepArrays.h"
#include "HexSweepMemory.h"
#include "HexSweepRun.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <numeric>

namespace hexsweep
{
namespace
{
static_assert(sizeof(vtkIdType) == sizeof(Index), "hexsweep::Index is vtkIdType's size");

// Values that one piece of work writes: large enough for a thread, a few milliseconds.
constexpr Index ValuesAPiece = Index{ 1 } << 19;

vtkSmartPointer<vtkIdTypeArray> newIds(const char* name, Index count)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(name);
  setTuples(array.Get(), count);
  return array;
}

/// Calls body(layer, begin, end) for parts of all layers.
void forPartsOfLayers(Index perLayer, Index layers, Index valuesEach, const Progress& progress,
  const std::function<void(Index, Index, Index)>& body)
{
  if (perLayer == 0)
  {
    return;
  }
  // Whole layers, or parts of one: an entry of a table needs no division then.
  const Index layersAPiece = std::max<Index>(1, ValuesAPiece / (perLayer * valuesEach));
  const Index parts = (perLayer * valuesEach + ValuesAPiece - 1) / ValuesAPiece;
  const Index partSize = (perLayer + parts - 1) / parts;
  if (parts > 1)
  {
    forStoppablePieces(smpFor(), progress, layers * parts, 1, [&](Index piece, Index) {
      const Index begin = (piece % parts) * partSize;
      body(piece / parts, begin, std::min(begin + partSize, perLayer));
    });
    return;
  }
  forStoppablePieces(smpFor(), progress, layers, layersAPiece, [&](Index first, Index last) {
    for (Index k = first; k < last; ++k)
    {
      body(k, 0, perLayer);
    }
  });
}

template <typename Array>
vtkSmartPointer<vtkPoints> newPointsOf(const PointsRef& points, int type, const Progress& progress)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataType(type);
  setTuples(result->GetData(), points.rows());
  auto* to = Array::SafeDownCast(result->GetData())->GetPointer(0);
  using Value = typename Array::ValueType;
  forStoppablePieces(smpFor(), progress, points.size(), ValuesAPiece, [&](Index begin, Index end) {
    std::transform(points.data() + begin, points.data() + end, to + begin,
      [](double value) { return static_cast<Value>(value); });
  });
  return result;
}

/// The tuples `ids` of the source, which stay in its order of arrays and keep their roles.
void gather(
  vtkDataSetAttributes* source, const std::vector<Index>& ids, vtkDataSetAttributes* gathered)
{
  const vtkIdType n = static_cast<vtkIdType>(ids.size());
  gathered->CopyAllOn();
  allocateTuples(source, n, gathered);
  vtkNew<vtkIdList> from;
  from->SetNumberOfIds(n);
  std::copy(ids.begin(), ids.end(), from->GetPointer(0));
  vtkNew<vtkIdList> to;
  to->SetNumberOfIds(n);
  std::iota(to->GetPointer(0), to->GetPointer(0) + n, vtkIdType{ 0 });
  gathered->CopyData(source, from, to);
}
}

vtkSmartPointer<vtkPoints> newSweptPoints(
  const PointsRef& points, int precision, const Progress& progress)
{
  if (precision == vtkAlgorithm::SINGLE_PRECISION)
  {
    checkFitsSinglePrecision(points);
    return newPointsOf<vtkFloatArray>(points, VTK_FLOAT, progress);
  }
  return newPointsOf<vtkDoubleArray>(points, VTK_DOUBLE, progress);
}

vtkSmartPointer<vtkIdTypeArray> newSweptConnectivity(const QuadsRef& quads, Index pointsPerLayer,
  Index layers, bool sourceIsBottom, const Progress& progress)
{
  const Index m = quads.rows();
  auto connectivity = newIds("connectivity", 8 * m * layers);
  vtkIdType* ids = connectivity->GetPointer(0);
  forPartsOfLayers(m, layers, 8, progress, [&](Index k, Index begin, Index end) {
    const Index bottom = (sourceIsBottom ? k : k + 1) * pointsPerLayer;
    const Index top = (sourceIsBottom ? k + 1 : k) * pointsPerLayer;
    vtkIdType* to = ids + 8 * (k * m + begin);
    const Index* from = quads.data() + 4 * begin;
    for (Index q = begin; q < end; ++q, from += 4, to += 8)
    {
      for (int c = 0; c < 4; ++c)
      {
        to[c] = from[c] + bottom;
        to[4 + c] = from[c] + top;
      }
    }
  });
  return connectivity;
}

Eigen::Map<const Hexes> hexView(vtkIdTypeArray* connectivity)
{
  return { reinterpret_cast<const Index*>(connectivity->GetPointer(0)),
    connectivity->GetNumberOfValues() / 8, 8 };
}

void setSweptCells(
  vtkUnstructuredGrid* grid, vtkIdTypeArray* connectivity, const Progress& progress)
{
  const Index count = connectivity->GetNumberOfValues() / 8;
  const auto offsets = newIds("offsets", count + 1);
  vtkIdType* to = offsets->GetPointer(0);
  forStoppablePieces(smpFor(), progress, count + 1, ValuesAPiece, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i)
    {
      to[i] = 8 * i;
    }
  });
  vtkNew<vtkCellArray> cells;
  requireMemory(static_cast<double>(count)); // types of the cells
  cells->SetData(offsets, connectivity);
  grid->SetCells(VTK_HEXAHEDRON, cells);
}

void carryAttributes(vtkDataSetAttributes* source, const std::vector<Index>& ids, Index layers,
  vtkDataSetAttributes* output, const Progress& progress)
{
  const vtkIdType n = static_cast<vtkIdType>(ids.size());
  vtkNew<vtkDataSetAttributes> gathered;
  bool inOrder = n == source->GetNumberOfTuples();
  for (vtkIdType i = 0; i < n && inOrder; ++i)
  {
    inOrder = ids[static_cast<std::size_t>(i)] == i;
  }
  vtkDataSetAttributes* layer = source;
  if (!inOrder)
  {
    gather(source, ids, gathered);
    layer = gathered;
  }
  output->CopyAllOn();
  output->CopyGlobalIdsOff();
  output->CopyFieldOff(vtkDataSetAttributes::GhostArrayName());
  allocateTuples(layer, n * layers, output);
  for (Index k = 0; k < layers; ++k)
  {
    reportProgress(progress, static_cast<double>(k) / static_cast<double>(layers));
    output->CopyData(layer, k * n, n, 0);
  }
}

vtkSmartPointer<vtkIdTypeArray> newRepeatedIds(
  const char* name, const std::vector<Index>& ids, Index layers, const Progress& progress)
{
  const Index n = static_cast<Index>(ids.size());
  auto array = newIds(name, n * layers);
  vtkIdType* to = array->GetPointer(0);
  forPartsOfLayers(n, layers, 1, progress, [&](Index k, Index begin, Index end) {
    std::copy(ids.begin() + begin, ids.begin() + end, to + k * n + begin);
  });
  return array;
}

vtkSmartPointer<vtkIdTypeArray> newLayerNumbers(
  Index perLayer, Index layers, const Progress& progress)
{
  auto array = newIds(arrays::SweepLayer, perLayer * layers);
  vtkIdType* to = array->GetPointer(0);
  forPartsOfLayers(perLayer, layers, 1, progress, [&](Index k, Index begin, Index end) {
    std::fill(to + k * perLayer + begin, to + k * perLayer + end, static_cast<vtkIdType>(k));
  });
  return array;
}
}

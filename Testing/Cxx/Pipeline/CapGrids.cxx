// SPDX-License-Identifier: BSD-3-Clause

#include "CapGrids.h"

namespace test
{
Grid readGrid(const std::string& file)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((std::string(HEXSWEEP_DATA_DIR "/cases/") + file + ".vtu").c_str());
  reader->Update();
  EXPECT_GT(reader->GetOutput()->GetNumberOfCells(), 0) << file;
  return reader->GetOutput();
}

SweepGrids readCase(const std::string& name)
{
  return { readGrid(name + "/source_quads"), readGrid(name + "/source_surface"),
    readGrid(name + "/target_surface"), readGrid(name + "/linking_quads") };
}

Corners cornersOf(vtkDataSet* data, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  data->GetCellPoints(cell, ids);
  return Corners(ids->begin(), ids->end());
}

std::array<double, 3> pointOf(vtkDataSet* data, vtkIdType i)
{
  std::array<double, 3> p;
  data->GetPoint(i, p.data());
  return p;
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

double sizeOf(vtkDataSet* data)
{
  return data->GetLength();
}

double greatestDistance(vtkDataSet* a, vtkDataSet* b)
{
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints())
  {
    return VTK_DOUBLE_MAX;
  }
  double greatest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    greatest = std::max(greatest, distance(pointOf(a, i), pointOf(b, i)));
  }
  return greatest;
}

Grid gridOf(const std::vector<std::array<double, 3>>& coordinates,
  const std::vector<Corners>& cells, int type)
{
  auto grid = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p : coordinates)
  {
    points->InsertNextPoint(p.data());
  }
  grid->SetPoints(points);
  for (const Corners& cell : cells)
  {
    grid->InsertNextCell(type, static_cast<vtkIdType>(cell.size()), cell.data());
  }
  return grid;
}

Grid emptyGrid()
{
  return Grid::New();
}

Grid changedCells(vtkUnstructuredGrid* grid, const std::function<void(vtkIdType, Corners&)>& change)
{
  auto result = Grid::New();
  result->SetPoints(grid->GetPoints());
  result->GetPointData()->ShallowCopy(grid->GetPointData());
  result->GetCellData()->ShallowCopy(grid->GetCellData());
  result->GetFieldData()->ShallowCopy(grid->GetFieldData());
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    Corners corners = cornersOf(grid, c);
    change(c, corners);
    result->InsertNextCell(
      grid->GetCellType(c), static_cast<vtkIdType>(corners.size()), corners.data());
  }
  return result;
}

Grid turnedOver(vtkUnstructuredGrid* grid)
{
  return changedCells(
    grid, [](vtkIdType, Corners& corners) { std::reverse(corners.begin(), corners.end()); });
}

Grid anyOrientation(vtkUnstructuredGrid* grid, unsigned seed)
{
  std::mt19937 generator(seed);
  return changedCells(grid, [&](vtkIdType, Corners& corners) {
    std::rotate(corners.begin(), corners.begin() + static_cast<long>(generator() % corners.size()),
      corners.end());
    if (generator() % 2)
    {
      std::reverse(corners.begin(), corners.end());
    }
  });
}

Grid shuffledCells(vtkUnstructuredGrid* grid, unsigned seed)
{
  std::vector<vtkIdType> order(static_cast<std::size_t>(grid->GetNumberOfCells()));
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = static_cast<vtkIdType>(i);
  }
  std::mt19937 generator(seed);
  std::shuffle(order.begin(), order.end(), generator);
  auto result = Grid::New();
  result->SetPoints(grid->GetPoints());
  for (const vtkIdType c : order)
  {
    const Corners corners = cornersOf(grid, c);
    result->InsertNextCell(
      grid->GetCellType(c), static_cast<vtkIdType>(corners.size()), corners.data());
  }
  return result;
}

Grid changedPoints(
  vtkUnstructuredGrid* grid, const std::function<void(vtkIdType, std::array<double, 3>&)>& change)
{
  auto result = Grid::New();
  result->DeepCopy(grid);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p = pointOf(grid, i);
    change(i, p);
    result->GetPoints()->SetPoint(i, p.data());
  }
  return result;
}

Grid withNaN(vtkUnstructuredGrid* grid)
{
  const vtkIdType bad = cornersOf(grid, grid->GetNumberOfCells() / 2)[1];
  return changedPoints(
    grid, [bad](vtkIdType i, std::array<double, 3>& p) { p[1] = i == bad ? std::nan("") : p[1]; });
}

Grid singlePrecision(vtkUnstructuredGrid* grid)
{
  auto result = Grid::New();
  result->DeepCopy(grid);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, pointOf(grid, i).data());
  }
  result->SetPoints(points);
  return result;
}

vtkSmartPointer<vtkPolyData> polyData(vtkUnstructuredGrid* grid)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(grid->GetPoints());
  result->SetPolys(grid->GetCells());
  result->GetPointData()->ShallowCopy(grid->GetPointData());
  result->GetCellData()->ShallowCopy(grid->GetCellData());
  return result;
}

Grid withVerticesAndLines(vtkUnstructuredGrid* grid)
{
  auto result = Grid::New();
  result->SetPoints(grid->GetPoints());
  vtkNew<vtkDoubleArray> number;
  number->SetName("Number");
  const auto add = [&](int type, const Corners& corners) {
    number->InsertNextValue(static_cast<double>(result->GetNumberOfCells()));
    result->InsertNextCell(type, static_cast<vtkIdType>(corners.size()), corners.data());
  };
  add(VTK_VERTEX, { 3 });
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    add(grid->GetCellType(c), cornersOf(grid, c));
    if (c == 0)
    {
      add(VTK_LINE, { 0, 1 });
    }
  }
  add(VTK_POLY_LINE, { 0, 1, 2 });
  result->GetCellData()->AddArray(number);
  return result;
}

vtkSmartPointer<vtkDoubleArray> numbers(const char* name, vtkIdType count, double first)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetValue(i, first + static_cast<double>(i));
  }
  return array;
}

Grid withData(vtkUnstructuredGrid* grid)
{
  auto result = Grid::New();
  result->ShallowCopy(grid);
  result->GetPointData()->AddArray(numbers("PointNumber", grid->GetNumberOfPoints(), 100.0));
  result->GetCellData()->AddArray(numbers("CellNumber", grid->GetNumberOfCells(), 1000.0));
  result->GetFieldData()->AddArray(numbers("Note", 1, 7.0));
  return result;
}

std::map<vtkIdType, vtkIdType> boundaryOf(vtkDataSet* data)
{
  std::set<std::pair<vtkIdType, vtkIdType>> sides;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c)
  {
    const Corners corners = cornersOf(data, c);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      sides.emplace(corners[i], corners[(i + 1) % corners.size()]);
    }
  }
  std::map<vtkIdType, vtkIdType> next;
  for (const auto& side : sides)
  {
    if (!sides.count({ side.second, side.first }))
    {
      next[side.first] = side.second;
    }
  }
  return next;
}

void expectOnTarget(vtkDataSet* projected, const SweepGrids& sweep,
  const std::map<std::array<double, 3>, std::array<double, 3>>& ends)
{
  ASSERT_EQ(projected->GetNumberOfPoints(), sweep.sourceQuads->GetNumberOfPoints());
  const auto boundary = boundaryOf(sweep.sourceQuads);
  ASSERT_EQ(boundary.size(), ends.size());
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(sweep.targetSurface);
  locator->BuildLocator();
  for (vtkIdType i = 0; i < projected->GetNumberOfPoints(); ++i)
  {
    const auto p = pointOf(projected, i);
    if (boundary.count(i))
    {
      ASSERT_EQ(p, ends.at(pointOf(sweep.sourceQuads, i))) << "point " << i;
      continue;
    }
    double closest[3];
    vtkIdType cell = -1;
    int subId = 0;
    double distance2 = 0.0;
    locator->FindClosestPoint(p.data(), closest, cell, subId, distance2);
    ASSERT_LT(std::sqrt(distance2), 1e-12 * sizeOf(sweep.targetSurface)) << "point " << i;
  }
}

SweepGrids plateSweep(int numberOfHoles)
{
  constexpr int cells = 12;
  const int holes[3][4] = { { 2, 2, 2, 2 }, { 7, 3, 3, 2 }, { 4, 7, 2, 3 } };
  std::map<std::pair<int, int>, vtkIdType> ids;
  std::vector<Corners> quads;
  std::vector<Corners> halves;
  const auto point = [&](int i, int j) {
    return ids.emplace(std::make_pair(i, j), static_cast<vtkIdType>(ids.size())).first->second;
  };
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      bool cut = false;
      for (int h = 0; h < numberOfHoles; ++h)
      {
        cut = cut ||
          (i >= holes[h][0] && i < holes[h][0] + holes[h][2] && j >= holes[h][1] &&
            j < holes[h][1] + holes[h][3]);
      }
      if (!cut)
      {
        const Corners q{ point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1) };
        quads.push_back(q);
        const bool other = (i + j) % 2 == 1;
        halves.push_back(other ? Corners{ q[0], q[1], q[2] } : Corners{ q[0], q[1], q[3] });
        halves.push_back(other ? Corners{ q[0], q[2], q[3] } : Corners{ q[1], q[2], q[3] });
      }
    }
  }
  std::vector<std::array<double, 3>> source(ids.size());
  std::vector<std::array<double, 3>> target(ids.size());
  std::vector<std::array<double, 3>> middle(ids.size());
  for (const auto& [place, id] : ids)
  {
    const double x = 1.0 * place.first / cells;
    const double y = 1.0 * place.second / cells;
    const auto i = static_cast<std::size_t>(id);
    const double inside = 16.0 * x * (1.0 - x) * y * (1.0 - y);
    source[i] = { x, y, 0.1 * inside };
    target[i] = { 1.5 * x + 0.05 * inside, y - 0.2 * x + 0.04 * inside, 2.0 - 0.1 * x * y };
    for (std::size_t c = 0; c < 3; ++c)
    {
      middle[i][c] = 0.5 * (source[i][c] + target[i][c]);
    }
  }
  SweepGrids sweep;
  sweep.sourceQuads = gridOf(source, quads, VTK_QUAD);
  sweep.sourceSurface = gridOf(source, halves, VTK_TRIANGLE);
  sweep.targetSurface = gridOf(target, halves, VTK_TRIANGLE);

  std::vector<std::array<double, 3>> linkingPoints;
  std::vector<Corners> linkingQuads;
  std::map<vtkIdType, vtkIdType> column;
  const auto columnOf = [&](vtkIdType id) {
    const auto known = column.emplace(id, static_cast<vtkIdType>(linkingPoints.size()));
    if (known.second)
    {
      for (const auto* layer : { &source, &middle, &target })
      {
        linkingPoints.push_back((*layer)[static_cast<std::size_t>(id)]);
      }
    }
    return known.first->second;
  };
  for (const auto& [a, b] : boundaryOf(sweep.sourceQuads))
  {
    const vtkIdType ca = columnOf(a);
    const vtkIdType cb = columnOf(b);
    for (vtkIdType k = 0; k < 2; ++k)
    {
      linkingQuads.push_back({ ca + k, cb + k, cb + k + 1, ca + k + 1 });
    }
  }
  sweep.linkingSides = gridOf(linkingPoints, linkingQuads, VTK_QUAD);
  return sweep;
}

double report(vtkDataSet* data, const std::string& name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name.c_str());
  EXPECT_NE(array, nullptr) << name;
  return array ? array->GetTuple1(0) : std::nan("");
}

std::string textReport(vtkDataSet* data, const std::string& name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name.c_str()));
  EXPECT_NE(array, nullptr) << name;
  return array && array->GetNumberOfValues() > 0 ? array->GetValue(0) : std::string();
}

void expectSameBits(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  EXPECT_EQ(greatestDistance(a, b), 0.0);
  for (vtkIdType c = 0; c < a->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(cornersOf(a, c), cornersOf(b, c));
  }
  for (const auto& [one, other] : { std::make_pair<vtkDataSetAttributes*, vtkDataSetAttributes*>(
                                      a->GetPointData(), b->GetPointData()),
         std::make_pair<vtkDataSetAttributes*, vtkDataSetAttributes*>(
           a->GetCellData(), b->GetCellData()) })
  {
    ASSERT_EQ(one->GetNumberOfArrays(), other->GetNumberOfArrays());
    for (int i = 0; i < one->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* left = one->GetArray(i);
      vtkDataArray* right = other->GetArray(left->GetName());
      ASSERT_NE(right, nullptr) << left->GetName();
      ASSERT_EQ(left->GetNumberOfValues(), right->GetNumberOfValues());
      for (vtkIdType v = 0; v < left->GetNumberOfValues(); ++v)
      {
        const int components = left->GetNumberOfComponents();
        ASSERT_EQ(left->GetComponent(v / components, static_cast<int>(v % components)),
          right->GetComponent(v / components, static_cast<int>(v % components)))
          << left->GetName();
      }
    }
  }
}

bool isEmpty(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    if (output && (output->GetNumberOfPoints() > 0 || output->GetNumberOfCells() > 0))
    {
      return false;
    }
  }
  return true;
}

void expectOneError(vtkAlgorithm* filter, const std::string& part)
{
  Events events(filter);
  filter->Update();
  ASSERT_EQ(events.errors.size(), 1u) << part;
  EXPECT_NE(events.errors[0].find(part), std::string::npos) << events.errors[0];
  EXPECT_TRUE(isEmpty(filter));
}

void expectEmptyWhenAborted(vtkAlgorithm* filter, double fraction)
{
  Events events(filter);
  vtkNew<AbortAt> abort;
  abort->Fraction = fraction;
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, abort);
  filter->Modified();
  filter->Update();
  EXPECT_TRUE(isEmpty(filter)) << "aborted at " << fraction;
  EXPECT_TRUE(events.errors.empty());
  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
}
}

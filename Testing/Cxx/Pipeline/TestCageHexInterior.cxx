// SPDX-License-Identifier: BSD-3-Clause
// vtkCageHexInterior: numbering, arrays, report, both orientations, and what it says about bad
// input.
#include "Support/SweepMeshes.h"
#include "TestEvents.h"

#include "HexSweepArrays.h"

#include <vtkCageHexInterior.h>
#include <vtkSweepQuadProjector.h>

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkMeshQuality.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace TestCageHexInterior
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::Quads;
using test::Sweep;

vtkSmartPointer<vtkPoints> pointsOf(const Points& points)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataTypeToDouble();
  for (Index i = 0; i < points.rows(); ++i)
  {
    result->InsertNextPoint(points.row(i).data());
  }
  return result;
}

template <typename Grid = vtkUnstructuredGrid>
vtkSmartPointer<Grid> gridOf(const Points& points, const Quads& quads)
{
  auto grid = vtkSmartPointer<Grid>::New();
  grid->SetPoints(pointsOf(points));
  grid->Allocate(quads.rows());
  for (Index q = 0; q < quads.rows(); ++q)
  {
    const vtkIdType ids[4] = { quads(q, 0), quads(q, 1), quads(q, 2), quads(q, 3) };
    grid->InsertNextCell(VTK_QUAD, 4, ids);
  }
  return grid;
}

/// The three inputs; a test changes them before run().
struct Case
{
  vtkSmartPointer<vtkPointSet> source;
  vtkSmartPointer<vtkPointSet> target;
  vtkSmartPointer<vtkPointSet> linking;
  vtkNew<vtkCageHexInterior> filter;
  test::Events events;

  explicit Case(const Sweep& sweep)
    : source(gridOf(sweep.source, sweep.quads))
    , target(gridOf(sweep.target, sweep.quads))
    , linking(gridOf(sweep.linkingPoints, sweep.linkingQuads))
    , events(filter)
  {
  }

  vtkUnstructuredGrid* run()
  {
    this->filter->SetSourceQuadsData(this->source);
    this->filter->SetTargetQuadsData(this->target);
    this->filter->SetLinkingSidesData(this->linking);
    this->filter->Update();
    return this->filter->GetOutput();
  }

  double report(const std::string& name)
  {
    return this->filter->GetOutput()
      ->GetFieldData()
      ->GetArray((hexsweep::reports::Prefix + name).c_str())
      ->GetTuple1(0);
  }

  /// One error that contains the text, nothing in the output.
  void expectError(const std::string& part)
  {
    vtkUnstructuredGrid* output = this->run();
    ASSERT_EQ(this->events.errors.size(), 1u) << part;
    const std::string& text = this->events.errors.front();
    EXPECT_NE(text.find(part), std::string::npos) << "got: " << text;
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    EXPECT_EQ(output->GetNumberOfCells(), 0);
  }
};

Sweep someSweep()
{
  return test::makeSweep(12, 9, true, test::evenLayers(5), test::affineMotion);
}

vtkIdType countInverted(vtkUnstructuredGrid* grid)
{
  vtkIdType inverted = 0;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    inverted += vtkMeshQuality::HexScaledJacobian(grid->GetCell(cell)) <= 0.0;
  }
  return inverted;
}

/// The same quads, each beginning elsewhere, every second one turned over.
Quads disordered(const Quads& quads)
{
  Quads result = quads;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (int c = 0; c < 4; ++c)
    {
      result(q, c) = quads(q, (q + (q % 2 ? 1 : 3) * c) % 4);
    }
  }
  return result;
}

vtkSmartPointer<vtkUnstructuredGrid> readCase(const std::string& name, const std::string& file)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  const std::string path = std::string(HEXSWEEP_DATA_DIR) + "/cases/" + name + "/" + file;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

TEST(CageHexInterior, NumberingAndArraysFollowTheLayers)
{
  const Sweep sweep = someSweep();
  Case input(sweep);
  input.filter->SetMethodToBlend();
  vtkUnstructuredGrid* output = input.run();
  EXPECT_EQ(input.events.errors.size(), 0u);
  EXPECT_EQ(input.events.warnings.size(), 0u);
  const Index n = sweep.source.rows();
  const Index m = sweep.quads.rows();
  ASSERT_EQ(output->GetNumberOfPoints(), 6 * n);
  ASSERT_EQ(output->GetNumberOfCells(), 5 * m);
  vtkDataArray* sourceIds = output->GetPointData()->GetArray(hexsweep::arrays::SourcePointIds);
  vtkDataArray* pointLayers = output->GetPointData()->GetArray(hexsweep::arrays::SweepLayer);
  vtkDataArray* cellIds = output->GetCellData()->GetArray(hexsweep::arrays::SourceCellIds);
  vtkDataArray* cellLayers = output->GetCellData()->GetArray(hexsweep::arrays::SweepLayer);
  vtkDataArray* quality = output->GetCellData()->GetArray(hexsweep::arrays::ScaledJacobian);
  ASSERT_TRUE(sourceIds && pointLayers && cellIds && cellLayers && quality);
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (Index i = 0; i < 6 * n; ++i)
  {
    ASSERT_EQ(sourceIds->GetTuple1(i), i % n);
    ASSERT_EQ(pointLayers->GetTuple1(i), i / n);
    const Eigen::RowVector3d point(output->GetPoint(i));
    ASSERT_LT((point - sweep.layers.row(i)).norm(), 1e-12);
  }
  for (Index h = 0; h < 5 * m; ++h)
  {
    ASSERT_EQ(output->GetCellType(h), VTK_HEXAHEDRON);
    ASSERT_EQ(cellIds->GetTuple1(h), h % m);
    ASSERT_EQ(cellLayers->GetTuple1(h), h / m);
    const double verdict = vtkMeshQuality::HexScaledJacobian(output->GetCell(h));
    ASSERT_NEAR(quality->GetTuple1(h), verdict, 1e-12);
    ASSERT_GT(verdict, 0.0);
    vtkIdList* ids = output->GetCell(h)->GetPointIds();
    for (int c = 0; c < 8; ++c)
    {
      ASSERT_EQ(ids->GetId(c), (h / m + c / 4) * n + sweep.quads(h % m, c % 4));
    }
  }
}

TEST(CageHexInterior, CertifyProvesEveryHex)
{
  Case input(someSweep());
  EXPECT_TRUE(input.filter->GetCertify());
  vtkUnstructuredGrid* output = input.run();
  const auto range = [output](const char* name) {
    const double* values = output->GetCellData()->GetArray(name)->GetRange();
    return std::make_pair(values[0], values[1]);
  };
  EXPECT_EQ(range(hexsweep::arrays::Validity), std::make_pair(0.0, 0.0));
  EXPECT_GT(range(hexsweep::arrays::JacobianLowerBound).first, 0.0);
  EXPECT_EQ(input.report("NotCertified"), 0);
  EXPECT_EQ(
    input.report("MinJacobianLowerBound"), range(hexsweep::arrays::JacobianLowerBound).first);

  input.filter->CertifyOff();
  input.filter->Update();
  EXPECT_EQ(range(hexsweep::arrays::Validity), std::make_pair(3.0, 3.0));
  EXPECT_EQ(input.report("NotCertified"), input.report("Hexes"));
  EXPECT_EQ(input.report("Inverted"), 0);
}

TEST(CageHexInterior, ReportSaysWhatRan)
{
  Case input(someSweep());
  vtkUnstructuredGrid* output = input.run();
  EXPECT_EQ(input.report("Hexes"), static_cast<double>(output->GetNumberOfCells()));
  EXPECT_EQ(input.report("Inverted"), 0);
  vtkDataArray* quality = output->GetCellData()->GetArray(hexsweep::arrays::ScaledJacobian);
  EXPECT_EQ(input.report("MinScaledJacobian"), quality->GetRange()[0]);
  double sum = 0.0;
  for (vtkIdType h = 0; h < quality->GetNumberOfTuples(); ++h)
  {
    sum += quality->GetTuple1(h);
  }
  EXPECT_NEAR(input.report("MeanScaledJacobian"),
    sum / static_cast<double>(quality->GetNumberOfTuples()), 1e-12);
  const auto text = [&](const char* name) {
    return vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray(name));
  };
  ASSERT_TRUE(text(hexsweep::reports::Method) && text(hexsweep::reports::Stages));
  EXPECT_EQ(text(hexsweep::reports::Method)->GetValue(0), std::string("Blend + polish"));
  EXPECT_EQ(text(hexsweep::reports::Stages)->GetNumberOfValues(),
    output->GetFieldData()->GetArray(hexsweep::reports::Seconds)->GetNumberOfTuples());

  input.filter->SetMethodToAffineBoundaryError();
  input.filter->Update();
  EXPECT_EQ(text(hexsweep::reports::Method)->GetValue(0), "AffineBoundaryError");
  EXPECT_EQ(input.report("Inverted"), 0);
}

TEST(CageHexInterior, BothOrientationsOfTheSourceGiveRightHandedHexes)
{
  for (const bool turned : { false, true })
  {
    Sweep sweep = someSweep();
    if (turned)
    {
      sweep.quads = sweep.quads.rowwise().reverse().eval();
    }
    Case input(sweep);
    vtkUnstructuredGrid* output = input.run();
    ASSERT_EQ(output->GetNumberOfCells(), 5 * sweep.quads.rows());
    EXPECT_EQ(countInverted(output), 0);
    EXPECT_EQ(input.report("Inverted"), 0);
    EXPECT_EQ(input.events.errors.size() + input.events.warnings.size(), 0u);
  }
}

TEST(CageHexInterior, OrientationOfTargetAndLinkingCellsDoesNotMatter)
{
  const Sweep sweep = someSweep();
  Case plain(sweep);
  Sweep other = sweep;
  test::cutLinkingSides(other);
  test::disorderLinkingSides(other);
  Case mixed(other);
  mixed.target = gridOf(sweep.target, disordered(sweep.quads));
  vtkUnstructuredGrid* a = plain.run();
  vtkUnstructuredGrid* b = mixed.run();
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_EQ(a->GetPoint(i)[c], b->GetPoint(i)[c]);
    }
  }
  EXPECT_EQ(mixed.events.errors.size() + mixed.events.warnings.size(), 0u);
}

TEST(CageHexInterior, PolyDataGivesTheSameMesh)
{
  const Sweep sweep = someSweep();
  Case grid(sweep);
  Case poly(sweep);
  poly.source = gridOf<vtkPolyData>(sweep.source, sweep.quads);
  poly.target = gridOf<vtkPolyData>(sweep.target, sweep.quads);
  poly.linking = gridOf<vtkPolyData>(sweep.linkingPoints, sweep.linkingQuads);
  vtkUnstructuredGrid* a = grid.run();
  vtkUnstructuredGrid* b = poly.run();
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_EQ(a->GetPoint(i)[c], b->GetPoint(i)[c]);
    }
  }
}

TEST(CageHexInterior, SourceDataAreCarriedToEveryLayer)
{
  const Sweep sweep = someSweep();
  Case input(sweep);
  const Index n = sweep.source.rows();
  const Index m = sweep.quads.rows();
  vtkNew<vtkDoubleArray> temperature;
  temperature->SetName("Temperature");
  for (Index i = 0; i < n; ++i)
  {
    temperature->InsertNextValue(0.5 * static_cast<double>(i));
  }
  input.source->GetPointData()->AddArray(temperature);
  vtkNew<vtkStringArray> label;
  label->SetName("Label");
  vtkNew<vtkIntArray> material;
  material->SetName("Material");
  material->SetNumberOfComponents(2);
  for (Index j = 0; j < m; ++j)
  {
    label->InsertNextValue("quad " + std::to_string(j));
    material->InsertNextTuple2(static_cast<double>(j), static_cast<double>(7 * j));
  }
  input.source->GetCellData()->AddArray(label);
  input.source->GetCellData()->AddArray(material);
  vtkNew<vtkIntArray> serial;
  serial->SetName("SerialNumber");
  serial->InsertNextValue(4711);
  input.source->GetFieldData()->AddArray(serial);

  vtkUnstructuredGrid* output = input.run();
  vtkDataArray* carried = output->GetPointData()->GetArray("Temperature");
  ASSERT_TRUE(carried);
  ASSERT_EQ(carried->GetNumberOfTuples(), 6 * n);
  for (Index i = 0; i < 6 * n; ++i)
  {
    ASSERT_EQ(carried->GetTuple1(i), 0.5 * static_cast<double>(i % n));
  }
  auto* labels = vtkStringArray::SafeDownCast(output->GetCellData()->GetAbstractArray("Label"));
  vtkDataArray* materials = output->GetCellData()->GetArray("Material");
  ASSERT_TRUE(labels && materials);
  ASSERT_EQ(labels->GetNumberOfValues(), 5 * m);
  for (Index h = 0; h < 5 * m; ++h)
  {
    ASSERT_EQ(labels->GetValue(h), "quad " + std::to_string(h % m));
    ASSERT_EQ(materials->GetComponent(h, 1), static_cast<double>(7 * (h % m)));
  }
  ASSERT_TRUE(output->GetFieldData()->GetArray("SerialNumber"));
}

TEST(CageHexInterior, VertexAndLineCellsAreIgnored)
{
  const Sweep sweep = someSweep();
  Case input(sweep);
  auto mixed = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mixed->SetPoints(pointsOf(sweep.source));
  const vtkIdType line[2] = { 0, 1 };
  mixed->InsertNextCell(VTK_VERTEX, 1, line);
  mixed->InsertNextCell(VTK_LINE, 2, line);
  vtkNew<vtkIntArray> number;
  number->SetName("Number");
  number->InsertNextValue(-1);
  number->InsertNextValue(-1);
  for (Index q = 0; q < sweep.quads.rows(); ++q)
  {
    const vtkIdType ids[4] = { sweep.quads(q, 0), sweep.quads(q, 1), sweep.quads(q, 2),
      sweep.quads(q, 3) };
    mixed->InsertNextCell(VTK_QUAD, 4, ids);
    number->InsertNextValue(static_cast<int>(q));
  }
  mixed->GetCellData()->AddArray(number);
  input.source = mixed;
  vtkUnstructuredGrid* output = input.run();
  const Index m = sweep.quads.rows();
  ASSERT_EQ(output->GetNumberOfCells(), 5 * m);
  // Ids are those of the input, where the quads begin at 2.
  EXPECT_EQ(output->GetCellData()->GetArray(hexsweep::arrays::SourceCellIds)->GetTuple1(m + 3), 5);
  EXPECT_EQ(output->GetCellData()->GetArray("Number")->GetTuple1(m + 3), 3);
}

TEST(CageHexInterior, PointsOfNoQuadKeepTheirPlace)
{
  Sweep sweep = someSweep();
  const Index n = sweep.source.rows();
  for (Points* points : { &sweep.source, &sweep.target })
  {
    points->conservativeResize(n + 1, 3);
    points->row(n) << 1, 2, points == &sweep.source ? 3 : 8;
  }
  Case input(sweep);
  vtkUnstructuredGrid* output = input.run();
  ASSERT_EQ(output->GetNumberOfPoints(), 6 * (n + 1));
  EXPECT_EQ(countInverted(output), 0);
  double before = 2.0;
  for (Index k = 0; k <= 5; ++k)
  {
    const double z = output->GetPoint(k * (n + 1) + n)[2];
    EXPECT_GT(z, before);
    before = z;
  }
  EXPECT_EQ(before, 8.0);
}

TEST(CageHexInterior, SinglePrecisionOnDemand)
{
  Case input(someSweep());
  input.filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  vtkUnstructuredGrid* output = input.run();
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_FLOAT);
  vtkDataArray* quality = output->GetCellData()->GetArray(hexsweep::arrays::ScaledJacobian);
  for (vtkIdType h = 0; h < output->GetNumberOfCells(); ++h)
  {
    // Judged as stored.
    ASSERT_NEAR(
      quality->GetTuple1(h), vtkMeshQuality::HexScaledJacobian(output->GetCell(h)), 1e-12);
  }
}

TEST(CageHexInterior, InvertedHexesRaiseOneWarning)
{
  Sweep sweep = someSweep();
  // Fold the target: one inner node goes far beyond its neighbours.
  Index inner = -1;
  for (Index i = 0; i < sweep.source.rows() && inner < 0; ++i)
  {
    const double x = sweep.cap(i, 0);
    const double y = sweep.cap(i, 1);
    if (x > 0.2 && x < 0.5 && y > 0.2 && y < 0.8)
    {
      inner = i;
    }
  }
  ASSERT_GE(inner, 0);
  sweep.target.row(inner) = sweep.target.row(0);
  Case input(sweep);
  vtkUnstructuredGrid* output = input.run();
  const vtkIdType inverted = countInverted(output);
  ASSERT_GT(inverted, 0);
  EXPECT_EQ(input.report("Inverted"), inverted);
  EXPECT_EQ(input.events.errors.size(), 0u);
  ASSERT_EQ(input.events.warnings.size(), 1u);
  const std::string& text = input.events.warnings.front();
  EXPECT_NE(text.find(std::to_string(inverted) + " of " +
              std::to_string(output->GetNumberOfCells()) + " hexahedra are inverted"),
    std::string::npos)
    << text;
  EXPECT_NE(text.find("  cell "), std::string::npos) << text;

  Case failing(sweep);
  failing.filter->FailIfInvalidOn();
  failing.expectError("hexahedra are inverted");
}

/// A straight sweep.
Sweep straightSweep(int nx = 12, int ny = 9, int layers = 6)
{
  return test::makeSweep(nx, ny, false, test::evenLayers(layers),
    [](double x, double y, double t) { return Eigen::RowVector3d(x, y, 2 * t); });
}

/// Points of the linking sides at the foot (0, y) of a column, by height.
std::vector<Index> columnAt(const Sweep& sweep, double leastY)
{
  std::vector<Index> column;
  for (Index i = 0; i < sweep.linkingPoints.rows(); ++i)
  {
    const Eigen::RowVector3d p = sweep.linkingPoints.row(i);
    if (p[0] == 0.0 && p[1] > leastY && p[1] < leastY + 0.1)
    {
      column.push_back(i);
    }
  }
  std::sort(column.begin(), column.end(),
    [&](Index a, Index b) { return sweep.linkingPoints(a, 2) < sweep.linkingPoints(b, 2); });
  return column;
}

void expectConflicts(const Sweep& sweep, const std::vector<std::string>& parts)
{
  Case input(sweep);
  vtkUnstructuredGrid* output = input.run();
  EXPECT_TRUE(input.events.errors.empty()) << input.events.errors[0];
  const double conflicts = input.report("CornerConflicts");
  EXPECT_GT(conflicts, 0);
  EXPECT_GT(input.report("NotCertified"), 0);
  // Everything else is mended, and at the first start.
  EXPECT_LE(input.report("NotCertified"), conflicts);
  EXPECT_LE(
    output->GetFieldData()->GetAbstractArray(hexsweep::reports::Steps)->GetNumberOfValues(), 4);
  EXPECT_LE(input.report("FloorScaledJacobian"), 0.0);
  ASSERT_EQ(input.events.warnings.size(), 1u);
  const std::string& text = input.events.warnings.front();
  const std::string count =
    "alone make " + std::to_string(static_cast<int>(conflicts)) + " hexahedra bad";
  EXPECT_NE(text.find(count), std::string::npos) << text;
  for (const std::string& part : parts)
  {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
  }
  EXPECT_EQ(text.find("EnsureValid"), std::string::npos) << text;
  EXPECT_EQ(text.find("Automatic"), std::string::npos) << text;
}

TEST(CageHexInterior, WhatTheBoundaryForbidsIsCountedAndNamed)
{
  Sweep folded = straightSweep();
  for (Index i = 0; i < folded.target.rows(); ++i)
  {
    if (std::hypot(folded.cap(i, 0) - 1.0, folded.cap(i, 1) - 0.5) < 0.1)
    {
      folded.target.row(i) += Eigen::RowVector3d(0.25, 0.0, 0.0);
      break;
    }
  }
  expectConflicts(folded, { "the target quads fold", "correct the target quads" });

  Sweep back = straightSweep();
  const std::vector<Index> column = columnAt(back, 0.4);
  ASSERT_EQ(column.size(), 7u);
  back.linkingPoints(column[3], 2) = back.linkingPoints(column[2], 2) - 0.2;
  expectConflicts(back, { "a linking side folds", "mesh this linking side anew" });

  Sweep collapsed = straightSweep();
  collapsed.linkingPoints.row(column[3]) = collapsed.linkingPoints.row(column[2]);
  expectConflicts(collapsed, { "points of a linking side coincide", "move them apart" });
}

TEST(CageHexInterior, AdviceFitsTheSettings)
{
  Sweep sweep = straightSweep(6, 5, 3);
  for (Index i = 0; i < sweep.target.rows(); ++i)
  {
    // Bulges, so that the fold is no proof.
    const double x = sweep.cap(i, 0);
    const double y = sweep.cap(i, 1);
    sweep.target(i, 2) += 0.6 * x * (2 - x) * y * (1 - y);
  }
  for (Index i = 0; i < sweep.target.rows(); ++i)
  {
    if (std::hypot(sweep.cap(i, 0) - 0.5, sweep.cap(i, 1) - 0.3) < 0.2)
    {
      sweep.target.row(i) += Eigen::RowVector3d(0.5, 0.01, 0.0);
      break;
    }
  }
  const auto textOf = [&](bool ensureValid, bool automatic) -> std::string {
    Case input(sweep);
    input.filter->SetEnsureValid(ensureValid);
    if (!automatic)
    {
      input.filter->SetMethodToBlend();
    }
    input.run();
    EXPECT_EQ(input.events.warnings.size(), 1u);
    return input.events.warnings.empty() ? "" : input.events.warnings.front();
  };
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  const std::string off = textOf(false, true);
  EXPECT_TRUE(has(off, "switch EnsureValid on")) << off;
  const std::string one = textOf(true, false);
  EXPECT_TRUE(has(one, "method Automatic") && !has(one, "EnsureValid")) << one;
  const std::string all = textOf(true, true);
  EXPECT_TRUE(has(all, "check the target quads") && !has(all, "Automatic")) << all;
}

TEST(CageHexInterior, WhatSinglePrecisionSpoilsIsNamed)
{
  // A layer is lower than a unit of the last place there.
  Sweep sweep = test::makeSweep(6, 5, false, test::evenLayers(4),
    [](double x, double y, double t) { return Eigen::RowVector3d(x, y, 1e6 + 0.1 * t); });
  Case precise(sweep);
  precise.run();
  EXPECT_TRUE(precise.events.warnings.empty());
  EXPECT_EQ(precise.report("NotCertified"), 0);
  Case single(sweep);
  single.filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  single.run();
  EXPECT_GT(single.report("NotCertified"), 0);
  ASSERT_EQ(single.events.warnings.size(), 1u);
  const std::string& text = single.events.warnings.front();
  EXPECT_NE(text.find("single precision is too coarse"), std::string::npos) << text;
  EXPECT_NE(text.find("set OutputPointsPrecision to double"), std::string::npos) << text;
}

TEST(CageHexInterior, EmptyInput)
{
  Case source(someSweep());
  source.source = vtkSmartPointer<vtkUnstructuredGrid>::New();
  source.expectError("source quads are empty");
  Case target(someSweep());
  target.target = vtkSmartPointer<vtkPolyData>::New();
  target.expectError("target quads are empty");
  Case linking(someSweep());
  linking.linking = vtkSmartPointer<vtkUnstructuredGrid>::New();
  linking.expectError("linking sides are empty");
}

TEST(CageHexInterior, MissingPort)
{
  const char* names[3] = { "source quads are missing", "target quads are missing",
    "linking sides are missing" };
  for (int port = 0; port < 3; ++port)
  {
    const Sweep sweep = someSweep();
    vtkNew<vtkCageHexInterior> filter;
    test::Events events(filter);
    const Case input(sweep);
    vtkPointSet* data[3] = { input.source, input.target, input.linking };
    for (int other = 0; other < 3; ++other)
    {
      if (other != port)
      {
        filter->SetInputData(other, data[other]);
      }
    }
    filter->Update();
    ASSERT_EQ(events.errors.size(), 1u);
    EXPECT_NE(events.errors.front().find(names[port]), std::string::npos) << events.errors.front();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
}

TEST(CageHexInterior, CellsThatAreNotQuads)
{
  Case input(someSweep());
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->DeepCopy(input.source);
  const vtkIdType ids[3] = { 0, 1, 2 };
  grid->InsertNextCell(VTK_TRIANGLE, 3, ids);
  input.source = grid;
  input.expectError("not a quad");
}

TEST(CageHexInterior, MixedOrientationOfTheSource)
{
  Sweep sweep = someSweep();
  sweep.quads.row(7) = sweep.quads.row(7).reverse().eval();
  Case input(sweep);
  input.expectError("opposite orientation");
}

TEST(CageHexInterior, ClosedSourceSurface)
{
  Points cube(8, 3);
  cube << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  Quads faces(6, 4);
  faces << 0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7;
  Case input(someSweep());
  input.source = gridOf(cube, faces);
  input.target = gridOf(cube, faces);
  input.expectError("closed surface");
}

TEST(CageHexInterior, CoordinateThatIsNotFinite)
{
  for (int port = 0; port < 3; ++port)
  {
    Sweep sweep = someSweep();
    Points* points[3] = { &sweep.source, &sweep.target, &sweep.linkingPoints };
    (*points[port])(5, 1) = std::numeric_limits<double>::quiet_NaN();
    Case input(sweep);
    input.expectError("not a finite number");
  }
}

TEST(CageHexInterior, LoopsThatDoNotMatch)
{
  Sweep source = someSweep();
  source.source.rowwise() += Eigen::RowVector3d(0.1, 0, 0);
  Case(source).expectError("of the source quads");
  Sweep target = someSweep();
  target.target.rowwise() += Eigen::RowVector3d(0.1, 0, 0);
  Case(target).expectError("last ring of the linking sides does not lie on");
}

TEST(CageHexInterior, DifferentConnectivity)
{
  const Sweep sweep = someSweep();
  Case fewer(sweep);
  fewer.target = gridOf(sweep.target, sweep.quads.topRows(sweep.quads.rows() - 1));
  fewer.expectError("connectivity");

  Case other(sweep);
  Quads quads = sweep.quads;
  std::swap(quads(3, 0), quads(3, 1));
  other.target = gridOf(sweep.target, quads);
  other.expectError("quad 3 has other points");

  Case morePoints(sweep);
  Points points(sweep.target.rows() + 1, 3);
  points << sweep.target, Eigen::RowVector3d(0, 0, 0);
  morePoints.target = gridOf(points, sweep.quads);
  morePoints.expectError("points instead of");
}

TEST(CageHexInterior, MethodsThatDoNotExist)
{
  Case input(someSweep());
  input.filter->SetMethod(7);
  input.expectError("Method 7 does not exist");
}

TEST(CageHexInterior, AnErrorIsForgottenWhenTheInputIsMended)
{
  Case input(someSweep());
  input.filter->SetMethod(7);
  input.expectError("does not exist");
  input.filter->SetMethodToBlend();
  EXPECT_GT(input.run()->GetNumberOfCells(), 0);
  EXPECT_EQ(input.events.errors.size(), 1u);
}

TEST(CageHexInterior, EmptyPieceOfAnotherRankIsSilent)
{
  Case input(someSweep());
  input.source = input.target = input.linking = vtkSmartPointer<vtkUnstructuredGrid>::New();
  input.filter->SetSourceQuadsData(input.source);
  input.filter->SetTargetQuadsData(input.target);
  input.filter->SetLinkingSidesData(input.linking);
  input.filter->UpdatePiece(1, 2, 0);
  EXPECT_EQ(input.events.errors.size() + input.events.warnings.size(), 0u);
  EXPECT_EQ(input.filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(CageHexInterior, RealModelsAreSweptWithoutInvertedHexes)
{
  for (const std::string name : { "taper10", "ubend", "twist270_L", "c_open" })
  {
    const auto source = readCase(name, "source_quads.vtu");
    const auto linking = readCase(name, "linking_quads.vtu");
    vtkNew<vtkSweepQuadProjector> projector;
    projector->SetInputData(0, source);
    projector->SetInputData(1, readCase(name, "target_surface.vtu"));
    projector->SetInputData(2, linking);
    vtkNew<vtkCageHexInterior> interior;
    test::Events events(interior);
    interior->SetSourceQuadsData(source);
    interior->SetTargetQuadsConnection(projector->GetOutputPort());
    interior->SetLinkingSidesData(linking);
    interior->Update();
    vtkUnstructuredGrid* output = interior->GetOutput();
    ASSERT_GT(output->GetNumberOfCells(), 0) << name;
    EXPECT_EQ(output->GetNumberOfCells() % source->GetNumberOfCells(), 0) << name;
    EXPECT_EQ(countInverted(output), 0) << name;
    EXPECT_EQ(events.errors.size() + events.warnings.size(), 0u) << name;
    // The caps are where they were given, bit for bit.
    const vtkIdType n = source->GetNumberOfPoints();
    const vtkIdType last = output->GetNumberOfPoints() - n;
    auto* target = vtkDataSet::SafeDownCast(projector->GetOutputDataObject(0));
    for (vtkIdType i = 0; i < n; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_EQ(output->GetPoint(i)[c], source->GetPoint(i)[c]) << name;
        ASSERT_EQ(output->GetPoint(last + i)[c], target->GetPoint(i)[c]) << name;
      }
    }
  }
}

TEST(CageHexInterior, SingleAndDoublePrecisionInputsFitTogether)
{
  // As when one of the files was written in single precision.
  const Sweep sweep = someSweep();
  Case input(sweep);
  vtkNew<vtkPoints> rounded;
  rounded->SetDataTypeToFloat();
  rounded->DeepCopy(input.linking->GetPoints());
  ASSERT_EQ(rounded->GetDataType(), VTK_FLOAT);
  input.linking->SetPoints(rounded);
  vtkUnstructuredGrid* output = input.run();
  EXPECT_EQ(input.events.errors.size() + input.events.warnings.size(), 0u);
  EXPECT_EQ(countInverted(output), 0);
}

TEST(CageHexInterior, LinkingSidesThatCollapseAreNamed)
{
  vtkNew<vtkSweepQuadProjector> projector;
  projector->SetInputData(0, readCase("bad_rings", "source_quads.vtu"));
  projector->SetInputData(1, readCase("bad_rings", "target_surface.vtu"));
  projector->SetInputData(2, readCase("bad_rings", "linking_quads.vtu"));
  projector->SetInputData(3, readCase("bad_rings", "source_surface.vtu"));
  vtkNew<vtkCageHexInterior> filter;
  test::Events events(filter);
  filter->SetInputData(0, readCase("bad_rings", "source_quads.vtu"));
  filter->SetInputConnection(1, projector->GetOutputPort());
  filter->SetInputData(2, readCase("bad_rings", "linking_quads.vtu"));
  filter->Update();
  ASSERT_EQ(events.errors.size(), 1u);
  // The hole has 32 nodes; its edges turn round between rings 5 and 6 of 12.
  EXPECT_NE(events.errors[0].find("a hole (loop 1, 32 nodes"), std::string::npos)
    << events.errors[0];
  EXPECT_NE(events.errors[0].find("ring 6 is turned over against ring 5"), std::string::npos)
    << events.errors[0];
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(CageHexInterior, EnsureValidAndImproveQualityDoWhatTheySay)
{
  // A concave hole that turns, on target quads that are not polished: Blend alone leaves inverted
  // hexahedra.
  const std::string name = "fig8_concave_twisted_hole";
  vtkNew<vtkSweepQuadProjector> projector;
  projector->SetInputData(0, readCase(name, "source_quads.vtu"));
  projector->SetInputData(1, readCase(name, "target_surface.vtu"));
  projector->SetInputData(2, readCase(name, "linking_quads.vtu"));
  projector->SetInputData(3, readCase(name, "source_surface.vtu"));
  projector->ImproveQualityOff();
  vtkNew<vtkCageHexInterior> filter;
  test::Events events(filter);
  filter->SetInputData(0, readCase(name, "source_quads.vtu"));
  filter->SetInputConnection(1, projector->GetOutputPort());
  filter->SetInputData(2, readCase(name, "linking_quads.vtu"));
  const auto value = [&](const char* report) {
    return filter->GetOutput()->GetFieldData()->GetArray(report)->GetTuple1(0);
  };
  const auto method = [&]() {
    return std::string(vtkStringArray::SafeDownCast(
      filter->GetOutput()->GetFieldData()->GetAbstractArray(hexsweep::reports::Method))
                         ->GetValue(0));
  };
  filter->EnsureValidOff();
  filter->Update();
  const vtkIdType inverted = countInverted(filter->GetOutput());
  EXPECT_GT(inverted, 0);
  EXPECT_EQ(value(hexsweep::reports::Inverted), inverted);
  EXPECT_EQ(method(), "Blend");
  EXPECT_EQ(events.warnings.size(), 1u);

  filter->EnsureValidOn();
  filter->ImproveQualityOff();
  filter->Update();
  EXPECT_EQ(countInverted(filter->GetOutput()), 0);
  EXPECT_EQ(value(hexsweep::reports::NotCertified), 0);
  EXPECT_EQ(method(), "Blend + raised minimum");
  const double minimum = value(hexsweep::reports::MinScaledJacobian);
  const double mean = value(hexsweep::reports::MeanScaledJacobian);

  filter->ImproveQualityOn();
  filter->Update();
  EXPECT_EQ(value(hexsweep::reports::NotCertified), 0);
  EXPECT_EQ(method(), "Blend + raised minimum + polish");
  EXPECT_GE(value(hexsweep::reports::MinScaledJacobian), minimum);
  EXPECT_GT(value(hexsweep::reports::MeanScaledJacobian), mean + 0.01);
  EXPECT_LE(
    value(hexsweep::reports::MinScaledJacobian), value(hexsweep::reports::FloorScaledJacobian));
  EXPECT_EQ(value(hexsweep::reports::CornerConflicts), 0);
  EXPECT_EQ(events.warnings.size(), 1u);
  EXPECT_EQ(
    filter->GetOutput()->GetFieldData()->GetArray(hexsweep::reports::StepMended)->GetTuple1(1),
    inverted);
}

TEST(CageHexInterior, EveryMethodReproducesAStraightSweep)
{
  // Sheared, with a hole: the layers are translated caps.
  const Sweep sweep =
    test::makeSweep(12, 9, true, test::evenLayers(5), [](double x, double y, double t) {
      return Eigen::RowVector3d(x + 0.7 * t, y - 0.4 * t, 2 * t);
    });
  const double size = 3.0;
  const std::map<int, std::pair<const char*, double>> methods{ { vtkCageHexInterior::BLEND,
                                                                 { "Blend", 1e-12 } },
    { vtkCageHexInterior::HARMONIC_COORDINATES, { "HarmonicCoordinates", 1e-12 } },
    { vtkCageHexInterior::MEAN_VALUE_COORDINATES, { "MeanValueCoordinates", 1e-9 } },
    { vtkCageHexInterior::GREEN_COORDINATES, { "GreenCoordinates", 1e-9 } },
    { vtkCageHexInterior::LAYER_MARCH, { "LayerMarch", 1e-12 } },
    { vtkCageHexInterior::AFFINE_BOUNDARY_ERROR, { "AffineBoundaryError", 1e-12 } } };
  for (const auto& [method, expected] : methods)
  {
    Case input(sweep);
    input.filter->SetMethod(method);
    vtkUnstructuredGrid* output = input.run();
    ASSERT_EQ(output->GetNumberOfPoints(), sweep.layers.rows()) << expected.first;
    EXPECT_TRUE(input.events.warnings.empty());
    EXPECT_EQ(vtkStringArray::SafeDownCast(
                output->GetFieldData()->GetAbstractArray(hexsweep::reports::Method))
                ->GetValue(0),
      std::string(expected.first));
    for (Index i = 0; i < sweep.layers.rows(); ++i)
    {
      ASSERT_LT((Eigen::RowVector3d(output->GetPoint(i)) - sweep.layers.row(i)).norm(),
        expected.second * size)
        << expected.first;
    }
  }
}

TEST(CageHexInterior, TheTopologicalModelIsTheTargetTranslated)
{
  const Sweep sweep =
    test::makeSweep(12, 9, true, test::evenLayers(5), [](double x, double y, double t) {
      return Eigen::RowVector3d((1 + t) * x + 0.7 * t * t, y - 0.4 * t, 2 * t + 0.1 * t * x);
    });
  Case input(sweep);
  EXPECT_EQ(input.run()->GetNumberOfCells(), 5 * sweep.quads.rows());
  EXPECT_EQ(input.filter->GetOutput(1)->GetNumberOfCells(), 0);
  input.filter->GenerateTopologicalModelOn();
  input.filter->Update();
  vtkUnstructuredGrid* model = input.filter->GetOutput(1);
  const Index n = sweep.source.rows();
  ASSERT_EQ(model->GetNumberOfPoints(), 6 * n);
  ASSERT_EQ(model->GetNumberOfCells(), 5 * sweep.quads.rows());
  EXPECT_EQ(countInverted(model), 0);
  const auto point = [&](Index k, Index i) -> Eigen::RowVector3d {
    return Eigen::RowVector3d(model->GetPoint(k * n + i));
  };
  const Eigen::RowVector3d step = point(5, 0) - point(4, 0);
  EXPECT_GT(step.norm(), 0.1);
  for (Index k = 0; k <= 5; ++k)
  {
    for (Index i = 0; i < n; ++i)
    {
      const Eigen::RowVector3d expected = sweep.target.row(i) - static_cast<double>(5 - k) * step;
      ASSERT_LT((point(k, i) - expected).norm(), 1e-12);
    }
  }
}
}

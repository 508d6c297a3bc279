// SPDX-License-Identifier: BSD-3-Clause
// vtkCageHexInterior: where nodes go, by each method, numbering, arrays and report.
#include "CageHexCase.h"

#include "HexSweepArrays.h"

#include <vtkSweepQuadProjector.h>

#include <vtkIntArray.h>
#include <vtkMeshQuality.h>

namespace TestCageHexInterior
{
using hexsweep::Index;
using test::countInverted;
using test::someSweep;
using test::Sweep;
using Case = test::CageHexCase;

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

TEST(CageHexInterior, RealModelsAreSweptWithoutInvertedHexes)
{
  for (const std::string name : { "taper10", "ubend", "twist270_L", "c_open" })
  {
    const auto source = test::readGrid(name + "/source_quads");
    const auto linking = test::readGrid(name + "/linking_quads");
    vtkNew<vtkSweepQuadProjector> projector;
    projector->SetInputData(0, source);
    projector->SetInputData(1, test::readGrid(name + "/target_surface"));
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

TEST(CageHexInterior, EnsureValidAndImproveQualityDoWhatTheySay)
{
  // A concave hole that turns, on target quads that are not polished: Blend alone leaves inverted
  // hexahedra.
  const std::string name = "fig8_concave_twisted_hole";
  vtkNew<vtkSweepQuadProjector> projector;
  projector->SetInputData(0, test::readGrid(name + "/source_quads"));
  projector->SetInputData(1, test::readGrid(name + "/target_surface"));
  projector->SetInputData(2, test::readGrid(name + "/linking_quads"));
  projector->SetInputData(3, test::readGrid(name + "/source_surface"));
  projector->ImproveQualityOff();
  vtkNew<vtkCageHexInterior> filter;
  test::Events events(filter);
  filter->SetInputData(0, test::readGrid(name + "/source_quads"));
  filter->SetInputConnection(1, projector->GetOutputPort());
  filter->SetInputData(2, test::readGrid(name + "/linking_quads"));
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

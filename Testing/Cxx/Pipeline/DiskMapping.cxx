// SPDX-License-Identifier: BSD-3-Clause

#include "DiskMapping.h"

#include "HexSweepArrays.h"

#include <vtkCell.h>
#include <vtkIdTypeArray.h>

namespace test
{
DiskMapping::DiskMapping(vtkDataObject* input, vtkDataObject* partner, vtkDataObject* linking)
  : events(filter)
{
  this->filter->SetInputData(0, input);
  if (partner)
  {
    this->filter->SetInputData(1, partner);
  }
  if (linking)
  {
    this->filter->SetInputData(2, linking);
  }
}

vtkUnstructuredGrid* DiskMapping::run()
{
  this->filter->Update();
  EXPECT_TRUE(this->events.errors.empty()) << this->events.errors[0];
  EXPECT_TRUE(this->events.warnings.empty()) << this->events.warnings[0];
  return this->filter->GetOutput();
}

std::array<double, 3> diskPoint(vtkDataSet* output, vtkIdType i)
{
  std::array<double, 3> p;
  output->GetPointData()->GetArray(hexsweep::arrays::DiskCoordinates)->GetTuple(i, p.data());
  return p;
}

double greatestDiskDistance(vtkDataSet* a, vtkDataSet* b)
{
  EXPECT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  double greatest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    greatest = std::max(greatest, distance(diskPoint(a, i), diskPoint(b, i)));
  }
  return greatest;
}

vtkIdType idOf(vtkDataSetAttributes* data, const char* name, vtkIdType i)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(data->GetArray(name));
  EXPECT_NE(ids, nullptr) << name;
  return ids ? ids->GetValue(i) : -2;
}

void expectOriginals(vtkUnstructuredGrid* output, vtkDataSet* input)
{
  ASSERT_GE(output->GetNumberOfPoints(), input->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const bool original = i < input->GetNumberOfPoints();
    EXPECT_EQ(
      idOf(output->GetPointData(), hexsweep::arrays::OriginalPointIds, i), original ? i : -1);
    if (original)
    {
      EXPECT_EQ(pointOf(output, i), pointOf(input, i));
    }
  }
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(output->GetCellType(c), VTK_TRIANGLE);
    const vtkIdType origin = idOf(output->GetCellData(), hexsweep::arrays::OriginalCellIds, c);
    ASSERT_GE(origin, 0);
    ASSERT_LT(origin, input->GetNumberOfCells());
    vtkCell* cell = input->GetCell(origin);
    std::array<double, 3> center{ 0, 0, 0 };
    for (const vtkIdType p : cornersOf(output, c))
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        center[k] += pointOf(output, p)[k] / 3.0;
      }
    }
    double closest[3];
    double parametric[3];
    double weights[32];
    double distance2 = 0.0;
    int subId = 0;
    const int status =
      cell->EvaluatePosition(center.data(), closest, subId, parametric, distance2, weights);
    EXPECT_EQ(status, 1);
    EXPECT_LT(distance2, 1e-20 * input->GetLength() * input->GetLength());
  }
}
}

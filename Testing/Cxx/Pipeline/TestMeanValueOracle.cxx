// SPDX-License-Identifier: BSD-3-Clause
// Core's mean value coordinates against VTK's.
#include "Core/Interior/MeanValueCoordinates.h"
#include "Support/CageShapes.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkMeanValueCoordinatesInterpolator.h>
#include <vtkNew.h>
#include <vtkPoints.h>

namespace TestMeanValueOracle
{
using hexsweep::Index;
using hexsweep::TriangleMesh;

Eigen::VectorXd weightsOfVtk(const TriangleMesh& cage, const Eigen::RowVector3d& x)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (Index i = 0; i < cage.points.rows(); ++i)
  {
    points->InsertNextPoint(cage.points(i, 0), cage.points(i, 1), cage.points(i, 2));
  }
  vtkNew<vtkCellArray> triangles;
  for (Index t = 0; t < cage.triangles.rows(); ++t)
  {
    triangles->InsertNextCell({ cage.triangles(t, 0), cage.triangles(t, 1), cage.triangles(t, 2) });
  }
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(cage.points.rows());
  vtkMeanValueCoordinatesInterpolator::ComputeInterpolationWeights(
    x.data(), points, triangles, weights.data());
  return weights;
}

TEST(MeanValueOracle, CoreEqualsVtkAtUnitSize)
{
  const Eigen::Affine3d motion = test::similarity(1.0);
  const TriangleMesh cage = test::moved(test::angleBlock(), motion);
  const hexsweep::MeanValueCoordinates coordinates(cage.points, cage.triangles);
  const test::Points inside = test::insideAngleBlock();
  for (Index i = 0; i < inside.rows(); ++i)
  {
    const Eigen::RowVector3d x = (motion * inside.row(i).transpose().eval()).transpose();
    // The last three are in the planes of walls, where weights have half the digits.
    const double tolerance = i < 6 ? 1e-10 : 1e-7;
    EXPECT_LT((coordinates.at(x) - weightsOfVtk(cage, x)).cwiseAbs().maxCoeff(), tolerance) << i;
  }
}

TEST(MeanValueOracle, CoreNeedsNoUnitSize)
{
  // VTK's has absolute tolerances, so it is asked at unit size.
  const TriangleMesh unit = test::moved(test::angleBlock(), test::similarity(1.0));
  for (const double scale : { 1e-6, 1e6 })
  {
    const Eigen::Affine3d motion = test::similarity(scale);
    const TriangleMesh cage = test::moved(test::angleBlock(), motion);
    const hexsweep::MeanValueCoordinates coordinates(cage.points, cage.triangles);
    const Eigen::Vector3d point(0.31, 0.42, 0.53);
    const Eigen::VectorXd expected =
      weightsOfVtk(unit, (test::similarity(1.0) * point).transpose());
    EXPECT_LT(
      (coordinates.at((motion * point).transpose()) - expected).cwiseAbs().maxCoeff(), 1e-10);
  }
}
}

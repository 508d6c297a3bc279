// SPDX-License-Identifier: BSD-3-Clause
// A coarse finite element fill against the exact energy of the disk.
#include "Core/FillMesh.h"

#include "Core/DiskFill.h"
#include "Core/MultifrontalSolver.h"

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using hexsweep::Index;
using hexsweep::TriangleMesh;

constexpr double Pi = 3.14159265358979323846;

std::vector<double> anglesOf(int m, double unevenness, double direction)
{
  std::vector<double> angles;
  for (int i = 0; i < m; ++i)
  {
    const double t = 2.0 * Pi * i / m;
    angles.push_back(direction * (t + unevenness * std::sin(t)));
  }
  return angles;
}

/// The fill's energy as a form of the loop's values alone.
Eigen::MatrixXd loopForm(const TriangleMesh& mesh, Index m)
{
  const Eigen::MatrixXd all = hexsweep::cotangentLaplacian(mesh.points, mesh.triangles);
  const Index k = all.rows() - m;
  return all.topLeftCorner(m, m) -
    all.topRightCorner(m, k) * all.bottomRightCorner(k, k).ldlt().solve(all.bottomLeftCorner(k, m));
}
}

TEST(FillMesh, TrianglesFaceUpAndCoverThePolygon)
{
  for (const int m : { 3, 4, 5, 6, 7, 11, 12, 64, 101 })
  {
    for (const double direction : { 1.0, -1.0 })
    {
      const TriangleMesh mesh = hexsweep::fillMesh(anglesOf(m, 0.4, direction));
      double area = 0.0;
      for (Index t = 0; t < mesh.triangles.rows(); ++t)
      {
        const Eigen::RowVector3d a = mesh.points.row(mesh.triangles(t, 0));
        const Eigen::RowVector3d u = mesh.points.row(mesh.triangles(t, 1)) - a;
        const Eigen::RowVector3d v = mesh.points.row(mesh.triangles(t, 2)) - a;
        const double twice = u.x() * v.y() - u.y() * v.x();
        EXPECT_GT(twice, 0.0) << m << ", triangle " << t;
        area += 0.5 * twice;
      }
      double polygon = 0.0;
      for (int i = 0; i < m; ++i)
      {
        const Eigen::RowVector3d a = mesh.points.row(i);
        const Eigen::RowVector3d b = mesh.points.row((i + 1) % m);
        polygon += 0.5 * (a.x() * b.y() - a.y() * b.x());
      }
      EXPECT_NEAR(area, polygon, 1e-12) << m;
      // Euler's formula for a disk
      EXPECT_EQ(mesh.triangles.rows(), 2 * mesh.points.rows() - 2 - m) << m;
      EXPECT_LE(mesh.points.rows(), 4 * m + 8) << m;
    }
  }
}

TEST(FillMesh, EnergyIsNearTheExactOne)
{
  // As a preconditioner sees it: the eigenvalues of one form against the other.
  for (const int m : { 5, 16, 33, 120 })
  {
    for (const double unevenness : { 0.0, 0.3, 0.6 })
    {
      const std::vector<double> angles = anglesOf(m, unevenness, 1.0);
      const Eigen::MatrixXd constant = Eigen::MatrixXd::Ones(m, m);
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ratios(
        loopForm(hexsweep::fillMesh(angles), m) + constant,
        hexsweep::diskFillEnergy(angles) + constant);
      EXPECT_GT(ratios.eigenvalues().minCoeff(), 0.7) << m << ", " << unevenness;
      EXPECT_LT(ratios.eigenvalues().maxCoeff(), 4.0) << m << ", " << unevenness;
    }
  }
}

TEST(FillMesh, ArcsOfAnyShortnessHaveArea)
{
  std::vector<double> angles = anglesOf(20, 0.0, 1.0);
  angles[7] = std::nextafter(angles[6], 7.0);
  const TriangleMesh mesh = hexsweep::fillMesh(angles);
  EXPECT_NO_THROW(hexsweep::cotangentLaplacian(mesh.points, mesh.triangles));
  EXPECT_TRUE(hexsweep::cotangents(mesh.points, mesh.triangles).allFinite());
}

// SPDX-License-Identifier: BSD-3-Clause
// The plane, cut along circles and glued together again, is mapped to itself.
#include "Core/DiskMaps/GluedSphere.h"

#include "Support/CapMeshes.h"
#include "Support/CircleDomains.h"

#include "Core/DiskMaps/DiskFill.h"
#include "Core/Solvers/SurfaceLaplacian.h"
#include "Support/DenseTruth.h"

namespace TestGluedSphere
{
using hexsweep::GluedSphere;
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::PlanePoints;
using test::Pi;

struct Cut
{
  test::CircleDomain domain;
  std::vector<Loop> loops;
  GluedSphere::Gluing angles; // of the nodes on their circles

  explicit Cut(test::CircleDomain disk)
    : domain(std::move(disk))
    , loops(hexsweep::checkSurface(domain.mesh.triangles, domain.mesh.points.rows(), "disk").loops)
  {
    for (std::size_t p = 0; p < this->loops.size(); ++p)
    {
      this->angles.emplace_back();
      for (const Index v : this->loops[p])
      {
        const Eigen::RowVector2d center =
          p == 0 ? Eigen::RowVector2d(0.0, 0.0) : this->domain.holes[p - 1].center;
        const Eigen::RowVector2d arm = this->domain.mesh.points.row(v).head<2>() - center;
        std::vector<double>& list = this->angles.back();
        const double angle = std::atan2(arm.y(), arm.x());
        list.push_back(
          list.empty() ? angle : list.back() + std::remainder(angle - list.back(), 2.0 * Pi));
      }
    }
  }

  hexsweep::SparseMatrix laplacian() const
  {
    return hexsweep::cotangentLaplacian(this->domain.mesh.points, this->domain.mesh.triangles);
  }

  GluedSphere sphere() const
  {
    return { this->laplacian(), this->loops, this->domain.mesh.points };
  }

  /// Greatest distance of a loop's node from where it is.
  double error(const GluedSphere& sphere) const
  {
    double greatest = 0.0;
    for (std::size_t p = 0; p < this->loops.size(); ++p)
    {
      const PlanePoints image = sphere.image(p);
      for (Index i = 0; i < image.rows(); ++i)
      {
        const Index v = this->loops[p][static_cast<std::size_t>(i)];
        greatest =
          std::max(greatest, (image.row(i) - this->domain.mesh.points.row(v).head<2>()).norm());
      }
    }
    return greatest;
  }
};

Eigen::MatrixXd stacked(const GluedSphere& sphere, std::size_t loops)
{
  Eigen::MatrixXd all(0, 2);
  for (std::size_t p = 0; p < loops; ++p)
  {
    const PlanePoints image = sphere.image(p);
    all.conservativeResize(all.rows() + image.rows(), 2);
    all.bottomRows(image.rows()) = image;
  }
  return all;
}

TEST(GluedSphere, ThePlaneIsMappedToItself)
{
  test::CircleDomain domain = test::circleDomain(test::threeRoundHoles(), 0.2);
  double before = 1.0;
  for (int level = 0; level < 4; ++level)
  {
    const Cut cut(domain);
    GluedSphere sphere = cut.sphere();
    for (int k = 0; k < 4; ++k)
    {
      sphere.map(cut.angles);
    }
    const double error = cut.error(sphere);
    EXPECT_LT(error, before / 3.0) << level;
    before = error;
    domain = test::refined(domain);
  }
  EXPECT_LT(before, 1e-3);
}

TEST(GluedSphere, EachCallGainsAtLeastADigit)
{
  const Cut cut(test::circleDomain(test::scatteredHoles(40, 0.03, 0.08), 0.08));
  GluedSphere settled = cut.sphere();
  for (int k = 0; k < 12; ++k)
  {
    settled.map(cut.angles);
  }
  const Eigen::MatrixXd truth = stacked(settled, cut.loops.size());
  GluedSphere sphere = cut.sphere();
  double before = truth.norm();
  for (int k = 0; k < 5; ++k)
  {
    sphere.map(cut.angles);
    const double error = (stacked(sphere, cut.loops.size()) - truth).norm();
    EXPECT_LT(error, 0.1 * before) << k;
    before = error;
  }
}

TEST(GluedSphere, EqualsADenseSolve)
{
  // Gluings of the holes that fit nothing, and a point that no triangle uses.
  Cut cut(test::circleDomain(test::threeRoundHoles(), 0.2));
  for (std::size_t p = 1; p < cut.angles.size(); ++p)
  {
    for (double& angle : cut.angles[p])
    {
      angle += 0.6 * std::sin(angle + static_cast<double>(p));
    }
  }
  const Index n = cut.domain.mesh.points.rows();
  cut.domain.mesh.points.conservativeResize(n + 1, 3);
  cut.domain.mesh.points.row(n).setConstant(7.0);
  GluedSphere sphere(
    hexsweep::cotangentLaplacian(cut.domain.mesh.points, cut.domain.mesh.triangles), cut.loops,
    cut.domain.mesh.points);
  for (int k = 0; k < 12; ++k)
  {
    sphere.map(cut.angles);
  }
  // The outer loop's nodes are even: their mean and the flow of e^(i angle) have closed forms.
  const Index m = static_cast<Index>(cut.loops[0].size());
  const double step = 2.0 * Pi / static_cast<double>(m);
  Eigen::MatrixXd matrix = Eigen::MatrixXd(cut.laplacian()).topLeftCorner(n, n);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 2);
  for (std::size_t p = 0; p < cut.loops.size(); ++p)
  {
    Eigen::MatrixXd fill = hexsweep::diskFillEnergy(cut.angles[p]);
    for (Index i = 0; i < fill.rows(); ++i)
    {
      for (Index j = 0; j < fill.rows(); ++j)
      {
        matrix(cut.loops[p][static_cast<std::size_t>(i)],
          cut.loops[p][static_cast<std::size_t>(j)]) += fill(i, j) + (p == 0 ? 1.0 : 0.0);
      }
    }
  }
  for (Index i = 0; i < m; ++i)
  {
    const double angle = cut.angles[0][static_cast<std::size_t>(i)];
    right.row(cut.loops[0][static_cast<std::size_t>(i)]) = 4.0 * (2.0 - 2.0 * std::cos(step)) /
      step * Eigen::RowVector2d(std::cos(angle), std::sin(angle));
  }
  const Eigen::MatrixXd truth = test::denseSolution(matrix, right);
  Index row = 0;
  const Eigen::MatrixXd found = stacked(sphere, cut.loops.size());
  for (const Loop& loop : cut.loops)
  {
    for (const Index v : loop)
    {
      EXPECT_LT((found.row(row) - truth.row(v)).norm(), 1e-12);
      ++row;
    }
  }
}
}

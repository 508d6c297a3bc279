// SPDX-License-Identifier: BSD-3-Clause

#include "Support/StretchedCaps.h"

namespace test
{
TriangleMesh stretchedPlate(std::size_t holes, bool curved, double stretch)
{
  std::vector<Block> blocks = threeHoles();
  blocks.resize(holes);
  for (Block& block : blocks)
  {
    block = { 2 * block.left, 2 * block.bottom, 2 * block.width, 2 * block.height };
  }
  TriangleMesh mesh = plate(24, blocks, 0.24);
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    const double x = mesh.points(i, 0);
    const double y = mesh.points(i, 1);
    mesh.points.row(i) << stretch * x, y,
      curved ? 0.3 * std::sin(3.0 * x) + 0.8 * y * (1.0 - y) : 0.0;
  }
  return mesh;
}

TriangleMesh needleStrips(double height, bool curved)
{
  std::vector<double> rows;
  for (int k = 0; k < 6; ++k)
  {
    rows.insert(rows.end(), { k / 6.0, k / 6.0 + height, k / 6.0 + 2.0 * height });
  }
  rows.push_back(1.0);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Index n = 22;
  TriangleMesh mesh;
  mesh.points.resize(static_cast<Index>(rows.size()) * n, 3);
  std::vector<Index> ids;
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    std::vector<double> xs{ 0.0, 1.0 };
    while (static_cast<Index>(xs.size()) < n)
    {
      xs.push_back(uniform(generator));
    }
    std::sort(xs.begin(), xs.end());
    const Index first = static_cast<Index>(r) * n;
    for (Index i = 0; i < n; ++i)
    {
      const double x = xs[static_cast<std::size_t>(i)];
      mesh.points.row(first + i) << x, rows[r],
        curved ? 0.3 * std::sin(2.0 * x + 1.0) * std::cos(1.5 * rows[r]) : 0.0;
    }
    for (Index i = 0, j = 0; r > 0 && (i + 1 < n || j + 1 < n);)
    {
      const Index a = first - n + i; // the row below
      const Index b = first + j;
      if (j + 1 == n || (i + 1 < n && mesh.points(a + 1, 0) <= mesh.points(b + 1, 0)))
      {
        ids.insert(ids.end(), { a, a + 1, b });
        ++i;
      }
      else
      {
        ids.insert(ids.end(), { a, b + 1, b });
        ++j;
      }
    }
  }
  mesh.triangles = facesOf<Triangles>(ids);
  return mesh;
}

bool isInCircle(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c, const Eigen::RowVector3d& d, double part)
{
  using Real = long double;
  const Eigen::RowVector3d arms[3] = { a - d, b - d, c - d };
  Real sum = 0.0L;
  Real size = 0.0L;
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::RowVector3d& p = arms[i];
    const Eigen::RowVector3d& q = arms[(i + 1) % 3];
    const Eigen::RowVector3d& r = arms[(i + 2) % 3];
    const Real square = static_cast<Real>(p.x()) * p.x() + static_cast<Real>(p.y()) * p.y();
    const Real first = static_cast<Real>(q.x()) * r.y() * square;
    const Real second = static_cast<Real>(q.y()) * r.x() * square;
    sum += first - second;
    size += std::abs(first) + std::abs(second);
  }
  return sum > part * size;
}
}

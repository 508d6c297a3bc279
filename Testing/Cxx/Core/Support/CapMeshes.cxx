// SPDX-License-Identifier: BSD-3-Clause

#include "Support/CapMeshes.h"

namespace test
{
Triangles polarTriangles(Index rings, Index around, std::mt19937* generator)
{
  std::vector<Index> ids;
  for (Index k = 0; k + 1 < rings; ++k)
  {
    for (Index j = 0; j < around; ++j)
    {
      const Index a = k * around + j;
      const Index b = k * around + (j + 1) % around;
      const Index c = b + around;
      const Index d = a + around;
      if (generator && (*generator)() % 2 == 0)
      {
        ids.insert(ids.end(), { a, d, c, a, c, b });
      }
      else
      {
        ids.insert(ids.end(), { a, d, b, b, d, c });
      }
    }
  }
  return facesOf<Triangles>(ids);
}

TriangleMesh annulus(double inner, double outer, Index rings, Index around, std::mt19937* generator)
{
  TriangleMesh mesh;
  mesh.points.resize(rings * around, 3);
  for (Index k = 0; k < rings; ++k)
  {
    const double t = static_cast<double>(k) / static_cast<double>(rings - 1);
    const double r = (1.0 - t) * inner + t * outer;
    for (Index j = 0; j < around; ++j)
    {
      const double angle = 2.0 * Pi * static_cast<double>(j) / static_cast<double>(around);
      mesh.points.row(k * around + j) << r * std::cos(angle), r * std::sin(angle), 0.0;
    }
  }
  mesh.triangles = polarTriangles(rings, around, generator);
  return mesh;
}

TriangleMesh disk(Index rings, Index around)
{
  TriangleMesh mesh = annulus(1.0 / static_cast<double>(rings), 1.0, rings, around);
  const Index center = mesh.points.rows();
  mesh.points.conservativeResize(center + 1, 3);
  mesh.points.row(center).setZero();
  const Index old = mesh.triangles.rows();
  mesh.triangles.conservativeResize(old + around, 3);
  for (Index j = 0; j < around; ++j)
  {
    mesh.triangles.row(old + j) << center, j, (j + 1) % around;
  }
  return mesh;
}

hexsweep::QuadMesh quadPlate(
  int cells, const std::vector<Block>& holes, double shake, unsigned seed)
{
  std::vector<Index> ids;
  std::map<std::pair<int, int>, Index> numbers;
  std::vector<double> coordinates;
  const auto point = [&](int i, int j) {
    const auto known = numbers.emplace(std::make_pair(i, j), static_cast<Index>(numbers.size()));
    if (known.second)
    {
      coordinates.insert(coordinates.end(), { 1.0 * i / cells, 1.0 * j / cells, 0.0 });
    }
    return known.first->second;
  };
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      const bool cut = std::any_of(holes.begin(), holes.end(), [&](const Block& hole) {
        return i >= hole.left && i < hole.left + hole.width && j >= hole.bottom &&
          j < hole.bottom + hole.height;
      });
      if (!cut)
      {
        for (const Index id :
          { point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1) })
        {
          ids.push_back(id);
        }
      }
    }
  }
  hexsweep::QuadMesh mesh;
  mesh.points =
    Eigen::Map<const Points>(coordinates.data(), static_cast<Index>(coordinates.size()) / 3, 3);
  mesh.quads = facesOf<Quads>(ids);

  std::vector<bool> inner(static_cast<std::size_t>(mesh.points.rows()), true);
  for (const Loop& loop : hexsweep::checkSurface(mesh.quads, mesh.points.rows(), "plate").loops)
  {
    for (const Index v : loop)
    {
      inner[static_cast<std::size_t>(v)] = false;
    }
  }
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-shake / cells, shake / cells);
  for (Index i = 0; i < mesh.points.rows(); ++i)
  {
    const double dx = uniform(generator);
    const double dy = uniform(generator);
    if (inner[static_cast<std::size_t>(i)])
    {
      mesh.points.row(i) += Eigen::RowVector3d(dx, dy, 0.0);
    }
  }
  return mesh;
}

TriangleMesh plate(int cells, const std::vector<Block>& holes, double shake, unsigned seed)
{
  const hexsweep::QuadMesh quads = quadPlate(cells, holes, shake, seed);
  std::mt19937 generator(seed + 1);
  TriangleMesh mesh;
  mesh.points = quads.points;
  mesh.triangles.resize(2 * quads.quads.rows(), 3);
  for (Index q = 0; q < quads.quads.rows(); ++q)
  {
    const Index s = generator() % 2;
    const auto corner = [&](Index c) { return quads.quads(q, (s + c) % 4); };
    mesh.triangles.row(2 * q) << corner(0), corner(1), corner(2);
    mesh.triangles.row(2 * q + 1) << corner(0), corner(2), corner(3);
  }
  return mesh;
}

std::vector<Block> threeHoles()
{
  return { { 2, 2, 2, 2 }, { 7, 3, 3, 2 }, { 4, 7, 2, 3 } };
}

Points lifted(Points points, const std::function<double(double, double)>& height)
{
  for (Index i = 0; i < points.rows(); ++i)
  {
    points(i, 2) += height(points(i, 0), points(i, 1));
  }
  return points;
}

double bump(double x, double y)
{
  return 3.0 * x * (1.0 - x) * y * (1.0 - y) * (1.0 + 0.5 * x);
}

TriangleMesh curvedPlate(std::size_t holes, double shake, double height, unsigned seed)
{
  std::vector<Block> blocks = threeHoles();
  blocks.resize(holes);
  TriangleMesh mesh = plate(12, blocks, shake, seed);
  mesh.points = lifted(mesh.points, [height](double x, double y) { return height * bump(x, y); });
  return mesh;
}

Eigen::Matrix3d someTurn()
{
  return (Eigen::AngleAxisd(0.9, Eigen::Vector3d(0.3, 1.0, -0.4).normalized()) *
    Eigen::AngleAxisd(2.1, Eigen::Vector3d::UnitZ()))
    .toRotationMatrix();
}

std::vector<Placement> placements()
{
  const double unit = 1.1e-16;
  std::vector<Placement> result;
  for (const double scale : { 1e-6, 1e6 })
  {
    const std::string size = "size " + std::to_string(scale);
    result.push_back({ { scale, Eigen::Matrix3d::Identity(), { 0, 0, 0 } }, unit, size });
    result.push_back({ { scale, someTurn(), { 0, 0, 0 } }, unit, size + ", turned" });
    // Six digits of a double are spent on the offset.
    result.push_back({ { scale, someTurn(), 1e6 * scale * Eigen::RowVector3d(1, -2, 0.5) },
      2e6 * unit, size + ", turned, offset by a million sizes" });
  }
  return result;
}

std::vector<hexsweep::LoopPair> pairsOf(
  const Points& first, const Points& second, const std::vector<Loop>& loops)
{
  std::vector<hexsweep::LoopPair> pairs;
  for (const Loop& loop : loops)
  {
    hexsweep::LoopPair pair;
    pair.first.resize(static_cast<Index>(loop.size()), 3);
    pair.second.resize(pair.first.rows(), 3);
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      pair.first.row(static_cast<Index>(i)) = first.row(loop[i]);
      pair.second.row(static_cast<Index>(i)) = second.row(loop[i]);
    }
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

double loopLength(const Points& points, const Loop& loop)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    sum += (points.row(loop[(i + 1) % loop.size()]) - points.row(loop[i])).norm();
  }
  return sum;
}

std::vector<Loop> loopsOf(const TriangleMesh& mesh)
{
  std::vector<Loop> loops = surfaceLoops(mesh);
  std::stable_sort(loops.begin(), loops.end(), [&](const Loop& a, const Loop& b) {
    return loopLength(mesh.points, a) > loopLength(mesh.points, b);
  });
  return loops;
}

std::vector<Loop> surfaceLoops(const TriangleMesh& mesh)
{
  return hexsweep::checkSurface(mesh.triangles, mesh.points.rows(), "mesh").loops;
}

std::vector<Loop> disordered(std::vector<Loop> loops, bool reversed)
{
  std::reverse(loops.begin(), loops.end());
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    std::rotate(loops[l].begin(), loops[l].begin() + static_cast<long>((3 + l) % loops[l].size()),
      loops[l].end());
    if (reversed)
    {
      std::reverse(loops[l].begin(), loops[l].end());
    }
  }
  return loops;
}

std::vector<bool> boundaryFlags(const TriangleMesh& mesh)
{
  std::vector<bool> flags(static_cast<std::size_t>(mesh.points.rows()), false);
  for (const Loop& loop : loopsOf(mesh))
  {
    for (const Index v : loop)
    {
      flags[static_cast<std::size_t>(v)] = true;
    }
  }
  return flags;
}

hexsweep::QuadMesh linkingSides(
  const Points& source, const Points& target, const std::vector<Loop>& loops, Index layers)
{
  std::vector<Eigen::RowVector3d> points;
  std::vector<Index> ids;
  for (const Loop& loop : loops)
  {
    const Index first = static_cast<Index>(points.size());
    const Index n = static_cast<Index>(loop.size());
    for (Index k = 0; k <= layers; ++k)
    {
      const double t = static_cast<double>(k) / static_cast<double>(layers);
      for (const Index v : loop)
      {
        points.emplace_back((1.0 - t) * source.row(v) + t * target.row(v));
      }
    }
    for (Index k = 0; k < layers; ++k)
    {
      for (Index j = 0; j < n; ++j)
      {
        const Index a = first + k * n + j;
        const Index b = first + k * n + (j + 1) % n;
        ids.insert(ids.end(), { a, b, b + n, a + n });
      }
    }
  }
  hexsweep::QuadMesh mesh;
  mesh.points.resize(static_cast<Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mesh.points.row(static_cast<Index>(i)) = points[i];
  }
  mesh.quads = facesOf<Quads>(ids);
  return mesh;
}

double surfaceArea(const TriangleMesh& mesh)
{
  double area = 0.0;
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = mesh.points.row(mesh.triangles(t, 0));
    const Eigen::RowVector3d u = mesh.points.row(mesh.triangles(t, 1)) - a;
    const Eigen::RowVector3d v = mesh.points.row(mesh.triangles(t, 2)) - a;
    area += 0.5 * u.cross(v).norm();
  }
  return area;
}
}

// SPDX-License-Identifier: BSD-3-Clause

#include "Support/CircleDomains.h"

namespace test
{
std::vector<std::array<hexsweep::Index, 3>> delaunay(std::vector<Eigen::RowVector2d> points)
{
  using hexsweep::Index;
  const Index n = static_cast<Index>(points.size());
  points.insert(points.end(), { { -300.0, -200.0 }, { 300.0, -200.0 }, { 0.0, 300.0 } });
  const auto p = [&](Index i) { return points[static_cast<std::size_t>(i)]; };
  const auto inCircle = [&](const std::array<Index, 3>& t, const Eigen::RowVector2d& q) {
    Eigen::Matrix3d m;
    for (Index c = 0; c < 3; ++c)
    {
      const Eigen::RowVector2d d = p(t[static_cast<std::size_t>(c)]) - q;
      m.row(c) << d.x(), d.y(), d.squaredNorm();
    }
    return m.determinant() > 0.0;
  };
  std::vector<std::array<Index, 3>> triangles{ { n, n + 1, n + 2 } };
  // The last ones first: with the middles of the circles there, no four points share a circle.
  for (Index i = n; i-- > 0;)
  {
    const auto cavity = std::stable_partition(triangles.begin(), triangles.end(),
      [&](const std::array<Index, 3>& t) { return !inCircle(t, p(i)); });
    std::map<std::pair<Index, Index>, bool> edges;
    for (auto t = cavity; t != triangles.end(); ++t)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        edges[{ (*t)[c], (*t)[(c + 1) % 3] }] = true;
      }
    }
    triangles.erase(cavity, triangles.end());
    for (const auto& [edge, known] : edges)
    {
      if (known && edges.count({ edge.second, edge.first }) == 0)
      {
        triangles.push_back({ edge.first, edge.second, i });
      }
    }
  }
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                    [n](const auto& t) {
                      return std::max({ t[0], t[1], t[2] }) >= n;
                    }),
    triangles.end());
  return triangles;
}

CircleDomain circleDomain(
  const std::vector<Circle>& holes, double spacing, int around, unsigned seed)
{
  using hexsweep::Index;
  constexpr double pi = 3.14159265358979323846;
  CircleDomain domain;
  domain.holes = holes;
  std::vector<Eigen::RowVector2d> points;
  const auto addCircle = [&](const Circle& circle, std::size_t number) {
    const int n =
      std::max(around, static_cast<int>(std::lround(2.0 * pi * circle.radius / spacing)));
    for (int k = 0; k < n; ++k)
    {
      const double angle = 2.0 * pi * (k + 0.1 * static_cast<double>(number)) / n;
      points.emplace_back(
        circle.center + circle.radius * Eigen::RowVector2d(std::cos(angle), std::sin(angle)));
      domain.circle.push_back(number);
    }
    return n;
  };
  addCircle({ { 0.0, 0.0 }, 1.0 }, 0);
  std::vector<int> sides;
  for (std::size_t h = 0; h < holes.size(); ++h)
  {
    sides.push_back(addCircle(holes[h], h + 1));
  }
  // A point is taken where it keeps clear of the circles and of all others.
  const auto add = [&](const Eigen::RowVector2d& q, double size) {
    const bool clear = q.norm() < 1.0 - 0.7 * size &&
      std::all_of(holes.begin(), holes.end(),
        [&](const Circle& hole) {
          return (q - hole.center).norm() > hole.radius + 0.6 * std::min(size, hole.radius);
        }) &&
      std::all_of(points.begin(), points.end(),
        [&](const Eigen::RowVector2d& o) { return (o - q).norm() > 0.75 * size; });
    if (clear)
    {
      points.push_back(q);
      domain.circle.push_back(CircleDomain::Inside);
    }
  };
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> chance(-1.0, 1.0);
  for (std::size_t h = 0; h < holes.size(); ++h)
  {
    const double step = 2.0 * pi / sides[h];
    double radius = holes[h].radius * (1.0 + 0.87 * step);
    for (int ring = 1; step * radius < spacing; ++ring, radius *= 1.0 + 0.87 * step)
    {
      for (int k = 0; k < sides[h]; ++k)
      {
        const double angle = step * (k + 0.5 * ring) + 0.01 * chance(generator);
        add(holes[h].center + radius * Eigen::RowVector2d(std::cos(angle), std::sin(angle)),
          step * radius);
      }
    }
  }
  const int rows = static_cast<int>(std::ceil(1.2 / spacing));
  for (int j = -rows; j <= rows; ++j)
  {
    for (int i = -rows; i <= rows; ++i)
    {
      const double dx = chance(generator);
      const double dy = chance(generator);
      add(
        spacing * Eigen::RowVector2d(i + (j % 2 == 0 ? 0.0 : 0.5) + 0.1 * dx, 0.87 * j + 0.1 * dy),
        spacing);
    }
  }
  // A centre in each hole makes a fan of it, which is left out.
  const Index n = static_cast<Index>(points.size());
  for (const Circle& hole : holes)
  {
    points.push_back(hole.center);
  }
  std::vector<Index> ids;
  for (const auto& t : delaunay(points))
  {
    if (std::max({ t[0], t[1], t[2] }) < n)
    {
      ids.insert(ids.end(), t.begin(), t.end());
    }
  }
  domain.mesh.triangles =
    Eigen::Map<const hexsweep::Triangles>(ids.data(), static_cast<Index>(ids.size()) / 3, 3);
  domain.mesh.points = hexsweep::Points::Zero(n, 3);
  for (Index i = 0; i < n; ++i)
  {
    domain.mesh.points.row(i).head<2>() = points[static_cast<std::size_t>(i)];
  }
  return domain;
}

CircleDomain refined(const CircleDomain& coarse)
{
  using hexsweep::Index;
  CircleDomain fine = coarse;
  std::map<std::pair<Index, Index>, int> uses;
  const auto key = [](Index a, Index b) { return std::make_pair(std::min(a, b), std::max(a, b)); };
  const auto& triangles = coarse.mesh.triangles;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      ++uses[key(triangles(t, c), triangles(t, (c + 1) % 3))];
    }
  }
  std::map<std::pair<Index, Index>, Index> middles;
  Index next = coarse.mesh.points.rows();
  fine.mesh.points.conservativeResize(next + static_cast<Index>(uses.size()), 3);
  for (const auto& [edge, count] : uses)
  {
    Eigen::RowVector3d middle =
      0.5 * (coarse.mesh.points.row(edge.first) + coarse.mesh.points.row(edge.second));
    std::size_t on = CircleDomain::Inside;
    if (count == 1)
    {
      on = coarse.circle[static_cast<std::size_t>(edge.first)];
      const Circle circle = on == 0 ? Circle{ { 0.0, 0.0 }, 1.0 } : coarse.holes[on - 1];
      const Eigen::RowVector2d arm = middle.head<2>() - circle.center;
      middle.head<2>() = circle.center + circle.radius * arm.normalized();
    }
    fine.circle.push_back(on);
    fine.mesh.points.row(next) = middle;
    middles[edge] = next++;
  }
  fine.mesh.triangles.resize(4 * triangles.rows(), 3);
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    const Index a = triangles(t, 0);
    const Index b = triangles(t, 1);
    const Index c = triangles(t, 2);
    const Index ab = middles[key(a, b)];
    const Index bc = middles[key(b, c)];
    const Index ca = middles[key(c, a)];
    fine.mesh.triangles.middleRows<4>(4 * t) << a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca;
  }
  return fine;
}

hexsweep::Points warped(
  hexsweep::Points points, const std::function<std::complex<double>(std::complex<double>)>& map)
{
  for (hexsweep::Index i = 0; i < points.rows(); ++i)
  {
    const std::complex<double> w = map({ points(i, 0), points(i, 1) });
    points.row(i).head<2>() << w.real(), w.imag();
  }
  return points;
}

hexsweep::Points onSphere(hexsweep::Points points)
{
  for (hexsweep::Index i = 0; i < points.rows(); ++i)
  {
    const double x = points(i, 0);
    const double y = points(i, 1);
    const double s = 1.0 + x * x + y * y;
    points.row(i) << 2.0 * x / s, 2.0 * y / s, (s - 2.0) / s;
  }
  return points;
}

std::vector<Circle> scatteredHoles(std::size_t count, double smallest, double largest)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  std::vector<Circle> holes;
  while (holes.size() < count)
  {
    const double radius = smallest * std::pow(largest / smallest, chance(generator));
    const double x = 2.0 * chance(generator) - 1.0;
    const double y = 2.0 * chance(generator) - 1.0;
    const Circle hole{ { x, y }, radius };
    if (hole.center.norm() < 1.0 - 1.8 * radius &&
      std::all_of(holes.begin(), holes.end(), [&](const Circle& other) {
        return (other.center - hole.center).norm() >
          radius + other.radius + 0.6 * std::max(radius, other.radius);
      }))
    {
      holes.push_back(hole);
    }
  }
  return holes;
}

std::vector<Circle> oneRoundHole()
{
  return { { { 0.3, 0.1 }, 0.25 } };
}

std::vector<Circle> threeRoundHoles()
{
  return { { { 0.45, 0.1 }, 0.2 }, { { -0.4, 0.35 }, 0.25 }, { { -0.1, -0.5 }, 0.15 } };
}

std::vector<Circle> eightRoundHoles()
{
  return { { { 0.55, 0.1 }, 0.14 }, { { 0.2, 0.6 }, 0.16 }, { { -0.4, 0.5 }, 0.12 },
    { { -0.65, 0.0 }, 0.15 }, { { -0.35, -0.5 }, 0.18 }, { { 0.15, -0.65 }, 0.1 },
    { { 0.6, -0.4 }, 0.16 }, { { 0.05, 0.0 }, 0.2 } };
}

Eigen::VectorXd coordinatesOf(const std::vector<Circle>& circles)
{
  Eigen::VectorXd result(3 * static_cast<hexsweep::Index>(circles.size()));
  for (hexsweep::Index h = 0; 3 * h < result.size(); ++h)
  {
    const Circle& circle = circles[static_cast<std::size_t>(h)];
    result.segment<3>(3 * h) << circle.center.x(), circle.center.y(), circle.radius;
  }
  return result;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Support/WindingSweeps.h"

#include "Core/Surfaces/QuadHalving.h"

#include <deque>

namespace test
{
namespace
{
using Place = Eigen::RowVector2d;

constexpr double SquareHalfWidth = 0.6;
constexpr double Roundness = 0.4; // of the square in the middle of the disk

Place turned(const Place& p, double angle)
{
  return p * Eigen::Rotation2Dd(-angle).toRotationMatrix();
}

/// The square [-1, 1]^2 onto the unit disk, equal steps along its rim to equal angles.
Place onDisk(const Place& q)
{
  const double size = q.cwiseAbs().maxCoeff();
  if (size == 0.0)
  {
    return q;
  }
  const double angle = std::abs(q.x()) >= std::abs(q.y())
    ? (q.x() > 0.0 ? 0.0 : Pi) + 0.25 * Pi * q.y() / q.x()
    : (q.y() > 0.0 ? 0.5 * Pi : -0.5 * Pi) - 0.25 * Pi * q.x() / q.y();
  return { size * std::cos(angle), size * std::sin(angle) };
}

std::vector<Block> blocksOf(const WindingShape& shape)
{
  const int n = shape.cells;
  if (shape.holes == Holes::One)
  {
    return { { n / 3, n / 3, n / 3, n / 3 } };
  }
  const int size = n / 6;
  const int bottom = (n - size) / 2;
  const int left = static_cast<int>(std::lround(n * 2.0 / 9.0));
  return { { left, bottom, size, size }, { n - left - size, bottom, size, size } };
}

/// Quads of the disk: a square with holes in a ring of quads.
struct DiskQuads
{
  std::vector<Place> places;
  std::vector<Index> corners;

  DiskQuads(const WindingShape& shape)
  {
    const int n = shape.cells;
    const hexsweep::QuadMesh plate = quadPlate(n, blocksOf(shape));
    std::map<std::pair<int, int>, Index> idOf;
    for (Index i = 0; i < plate.points.rows(); ++i)
    {
      const Place q(2.0 * plate.points(i, 0) - 1.0, 2.0 * plate.points(i, 1) - 1.0);
      this->places.push_back(SquareHalfWidth * ((1.0 - Roundness) * q + Roundness * onDisk(q)));
      idOf[{ static_cast<int>(std::lround(n * plate.points(i, 0))),
        static_cast<int>(std::lround(n * plate.points(i, 1))) }] = i;
    }
    this->corners.assign(plate.quads.data(), plate.quads.data() + plate.quads.size());
    std::vector<Index> inner;
    std::vector<Place> rim;
    for (int side = 0; side < 4; ++side)
    {
      for (int k = 0; k < n; ++k)
      {
        const std::pair<int, int> cells[4] = { { k, 0 }, { n, k }, { n - k, n }, { 0, n - k } };
        inner.push_back(idOf.at(cells[side]));
        rim.push_back(
          onDisk({ 2.0 * cells[side].first / n - 1.0, 2.0 * cells[side].second / n - 1.0 }));
      }
    }
    this->addRing(inner, rim, n / 3);
  }

private:
  void addRing(std::vector<Index> inner, const std::vector<Place>& rim, int layers)
  {
    const std::vector<Index> first = inner;
    for (int layer = 1; layer <= layers; ++layer)
    {
      const double t = static_cast<double>(layer) / layers;
      std::vector<Index> outer;
      for (std::size_t k = 0; k < rim.size(); ++k)
      {
        outer.push_back(static_cast<Index>(this->places.size()));
        const Place from = this->places[static_cast<std::size_t>(first[k])];
        this->places.emplace_back((1.0 - t) * from + t * rim[k]);
      }
      for (std::size_t k = 0; k < rim.size(); ++k)
      {
        const std::size_t next = (k + 1) % rim.size();
        this->corners.insert(this->corners.end(), { inner[k], outer[k], outer[next], inner[next] });
      }
      inner = std::move(outer);
    }
  }
};

/// Of all nodes, one before on a shortest way from the first of the farthest ones.
std::vector<Index> waysFromRim(const Quads& quads, const PlanePoints& places)
{
  std::map<Index, std::set<Index>> neighbors;
  for (Index q = 0; q < quads.rows(); ++q)
  {
    for (int c = 0; c < 4; ++c)
    {
      neighbors[quads(q, c)].insert(quads(q, (c + 1) % 4));
      neighbors[quads(q, (c + 1) % 4)].insert(quads(q, c));
    }
  }
  Index start = 0;
  places.rowwise().squaredNorm().maxCoeff(&start);
  std::vector<Index> before(static_cast<std::size_t>(places.rows()), -1);
  before[static_cast<std::size_t>(start)] = start;
  std::deque<Index> reached{ start };
  for (; !reached.empty(); reached.pop_front())
  {
    for (const Index next : neighbors[reached.front()])
    {
      if (before[static_cast<std::size_t>(next)] < 0)
      {
        before[static_cast<std::size_t>(next)] = reached.front();
        reached.push_back(next);
      }
    }
  }
  return before;
}
}

WindingSweep windingSweep(const WindingShape& shape)
{
  const DiskQuads disk(shape);
  PlanePoints cap(static_cast<Index>(disk.places.size()), 2);
  for (Index i = 0; i < cap.rows(); ++i)
  {
    cap.row(i) = disk.places[static_cast<std::size_t>(i)];
  }
  const Quads quads = facesOf<Quads>(disk.corners);
  const double turn = shape.degrees * Pi / 180.0;
  const auto placed = [&](const Place& p, double t) -> Eigen::RowVector3d {
    const double z = shape.bulge * (1.0 - p.squaredNorm());
    if (shape.bend == 0.0)
    {
      return { p.x(), p.y(), shape.height * t + z };
    }
    const double radius = shape.height / shape.bend;
    const double angle = shape.bend * t;
    return { (radius + p.x()) * std::cos(angle) - z * std::sin(angle), p.y(),
      (radius + p.x()) * std::sin(angle) + z * std::cos(angle) };
  };
  WindingSweep result;
  result.sweep = sweepCap(cap, quads, evenLayers(shape.layers), [&](double x, double y, double t) {
    const Place p(x, y);
    return placed(p.norm() > 1.0 - 1e-9 ? p : turned(p, turn * t), t);
  });
  result.target.points.resize(cap.rows(), 3);
  for (Index i = 0; i < cap.rows(); ++i)
  {
    result.target.points.row(i) = placed(turned(cap.row(i), turn), 1.0);
  }
  result.target.triangles = hexsweep::halveQuads(result.target.points, quads);
  return result;
}

std::vector<double> turnOfPaths(const Quads& quads, const PlanePoints& from, const PlanePoints& to)
{
  const std::vector<Index> before = waysFromRim(quads, from);
  const auto turnAt = [&](const PlanePoints& points, Index end) {
    double turn = 0.0;
    for (Index node = end; before[static_cast<std::size_t>(node)] != node;)
    {
      const Index last = before[static_cast<std::size_t>(node)];
      turn += std::remainder(
        std::atan2(points(node, 1), points(node, 0)) - std::atan2(points(last, 1), points(last, 0)),
        2.0 * Pi);
      node = last;
    }
    return turn;
  };
  std::vector<double> turns;
  for (const Loop& loop : hexsweep::checkSurface(quads, from.rows(), "quads").loops)
  {
    if (from.row(loop.front()).norm() < 1.0 - 1e-9)
    {
      turns.push_back(turnAt(to, loop.front()) - turnAt(from, loop.front()));
    }
  }
  return turns;
}
}

// SPDX-License-Identifier: BSD-3-Clause

#include "Support/SweepMeshes.h"

namespace test
{
void makeCap(int nx, int ny, bool hole, hexsweep::PlanePoints& points, Quads& quads)
{
  std::map<std::pair<int, int>, Index> ids;
  std::vector<double> coordinates;
  const auto idOf = [&](int i, int j) {
    const auto known = ids.emplace(std::make_pair(i, j), static_cast<Index>(ids.size()));
    if (known.second)
    {
      const double x = 2.0 * i / nx;
      const double y = 1.0 * j / ny;
      const double pi = std::acos(-1.0);
      // Vanishes on the outer loop, so that opposite sides stay straight.
      const double bump = 0.05 * std::sin(0.5 * pi * x) * std::sin(pi * y);
      coordinates.push_back(x + bump * std::sin(7 * x + 3 * y));
      coordinates.push_back(y + bump * std::cos(5 * x - 4 * y));
    }
    return known.first->second;
  };
  std::vector<Index> corners;
  for (int j = 0; j < ny; ++j)
  {
    for (int i = 0; i < nx; ++i)
    {
      if (hole && 3 * i >= nx && 3 * i < 2 * nx && 3 * j >= ny && 3 * j < 2 * ny)
      {
        continue;
      }
      for (const Index id : { idOf(i, j), idOf(i + 1, j), idOf(i + 1, j + 1), idOf(i, j + 1) })
      {
        corners.push_back(id);
      }
    }
  }
  points = Eigen::Map<const hexsweep::PlanePoints>(
    coordinates.data(), static_cast<Index>(coordinates.size()) / 2, 2);
  quads = Eigen::Map<const Quads>(corners.data(), static_cast<Index>(corners.size()) / 4, 4);
}

Sweep sweepCap(const hexsweep::PlanePoints& cap, const Quads& quads,
  const std::vector<double>& positions, const Motion& motion)
{
  Sweep sweep;
  sweep.cap = cap;
  sweep.quads = quads;
  const Index n = sweep.cap.rows();
  const Index layers = static_cast<Index>(positions.size()) - 1;
  sweep.numberOfLayers = layers;
  sweep.layers.resize((layers + 1) * n, 3);
  for (Index k = 0; k <= layers; ++k)
  {
    for (Index i = 0; i < n; ++i)
    {
      sweep.layers.row(k * n + i) = motion(sweep.cap(i, 0), sweep.cap(i, 1), positions[k]);
    }
  }
  sweep.source = sweep.layers.topRows(n);
  sweep.target = sweep.layers.bottomRows(n);

  // Boundary edges are those that run one way only.
  std::map<std::pair<Index, Index>, bool> directed;
  for (Index q = 0; q < sweep.quads.rows(); ++q)
  {
    for (int c = 0; c < 4; ++c)
    {
      directed[{ sweep.quads(q, c), sweep.quads(q, (c + 1) % 4) }] = true;
    }
  }
  std::map<Index, Index> column;
  std::vector<Index> corners;
  for (const auto& edge : directed)
  {
    const Index a = edge.first.first;
    const Index b = edge.first.second;
    if (directed.count({ b, a }))
    {
      continue;
    }
    const Index ca = column.emplace(a, static_cast<Index>(column.size())).first->second;
    const Index cb = column.emplace(b, static_cast<Index>(column.size())).first->second;
    for (Index k = 0; k < layers; ++k)
    {
      for (const Index id : { ca * (layers + 1) + k, cb * (layers + 1) + k,
             cb * (layers + 1) + k + 1, ca * (layers + 1) + k + 1 })
      {
        corners.push_back(id);
      }
    }
  }
  sweep.linkingQuads =
    Eigen::Map<const Quads>(corners.data(), static_cast<Index>(corners.size()) / 4, 4);
  sweep.linkingPoints.resize(static_cast<Index>(column.size()) * (layers + 1), 3);
  for (const auto& entry : column)
  {
    for (Index k = 0; k <= layers; ++k)
    {
      sweep.linkingPoints.row(entry.second * (layers + 1) + k) =
        sweep.layers.row(k * n + entry.first);
    }
  }
  return sweep;
}

Sweep makeSweep(
  int nx, int ny, bool hole, const std::vector<double>& positions, const Motion& motion)
{
  hexsweep::PlanePoints cap;
  Quads quads;
  makeCap(nx, ny, hole, cap, quads);
  return sweepCap(cap, quads, positions, motion);
}

std::vector<double> evenLayers(int layers)
{
  std::vector<double> positions;
  for (int k = 0; k <= layers; ++k)
  {
    positions.push_back(1.0 * k / layers);
  }
  return positions;
}

Eigen::RowVector3d affineMotion(double x, double y, double t)
{
  Eigen::Matrix3d shape;
  shape << 1 + 0.5 * t, 0.4 * t, 0, -0.2 * t, 1 - 0.3 * t, 0, 0, 0, 1;
  const Eigen::Matrix3d turn =
    (Eigen::AngleAxisd(0.9 * t, Eigen::Vector3d(0.3, 1, 0.2).normalized()) *
      Eigen::AngleAxisd(0.7 * t, Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
  const Eigen::Vector3d path(std::sin(t), 0.3 * t * t, 6 * t);
  return (turn * (shape * Eigen::Vector3d(x, y, 0)) + path).transpose();
}

void disorderLinkingSides(Sweep& sweep)
{
  std::mt19937 generator(11);
  std::vector<Index> place(static_cast<std::size_t>(sweep.linkingPoints.rows()));
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    place[i] = static_cast<Index>(i);
  }
  std::shuffle(place.begin(), place.end(), generator);
  Points points(sweep.linkingPoints.rows(), 3);
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    points.row(place[i]) = sweep.linkingPoints.row(static_cast<Index>(i));
  }
  sweep.linkingPoints = points;

  const Quads quads = sweep.linkingQuads;
  std::vector<Index> order(static_cast<std::size_t>(quads.rows()));
  for (std::size_t q = 0; q < order.size(); ++q)
  {
    order[q] = static_cast<Index>(q);
  }
  std::shuffle(order.begin(), order.end(), generator);
  for (std::size_t q = 0; q < order.size(); ++q)
  {
    const int start = static_cast<int>(generator() % 4);
    const int step = generator() % 2 ? 1 : 3;
    for (int c = 0; c < 4; ++c)
    {
      sweep.linkingQuads(static_cast<Index>(q), c) =
        place[static_cast<std::size_t>(quads(order[q], (start + step * c) % 4))];
    }
  }
}

void cutLinkingSides(Sweep& sweep)
{
  std::vector<Eigen::RowVector3d> points;
  for (Index i = 0; i < sweep.linkingPoints.rows(); ++i)
  {
    points.push_back(sweep.linkingPoints.row(i));
  }
  const Index layers = sweep.numberOfLayers;
  for (Index q = 0; q < sweep.linkingQuads.rows(); ++q)
  {
    if (q / layers % 2 == 1)
    {
      continue;
    }
    for (int c = 0; c < 4; ++c)
    {
      points.push_back(points[static_cast<std::size_t>(sweep.linkingQuads(q, c))]);
      sweep.linkingQuads(q, c) = static_cast<Index>(points.size()) - 1;
    }
  }
  sweep.linkingPoints.resize(static_cast<Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    sweep.linkingPoints.row(static_cast<Index>(i)) = points[i];
  }
}

Sweep placed(Sweep sweep, double scale, const Eigen::RowVector3d& offset)
{
  for (Points* points : { &sweep.source, &sweep.target, &sweep.linkingPoints, &sweep.layers })
  {
    *points = ((*points * scale).rowwise() + offset).eval();
  }
  return sweep;
}

double greatestDistance(const Points& a, const Points& b)
{
  return (a - b).rowwise().norm().maxCoeff();
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/FaceGrid.h"

#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/SurfaceSearch.h"
#include "Core/Linking/LayerSpacing.h"
#include "Core/Linking/LinkingSideColumns.h"
#include "Core/Surfaces/SurfacePart.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hexsweep
{
namespace
{
/// Row k, column j: the node.
using NodeGrid = Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

std::string nameOf(const ComplexFace& face)
{
  return "face " + std::to_string(face.id);
}

/// Fractions of the length that is passed at each place of a chain.
std::vector<double> passed(const Points& places)
{
  std::vector<double> fractions(1, 0.0);
  for (Index k = 1; k < places.rows(); ++k)
  {
    fractions.push_back(fractions.back() + (places.row(k) - places.row(k - 1)).norm());
  }
  const double length = fractions.back();
  for (double& fraction : fractions)
  {
    fraction /= length;
  }
  return fractions;
}

/// The nodes of a face's side, from the chain that was meant to be first.
struct Rim
{
  std::vector<Index> nodes;
  Points places;
  std::vector<double> fractions;
};

Rim rimOf(const AssemblyMesh& mesh, const std::vector<CurveUse>& chain, bool backwards)
{
  Rim rim;
  rim.nodes = nodesAlong(mesh, chain);
  if (backwards)
  {
    std::reverse(rim.nodes.begin(), rim.nodes.end());
  }
  rim.places = mesh.nodes.placesOf(rim.nodes);
  rim.fractions = passed(rim.places);
  return rim;
}

/// The face's point for a place, on the true surface where it is known.
class FaceProjection
{
public:
  FaceProjection(const AssemblyComplex& complex, const AssemblyGeometry& geometry, Index face)
    : Geometry(geometry)
    , Face(face)
    , Surface(meshOfFaces(complex, complex.faces[at(face)].volumes.front(), { face }))
  {
  }

  /// Of a place from the face's triangles.
  double distance(const Eigen::RowVector3d& place) const
  {
    return (this->Surface.project(place, -1).point - place).norm();
  }

  /// @param reach no CAD point farther away counts.
  Eigen::RowVector3d operator()(const Eigen::RowVector3d& place, double reach) const
  {
    const Eigen::RowVector3d near = this->Surface.project(place, -1).point;
    const std::optional<Eigen::RowVector3d> exact = this->Geometry.onFace(this->Face, near);
    return exact && (*exact - near).norm() < reach ? *exact : near;
  }

private:
  const AssemblyGeometry& Geometry;
  Index Face;
  SurfaceSearch Surface;
};

/// Quads between the rows of a grid. @param closed whether the last column is followed by the
/// first.
Quads quadsOf(const NodeGrid& grid, bool closed)
{
  const Index columns = grid.cols() - (closed ? 0 : 1);
  Quads quads((grid.rows() - 1) * columns, 4);
  for (Index k = 0; k + 1 < grid.rows(); ++k)
  {
    for (Index j = 0; j < columns; ++j)
    {
      const Index next = (j + 1) % grid.cols();
      quads.row(k * columns + j) << grid(k, j), grid(k, next), grid(k + 1, next), grid(k + 1, j);
    }
  }
  return quads;
}

void meshQuadrilateral(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const SideFace& side, AssemblyMesh& mesh)
{
  // Chains run round the face: bottom to the right, up, top to the left, down.
  const Rim bottom = rimOf(mesh, side.chains[0], false);
  const Rim right = rimOf(mesh, side.chains[1], false);
  const Rim top = rimOf(mesh, side.chains[2], true);
  const Rim left = rimOf(mesh, side.chains[3], true);
  const Index n = static_cast<Index>(bottom.nodes.size()) - 1;
  const Index m = static_cast<Index>(left.nodes.size()) - 1;
  if (top.nodes.size() != bottom.nodes.size() || right.nodes.size() != left.nodes.size())
  {
    throw InvalidInput(nameOf(complex.faces[at(side.face)]) +
      " has different numbers of edges on opposite sides: " + std::to_string(n) + " and " +
      std::to_string(top.nodes.size() - 1) + ", " + std::to_string(m) + " and " +
      std::to_string(right.nodes.size() - 1) + ".");
  }
  const FaceProjection project(complex, geometry, side.face);
  NodeGrid grid(m + 1, n + 1);
  const auto corner = [&](const Rim& rim, bool last) {
    return rim.places.row(last ? rim.places.rows() - 1 : 0);
  };
  for (Index k = 0; k <= m; ++k)
  {
    for (Index j = 0; j <= n; ++j)
    {
      if (k == 0 || k == m)
      {
        grid(k, j) = (k == 0 ? bottom : top).nodes[at(j)];
        continue;
      }
      if (j == 0 || j == n)
      {
        grid(k, j) = (j == 0 ? left : right).nodes[at(k)];
        continue;
      }
      // Where the lines between the chains' fractions cross.
      const double a = bottom.fractions[at(j)];
      const double b = top.fractions[at(j)] - a;
      const double c = left.fractions[at(k)];
      const double d = right.fractions[at(k)] - c;
      const double s = (a + c * b) / (1.0 - b * d);
      const double t = c + s * d;
      const Eigen::RowVector3d place = (1.0 - t) * bottom.places.row(j) + t * top.places.row(j) +
        (1.0 - s) * left.places.row(k) + s * right.places.row(k) -
        (1.0 - s) * (1.0 - t) * corner(bottom, false) - s * (1.0 - t) * corner(bottom, true) -
        (1.0 - s) * t * corner(top, false) - s * t * corner(top, true);
      const double reach = std::max((bottom.places.row(j) - bottom.places.row(j - 1)).norm(),
        (left.places.row(k) - left.places.row(k - 1)).norm());
      grid(k, j) = mesh.nodes.add(project(place, reach));
    }
  }
  mesh.faces[at(side.face)] = quadsOf(grid, false);
}

/// A rim with more than four corners, in the rows and columns of its grid.
struct GridRim
{
  std::vector<Index> nodes;
  std::vector<std::array<Index, 2>> places; ///< column, row; one a node
};

/// @param least column and row of its lower left corner.
GridRim gridRim(
  const AssemblyMesh& mesh, const std::vector<DirectedUse>& uses, const std::array<Index, 2>& least)
{
  static constexpr std::array<std::array<Index, 2>, 4> Steps = { { { 1, 0 }, { 0, 1 }, { -1, 0 },
    { 0, -1 } } };
  GridRim rim;
  std::array<Index, 2> here{ 0, 0 };
  std::array<Index, 2> lowest{ 0, 0 };
  for (const DirectedUse& use : uses)
  {
    std::vector<Index> own = mesh.curves[at(use.use.curve)].nodes;
    if (use.use.reversed)
    {
      std::reverse(own.begin(), own.end());
    }
    own.pop_back();
    const std::array<Index, 2>& step = Steps[static_cast<std::size_t>(use.direction)];
    for (const Index node : own)
    {
      rim.nodes.push_back(node);
      rim.places.push_back(here);
      here = { here[0] + step[0], here[1] + step[1] };
      lowest = { std::min(lowest[0], here[0]), std::min(lowest[1], here[1]) };
    }
  }
  for (std::array<Index, 2>& place : rim.places)
  {
    place = { place[0] - lowest[0] + least[0], place[1] - lowest[1] + least[1] };
  }
  return rim;
}

/// Which cells of a grid lie within rims: row k, column j.
using CellGrid = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

CellGrid cellsWithin(const std::vector<GridRim>& rims, Index rows, Index columns)
{
  CellGrid within = CellGrid::Constant(rows, columns, false);
  for (const GridRim& rim : rims)
  {
    for (std::size_t i = 0; i < rim.places.size(); ++i)
    {
      const std::array<Index, 2>& a = rim.places[i];
      const std::array<Index, 2>& b = rim.places[(i + 1) % rim.places.size()];
      if (a[0] == b[0])
      {
        // An upright edge: what lies right of it changes sides.
        auto right = within.row(std::min(a[1], b[1])).tail(columns - a[0]);
        right = !right;
      }
    }
  }
  return within;
}

/// Places of the free nodes, each in the middle of its neighbours.
/// @param unknown row k, column j: number of the free node, -1: none. @param known places of
/// others.
Points middlePlaces(
  const NodeGrid& unknown, const NodeGrid& known, Index count, const AssemblyMesh& mesh)
{
  std::vector<Eigen::Triplet<double>> entries;
  Points right = Points::Zero(count, 3);
  for (Index k = 0; k < unknown.rows(); ++k)
  {
    for (Index j = 0; j < unknown.cols(); ++j)
    {
      const Index row = unknown(k, j);
      if (row < 0)
      {
        continue;
      }
      entries.emplace_back(row, row, 4.0);
      for (const auto& [dk, dj] :
        { std::pair<Index, Index>{ 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } })
      {
        const Index other = unknown(k + dk, j + dj);
        if (other >= 0)
        {
          entries.emplace_back(row, other, -1.0);
        }
        else
        {
          right.row(row) += mesh.nodes[known(k + dk, j + dj)];
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  return solver.solve(right);
}

void meshPolygon(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const SideFace& side, const std::array<Index, 2>& inside, AssemblyMesh& mesh)
{
  std::vector<GridRim> rims;
  for (std::size_t r = 0; r < side.rims.size(); ++r)
  {
    rims.push_back(gridRim(mesh, side.rims[r], r == 0 ? std::array<Index, 2>{ 0, 0 } : inside));
  }
  Index columns = 0;
  Index rows = 0;
  for (const std::array<Index, 2>& place : rims.front().places)
  {
    columns = std::max(columns, place[0]);
    rows = std::max(rows, place[1]);
  }
  const CellGrid within = cellsWithin(rims, rows, columns);
  NodeGrid nodes = NodeGrid::Constant(rows + 1, columns + 1, -1);
  for (const GridRim& rim : rims)
  {
    for (std::size_t i = 0; i < rim.nodes.size(); ++i)
    {
      nodes(rim.places[i][1], rim.places[i][0]) = rim.nodes[i];
    }
  }
  NodeGrid unknown = NodeGrid::Constant(rows + 1, columns + 1, -1);
  Index count = 0;
  for (Index k = 1; k < rows; ++k)
  {
    for (Index j = 1; j < columns; ++j)
    {
      if (nodes(k, j) < 0 && within(k, j))
      {
        unknown(k, j) = count++;
      }
    }
  }
  const Points middles = count > 0 ? middlePlaces(unknown, nodes, count, mesh) : Points(0, 3);
  const FaceProjection project(complex, geometry, side.face);
  const double reach =
    (mesh.nodes[rims.front().nodes[1]] - mesh.nodes[rims.front().nodes[0]]).norm();
  Index cells = 0;
  for (Index k = 0; k <= rows; ++k)
  {
    for (Index j = 0; j <= columns; ++j)
    {
      if (unknown(k, j) >= 0)
      {
        nodes(k, j) = mesh.nodes.add(project(middles.row(unknown(k, j)), reach));
      }
      cells += k < rows && j < columns && within(k, j) ? 1 : 0;
    }
  }
  Quads quads(cells, 4);
  cells = 0;
  for (Index k = 0; k < rows; ++k)
  {
    for (Index j = 0; j < columns; ++j)
    {
      if (within(k, j))
      {
        quads.row(cells++) << nodes(k, j), nodes(k, j + 1), nodes(k + 1, j + 1), nodes(k + 1, j);
      }
    }
  }
  mesh.faces[at(side.face)] = std::move(quads);
}

/// Which node of a closed rim each column ends at.
struct RimMatch
{
  Index first = 0;                                           ///< node of column 0
  Index step = 1;                                            ///< 1 or -1
  double distance = std::numeric_limits<double>::infinity(); ///< sum of squares

  Index nodeOf(Index column, Index count) const
  {
    return ((this->first + this->step * column) % count + count) % count;
  }
};

RimMatch nearestMatch(const Points& ends, const Points& rim)
{
  const Index n = ends.rows();
  RimMatch best;
  for (const Index step : { Index(1), Index(-1) })
  {
    for (Index first = 0; first < n; ++first)
    {
      RimMatch match{ first, step, 0.0 };
      for (Index j = 0; j < n && match.distance < best.distance; ++j)
      {
        match.distance += (ends.row(j) - rim.row(match.nodeOf(j, n))).squaredNorm();
      }
      if (match.distance < best.distance)
      {
        best = match;
      }
    }
  }
  return best;
}

/// Turns the ends of columns that nothing holds so that they lie on the rim's nodes.
void turnOnto(LinkingSideColumns& columns, const Points& rim)
{
  const auto distanceFor = [&](double turn) {
    columns.turnEnds(turn);
    const double distance =
      nearestMatch(columns.mesh({ 0.0, 1.0 }).nodes.bottomRows(rim.rows()), rim).distance;
    columns.turnEnds(-turn);
    return distance;
  };
  // Between two nodes there is one best turn; rims are divided evenly, so few trials find it.
  constexpr int Trials = 16;
  const double spacing = 1.0 / static_cast<double>(rim.rows());
  double best = 0.0;
  double least = distanceFor(0.0);
  for (int trial = 1; trial < Trials; ++trial)
  {
    const double turn = spacing * (static_cast<double>(trial) / Trials - 0.5);
    const double distance = distanceFor(turn);
    if (distance < least)
    {
      least = distance;
      best = turn;
    }
  }
  columns.turnEnds(best);
}

/// Of the edges beside it: straight lines between two rims that stay this near to the face are on
/// it.
constexpr double NearFace = 0.1;

/// Rows of places on straight lines from rim to rim; no rows where these leave the face.
Points ruledRows(const Points& bottom, const Points& top, const RimMatch& match, Index layers,
  const FaceProjection& project)
{
  const Index n = bottom.rows();
  Points rows((layers + 1) * n, 3);
  for (Index j = 0; j < n; ++j)
  {
    const Eigen::RowVector3d end = top.row(match.nodeOf(j, n));
    const double spacing = std::max((bottom.row(j) - bottom.row((j + 1) % n)).norm(),
      (end - bottom.row(j)).norm() / static_cast<double>(layers));
    for (Index k = 0; k <= layers; ++k)
    {
      const double along = static_cast<double>(k) / static_cast<double>(layers);
      const Eigen::RowVector3d place = (1.0 - along) * bottom.row(j) + along * end;
      if (project.distance(place) > NearFace * spacing)
      {
        return { 0, 3 };
      }
      rows.row(k * n + j) = place;
    }
  }
  return rows;
}

void meshTube(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const SideFace& side, Index layers, AssemblyMesh& mesh)
{
  const ComplexFace& face = complex.faces[at(side.face)];
  const Rim bottom = rimOf(mesh, side.chains[0], false);
  const Rim top = rimOf(mesh, side.chains[2], false);
  const Index n = static_cast<Index>(bottom.nodes.size());
  if (bottom.nodes.size() != top.nodes.size())
  {
    throw InvalidInput(nameOf(face) + " has different numbers of edges on its two loops: " +
      std::to_string(n) + " and " + std::to_string(top.nodes.size()) + ".");
  }
  const SurfacePart part = surfacePart(complex.points, complex.triangles, face.triangles);
  SideTube tube;
  tube.surface = part.mesh;
  for (const CurveUse& use : side.chains[0])
  {
    std::vector<Index> points = complex.curves[at(use.curve)].points;
    if (use.reversed)
    {
      std::reverse(points.begin(), points.end());
    }
    points.pop_back();
    for (const Index point : points)
    {
      tube.sourceLoop.push_back(part.idOf(point));
    }
  }
  const FaceProjection project(complex, geometry, side.face);
  RimMatch match = nearestMatch(bottom.places, top.places);
  Points rows = ruledRows(bottom.places, top.places, match, layers, project);
  if (rows.rows() == 0)
  {
    LinkingSideColumns columns(tube, bottom.places);
    if (columns.isFree())
    {
      turnOnto(columns, top.places);
    }
    rows = columns.mesh(layerFractions(layers)).nodes;
    match = nearestMatch(rows.bottomRows(n), top.places);
  }
  const Points ends = rows.bottomRows(n);
  NodeGrid grid(layers + 1, n);
  for (Index j = 0; j < n; ++j)
  {
    const Index node = match.nodeOf(j, n);
    const Eigen::RowVector3d missed = top.places.row(node) - ends.row(j);
    grid(0, j) = bottom.nodes[at(j)];
    grid(layers, j) = top.nodes[at(node)];
    for (Index k = 1; k < layers; ++k)
    {
      const double along = static_cast<double>(k) / static_cast<double>(layers);
      const Eigen::RowVector3d here = rows.row(k * n + j);
      const double reach = (here - rows.row((k - 1) * n + j)).norm();
      grid(k, j) = mesh.nodes.add(project(here + along * missed, reach));
    }
  }
  mesh.faces[at(side.face)] = quadsOf(grid, true);
}
}

void meshSideFace(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const SideFace& side, const AssemblyIntervals& intervals, AssemblyMesh& mesh)
{
  const Index begin = mesh.nodes.size();
  if (side.isTube())
  {
    meshTube(complex, geometry, side, intervals.tubeLayers[at(side.face)], mesh);
  }
  else if (side.isPolygon())
  {
    meshPolygon(complex, geometry, side, intervals.inside[at(side.face)], mesh);
  }
  else
  {
    meshQuadrilateral(complex, geometry, side, mesh);
  }
  mesh.blocks.push_back({ side.face, begin, mesh.nodes.size() - begin });
}
}

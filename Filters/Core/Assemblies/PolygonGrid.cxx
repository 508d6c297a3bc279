// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/PolygonGrid.h"

#include "Core/Assemblies/FaceRims.h"
#include "Core/Common/StandardIndex.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <utility>
#include <vector>

namespace hexsweep
{
namespace
{
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
}

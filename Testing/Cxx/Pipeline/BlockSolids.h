// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Solids that are images of a box of points, some of their faces meshed with quads.
 */
#ifndef BlockSolids_h
#define BlockSolids_h

#include "SolidGrids.h"

#include "HexSweepArrays.h"

#include <vtkIdTypeArray.h>

namespace test
{
using Point = std::array<double, 3>;

/// Faces of a block, and their ids in the cell array FaceId.
enum BlockFace
{
  Bottom = 1, ///< k = 0
  Top = 2,
  Left = 3, ///< i = 0
  Right = 4,
  Front = 5, ///< j = 0
  Back = 6
};

/// (n[0] + 1) x (n[1] + 1) x (n[2] + 1) points.
struct SolidBlock
{
  std::array<int, 3> n;
  std::function<Point(int, int, int)> at;
};

/// A block whose points are the images of a regular grid in [0, 1]^3.
SolidBlock blockOf(std::array<int, 3> n, const std::function<Point(double, double, double)>& map);

/// Some faces of a block, outward, each with points of its own, as quads or as triangles.
Grid blockFaces(
  const SolidBlock& block, const std::set<int>& faces, const std::set<int>& asQuads = {});

std::set<int> allFaces();

/// Cells of a boundary with one value of a cell array, and the points they use.
Grid cellsWith(vtkUnstructuredGrid* boundary, const char* array, double value);

/// Adds the cells of another grid, with one face id.
void addFace(vtkUnstructuredGrid* solid, vtkUnstructuredGrid* cells, int face);

/// Several meshes of hexahedra as one: points at the same place, to the last bit, are one point.
struct MergedHexes
{
  std::vector<Point> points;
  std::vector<Corners> hexes;
  std::map<Corners, int> faces; ///< how many hexahedra each face (sorted) is of
};

MergedHexes merged(const std::vector<vtkUnstructuredGrid*>& grids);
}

#endif

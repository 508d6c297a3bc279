// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief From VTK data sets to Core's meshes. Private to the module.
 */
#ifndef HexSweepReader_h
#define HexSweepReader_h

#include "Core/Common/Mesh.h"

#include <optional>
#include <string>
#include <vector>

class vtkDataSet;

namespace hexsweep
{
/// Triangles read from a data set. Points are all points of the input, used or not, so that ids are
/// the input's own.
struct TriangleInput
{
  TriangleMesh mesh;
  std::vector<Index> cellIds; ///< input cell that each triangle came from
  Index ignoredCells = 0;     ///< vertex and line cells, which are no part of a surface
};

/// Quads read from a data set, as TriangleInput.
struct QuadInput
{
  QuadMesh mesh;
  std::vector<Index> cellIds;
  Index ignoredCells = 0;
};

/**
 * Reads triangles; triangle strips, quads and polygons are triangulated.
 *
 * @param data nullptr counts as missing.
 * @param what name for the error text, e.g. "target surface".
 * @throw InvalidInput missing, empty, volume cells, coordinates as in checkCoordinates().
 */
TriangleInput readTriangles(vtkDataSet* data, const std::string& what);

/**
 * Triangles must have angles before a harmonic map is made of them.
 *
 * @param cellIds input cell that each triangle came from. @param what as readTriangles().
 * @throw InvalidInput naming the first cell without area.
 */
void checkAreas(const PointsRef& points, const TrianglesRef& triangles,
  const std::vector<Index>& cellIds, const std::string& what);
void checkAreas(const TriangleInput& surface, const std::string& what);

/// Reads quads; any other surface cell is an error. @throw InvalidInput as readTriangles().
QuadInput readQuads(vtkDataSet* data, const std::string& what);

/// The quads of an optional input, where one is connected. @throw InvalidInput as readQuads().
std::optional<QuadMesh> readOptionalQuads(vtkDataSet* data, const std::string& what);

/// All points of the data set. @throw InvalidInput never: coordinates are not looked at.
Points readPoints(vtkDataSet* data);
}

#endif

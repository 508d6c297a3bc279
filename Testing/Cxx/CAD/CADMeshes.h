// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Files read and swept, and how far their nodes lie from the kernel's own surfaces.
 */
#ifndef CADMeshes_h
#define CADMeshes_h

#include <TopoDS_Shape.hxx>

#include <vtkUnstructuredGrid.h>

#include <string>

class vtkCADReader;
class vtkPolyData;

namespace cadmeshes
{
/// A path for a file of the running test.
std::string temporaryFile(const std::string& name);

/// The triangles of a solid of a reader's output.
vtkPolyData* solidOf(vtkCADReader* reader, unsigned int number = 0);

/// Volume that closed triangles enclose.
double volumeOf(vtkPolyData* triangles);

/// Volume of hexahedra, integrated exactly.
double volumeOf(vtkUnstructuredGrid* hexes);

struct Distances
{
  double inFaces = 0.0; ///< greatest, of nodes inside a face from that face
  double onEdges = 0.0; ///< greatest, of nodes between faces from the nearest edge
  int nodesInFaces = 0;
  int nodesOnEdges = 0;
};

/**
 * How far boundary nodes lie from the shape, asked of the kernel's own search, which begins
 * everywhere on a surface or curve.
 *
 * @param boundary of vtkOneToOneSweep. A node whose quads have one BoundaryId is inside that face;
 *                 one between source or target and a side is on an edge.
 */
Distances distancesFrom(const TopoDS_Shape& shape, vtkUnstructuredGrid* boundary);

/// The greatest distance of a node from the nearest face, asked of some five hundred nodes.
double distanceFromNearestFace(const TopoDS_Shape& shape, vtkUnstructuredGrid* boundary);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles and polylines of solids, each point once. Private to the module.
 */
#ifndef HexSweepCADFacets_h
#define HexSweepCADFacets_h

#include "Core/Geometry/ModelGeometry.h"
#include "HexSweepCADModel.h"

#include <map>

namespace hexsweep
{
/// An edge of the model as it was divided.
struct CADEdgeFacets
{
  Index edgeId;
  std::vector<Index> points;  ///< along the edge; the first again at the end of a closed one
  std::vector<Index> faceIds; ///< of the faces of the solid on both sides, rising
};

struct CADSolidFacets
{
  ModelFacets facets;
  std::vector<CADEdgeFacets> edges;
  std::vector<Index> emptyFaces; ///< ids of faces that the kernel could not divide
};

/**
 * Divides edges and faces of shapes, each edge once for all faces that meet in it. The kernel keeps
 * the result in the shapes.
 *
 * @param deflection greatest distance from the surfaces, a length.
 * @param angle      greatest turn from facet to facet, radians.
 * @throw Aborted; InvalidInput where the kernel fails.
 */
void divideShape(
  const TopoDS_Shape& shape, double deflection, double angle, const Progress& progress);

/**
 * What divideShape() made of a solid.
 *
 * Points on edges are where the edge's curve is, so neighbouring faces, of this solid or another,
 * have them bit for bit.
 *
 * @param faces, edges their numbers are the ids.
 */
CADSolidFacets facetsOfSolid(const TopoDS_Shape& solid, const TopTools_IndexedMapOfShape& faces,
  const TopTools_IndexedMapOfShape& edges);
}

#endif

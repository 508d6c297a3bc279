// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The faces, curves and volumes of several solids that share faces, each face once.
 */
#ifndef hexsweep_AssemblyComplex_h
#define hexsweep_AssemblyComplex_h

#include "Core/Solids/SolidSurface.h"
#include "Core/Surfaces/SurfacePart.h"

#include <set>
#include <vector>

namespace hexsweep
{
/// A curve as it is run round a face.
struct CurveUse
{
  Index curve = -1;      ///< row of AssemblyComplex::curves
  bool reversed = false; ///< from its last point to its first
};

/// A chain of edges along which the same faces meet, between two vertices.
struct ComplexCurve
{
  std::vector<Index> points; ///< two or more; a closed curve ends with its first point
  std::vector<Index> faces;  ///< rows, rising

  bool closed() const { return this->points.front() == this->points.back(); }
};

struct ComplexFace
{
  Index id = 0;      ///< the FaceId of the first volume; parts of a face that was cut share it
  Index otherId = 0; ///< of the second volume
  std::vector<Index> triangles; ///< rows of AssemblyComplex::triangles, rising
  std::vector<Index> volumes;   ///< rows; one, or two where solids touch
  /// Boundary loops in the direction of the triangles, each from the start of a curve on.
  std::vector<std::vector<CurveUse>> loops;

  /// The FaceId in one of its volumes.
  Index idIn(Index volume) const
  {
    return this->volumes.front() == volume ? this->id : this->otherId;
  }
};

struct ComplexVolume
{
  std::vector<Index> faces; ///< rows, rising
};

/**
 * The non-manifold complex of an assembly. A face that two volumes share is there once, oriented
 * outward from the first of them.
 */
struct AssemblyComplex
{
  Points points;
  Triangles triangles;
  std::vector<Index> faceOf; ///< row of `faces`, one a triangle
  std::vector<ComplexFace> faces;
  std::vector<ComplexCurve> curves;
  std::vector<ComplexVolume> volumes;
  std::set<Index> vertices; ///< points at which curves end, whatever meets there
};

/**
 * Points are the same where they are nearer to each other than `matchTolerance` of the shortest
 * edge, and triangles of two solids are one where they have the same corners and face each other.
 * What two solids share of two of their faces is a face, each connected piece by itself, with the
 * first one's id.
 *
 * Curves end where more or fewer than two border edges meet, where other faces begin, and at
 * corners (turns of more than 30 degrees). A closed curve without any of these begins at its point
 * that lies farthest in a direction that is the same for all, so that parallel circles begin at the
 * same angle.
 *
 * @param solids one a volume, see makeSolidSurface().
 * @throw InvalidInput naming a face that more than two solids have, and where the border of a face
 *        touches itself.
 */
AssemblyComplex makeAssemblyComplex(
  const std::vector<const SolidSurface*>& solids, double matchTolerance = 1e-6);

/// Of triangles with labels: the first triangle of the connected piece of one label that each is
/// in.
std::vector<Index> connectedPieces(
  const Triangles& triangles, Index points, const std::vector<Index>& labels);

/// Finds curves and loops anew, after faces were cut.
void traceCurves(AssemblyComplex& complex);

/// Rows of a volume's faces with some ids, rising.
std::vector<Index> rowsOfFaces(
  const AssemblyComplex& complex, Index volume, const std::vector<Index>& ids);

/// The different ids of some of a volume's faces, rising.
std::vector<Index> idsOfFaces(
  const AssemblyComplex& complex, Index volume, const std::vector<Index>& faces);

/// Rows of the triangles of some faces, rising.
std::vector<Index> trianglesOfFaces(
  const AssemblyComplex& complex, const std::vector<Index>& faces);

/// Some triangles, turned outward from one of their volumes.
SurfacePart partOfVolume(
  const AssemblyComplex& complex, Index volume, const std::vector<Index>& triangles);

/// Some faces of a volume, turned outward from it.
TriangleMesh meshOfFaces(
  const AssemblyComplex& complex, Index volume, const std::vector<Index>& faces);

/// The points that a curve begins and ends at, as it is run.
Index firstPointOf(const AssemblyComplex& complex, const CurveUse& use);
Index lastPointOf(const AssemblyComplex& complex, const CurveUse& use);

/// Length of a chain of points.
double lengthOf(const AssemblyComplex& complex, const ComplexCurve& curve);

/// Radians: how much a curve bends from end to end, one bend added to the other.
double turnOf(const AssemblyComplex& complex, const ComplexCurve& curve);

/// Points a curve runs through, as a mesh that divides it has them: n x 3.
Points placesOf(const AssemblyComplex& complex, const ComplexCurve& curve);
}

#endif

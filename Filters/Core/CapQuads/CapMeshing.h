// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief An all-quad mesh of a triangulated cap, for users who bring none.
 *
 * The cap is remeshed with triangles of twice the wanted size, these are joined in pairs, and every
 * quad is cut into four, every triangle that is left into three.
 */
#ifndef hexsweep_CapMeshing_h
#define hexsweep_CapMeshing_h

#include "Core/CapQuads/CornerFans.h"
#include "Core/Common/ParallelFor.h"

#include <utility>

namespace hexsweep
{
/// A curve of a cap whose nodes are known, as a mesh beside it has them.
struct GivenCurve
{
  std::vector<Index> points;     ///< of the cap, along its edges; a closed curve repeats its first
  std::vector<double> fractions; ///< of its length, from 0 to 1, rising: an odd number of nodes
  Points places; ///< of these nodes: on or near the curve, where the quads have them bit for bit
};

struct CapQuadOptions
{
  double size = 0.0; ///< wanted edge length of the quads, > 0, in the cap's length unit
  /// How high curves and surfaces may rise above the quads' edges, over the edges' length, in
  /// [0, 0.5]: edges there are shorter than `size` (down to a fiftieth). The polish moves nodes:
  /// some edges (one in ten or fewer) rise higher, up to twice as high. 0: any height.
  double chordTolerance = 0.0;
  std::vector<Index> keep; ///< points of the cap that are to be nodes, in any order
  /// Edges of the cap's boundary that are to be edges of the quads, undivided, as pairs of points
  /// in any order.
  std::vector<std::pair<Index, Index>> keepEdges;
  /// Not empty: all curves of the cap, its loops and the borders between its faces. They are
  /// divided as given; `keep`, `keepEdges` and `fans` are to be empty then.
  std::vector<GivenCurve> given;
  std::vector<CornerFan> fans; ///< nodes of earlier quads of the same cap that want more quads
  ParallelFor parallelFor;     ///< lends threads; the bits do not depend on them
};

struct CapQuads
{
  QuadMesh mesh; ///< oriented as the cap is
  /// Triangle of the cap in which (or nearest to which) the middle of each quad lies.
  std::vector<Index> quadOrigin;
  /// Node at each point of CapQuadOptions::keep, with its coordinates exactly.
  std::vector<Index> keptNodes;
  /// Nodes along each curve of CapQuadOptions::given.
  std::vector<std::vector<Index>> givenNodes;
  /// Nodes on the boundary and on the borders of faces.
  std::vector<bool> onCurve;
  Index loops = 0;
  Index splitTriangles = 0; ///< triangles that found no partner and were cut into three quads
  Index inverted = 0;       ///< quads with a corner <= 0, see quadQuality()
  double minimumScaledJacobian = 0.0;
  double meanScaledJacobian = 0.0;
};

/**
 * Meshes a cap with quads of about one size.
 *
 * Nodes of the boundary lie on the cap's boundary polygon, those inside on its triangles. Corners
 * of the loops (more than 30 degrees), points where faces meet and the points to keep are nodes;
 * between them loops and borders of faces are divided by arc length, evenly but where the cap is
 * narrower than the wanted size: edges there are as short as it is wide, and grow from there. Every
 * curve has an even number of edges; every loop at least eight. Edges to keep are kept on curves
 * that consist of these alone, of an even number and at least four (eight where they are a whole
 * loop).
 *
 * @param cap     oriented, one genus-0 piece, any number of loops, planar or not.
 * @param faceIds one a triangle: edges between different ids are kept as edges of the quads; empty:
 *                the cap is one face.
 * @throw InvalidInput for a size that is not positive and finite or would take more than 50 million
 *        quads, for ids of points that no triangle uses, for given curves that cannot be kept, and
 * for a cap that checkCap() refuses.
 * @throw Aborted.
 */
CapQuads meshCapWithQuads(const TriangleMesh& cap, const std::vector<Index>& faceIds,
  const CapQuadOptions& options, const Progress& progress = {});

/**
 * A size for a cap about which nothing is known: about 1000 quads, or as many more, up to 16000, as
 * put twelve edges round the shortest loop.
 *
 * @return > 0 for a cap with an area.
 * @throw InvalidInput where it has none.
 */
double defaultQuadSize(const TriangleMesh& cap);
}

#endif

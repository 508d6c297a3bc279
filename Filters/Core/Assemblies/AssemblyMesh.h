// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The nodes of an assembly's curves and the quads of its faces, each made once and shared by
 * all volumes beside them.
 */
#ifndef hexsweep_AssemblyMesh_h
#define hexsweep_AssemblyMesh_h

#include "Core/Assemblies/AssemblyGeometry.h"
#include "Core/Assemblies/SideLayout.h"

namespace hexsweep
{
/// Places of nodes, numbered as they come.
class NodeTable
{
public:
  Index add(const Eigen::RowVector3d& place)
  {
    this->Places.push_back(place);
    return static_cast<Index>(this->Places.size()) - 1;
  }
  Index size() const { return static_cast<Index>(this->Places.size()); }
  const Eigen::RowVector3d& operator[](Index node) const
  {
    return this->Places[static_cast<std::size_t>(node)];
  }
  /// n x 3, the places of some nodes.
  Points placesOf(const std::vector<Index>& nodes) const;

private:
  std::vector<Eigen::RowVector3d> Places;
};

struct MeshedCurve
{
  std::vector<Index> nodes;      ///< a closed curve ends with its first node
  std::vector<double> fractions; ///< of the curve's length, one a node
};

/// Nodes that were made one after the other for one thing: inside a face, or inside the target cap
/// of a volume.
struct NodeBlock
{
  Index entity; ///< row of a face, or number of faces + row of a volume
  Index begin;
  Index count;
};

struct AssemblyMesh
{
  NodeTable nodes; ///< those of the curves first
  Index curveNodes = 0;
  std::vector<NodeBlock> blocks;   ///< of the others, in the order in which they were made
  std::vector<MeshedCurve> curves; ///< rows as in AssemblyComplex
  std::vector<Quads> faces;        ///< of nodes, turned as the face's triangles; no row: not meshed
};

/**
 * Divides each curve into edges of one length, on the CAD edge where it is known.
 *
 * @param counts edges, one a curve; at least 1, of a closed one 3.
 */
AssemblyMesh divideCurves(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const std::vector<Index>& counts);

/// Nodes along a chain of curves, each once; of a closed one without the first again.
std::vector<Index> nodesAlong(const AssemblyMesh& mesh, const std::vector<CurveUse>& chain);
}

#endif

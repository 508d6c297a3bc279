// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The matrices of a quad mesh, arranged for many Helmholtz problems on it.
 */
#ifndef hexsweep_HelmholtzMesh_h
#define hexsweep_HelmholtzMesh_h

#include "Core/Common/Mesh.h"
#include "Core/Solvers/PrismKernels.h"
#include "Core/Solvers/QuadLaplacian.h"

#include <vector>

namespace hexsweep
{
/// Compressed rows of K and M.
template <typename Real>
struct MatrixPair
{
  std::vector<Real> stiffness;
  std::vector<Real> mass;
};

/// A part of the matrices: the same rows and columns in both precisions.
struct MatrixPart
{
  std::vector<Index> begin;
  std::vector<int> column;
  MatrixPair<double> inDouble;
  MatrixPair<float> inSingle;
};

/**
 * K and M between the free nodes, which are numbered by their distance from the given ones in
 * edges: what is far from the boundary comes last and can be left out where nothing reaches it.
 */
struct HelmholtzMesh
{
  std::vector<Index> ids;   ///< point id of each free node
  std::vector<Index> given; ///< point id of each given node that has a free neighbour
  /// Nodes [levels[l], levels[l + 1]) are l + 1 edges from the given ones; those that no edge
  /// connects with a given node are in the last level.
  std::vector<Index> levels;
  /// Mass over stiffness across the edges from level to level, mean of each level (length^2): a
  /// mode falls by acosh(1 + lambda / 2 times this) from one level to the next, in powers of e.
  std::vector<double> decay;
  MatrixPart lower, upper;
  MatrixPair<double> diagonal, upperSums;
  MatrixPair<float> diagonalInSingle, upperSumsInSingle;
  /// Rows: free nodes; columns: numbers in `given`.
  MatrixPart coupling;

  Index size() const { return static_cast<Index>(this->ids.size()); }

  /// The first n nodes as the kernels want them.
  HelmholtzSystem<double> system(Index n, const double* lambda) const;
  HelmholtzSystem<float> systemInSingle(Index n, const double* lambda) const;
};

/// @param isGiven one entry a point: not 0 where values are given, and where no quad is.
HelmholtzMesh helmholtzMesh(const QuadLaplacian& laplacian, const std::vector<char>& isGiven);
}

#endif

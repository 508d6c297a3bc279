// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Newton descent of the foldover-free energy of a patch of hexahedra.
 */
#ifndef hexsweep_HexDescent_h
#define hexsweep_HexDescent_h

#include "Core/Common/Mesh.h"

#include <memory>

namespace hexsweep
{
/// Wanted edge lengths of a hexahedron along its three axes (VTK_HEXAHEDRON corners 0-1, 0-3 and
/// 0-4), in the unit of the mesh, > 0; one row a hexahedron.
using HexBoxes = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Where the Jacobian of a hexahedron is looked at.
enum class HexSamples
{
  Corners, ///< 8
  Lattice  ///< 27: the corners, and the middles of edges, faces and the hexahedron
};

/**
 * Moves the free nodes of some hexahedra so that the sum of distortion<3>() over the samples of all
 * of them falls \cite Garanzha2021 (see FoldoverFreeEnergy.h), each sample's Jacobian taken
 * relative to a box. The energy is finite for inverted hexahedra.
 *
 * Newton's method with the positive semidefinite part of the second derivative; the linear systems
 * are solved by conjugateGradients(), which takes a tenth to a twentieth of a factorisation's time
 * for patches of some thousand hexahedra, and no more for the smallest.
 */
class HexDescent
{
public:
  /**
   * @param hexes  the patch: ids in [0, n); @param boxes one row each.
   * @param free   n entries: nodes that may move; of those, nodes outside the patch stay too.
   */
  HexDescent(const HexesRef& hexes, const HexBoxes& boxes, const std::vector<bool>& free);
  ~HexDescent();

  bool hasFreeNodes() const;

  struct Result
  {
    Points points;
    double before;
    double after;
    /// Over the samples of all hexahedra that have a free node, relative to the box.
    double leastDeterminant;
    /// Newton steps taken.
    Index steps = 0;
  };

  /**
   * @param points n x 3.
   * @param epsilon regularisation of the determinant, relative to the box, > 0.
   * @param steps at the most; fewer once a step lowers the sum by less than relativeDecrease.
   * @throw Aborted when progress returns false.
   */
  Result descend(const Points& points, HexSamples samples, double epsilon, int steps,
    double relativeDecrease, const Progress& progress = {}) const;

private:
  struct System;
  std::unique_ptr<System> Equations;
};
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Both models of a sweep, and what holds for every cage method.
 */
#ifndef CageTests_h
#define CageTests_h

#include "Core/Common/Errors.h"
#include "Core/Common/ParallelFor.h"
#include "Core/Interior/CageMesh.h"
#include "Core/Interior/TopologicalModel.h"
#include "Support/InteriorTests.h"

#include <Eigen/Geometry>

namespace test
{
/// The physical and the topological model of a sweep, and their cage.
struct CageModels
{
  hexsweep::SweepBoundary boundary;
  Points physical;
  Quads cageQuads;
  Points model;
  hexsweep::CageMesh cage;
};

CageModels modelsOf(const Sweep& sweep);

/// The caps' quads turned over.
Sweep turnedOver(Sweep sweep);

/// Rows of the swept points inside the volume.
std::vector<Index> insideRows(const Sweep& sweep);

Points rowsOf(const Points& points, const std::vector<Index>& rows);

/// One affine map of a straight prism: shear, scale, rotation and stretch of the whole volume.
Eigen::RowVector3d straightAffineMotion(double x, double y, double t);

template <typename CageInterior>
void expectStraightAffineSweepsExact(const CageInterior& interior, double tolerance)
{
  for (const bool hole : { false, true })
  {
    for (const double scale : { 1e-6, 1.0, 1e6 })
    {
      const Sweep sweep = placed(makeSweep(12, 9, hole, evenLayers(5), straightAffineMotion), scale,
        Eigen::RowVector3d::Zero());
      for (const Sweep& either : { sweep, turnedOver(sweep) })
      {
        EXPECT_LT(greatestDistance(interior(either), either.layers), tolerance * sizeOf(either));
      }
    }
  }
}
}

#endif

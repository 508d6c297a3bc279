// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Analytic sweeps: a quad mesh moved by a function of (x, y, t), and its linking sides.
 */
#ifndef SweepMeshes_h
#define SweepMeshes_h

#include "Core/Common/Mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace test
{
using hexsweep::Index;
using hexsweep::Points;
using hexsweep::Quads;

/// Where the cap point (x, y) is at t, 0 at the source and 1 at the target.
using Motion = std::function<Eigen::RowVector3d(double x, double y, double t)>;

struct Sweep
{
  /// Parameters of the cap points, n x 2.
  hexsweep::PlanePoints cap;
  Quads quads;
  Points source;
  Points target;
  Points linkingPoints;
  Quads linkingQuads;
  /// True positions of all points on all layers, row k n + i.
  Points layers;
  Index numberOfLayers = 0;
};

/// An irregular quad mesh of [0, 2] x [0, 1]; with a hole, the middle ninth is cut out.
void makeCap(int nx, int ny, bool hole, hexsweep::PlanePoints& points, Quads& quads);

/// Sweeps any cap. @param positions t of each layer, from 0 to 1.
Sweep sweepCap(const hexsweep::PlanePoints& cap, const Quads& quads,
  const std::vector<double>& positions, const Motion& motion);

/// Sweeps makeCap().
Sweep makeSweep(
  int nx, int ny, bool hole, const std::vector<double>& positions, const Motion& motion);

std::vector<double> evenLayers(int layers);

/// Every layer is an affine image of the cap: it turns, is sheared, stretched, and follows an arc.
Eigen::RowVector3d affineMotion(double x, double y, double t);

/// Turns every second linking quad over, starts cells anywhere, and shuffles cells and points.
void disorderLinkingSides(Sweep& sweep);

/// Gives every linking quad of an odd column its own points: seams that share nothing.
void cutLinkingSides(Sweep& sweep);

/// All coordinates of the sweep times `scale`, then moved by `offset`.
Sweep placed(Sweep sweep, double scale, const Eigen::RowVector3d& offset);

/// Greatest distance between matching rows.
double greatestDistance(const Points& a, const Points& b);
}

#endif

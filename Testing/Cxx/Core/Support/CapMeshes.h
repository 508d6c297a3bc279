// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangulated caps of known shape: disks, annuli, plates with holes.
 */
#ifndef CapMeshes_h
#define CapMeshes_h

#include "Core/Common/Errors.h"
#include "Core/Common/Mesh.h"
#include "Core/Linking/CapBoundary.h"
#include "Core/Linking/LinkingRings.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test
{
using hexsweep::Index;
using hexsweep::Loop;
using hexsweep::PlanePoints;
using hexsweep::Points;
using hexsweep::Quads;
using hexsweep::TriangleMesh;
using hexsweep::Triangles;

constexpr double Pi = 3.14159265358979323846;

/// Rows from a flat list of ids.
template <typename Faces>
Faces facesOf(const std::vector<Index>& ids)
{
  constexpr Index corners = Faces::ColsAtCompileTime;
  return Eigen::Map<const Faces>(ids.data(), static_cast<Index>(ids.size()) / corners, corners);
}

/// A triangulated polar grid: node (ring k, place j) is point k * around + j; all diagonals lean
/// the same way, or by chance when a generator is given.
Triangles polarTriangles(Index rings, Index around, std::mt19937* generator = nullptr);

/// The annulus inner <= |z| <= outer in the plane z = 0; rings evenly spaced, the hole first.
TriangleMesh annulus(
  double inner, double outer, Index rings, Index around, std::mt19937* generator = nullptr);

/// The unit disk: `rings` circles of nodes (point k * around + j) and the centre, the last point.
TriangleMesh disk(Index rings, Index around);

/// A block of cells that is cut out of a plate.
struct Block
{
  int left;
  int bottom;
  int width;
  int height;
};

/// A plate of cells x cells squares over [0, 1]^2 in the plane z = 0, with rectangular holes.
/// Inner nodes are shaken by `shake` of a cell.
hexsweep::QuadMesh quadPlate(
  int cells, const std::vector<Block>& holes, double shake = 0.0, unsigned seed = 1);

/// The same in triangles, each square cut along a diagonal that chance picks.
TriangleMesh plate(
  int cells, const std::vector<Block>& holes, double shake = 0.0, unsigned seed = 1);

/// Three holes that fit plates of 12 cells.
std::vector<Block> threeHoles();

/// Lifts points over the plane: z += height(x, y).
Points lifted(Points points, const std::function<double(double, double)>& height);

/// A bump that vanishes on the edges of the unit square.
double bump(double x, double y);

/// A plate of 12 x 12 cells with the first of threeHoles(), lifted by a multiple of bump().
TriangleMesh curvedPlate(std::size_t holes, double shake, double height = 1.0, unsigned seed = 1);

/// x -> offset + scale * turn x.
struct Similarity
{
  double scale = 1.0;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::RowVector3d offset = Eigen::RowVector3d::Zero();
  Points operator()(const Points& points) const
  {
    return (scale * (points * turn.transpose())).rowwise() + offset;
  }
};

Eigen::Matrix3d someTurn();

/// Places of the size-1 model, each with the rounding error of its coordinates over the size.
struct Placement
{
  Similarity motion;
  double relativeRounding;
  std::string name;
};

std::vector<Placement> placements();

/// Loops of nodes as rings, both in the order of the loops of the first cap.
std::vector<hexsweep::LoopPair> pairsOf(
  const Points& first, const Points& second, const std::vector<Loop>& loops);

double loopLength(const Points& points, const Loop& loop);

/// Boundary loops, the longest first.
std::vector<Loop> loopsOf(const TriangleMesh& mesh);

/// Boundary loops as checkSurface() finds them.
std::vector<Loop> surfaceLoops(const TriangleMesh& mesh);

/// Loops in another order, beginning elsewhere, perhaps running the other way.
std::vector<Loop> disordered(std::vector<Loop> loops, bool reversed);

/// Which nodes lie on the boundary.
std::vector<bool> boundaryFlags(const TriangleMesh& mesh);

/// Straight linking sides of a few layers between two caps that share loops; an own numbering.
hexsweep::QuadMesh linkingSides(
  const Points& source, const Points& target, const std::vector<Loop>& loops, Index layers = 3);

/// The rings of linking quads, from the loops of the source quads.
inline hexsweep::RingStack traced(
  const hexsweep::QuadMesh& source, const hexsweep::QuadMesh& linking)
{
  return hexsweep::traceLinkingRings(source.points,
    hexsweep::checkSurface(source.quads, source.points.rows(), "source quads").loops,
    linking.points, linking.quads);
}

/// Runs something that must throw InvalidInput with `part` in its text.
template <typename Work>
void expectInvalid(const Work& work, const std::string& part)
{
  try
  {
    work();
    FAIL() << "nothing was thrown; expected \"" << part << '"';
  }
  catch (const hexsweep::InvalidInput& error)
  {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << "got: " << error.what();
  }
}

/// All faces turned over.
template <typename Faces>
Faces turnedOver(const Faces& faces)
{
  return faces.rowwise().reverse();
}

double surfaceArea(const TriangleMesh& mesh);
}

#endif

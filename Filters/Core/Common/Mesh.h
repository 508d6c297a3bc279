// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The array types that every Core function speaks.
 *
 * Functions take `Eigen::Ref` or `Eigen::Map` views of these and return them by value. Ids are
 * 64-bit and zero-based; coordinates are in the user's length unit unless stated otherwise.
 */
#ifndef hexsweep_Mesh_h
#define hexsweep_Mesh_h

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace hexsweep
{
using Index = std::int64_t;

/// n x 3, one point a row.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using PointsRef = Eigen::Ref<const Points>;

/// n x 2, one point of the plane (the disk) a row.
using PlanePoints = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
using PlanePointsRef = Eigen::Ref<const PlanePoints>;

/// m x 3 and m x 4, one face a row, counter-clockwise about its normal.
using Triangles = Eigen::Matrix<Index, Eigen::Dynamic, 3, Eigen::RowMajor>;
using TrianglesRef = Eigen::Ref<const Triangles>;
using Quads = Eigen::Matrix<Index, Eigen::Dynamic, 4, Eigen::RowMajor>;
using QuadsRef = Eigen::Ref<const Quads>;

/// m x 8, VTK_HEXAHEDRON order.
using Hexes = Eigen::Matrix<Index, Eigen::Dynamic, 8, Eigen::RowMajor>;
using HexesRef = Eigen::Ref<const Hexes>;

/// m x 3 or m x 4: for what works on triangles and quads alike.
using Faces = Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using FacesRef = Eigen::Ref<const Faces>;

/// A closed chain of point ids; the last one is followed by the first.
using Loop = std::vector<Index>;

struct TriangleMesh
{
  Points points;
  Triangles triangles;
};

struct QuadMesh
{
  Points points;
  Quads quads;
};

/// Called with the fraction done, in [0, 1]; returns false when the work is to be given up
/// (the callee then throws hexsweep::Aborted). May be empty.
using Progress = std::function<bool(double)>;
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a quad's corner contributes to the sums that CapDescent lowers.
 */
#ifndef hexsweep_CornerTerms_h
#define hexsweep_CornerTerms_h

#include "Core/CapQuads/CapDescent.h"

#include <array>

namespace hexsweep
{
/// In distortion(). Shape counts, size hardly: quads of very different sizes are wanted where a
/// hole grows.
constexpr double VolumeWeight = 1.0 / 128.0;

/// A function of one variable at one place.
struct CurvePoint
{
  double value;
  double slope;
  double curvature; ///< >= 0
};

/// What each quad is to look like.
enum class ReferenceShape
{
  SourceQuad, ///< the quad that it came from
  Rectangle,  ///< a rectangle with the source quad's mean edge lengths
  Square
};

/// Mean lengths of the source quad's sides at a corner and of those across: to the next node, to
/// the previous one.
std::array<double, 2> rectangleOf(
  const PointsRef& source, const Quads& quads, const QuadCorner& corner);

/**
 * Inverse of the wanted edge matrix of each corner (columns: edge to the next node, edge to the
 * previous one), scaled so that all wanted quads together are as large as the mesh.
 */
std::vector<Eigen::Matrix2d> inverseReferences(
  const CapCorners& cap, ReferenceShape shape, const PointsRef& source, const PointsRef& points);

/// distortion() of the map from the wanted corner.
CornerTerm distortionTerm(
  const Eigen::Matrix2d& edges, const Eigen::Matrix2d& inverseReference, double epsilon);

/// Its value alone.
double distortionValueOf(
  const Eigen::Matrix2d& edges, const Eigen::Matrix2d& inverseReference, double epsilon);

/// A convex falling function of the corner's scaled Jacobian, the sine of its angle.
CornerTerm jacobianTerm(
  const Eigen::Matrix2d& edges, const std::function<CurvePoint(double)>& function);

/// The same of the corner of a hexahedron: the determinant of both edges and the column over the
/// product of their lengths.
ColumnCornerTerm hexJacobianTerm(
  const CornerEdges& edges, const std::function<CurvePoint(double)>& function);

/// a + weight * b
CornerTerm sumOfTerms(const CornerTerm& a, const CornerTerm& b, double weight);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexCertificate.h"

#include "Core/Common/Expansion.h"
#include "Core/Hexahedra/BezierHex.h"
#include "Core/Hexahedra/BezierMinimum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace hexsweep
{
namespace
{
// Products of three differences of coordinates in [2^-250, 1], with all their digits and bisected
// as often as they are, are far from underflow.
constexpr int LeastExponent = -250;

template <typename Number>
HexEdges<Number> edgesOf(const HexCornersRef& corners)
{
  std::array<Vector3<Number>, 8> points;
  for (int i = 0; i < 8; ++i)
  {
    points[static_cast<std::size_t>(i)] = { corners(i, 0), corners(i, 1), corners(i, 2) };
  }
  return hexEdges(points);
}

// The square of the product of the greatest lengths of the edges in the three directions.
double squaredProduct(const HexEdges<double>& edges)
{
  const auto greatest = [](const Vector3<double>(&vectors)[2][2]) {
    return std::max(std::max(dot(vectors[0][0], vectors[0][0]), dot(vectors[0][1], vectors[0][1])),
      std::max(dot(vectors[1][0], vectors[1][0]), dot(vectors[1][1], vectors[1][1])));
  };
  return greatest(edges.u) * greatest(edges.v) * greatest(edges.w);
}

bool hasZeroEdge(const HexCornersRef& corners)
{
  constexpr int Ends[12][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 },
    { 6, 7 }, { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
  return std::any_of(std::begin(Ends), std::end(Ends),
    [&](const int(&ends)[2]) { return corners.row(ends[0]) == corners.row(ends[1]); });
}

struct Judgement
{
  /// Nothing where rounding, or the number of bisections, does not allow to tell.
  std::optional<Validity> validity;
  double jacobianLowerBound;
  /// Whether exact numbers may tell more.
  bool isRounded;
};

/// @param error bound of the rounding error of the coefficients; 0 means that they are exact.
template <typename Number>
Judgement judge(const BezierCoefficients<Number>& coefficients, double error)
{
  const auto isNotPositive = [error](double value) {
    return error > 0.0 ? value < -error : value <= 0.0;
  };
  const double leastCorner = BezierBox<Number>(coefficients).sample;
  const JacobianMinimum minimum = boundMinimum(coefficients, error);
  const bool isAwayFromZero =
    leastCorner > error && minimum.sample > error && minimum.lowerBound < -error;
  Judgement judgement{ std::nullopt, minimum.lowerBound - error, !isAwayFromZero };
  if (isNotPositive(leastCorner))
  {
    judgement.validity = Validity::InvertedCorner;
  }
  else if (minimum.lowerBound > error)
  {
    judgement.validity = Validity::Certified;
  }
  else if (leastCorner > error && isNotPositive(minimum.sample))
  {
    judgement.validity = Validity::InvertedInside;
  }
  return judgement;
}

Judgement judgeRounded(const HexCornersRef& corners)
{
  const HexEdges<double> edges = edgesOf<double>(corners);
  const double squared = squaredProduct(edges);
  if (!(squared >= LeastSquaredProduct && squared <= GreatestSquaredProduct))
  {
    return { std::nullopt, -std::numeric_limits<double>::infinity(), true };
  }
  return judge(bezierCoefficients(edges), BezierErrorBound * std::sqrt(squared));
}

Judgement judgeExactly(const HexCornersRef& corners)
{
  const HexEdges<Expansion> edges = edgesOf<Expansion>(corners);
  // A flat hexahedron, the commonest guest here, is told by its corners for a fraction of the cost.
  for (const int i : { 0, 1 })
  {
    for (const int j : { 0, 1 })
    {
      for (const int k : { 0, 1 })
      {
        if (toDouble(edges.cornerJacobian(i, j, k)) <= 0.0)
        {
          return { Validity::InvertedCorner, -std::numeric_limits<double>::infinity(), false };
        }
      }
    }
  }
  return judge(bezierCoefficients(edges), 0.0);
}

// The hexahedron with its greatest coordinate in [1/2, 1).
Judgement judgeScaled(const HexCornersRef& corners, int exponent)
{
  const HexCorners scaled =
    corners.unaryExpr([exponent](double value) { return std::ldexp(value, -exponent); });
  const Judgement rounded = judgeRounded(scaled);
  const double least = std::ldexp(1.0, LeastExponent);
  const bool isExact = (corners.array() == 0.0 || scaled.array().abs() >= least).all();
  if (rounded.validity || !rounded.isRounded || !isExact)
  {
    return rounded;
  }
  const Judgement exact = judgeExactly(scaled);
  return { exact.validity, std::max(rounded.jacobianLowerBound, exact.jacobianLowerBound), false };
}
}

HexCertificate certifyHex(const HexCornersRef& corners)
{
  if (!corners.allFinite() || hasZeroEdge(corners))
  {
    return { Validity::Degenerate, std::numeric_limits<double>::quiet_NaN() };
  }
  Judgement judgement = judgeRounded(corners);
  if (!judgement.validity && judgement.isRounded)
  {
    int exponent = 0;
    std::frexp(corners.cwiseAbs().maxCoeff(), &exponent);
    judgement = judgeScaled(corners, exponent);
    // Downwards: a bound that is too small for all its digits was rounded.
    judgement.jacobianLowerBound =
      std::nextafter(std::ldexp(judgement.jacobianLowerBound, 3 * exponent),
        -std::numeric_limits<double>::infinity());
  }
  return { judgement.validity.value_or(Validity::Undecided), judgement.jacobianLowerBound };
}
}

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The Jacobian of a trilinear hexahedron as a polynomial in Bezier form.
 *
 * With x(u, v, w) the trilinear map of the unit cube onto the hexahedron, x_u is bilinear in v and
 * w, and so on: det J = det(x_u, x_v, x_w) is of degree 2 in each variable and has 27 Bezier
 * coefficients \cite Johnen2017. It lies between the least and the greatest of them, and at a
 * corner it equals the coefficient there.
 *
 * Everything is a template of the number type: double, several hexahedra as the lanes of a vector
 * register, or exact numbers (Expansion).
 */
#ifndef hexsweep_BezierHex_h
#define hexsweep_BezierHex_h

#include <array>
#include <cmath>
#include <limits>

namespace hexsweep
{
template <typename Number>
struct Vector3
{
  Number x, y, z;

  friend Vector3 operator+(const Vector3& a, const Vector3& b)
  {
    return { a.x + b.x, a.y + b.y, a.z + b.z };
  }
  friend Vector3 operator-(const Vector3& a, const Vector3& b)
  {
    return { a.x - b.x, a.y - b.y, a.z - b.z };
  }
};

template <typename Number>
Number dot(const Vector3<Number>& a, const Vector3<Number>& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Number>
Number determinant(const Vector3<Number>& a, const Vector3<Number>& b, const Vector3<Number>& c)
{
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
    a.z * (b.x * c.y - b.y * c.x);
}

/// The twelve edges: u[j][k] from (0, j, k) to (1, j, k), v[i][k] from (i, 0, k) to (i, 1, k) and
/// w[i][j] from (i, j, 0) to (i, j, 1).
template <typename Number>
struct HexEdges
{
  Vector3<Number> u[2][2];
  Vector3<Number> v[2][2];
  Vector3<Number> w[2][2];

  /// The Jacobian at the corner (i, j, k).
  Number cornerJacobian(int i, int j, int k) const
  {
    return determinant(this->u[j][k], this->v[i][k], this->w[i][j]);
  }
};

/// @param x the corners in VTK_HEXAHEDRON order.
template <typename Number>
HexEdges<Number> hexEdges(const std::array<Vector3<Number>, 8>& x)
{
  return { { { x[1] - x[0], x[5] - x[4] }, { x[2] - x[3], x[6] - x[7] } },
    { { x[3] - x[0], x[7] - x[4] }, { x[2] - x[1], x[6] - x[5] } },
    { { x[4] - x[0], x[7] - x[3] }, { x[5] - x[1], x[6] - x[2] } } };
}

/// Coefficient (p, q, r), each in {0, 1, 2}, is entry p + 3 q + 9 r.
template <typename Number>
using BezierCoefficients = std::array<Number, 27>;

constexpr std::size_t bezierIndex(int p, int q, int r)
{
  return static_cast<std::size_t>(p + 3 * q + 9 * r);
}

/**
 * The coefficients from the Jacobian at the 8 corners and the 12 middles of the edges.
 *
 * On an edge the Jacobian is a parabola: b_1 = 2 J(1/2) - (b_0 + b_2) / 2. No monomial of the
 * Jacobian contains u^2 v^2, v^2 w^2 or w^2 u^2 (each would be a determinant with two equal
 * vectors), so the second difference in one variable of the second difference in another vanishes,
 *
 *   sum_pq d_p d_q b_pq = 0 with d = (1, -2, 1),
 *
 * on the faces and on the middle plane, which gives the coefficients of the faces and of the
 * centre.
 */
template <typename Number>
BezierCoefficients<Number> bezierCoefficients(const HexEdges<Number>& e)
{
  BezierCoefficients<Number> b;
  for (int k = 0; k < 2; ++k)
  {
    for (int j = 0; j < 2; ++j)
    {
      for (int i = 0; i < 2; ++i)
      {
        b[bezierIndex(2 * i, 2 * j, 2 * k)] = e.cornerJacobian(i, j, k);
      }
    }
  }
  // Each vector across an edge is the mean of two; their sums give four times the Jacobian.
  for (int s = 0; s < 2; ++s)
  {
    for (int t = 0; t < 2; ++t)
    {
      const auto setMiddle = [&b](std::size_t middle, std::size_t step, const Number& fourfold) {
        b[middle] = 0.5 * (fourfold - b[middle - step] - b[middle + step]);
      };
      setMiddle(bezierIndex(1, 2 * s, 2 * t), 1,
        determinant(e.u[s][t], e.v[0][t] + e.v[1][t], e.w[0][s] + e.w[1][s]));
      setMiddle(bezierIndex(2 * s, 1, 2 * t), 3,
        determinant(e.u[0][t] + e.u[1][t], e.v[s][t], e.w[s][0] + e.w[s][1]));
      setMiddle(bezierIndex(2 * s, 2 * t, 1), 9,
        determinant(e.u[t][0] + e.u[t][1], e.v[s][0] + e.v[s][1], e.w[s][t]));
    }
  }
  const auto setCenter = [&b](std::size_t center, std::size_t p, std::size_t q) {
    const Number middles = (b[center - p] + b[center + p]) + (b[center - q] + b[center + q]);
    const Number corners =
      (b[center - p - q] + b[center + p - q]) + (b[center - p + q] + b[center + p + q]);
    b[center] = 0.5 * middles - 0.25 * corners;
  };
  for (int s = 0; s < 2; ++s)
  {
    setCenter(bezierIndex(1, 1, 2 * s), 1, 3);
    setCenter(bezierIndex(1, 2 * s, 1), 1, 9);
    setCenter(bezierIndex(2 * s, 1, 1), 3, 9);
  }
  setCenter(bezierIndex(1, 1, 1), 1, 3);
  return b;
}

/**
 * Rounding error of double coefficients, as a multiple of the greatest lengths of the u, the v and
 * the w edges multiplied, after at most 400 bisections.
 *
 * In units of 2^-53 M, where M bounds the sum of the magnitudes of the six products of a
 * determinant of edges: 8 for a corner (three differences, which are rounded once however far from
 * the origin, and five operations on each product); 40 for the sum of four determinants at the
 * middle of an edge, 34 for its coefficient, 85 for that of a face, 214 for the centre; two more
 * with each bisection. M is at most the product of the 1-norms, 3^(3/2) times that of the lengths:
 * 1014 * 5.2 < 5300, and some for the rounding of the lengths and terms of second order.
 *
 * Holds where nothing overflows, and underflow is too small to matter: see LeastSquaredProduct.
 */
constexpr double BezierErrorBound = 6000 * (std::numeric_limits<double>::epsilon() / 2);

/// The square of a product of three lengths within which BezierErrorBound holds: 1e-33 to 1e33 of
/// any unit. Beyond, the hexahedron must be scaled.
constexpr double LeastSquaredProduct = 1e-200;
constexpr double GreatestSquaredProduct = 1e200;
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexLanes.h"

#include "Core/Hexahedra/BezierHex.h"

namespace hexsweep
{
namespace
{
template <typename Number>
using Corners = std::array<Vector3<Number>, 8>;

template <typename Number>
Number lesser(const Number& a, const Number& b)
{
  return a < b ? a : b;
}

template <typename Number>
Number greater(const Number& a, const Number& b)
{
  return a > b ? a : b;
}

// With its sign.
template <typename Number>
Number square(const Number& a)
{
  return a * greater(a, -a);
}

template <typename Number>
Vector3<Number> meanOfFour(const Vector3<Number> (&edges)[2][2])
{
  const Vector3<Number> sum = (edges[0][0] + edges[0][1]) + (edges[1][0] + edges[1][1]);
  return { 0.25 * sum.x, 0.25 * sum.y, 0.25 * sum.z };
}

template <typename Number>
struct SquaredLengths
{
  explicit SquaredLengths(const Vector3<Number> (&edges)[2][2])
  {
    for (int i = 0; i < 2; ++i)
    {
      for (int j = 0; j < 2; ++j)
      {
        this->values[i][j] = dot(edges[i][j], edges[i][j]);
      }
    }
  }

  Number greatest() const
  {
    return greater(greater(this->values[0][0], this->values[0][1]),
      greater(this->values[1][0], this->values[1][1]));
  }

  Number values[2][2];
};

template <typename Number>
HexFigures<Number> figuresOf(const Corners<Number>& corners)
{
  const HexEdges<Number> edges = hexEdges(corners);
  const BezierCoefficients<Number> coefficients = bezierCoefficients(edges);
  HexFigures<Number> figures;

  const Vector3<Number> u = meanOfFour(edges.u);
  const Vector3<Number> v = meanOfFour(edges.v);
  const Vector3<Number> w = meanOfFour(edges.w);
  const Number centerProduct = dot(u, u) * dot(v, v) * dot(w, w);
  figures.scaledCenter = square(determinant(u, v, w)) / centerProduct;
  figures.leastProduct = centerProduct;
  figures.sumOfProducts = centerProduct;

  const SquaredLengths<Number> uu(edges.u);
  const SquaredLengths<Number> vv(edges.v);
  const SquaredLengths<Number> ww(edges.w);
  figures.edgeProduct = uu.greatest() * vv.greatest() * ww.greatest();

  for (int k = 0; k < 2; ++k)
  {
    for (int j = 0; j < 2; ++j)
    {
      for (int i = 0; i < 2; ++i)
      {
        const Number corner = coefficients[bezierIndex(2 * i, 2 * j, 2 * k)];
        const Number product = uu.values[j][k] * vv.values[i][k] * ww.values[i][j];
        const Number scaled = square(corner) / product;
        const bool isFirst = i + j + k == 0;
        figures.leastCorner = isFirst ? corner : lesser(figures.leastCorner, corner);
        figures.greatestCorner = isFirst ? corner : greater(figures.greatestCorner, corner);
        figures.scaledCorner = isFirst ? scaled : lesser(figures.scaledCorner, scaled);
        figures.leastProduct = lesser(figures.leastProduct, product);
        figures.sumOfProducts = figures.sumOfProducts + product;
      }
    }
  }

  figures.leastCoefficient = coefficients[0];
  for (std::size_t i = 1; i < 27; ++i)
  {
    figures.leastCoefficient = lesser(figures.leastCoefficient, coefficients[i]);
  }
  return figures;
}
}

#if defined(__GNUC__)
HexFigures<HexLanes> measureHexes(const double* const (&corners)[8 * HexLanesSize])
{
  Corners<HexLanes> lanes;
  for (std::size_t i = 0; i < 8; ++i)
  {
    const double* first = corners[i];
    const double* second = corners[8 + i];
    lanes[i] = { HexLanes{ first[0], second[0] }, HexLanes{ first[1], second[1] },
      HexLanes{ first[2], second[2] } };
  }
  return figuresOf(lanes);
}
#else
HexFigures<HexLanes> measureHexes(const double* const (&corners)[8 * HexLanesSize])
{
  HexFigures<HexLanes> figures;
  for (int lane = 0; lane < HexLanesSize; ++lane)
  {
    Corners<double> points;
    for (std::size_t i = 0; i < 8; ++i)
    {
      const double* point = corners[8 * static_cast<std::size_t>(lane) + i];
      points[i] = { point[0], point[1], point[2] };
    }
    const HexFigures<double> one = figuresOf(points);
    figures.leastCoefficient[lane] = one.leastCoefficient;
    figures.leastCorner[lane] = one.leastCorner;
    figures.greatestCorner[lane] = one.greatestCorner;
    figures.scaledCorner[lane] = one.scaledCorner;
    figures.scaledCenter[lane] = one.scaledCenter;
    figures.leastProduct[lane] = one.leastProduct;
    figures.sumOfProducts[lane] = one.sumOfProducts;
    figures.edgeProduct[lane] = one.edgeProduct;
  }
  return figures;
}
#endif
}

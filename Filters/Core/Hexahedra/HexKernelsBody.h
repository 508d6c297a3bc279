// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The bodies of HexKernels.h; one file for each instruction set includes them.
 *
 * Everything here and in what is included is in an unnamed namespace or a template of a type that
 * is, so that no two files share a function.
 */
#ifndef hexsweep_HexKernelsBody_h
#define hexsweep_HexKernelsBody_h

#include "Core/Hexahedra/HexKernelsLanes.h"

namespace hexsweep
{
namespace
{
// With its sign.
inline Lanes square(const Lanes& a)
{
  return a * greater(a, -a);
}

inline LanesVector meanOfFour(const LanesVector (&edges)[2][2])
{
  const LanesVector sum = (edges[0][0] + edges[0][1]) + (edges[1][0] + edges[1][1]);
  return { 0.25 * sum.x, 0.25 * sum.y, 0.25 * sum.z };
}

struct SquaredLengths
{
  explicit SquaredLengths(const LanesVector (&edges)[2][2])
  {
    for (int i = 0; i < 2; ++i)
    {
      for (int j = 0; j < 2; ++j)
      {
        this->values[i][j] = dot(edges[i][j], edges[i][j]);
      }
    }
  }

  Lanes greatest() const
  {
    return greater(greater(this->values[0][0], this->values[0][1]),
      greater(this->values[1][0], this->values[1][1]));
  }

  Lanes values[2][2];
};

inline HexFigures<Lanes> figuresOf(const std::array<LanesVector, 8>& corners)
{
  const HexEdges<Lanes> edges = hexEdges(corners);
  const BezierCoefficients<Lanes> coefficients = bezierCoefficients(edges);
  HexFigures<Lanes> figures;

  const LanesVector u = meanOfFour(edges.u);
  const LanesVector v = meanOfFour(edges.v);
  const LanesVector w = meanOfFour(edges.w);
  const Lanes centerProduct = dot(u, u) * dot(v, v) * dot(w, w);
  figures.scaledCenter = square(determinant(u, v, w)) / centerProduct;
  figures.leastProduct = centerProduct;
  figures.sumOfProducts = centerProduct;

  const SquaredLengths uu(edges.u);
  const SquaredLengths vv(edges.v);
  const SquaredLengths ww(edges.w);
  figures.edgeProduct = uu.greatest() * vv.greatest() * ww.greatest();

  for (int k = 0; k < 2; ++k)
  {
    for (int j = 0; j < 2; ++j)
    {
      for (int i = 0; i < 2; ++i)
      {
        const Lanes corner = coefficients[bezierIndex(2 * i, 2 * j, 2 * k)];
        const Lanes product = uu.values[j][k] * vv.values[i][k] * ww.values[i][j];
        const Lanes scaled = square(corner) / product;
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

inline void put(const Lanes& from, int first, HexLanes& to)
{
  for (int i = 0; i < Width; ++i)
  {
    to[first + i] = from.v[i];
  }
}

HexFigures<HexLanes> measure(const double* const* corners)
{
  HexFigures<HexLanes> result;
  for (int first = 0; first < HexLanesSize; first += Width)
  {
    std::array<LanesVector, 8> points;
    for (int i = 0; i < 8; ++i)
    {
      points[static_cast<std::size_t>(i)] = point(corners + 8 * first, i);
    }
    const HexFigures<Lanes> figures = figuresOf(points);
    put(figures.leastCoefficient, first, result.leastCoefficient);
    put(figures.leastCorner, first, result.leastCorner);
    put(figures.greatestCorner, first, result.greatestCorner);
    put(figures.scaledCorner, first, result.scaledCorner);
    put(figures.scaledCenter, first, result.scaledCenter);
    put(figures.leastProduct, first, result.leastProduct);
    put(figures.sumOfProducts, first, result.sumOfProducts);
    put(figures.edgeProduct, first, result.edgeProduct);
  }
  return result;
}

/// HexLoss::Place of each lane.
struct LanesPlace
{
  Lanes value;
  Lanes slope;
  Lanes curvature;
};

inline LanesPlace placeOf(const HexLoss& loss, const Lanes& x)
{
  if (loss.sharpness == 0.0)
  {
    const Lanes rest = spread(1.0) - x;
    return { rest * rest, -2.0 * rest, spread(2.0) };
  }
  LanesPlace places;
  for (int i = 0; i < Width; ++i)
  {
    const HexLoss::Place place = loss.at(x.v[i]);
    places.value.v[i] = place.value;
    places.slope.v[i] = place.slope;
    places.curvature.v[i] = place.curvature;
  }
  return places;
}

/// HexNodeSum of each lane. Corners with an edge of no length add nothing.
struct LanesSum
{
  Lanes value = spread(0.0);
  Lanes gradient[3] = { spread(0.0), spread(0.0), spread(0.0) };
  Lanes curvature[6] = { spread(0.0), spread(0.0), spread(0.0), spread(0.0), spread(0.0),
    spread(0.0) };

  void addValue(const HexLoss& loss, const Lanes& jacobian, const Lanes& lengths)
  {
    this->value = this->value + wherePositive(lengths, placeOf(loss, jacobian).value);
  }

  /// @param slope of the scaled Jacobian by the node's place.
  /// @param stiffness the scaled Jacobian falls about quadratically as an arm turns away from its
  ///        best place: the sum of the arms' squared inverse lengths.
  void add(const HexLoss& loss, const Lanes& jacobian, const Lanes& lengths,
    const LanesVector& slope, const Lanes& stiffness)
  {
    const LanesPlace place = placeOf(loss, jacobian);
    this->value = this->value + wherePositive(lengths, place.value);
    const Lanes s[3] = { wherePositive(lengths, slope.x), wherePositive(lengths, slope.y),
      wherePositive(lengths, slope.z) };
    const Lanes placeSlope = wherePositive(lengths, place.slope);
    const Lanes placeCurvature = wherePositive(lengths, place.curvature);
    const Lanes turn =
      wherePositive(lengths, placeSlope * greater(jacobian, spread(0.0)) * stiffness);
    int entry = 0;
    for (int i = 0; i < 3; ++i)
    {
      this->gradient[i] = this->gradient[i] + placeSlope * s[i];
      const Lanes weighted = placeCurvature * s[i];
      this->curvature[entry] = this->curvature[entry] - turn;
      for (int j = i; j < 3; ++j, ++entry)
      {
        this->curvature[entry] = this->curvature[entry] + weighted * s[j];
      }
    }
  }
};

struct Arm
{
  explicit Arm(const LanesVector& from, const LanesVector& to)
    : vector(to - from)
    , squared(dot(vector, vector))
    , length(root(squared))
  {
  }
  LanesVector vector;
  Lanes squared;
  Lanes length;
};

/// A corner at the far end of an edge from the node: that edge, and its two others, so that the
/// three are right-handed.
template <bool WithSlopes>
inline void addFarCorner(const HexLoss& loss, const Arm& own, const Lanes& inverse, const Arm& p,
  const Arm& q, LanesSum& sum)
{
  const Lanes lengths = own.length * p.length * q.length;
  const LanesVector normal = cross(p.vector, q.vector);
  const Lanes scale = spread(1.0) / lengths;
  // The edge leads away from the node.
  const Lanes jacobian = -scale * dot(own.vector, normal);
  if constexpr (WithSlopes)
  {
    sum.add(loss, jacobian, lengths, scale * normal + (jacobian * inverse) * own.vector, inverse);
  }
  else
  {
    sum.addValue(loss, jacobian, lengths);
  }
}

template <bool WithSlopes>
inline void addNearCorner(
  const HexLoss& loss, const Arm (&arm)[3], const Lanes (&inverse)[3], LanesSum& sum)
{
  const Lanes lengths = arm[0].length * arm[1].length * arm[2].length;
  const Lanes scale = spread(1.0) / lengths;
  const LanesVector normal = cross(arm[1].vector, arm[2].vector);
  const Lanes jacobian = scale * dot(arm[0].vector, normal);
  if constexpr (WithSlopes)
  {
    const LanesVector normals =
      normal + (cross(arm[2].vector, arm[0].vector) + cross(arm[0].vector, arm[1].vector));
    const LanesVector turns =
      inverse[0] * arm[0].vector + (inverse[1] * arm[1].vector + inverse[2] * arm[2].vector);
    sum.add(loss, jacobian, lengths, jacobian * turns - scale * normals,
      inverse[0] + (inverse[1] + inverse[2]));
  }
  else
  {
    sum.addValue(loss, jacobian, lengths);
  }
}

template <bool WithSlopes>
inline void addHexes(const double* const* corners, const HexLoss& loss, LanesSum& sum)
{
  const LanesVector node = point(corners, 0);
  const LanesVector x1 = point(corners, 1);
  const LanesVector x3 = point(corners, 3);
  const LanesVector x4 = point(corners, 4);
  const LanesVector x2 = point(corners, 2);
  const LanesVector x5 = point(corners, 5);
  const LanesVector x7 = point(corners, 7);
  const Arm arm[3] = { Arm(node, x1), Arm(node, x3), Arm(node, x4) };
  Lanes inverse[3] = {};
  if constexpr (WithSlopes)
  {
    for (int i = 0; i < 3; ++i)
    {
      inverse[i] = spread(1.0) / arm[i].squared;
    }
  }
  addFarCorner<WithSlopes>(loss, arm[0], inverse[0], Arm(x1, x5), Arm(x1, x2), sum);
  addFarCorner<WithSlopes>(loss, arm[1], inverse[1], Arm(x3, x2), Arm(x3, x7), sum);
  addFarCorner<WithSlopes>(loss, arm[2], inverse[2], Arm(x4, x7), Arm(x4, x5), sum);
  addNearCorner<WithSlopes>(loss, arm, inverse, sum);
}

inline double total(const HexLanes& lanes)
{
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

HexNodeSum sum(const double* const* corners, int batches, const HexLoss& loss)
{
  HexLanes lanes[10];
  for (int first = 0; first < HexLanesSize; first += Width)
  {
    LanesSum sum;
    for (int batch = 0; batch < batches; ++batch)
    {
      addHexes<true>(corners + 8 * (batch * HexLanesSize + first), loss, sum);
    }
    put(sum.value, first, lanes[0]);
    for (int i = 0; i < 3; ++i)
    {
      put(sum.gradient[i], first, lanes[1 + i]);
    }
    for (int i = 0; i < 6; ++i)
    {
      put(sum.curvature[i], first, lanes[4 + i]);
    }
  }
  HexNodeSum result;
  result.value = total(lanes[0]);
  for (int i = 0; i < 3; ++i)
  {
    result.gradient[i] = total(lanes[1 + i]);
  }
  for (int i = 0; i < 6; ++i)
  {
    result.curvature[i] = total(lanes[4 + i]);
  }
  return result;
}

double value(const double* const* corners, int batches, const HexLoss& loss)
{
  HexLanes lanes;
  for (int first = 0; first < HexLanesSize; first += Width)
  {
    LanesSum sum;
    for (int batch = 0; batch < batches; ++batch)
    {
      addHexes<false>(corners + 8 * (batch * HexLanesSize + first), loss, sum);
    }
    put(sum.value, first, lanes);
  }
  return total(lanes);
}

constexpr HexKernels makeHexKernels(const char* name)
{
  return { name, measure, sum, value };
}
}
}

#endif

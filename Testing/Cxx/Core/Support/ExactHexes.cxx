// SPDX-License-Identifier: BSD-3-Clause
#include "Support/ExactHexes.h"

#include "Support/HexSamples.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace test
{
namespace
{
constexpr int IntervalBoxes = 73;
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A number between two others; each operation rounds outwards by more than it may have erred.
struct Interval
{
  double low = 0.0;
  double high = 0.0;

  Interval() = default;
  Interval(double exact)
    : low(exact)
    , high(exact)
  {
  }
  Interval(double least, double most)
    : low(std::isfinite(least) ? least - widthOf(least) : -Infinity)
    , high(std::isfinite(most) ? most + widthOf(most) : Infinity)
  {
  }

  static double widthOf(double value)
  {
    return std::abs(value) * 0x1p-51 + 4.0 * std::numeric_limits<double>::denorm_min();
  }
};

Interval operator+(const Interval& a, const Interval& b)
{
  return { a.low + b.low, a.high + b.high };
}

Interval operator-(const Interval& a, const Interval& b)
{
  return { a.low - b.high, a.high - b.low };
}

Interval operator*(const Interval& a, const Interval& b)
{
  const double products[] = { a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high };
  if (std::any_of(std::begin(products), std::end(products), [](double p) { return std::isnan(p); }))
  {
    return { -Infinity, Infinity };
  }
  return { *std::min_element(std::begin(products), std::end(products)),
    *std::max_element(std::begin(products), std::end(products)) };
}

Truth signOf(const Interval& value)
{
  return value.low > 0.0 ? Truth::Positive
    : value.high <= 0.0  ? Truth::NotPositive
                         : Truth::Unknown;
}

/// Of any length; most are short enough to need no memory of their own.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<512>>;

Truth signOf(const Integer& value)
{
  return value > 0 ? Truth::Positive : Truth::NotPositive;
}

template <typename Number>
using Coordinates = std::array<std::array<Number, 3>, 8>;

Coordinates<Interval> inIntervals(const HexCorners& corners)
{
  Coordinates<Interval> result;
  for (int i = 0; i < 8; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      result[static_cast<std::size_t>(i)][static_cast<std::size_t>(c)] = Interval(corners(i, c));
    }
  }
  return result;
}

/// Times the power of two that makes whole numbers of them all.
Coordinates<Integer> inIntegers(const HexCorners& corners)
{
  constexpr int Digits = std::numeric_limits<double>::digits;
  int least = std::numeric_limits<int>::max();
  for (Eigen::Index i = 0; i < corners.size(); ++i)
  {
    int exponent = 0;
    if (std::frexp(corners.data()[i], &exponent) != 0.0)
    {
      least = std::min(least, exponent - Digits);
    }
  }
  Coordinates<Integer> result;
  for (int i = 0; i < 8; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      int exponent = 0;
      const double fraction = std::frexp(corners(i, c), &exponent);
      Integer whole = static_cast<std::int64_t>(std::ldexp(fraction, Digits));
      if (whole != 0)
      {
        whole <<= exponent - Digits - least;
      }
      result[static_cast<std::size_t>(i)][static_cast<std::size_t>(c)] = whole;
    }
  }
  return result;
}

/// Places along an axis in halves, and the corners in VTK_HEXAHEDRON order by the same.
constexpr std::array<std::array<int, 3>, 8> CornerPlaces = { { { 0, 0, 0 }, { 2, 0, 0 },
  { 2, 2, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 2 } } };

/// 64 times the Jacobian at (u, v, w) / 2.
template <typename Number>
Number jacobianAtHalves(const Coordinates<Number>& corners, const std::array<int, 3>& at)
{
  std::array<std::array<Number, 3>, 3> slopes;
  for (std::size_t d = 0; d < 3; ++d)
  {
    const std::size_t e = (d + 1) % 3;
    const std::size_t f = (d + 2) % 3;
    for (std::size_t c = 0; c < 3; ++c)
    {
      Number sum(0);
      for (std::size_t i = 0; i < 8; ++i)
      {
        // The shape function of a corner, times 2 in each of the other directions.
        const auto share = [&](std::size_t axis) {
          return CornerPlaces[i][axis] == 2 ? at[axis] : 2 - at[axis];
        };
        const int weight = share(e) * share(f);
        if (weight == 0)
        {
          continue;
        }
        const Number term = Number(weight) * corners[i][c];
        sum = CornerPlaces[i][d] == 2 ? Number(sum + term) : Number(sum - term);
      }
      slopes[d][c] = sum;
    }
  }
  const auto minor = [&](std::size_t a, std::size_t b) {
    return Number(slopes[1][a] * slopes[2][b] - slopes[1][b] * slopes[2][a]);
  };
  return slopes[0][0] * minor(1, 2) - slopes[0][1] * minor(0, 2) + slopes[0][2] * minor(0, 1);
}

/// Of a polynomial of degree 2 in each direction, u fastest.
template <typename Number>
using Lattice = std::array<Number, 27>;

/// Applies a change of three numbers along one direction of a lattice.
template <typename Number, typename Change>
void alongAxis(Lattice<Number>& lattice, std::size_t stride, const Change& change)
{
  for (std::size_t i = 0; i < 27; ++i)
  {
    if (i / stride % 3 == 0)
    {
      change(lattice[i], lattice[i + stride], lattice[i + 2 * stride]);
    }
  }
}

/// Bernstein coefficients, times a positive number.
template <typename Number>
Lattice<Number> bernsteinOf(const Coordinates<Number>& corners)
{
  Lattice<Number> lattice;
  for (int i = 0; i < 27; ++i)
  {
    lattice[static_cast<std::size_t>(i)] = jacobianAtHalves(corners, { i % 3, i / 3 % 3, i / 9 });
  }
  for (const std::size_t stride : { 1, 3, 9 })
  {
    alongAxis(lattice, stride, [](Number& first, Number& middle, Number& last) {
      middle = Number(4) * middle - first - last;
      first = Number(2) * first;
      last = Number(2) * last;
    });
  }
  return lattice;
}

template <typename Number>
Truth signOfCorners(const Lattice<Number>& lattice)
{
  Truth all = Truth::Positive;
  for (const std::size_t i : { 0, 2, 6, 8, 18, 20, 24, 26 })
  {
    const Truth one = signOf(lattice[i]);
    if (one == Truth::NotPositive)
    {
      return one;
    }
    all = one == Truth::Unknown ? one : all;
  }
  return all;
}

/// The two halves along one direction, times 4.
template <typename Number>
std::array<Lattice<Number>, 2> halves(const Lattice<Number>& lattice, std::size_t stride)
{
  std::array<Lattice<Number>, 2> result = { lattice, lattice };
  alongAxis(result[0], stride, [](Number& first, Number& middle, Number& last) {
    last = first + Number(2) * middle + last;
    middle = Number(2) * (first + middle);
    first = Number(4) * first;
  });
  alongAxis(result[1], stride, [](Number& first, Number& middle, Number& last) {
    first = first + Number(2) * middle + last;
    middle = Number(2) * (middle + last);
    last = Number(4) * last;
  });
  return result;
}

template <typename Number>
Truth decide(const Lattice<Number>& whole, int boxes)
{
  std::vector<Lattice<Number>> open = { whole };
  bool isSure = true;
  for (std::size_t next = 0; next < open.size(); ++next)
  {
    if (static_cast<int>(next) >= boxes)
    {
      return Truth::Unknown;
    }
    const Lattice<Number> box = std::move(open[next]);
    const Truth corners = signOfCorners(box);
    if (corners == Truth::NotPositive)
    {
      return corners;
    }
    const bool isPositive = std::all_of(
      box.begin(), box.end(), [](const Number& value) { return signOf(value) == Truth::Positive; });
    if (isPositive)
    {
      continue;
    }
    if (corners == Truth::Unknown)
    {
      isSure = false; // no smaller box will tell, but one may be negative
      continue;
    }
    for (const Lattice<Number>& u : halves(box, 1))
    {
      for (const Lattice<Number>& v : halves(u, 3))
      {
        for (Lattice<Number>& w : halves(v, 9))
        {
          open.push_back(std::move(w));
        }
      }
    }
  }
  return isSure ? Truth::Positive : Truth::Unknown;
}
}

HexTruth truthOf(const HexCorners& corners, int boxes)
{
  HexTruth truth;
  const Lattice<Interval> rough = bernsteinOf(inIntervals(corners));
  const Truth roughCorners = signOfCorners(rough);
  truth.everywhere = decide(rough, IntervalBoxes);
  truth.byIntervals = truth.everywhere != Truth::Unknown && roughCorners != Truth::Unknown;
  truth.positiveCorners = roughCorners == Truth::Positive;
  if (!truth.byIntervals)
  {
    const Lattice<Integer> exact = bernsteinOf(inIntegers(corners));
    truth.positiveCorners = signOfCorners(exact) == Truth::Positive;
    truth.everywhere = decide(exact, boxes);
  }
  return truth;
}

Truth truthEverywhere(const HexCorners& corners, int boxes)
{
  const Truth rough = decide(bernsteinOf(inIntervals(corners)), IntervalBoxes);
  return rough == Truth::Unknown ? decide(bernsteinOf(inIntegers(corners)), boxes) : rough;
}

namespace
{
using Generator = std::mt19937;

double uniform(Generator& generator, double from, double to)
{
  return std::uniform_real_distribution<double>(from, to)(generator);
}

int whole(Generator& generator, int from, int to)
{
  return std::uniform_int_distribution<int>(from, to)(generator);
}

HexCorners filled(const std::function<double()>& value)
{
  HexCorners corners;
  for (Eigen::Index i = 0; i < corners.size(); ++i)
  {
    corners.data()[i] = value();
  }
  return corners;
}

/// Some last bits more or less.
double nudged(double value, int steps)
{
  const double to = std::copysign(std::numeric_limits<double>::infinity(), steps);
  for (int i = 0; i < std::abs(steps); ++i)
  {
    value = std::nextafter(value, to);
  }
  return value;
}

/// One corner in the plane of its neighbours, as far as rounding allows, then moved by some last
/// bits.
HexCorners withFlatCorner(Generator& generator)
{
  constexpr int Neighbors[8][3] = { { 1, 3, 4 }, { 0, 2, 5 }, { 1, 3, 6 }, { 0, 2, 7 }, { 0, 5, 7 },
    { 1, 4, 6 }, { 2, 5, 7 }, { 3, 4, 6 } };
  HexCorners corners = shakenCube(uniform(generator, 0.0, 0.2), generator);
  const int corner = whole(generator, 0, 7);
  const int* around = Neighbors[corner];
  const double a = uniform(generator, 0.2, 0.5);
  const double b = uniform(generator, 0.2, 0.5);
  corners.row(corner) = a * corners.row(around[0]) + b * corners.row(around[1]) +
    (1.0 - a - b) * corners.row(around[2]);
  double& coordinate = corners(corner, whole(generator, 0, 2));
  coordinate = nudged(coordinate, whole(generator, -3, 3));
  return corners;
}

/// Between a good hexahedron and any other, where Core's certificate ends, give or take some last
/// bits.
HexCorners onTheEdge(Generator& generator)
{
  const HexCorners good = shakenCube(0.1, generator);
  const HexCorners other = whole(generator, 0, 1) == 0
    ? shakenCube(1.0, generator)
    : HexCorners(filled([&] { return uniform(generator, -1.0, 2.0); }));
  const auto between = [&](double t) { return HexCorners(good + t * (other - good)); };
  const auto isGood = [&](double t) {
    return hexsweep::certifyHex(between(t)).validity == hexsweep::Validity::Certified;
  };
  // To the last bit it costs a thousand verdicts elsewhere.
  const int steps = whole(generator, 0, 7) == 0 ? 54 : 20;
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < steps; ++i)
  {
    const double middle = 0.5 * (low + high);
    (isGood(middle) ? low : high) = middle;
  }
  return between(nudged(high, whole(generator, -2, 2)));
}

HexCorners slender(Generator& generator)
{
  HexCorners corners = shakenCube(0.5, generator);
  for (int c = 0; c < 3; ++c)
  {
    corners.col(c) *= std::pow(10.0, uniform(generator, -12.0, 0.0));
  }
  return corners;
}

HexCorners collapsed(Generator& generator)
{
  HexCorners corners = shakenCube(0.3, generator);
  const int from = whole(generator, 0, 7);
  const int to = whole(generator, 0, 7);
  const int third = whole(generator, 0, 7);
  corners.row(from) = whole(generator, 0, 1) == 0
    ? Eigen::RowVector3d(corners.row(to))
    : Eigen::RowVector3d(0.5 * (corners.row(to) + corners.row(third)));
  return corners;
}

HexCorners ofSpecialNumbers(Generator& generator)
{
  constexpr double Values[] = { 0.0, -0.0, 1.0, -1.0, 0.5, 1e-15, 1.0 + 0x1p-52, 1e300, -1e300,
    1e150, 1e-150, 1e-300, std::numeric_limits<double>::denorm_min(), 1e16, 3.0 };
  const HexCorners cube = unitCube();
  HexCorners corners = filled([&] { return Values[whole(generator, 0, 14)]; });
  // Half of them not beyond hope.
  if (whole(generator, 0, 1) == 0)
  {
    for (Eigen::Index i = 0; i < corners.size(); ++i)
    {
      corners.data()[i] = whole(generator, 0, 5) == 0 ? corners.data()[i] : cube.data()[i];
    }
  }
  return corners;
}

HexCorners plainHex(int kind, Generator& generator)
{
  switch (kind)
  {
    case 0:
      return filled([&] { return uniform(generator, -1.0, 1.0); });
    case 1:
      return shakenCube(uniform(generator, 0.0, 0.7), generator);
    case 2:
      return randomHex(generator);
    case 3:
      return filled([&] { return static_cast<double>(whole(generator, -3, 3)); });
    case 4:
      return withFlatCorner(generator);
    case 5:
      return onTheEdge(generator);
    case 6:
      return slender(generator);
    case 7:
      return collapsed(generator);
    case 8:
      return ofSpecialNumbers(generator);
    default:
      return filled(
        [&] { return std::ldexp(uniform(generator, -1.0, 1.0), whole(generator, -200, 200)); });
  }
}
}

HexCorners adversarialHex(std::uint64_t number)
{
  std::seed_seq seed = { static_cast<std::uint32_t>(number),
    static_cast<std::uint32_t>(number >> 32) };
  Generator generator(seed);
  const int kind = static_cast<int>(number % AdversarialKinds);
  if (kind <= 9)
  {
    return plainHex(kind, generator);
  }
  const HexCorners plain = plainHex(whole(generator, 0, 6), generator);
  switch (kind)
  {
    case 10: // far away
      return plain.array() + std::pow(10.0, uniform(generator, 2.0, 15.0));
    case 11: // huge or tiny
      return plain * std::ldexp(1.0, whole(generator, -330, 330));
    case 12: // left-handed
      return plain.cwiseProduct(HexCorners(Eigen::RowVector3d(1.0, -1.0, 1.0).replicate(8, 1)));
    default: // as a grid in single precision holds it
      return plain.cast<float>().cast<double>();
  }
}
}

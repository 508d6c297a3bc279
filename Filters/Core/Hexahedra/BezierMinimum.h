// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The minimum of a polynomial in Bezier form, by bisection of the cube.
 */
#ifndef hexsweep_BezierMinimum_h
#define hexsweep_BezierMinimum_h

#include "Core/Hexahedra/BezierHex.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hexsweep
{
/// What is known of the minimum of a Jacobian over the cube; `lowerBound <= minimum <= sample`, but
/// for rounding.
struct JacobianMinimum
{
  double lowerBound;
  /// The least value found at a point.
  double sample;
};

/// The bound is refined until it is within this fraction of the least value found.
constexpr double JacobianBoundTolerance = 0.01;
/// ... or so many bisections have been made.
constexpr int GreatestNumberOfBisections = 400;
/// Exact numbers take a thousand times as long.
constexpr int GreatestNumberOfExactBisections = 100;

/// The value rounded, with the exact sign.
inline double toDouble(double value)
{
  return value;
}

/// The part of a Jacobian over a box in the cube.
template <typename Number>
struct BezierBox
{
  explicit BezierBox(const BezierCoefficients<Number>& numbers)
    : coefficients(numbers)
  {
    for (std::size_t i = 0; i < 27; ++i)
    {
      this->rounded[i] = toDouble(numbers[i]);
    }
    this->lowerBound = *std::min_element(this->rounded.begin(), this->rounded.end());
    this->sample = this->rounded[0];
    for (const std::size_t corner : { 2, 6, 8, 18, 20, 24, 26 })
    {
      this->sample = std::min(this->sample, this->rounded[corner]);
    }
  }

  /// The direction (1 for u, 3 for v, 9 for w) in which the control net is bent most.
  std::size_t mostBentDirection() const
  {
    std::size_t direction = 1;
    double most = -1.0;
    for (const std::size_t step : { 1, 3, 9 })
    {
      double bend = 0.0;
      for (std::size_t i = 0; i < 27; ++i)
      {
        if (i / step % 3 == 1)
        {
          bend = std::max(bend,
            std::abs((this->rounded[i - step] - this->rounded[i]) +
              (this->rounded[i + step] - this->rounded[i])));
        }
      }
      if (bend > most)
      {
        most = bend;
        direction = step;
      }
    }
    return direction;
  }

  /// One half of the box (de Casteljau): the lower one or the upper one.
  BezierBox half(std::size_t direction, bool upper) const
  {
    BezierCoefficients<Number> part = this->coefficients;
    for (std::size_t i = 0; i < 27; ++i)
    {
      if (i / direction % 3 == 1)
      {
        const Number& middle = this->coefficients[i];
        const Number low = 0.5 * (this->coefficients[i - direction] + middle);
        const Number high = 0.5 * (middle + this->coefficients[i + direction]);
        part[i] = upper ? high : low;
        part[upper ? i - direction : i + direction] = 0.5 * (low + high);
      }
    }
    return BezierBox(part);
  }

  BezierCoefficients<Number> coefficients;
  std::array<double, 27> rounded;
  double lowerBound;
  double sample;
};

/**
 * Bounds the minimum over the cube, the box with the least bound first.
 *
 * @param coefficients of a hexahedron's Jacobian.
 * @param error bound of the rounding error of each coefficient, 0 for exact ones.
 * @return lowerBound > error proves that the Jacobian is positive, sample < -error (or sample <= 0
 *         where error is 0) that it is not; else rounding or the number of bisections does not
 * allow to tell. Both within JacobianBoundTolerance of each other where the number of bisections
 *         allows it.
 */
template <typename Number>
JacobianMinimum boundMinimum(const BezierCoefficients<Number>& coefficients, double error)
{
  const auto isGreater = [](const BezierBox<Number>& a, const BezierBox<Number>& b) {
    return a.lowerBound > b.lowerBound;
  };
  const int bisections = error > 0.0 ? GreatestNumberOfBisections : GreatestNumberOfExactBisections;
  std::vector<BezierBox<Number>> boxes{ BezierBox<Number>(coefficients) };
  double sample = boxes.front().sample;
  for (int bisection = 0; bisection < bisections; ++bisection)
  {
    const double lowerBound = boxes.front().lowerBound;
    const bool isTight = sample - lowerBound <= JacobianBoundTolerance * std::abs(sample);
    const bool isLost = std::abs(sample) <= error && sample - lowerBound <= error;
    if ((isTight && (lowerBound > error || sample <= error)) || isLost)
    {
      break;
    }
    std::pop_heap(boxes.begin(), boxes.end(), isGreater);
    const BezierBox<Number> box = std::move(boxes.back());
    boxes.pop_back();
    const std::size_t direction = box.mostBentDirection();
    for (const bool upper : { false, true })
    {
      boxes.push_back(box.half(direction, upper));
      sample = std::min(sample, boxes.back().sample);
      std::push_heap(boxes.begin(), boxes.end(), isGreater);
    }
  }
  return { boxes.front().lowerBound, sample };
}
}

#endif

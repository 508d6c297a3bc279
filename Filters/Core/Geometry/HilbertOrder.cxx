// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/HilbertOrder.h"

#include "Core/Common/Errors.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr unsigned BitsPerStep = 4;
constexpr unsigned StepValues = 1u << BitsPerStep;
constexpr double CellsPerSide = 65536.0;

/// How the curve runs through a sub-square: as through the whole square after its coordinates have
/// been exchanged (bit 0) and reversed (bit 1).
constexpr unsigned Exchanged = 1;
constexpr unsigned Reversed = 2;

/// Key of four levels at once, and how the curve runs through the sub-square reached.
struct Step
{
  std::uint8_t key;
  std::uint8_t state;
};

constexpr Step stepThrough(unsigned state, unsigned x, unsigned y)
{
  unsigned key = 0;
  for (unsigned level = BitsPerStep; level-- > 0;)
  {
    const unsigned bitX = (x >> level) & 1u;
    const unsigned bitY = (y >> level) & 1u;
    const unsigned reversed = (state & Reversed) ? 1u : 0u;
    const unsigned u = ((state & Exchanged) ? bitY : bitX) ^ reversed;
    const unsigned v = ((state & Exchanged) ? bitX : bitY) ^ reversed;
    // Lower left, upper left, upper right, lower right.
    key = (key << 2) | ((3u * u) ^ v);
    if (v == 0)
    {
      state ^= Exchanged | (u == 1 ? Reversed : 0u);
    }
  }
  return { static_cast<std::uint8_t>(key), static_cast<std::uint8_t>(state) };
}

constexpr std::array<Step, 4 * StepValues * StepValues> makeSteps()
{
  std::array<Step, 4 * StepValues * StepValues> steps{};
  for (unsigned i = 0; i < steps.size(); ++i)
  {
    steps[i] = stepThrough(i >> (2 * BitsPerStep), (i >> BitsPerStep) % StepValues, i % StepValues);
  }
  return steps;
}

constexpr std::array<Step, 4 * StepValues* StepValues> Steps = makeSteps();

/// NaN counts as 0.
std::uint32_t cellOf(double place)
{
  return place > 0.0 ? static_cast<std::uint32_t>(std::min(place, CellsPerSide - 1.0)) : 0u;
}

/// Stable; leaves the result in `places`.
void sortByKey(std::vector<CurvePlace>& places)
{
  constexpr unsigned DigitBits = 11;
  constexpr std::uint32_t DigitMask = (1u << DigitBits) - 1;
  constexpr std::size_t Passes = 3;
  std::array<std::array<std::uint32_t, DigitMask + 1>, Passes> starts{};
  for (const CurvePlace& place : places)
  {
    for (std::size_t pass = 0; pass < Passes; ++pass)
    {
      ++starts[pass][(place.key >> (pass * DigitBits)) & DigitMask];
    }
  }
  std::vector<CurvePlace> sorted(places.size());
  for (std::size_t pass = 0; pass < Passes; ++pass)
  {
    std::uint32_t start = 0;
    for (std::uint32_t& count : starts[pass])
    {
      start += std::exchange(count, start);
    }
    for (const CurvePlace& place : places)
    {
      sorted[starts[pass][(place.key >> (pass * DigitBits)) & DigitMask]++] = place;
    }
    places.swap(sorted);
  }
}
}

HilbertCurve::HilbertCurve(const PlanePointsRef& points)
{
  constexpr double Largest = std::numeric_limits<double>::max();
  double low[2] = { Largest, Largest };
  double high[2] = { -Largest, -Largest };
  for (Index i = 0; i < points.rows(); ++i)
  {
    for (Index c = 0; c < 2; ++c)
    {
      const double value = points(i, c);
      // False for what is not finite.
      if (value - value == 0.0)
      {
        low[c] = std::min(low[c], value);
        high[c] = std::max(high[c], value);
      }
    }
  }
  if (low[0] <= high[0] && low[1] <= high[1])
  {
    this->LowX = low[0];
    this->LowY = low[1];
    const double size = std::max(high[0] - low[0], high[1] - low[1]);
    this->CellsPerUnit = size > 0.0 ? CellsPerSide / size : 0.0;
  }
}

std::uint32_t HilbertCurve::key(double x, double y) const
{
  const std::uint32_t cellX = cellOf((x - this->LowX) * this->CellsPerUnit);
  const std::uint32_t cellY = cellOf((y - this->LowY) * this->CellsPerUnit);
  std::uint32_t key = 0;
  std::uint32_t state = 0;
  for (unsigned shift = 16; shift > 0;)
  {
    shift -= BitsPerStep;
    const Step step =
      Steps[(((state << BitsPerStep) | ((cellX >> shift) % StepValues)) << BitsPerStep) |
        ((cellY >> shift) % StepValues)];
    key = (key << (2 * BitsPerStep)) | step.key;
    state = step.state;
  }
  return key;
}

std::vector<CurvePlace> hilbertOrder(const HilbertCurve& curve, const PlanePointsRef& points)
{
  if (points.rows() >= static_cast<Index>(std::numeric_limits<std::uint32_t>::max()))
  {
    throw InvalidInput("there are " + std::to_string(points.rows()) +
      " points; at most 2^32 - 2 can be located at once. Coarsen the mesh.");
  }
  std::vector<CurvePlace> places(static_cast<std::size_t>(points.rows()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const Index row = static_cast<Index>(i);
    places[i] = { curve.key(points(row, 0), points(row, 1)), static_cast<std::uint32_t>(i) };
  }
  sortByKey(places);
  return places;
}
}

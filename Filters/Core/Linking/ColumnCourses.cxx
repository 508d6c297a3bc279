// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/ColumnCourses.h"

#include "Core/Common/StandardIndex.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr Index CourseHeights = 17; // 0 and 1 among them
constexpr Index RingSamples = 256;  // of a ring, at the least

/// A ring of one height: length that is passed at places of rising v, from column 0 round to it.
struct MeasuredRing
{
  std::vector<double> v;
  std::vector<double> passed;

  double length() const { return this->passed.back(); }

  /// v where so much is passed; rings go on beyond their ends.
  double at(double passedLength) const
  {
    const double rounds = std::floor(passedLength / this->length());
    const double rest = passedLength - rounds * this->length();
    const auto after = std::upper_bound(this->passed.begin() + 1, this->passed.end() - 1, rest);
    const std::size_t k = static_cast<std::size_t>(after - this->passed.begin());
    const double step = this->passed[k] - this->passed[k - 1];
    const double along = step > 0.0 ? (rest - this->passed[k - 1]) / step : 0.0;
    return rounds + this->v[k - 1] + along * (this->v[k] - this->v[k - 1]);
  }
};

/// @param places v of the columns, and that of the first one a round later.
/// @param samples of the way from column to column.
MeasuredRing measureRing(
  const StripSearch& search, double u, const std::vector<double>& places, Index samples)
{
  MeasuredRing ring;
  Eigen::RowVector3d last = search.at(places.front(), u).point;
  ring.v.push_back(places.front());
  ring.passed.push_back(0.0);
  for (std::size_t j = 0; j + 1 < places.size(); ++j)
  {
    for (Index i = 1; i <= samples; ++i)
    {
      const double v = places[j] +
        (places[j + 1] - places[j]) * static_cast<double>(i) / static_cast<double>(samples);
      const Eigen::RowVector3d here = search.at(v, u).point;
      ring.v.push_back(v);
      ring.passed.push_back(ring.passed.back() + (here - last).norm());
      last = here;
    }
  }
  return ring;
}

/// What a ring divided by length is ahead of its places, in the mean over its length.
double meanAhead(const MeasuredRing& ring)
{
  double sum = 0.0;
  for (std::size_t k = 1; k < ring.v.size(); ++k)
  {
    const double share = (ring.passed[k] - ring.passed[k - 1]) / ring.length();
    const double ahead = 0.5 * (ring.v[k - 1] + ring.v[k]) - ring.v.front() -
      0.5 * (ring.passed[k - 1] + ring.passed[k]) / ring.length();
    sum += share * ahead;
  }
  return sum;
}

/// v of the columns when they share the ring by length.
std::vector<double> sharedOut(const MeasuredRing& ring, const std::vector<double>& places,
  const std::vector<bool>& isHeld, Index samples)
{
  const std::size_t n = isHeld.size();
  std::vector<double> shared(n);
  const auto first = std::find(isHeld.begin(), isHeld.end(), true);
  if (first == isHeld.end())
  {
    const double ahead = meanAhead(ring);
    for (std::size_t j = 0; j < n; ++j)
    {
      shared[j] = ring.at((places[j] - places.front() - ahead) * ring.length());
    }
    return shared;
  }
  // Round the ring from a held column to the next one; j beyond n is a round later.
  const auto placeOf = [&](std::size_t j) { return places[j % n] + (j >= n ? 1.0 : 0.0); };
  const auto passedAt = [&](std::size_t j) {
    return ring.passed[(j % n) * static_cast<std::size_t>(samples)] +
      (j >= n ? ring.length() : 0.0);
  };
  std::size_t from = static_cast<std::size_t>(first - isHeld.begin());
  const std::size_t last = from + n;
  while (from < last)
  {
    std::size_t to = from + 1;
    while (!isHeld[to % n])
    {
      ++to;
    }
    const double way = placeOf(to) - placeOf(from);
    for (std::size_t j = from; j < to; ++j)
    {
      const double share = (placeOf(j) - placeOf(from)) / way;
      const double v =
        j == from ? placeOf(j) : ring.at(passedAt(from) + share * (passedAt(to) - passedAt(from)));
      shared[j % n] = v - (j >= n ? 1.0 : 0.0);
    }
    from = to;
  }
  return shared;
}
}

double ColumnCourses::at(std::size_t column, double u) const
{
  const double straight = (1.0 - u) * this->begin[column] + u * this->end[column];
  if (this->aside.cols() == 0)
  {
    return straight;
  }
  const auto own = this->aside.row(static_cast<Index>(column));
  const double place = u * static_cast<double>(own.size() - 1);
  const Index below = std::min(static_cast<Index>(place), own.size() - 2);
  const double along = place - static_cast<double>(below);
  return straight + (1.0 - along) * own[below] + along * own[below + 1];
}

Eigen::MatrixXd asideByLength(
  const StripSearch& search, const ColumnCourses& courses, const std::vector<bool>& isHeld)
{
  const std::size_t n = courses.size();
  const Index samples =
    std::max<Index>(2, (RingSamples + static_cast<Index>(n) - 1) / static_cast<Index>(n));
  Eigen::MatrixXd aside = Eigen::MatrixXd::Zero(static_cast<Index>(n), CourseHeights);
  for (Index h = 1; h + 1 < CourseHeights; ++h)
  {
    const double u = static_cast<double>(h) / static_cast<double>(CourseHeights - 1);
    std::vector<double> places;
    for (std::size_t j = 0; j < n; ++j)
    {
      places.push_back((1.0 - u) * courses.begin[j] + u * courses.end[j]);
    }
    places.push_back(places.front() + 1.0);
    const std::vector<double> shared =
      sharedOut(measureRing(search, u, places, samples), places, isHeld, samples);
    for (std::size_t j = 0; j < n; ++j)
    {
      aside(static_cast<Index>(j), h) = shared[j] - places[j];
    }
  }
  return aside;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzInput.h"

#include "Core/Common/Errors.h"

#include <cmath>
#include <cstring>
#include <ctime>
#include <iterator>
#include <limits>

namespace fuzz
{
Index Input::whole(Index from, Index to)
{
  const auto span = static_cast<std::uint64_t>(to - from) + 1;
  std::uint64_t value = this->byte();
  if (span > 256)
  {
    value = value << 8 | this->byte();
  }
  return from + static_cast<Index>(value % span);
}

Index Input::count(Index few, Index many)
{
  return this->whole(1, this->rarely(16) ? many : few);
}

double Input::share()
{
  const int high = this->byte();
  return static_cast<double>(high << 8 | this->byte()) / 65535.0;
}

double Input::bits()
{
  std::uint8_t bytes[sizeof(double)];
  for (std::uint8_t& one : bytes)
  {
    one = this->byte();
  }
  double value = 0.0;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

double Input::special()
{
  constexpr double Numbers[] = { 0.0, -0.0, 1.0, -1.0, 1e-15, 1e15, 1e50, 1e51, 1e155, 1e300,
    -1e300, 1e-155, 1e-300, std::numeric_limits<double>::denorm_min(),
    std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::quiet_NaN(), 3.5e38, 1.0 + 0x1p-52 };
  const Index which = this->whole(0, static_cast<Index>(std::size(Numbers)));
  return which < static_cast<Index>(std::size(Numbers)) ? Numbers[which] : this->bits();
}

hexsweep::Progress patience()
{
  constexpr std::clock_t Quarter = CLOCKS_PER_SEC / 4;
  const std::clock_t begin = std::clock();
  return [begin](double) { return std::clock() - begin < Quarter; };
}

void expectOrderly(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const hexsweep::InvalidInput&)
  {
  }
  catch (const hexsweep::SolverFailure&)
  {
  }
  catch (const hexsweep::Aborted&)
  {
  }
}

namespace
{
void shake(Input& input, Points& points)
{
  const double amount = std::pow(10.0, -4.0 * input.share());
  for (Index i = 0; i < points.size(); ++i)
  {
    points.data()[i] += amount * (input.share() - 0.5);
  }
}

void damagePlaces(Input& input, Points& points, Index kind)
{
  const Index last = points.rows() - 1;
  switch (kind)
  {
    case 0:
      points.row(input.whole(0, last)) = points.row(input.whole(0, last)).eval();
      return;
    case 1:
      points(input.whole(0, last), input.whole(0, 2)) = input.special();
      return;
    case 2:
      shake(input, points);
      return;
    case 3:
      points.rowwise() +=
        std::pow(10.0, 16.0 * input.share()) * Eigen::RowVector3d(1.0, input.share(), 0.0);
      return;
    case 4:
      points *= std::pow(10.0, 120.0 * (input.share() - 0.5));
      return;
    case 5: // flat
      points.col(input.whole(0, 2)) *= input.whole(0, 1) == 0 ? 0.0 : 1e-9;
      return;
    default:
      points.row(input.whole(0, last)) += Eigen::RowVector3d(
        4.0 * (input.share() - 0.5), 4.0 * (input.share() - 0.5), 4.0 * (input.share() - 0.5));
  }
}

template <typename Faces>
void damageFaces(Input& input, Points& points, Faces& faces, Index kind)
{
  const Index face = input.whole(0, faces.rows() - 1);
  const Index corner = input.whole(0, faces.cols() - 1);
  switch (kind)
  {
    case 0: // left out
      if (faces.rows() > 1)
      {
        faces.row(face) = faces.row(faces.rows() - 1).eval();
        faces.conservativeResize(faces.rows() - 1, Eigen::NoChange);
      }
      return;
    case 1: // doubled
      faces.conservativeResize(faces.rows() + 1, Eigen::NoChange);
      faces.row(faces.rows() - 1) = faces.row(face).eval();
      return;
    case 2:
      faces.row(face) = faces.row(face).reverse().eval();
      return;
    case 3: // welded to another point
      faces(face, corner) = input.whole(0, points.rows() - 1);
      return;
    default: // torn off
      points.conservativeResize(points.rows() + 1, Eigen::NoChange);
      points.row(points.rows() - 1) = points.row(faces(face, corner)).eval();
      faces(face, corner) = points.rows() - 1;
  }
}
}

double extentOf(const Points& points)
{
  const double extent = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  return std::isfinite(extent) && extent > 0.0 ? extent : 1.0;
}

bool isLaborious(double size, double extent)
{
  constexpr double RefusedBelow = 1e-9;
  constexpr double FewFrom = 0.1;
  return size >= RefusedBelow * extent && size < FewFrom * extent;
}

void damagePoints(Input& input, Points& points)
{
  for (Index count = input.whole(0, 6); count > 0; --count)
  {
    damagePlaces(input, points, input.whole(0, 6));
  }
}

template <typename Faces>
void damage(Input& input, Points& points, Faces& faces)
{
  for (Index count = input.whole(0, 6); count > 0; --count)
  {
    const Index kind = input.whole(0, 11);
    if (kind < 5)
    {
      damageFaces(input, points, faces, kind);
    }
    else
    {
      damagePlaces(input, points, kind - 5);
    }
  }
}

template void damage(Input&, Points&, hexsweep::Triangles&);
template void damage(Input&, Points&, hexsweep::Quads&);
template void damage(Input&, Points&, hexsweep::Hexes&);
}

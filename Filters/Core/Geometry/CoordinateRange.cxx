// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Geometry/CoordinateRange.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"

#include <algorithm>
#include <limits>

namespace hexsweep
{
namespace
{
void checkCornerCoordinates(
  const PointsRef& points, const Index* begin, const Index* end, const std::string& what)
{
  if (begin == end)
  {
    return;
  }
  const std::string start = "the " + what + ": ";
  Eigen::RowVector3d low = points.row(*begin);
  Eigen::RowVector3d high = low;
  for (const Index* corner = begin; corner != end; ++corner)
  {
    const auto place = points.row(*corner);
    if (!place.allFinite())
    {
      throw InvalidInput(start + "point " + std::to_string(*corner) +
        " has a coordinate that is not a finite number. Repair or remove it.");
    }
    if (place.cwiseAbs().maxCoeff() > GreatestLength)
    {
      throw InvalidInput(start + "point " + std::to_string(*corner) + " at " + describe(place) +
        " is too far out: volumes of such lengths are no numbers any more. Use another unit, up "
        "to " +
        describe(GreatestLength) + ".");
    }
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  // What is a single point has no area either, which is found with its cells.
  const double size = (high - low).maxCoeff();
  const double farthest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  if (size > 0.0 && size < LeastOfCoordinates * farthest)
  {
    throw InvalidInput(start + "it has a size of " + describe(size) + " at " + describe(low) +
      ", where coordinates cannot be told apart well enough. Move the mesh nearer to the origin.");
  }
  if (size > 0.0 && size < 1.0 / GreatestLength)
  {
    throw InvalidInput(start + "it has a size of " + describe(size) + " at " + describe(low) +
      ": volumes of such lengths are no numbers any more. Use another unit, down to " +
      describe(1.0 / GreatestLength) + ".");
  }
}
}

void checkCoordinates(const PointsRef& points, const FacesRef& faces, const std::string& what)
{
  const Faces copy = faces; // one after the other, whatever the view is
  checkCornerCoordinates(points, copy.data(), copy.data() + copy.size(), what);
}

void checkCoordinates(
  const PointsRef& points, const std::vector<Index>& corners, const std::string& what)
{
  checkCornerCoordinates(points, corners.data(), corners.data() + corners.size(), what);
}

void checkFitsSinglePrecision(const PointsRef& points)
{
  constexpr double Largest = std::numeric_limits<float>::max();
  for (Index i = 0; i < points.rows(); ++i)
  {
    const double greatest = points.row(i).cwiseAbs().maxCoeff();
    if (greatest > Largest && points.row(i).allFinite())
    {
      throw InvalidInput("the point at " + describe(points.row(i)) +
        " is too far out for single precision, which ends at " + describe(Largest) +
        ". Set OutputPointsPrecision to double precision, or use another unit.");
    }
  }
}
}

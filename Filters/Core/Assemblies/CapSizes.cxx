// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/CapSizes.h"

#include "Core/Common/Constants.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Surfaces/SurfaceArea.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
constexpr double SharpCorner = Pi / 3.0;
constexpr double LeastShare = 0.1;

/// Radians: the least angle of a face between two of its curves.
double sharpestCorner(const AssemblyComplex& complex, const ComplexFace& face)
{
  std::map<Index, double> angles;
  for (const std::vector<CurveUse>& loop : face.loops)
  {
    for (const CurveUse& use : loop)
    {
      if (!complex.curves[at(use.curve)].closed())
      {
        angles[firstPointOf(complex, use)] = 0.0;
      }
    }
  }
  for (const Index t : face.triangles)
  {
    for (Index c = 0; c < 3; ++c)
    {
      const auto corner = angles.find(complex.triangles(t, c));
      if (corner != angles.end())
      {
        const Eigen::RowVector3d here = complex.points.row(corner->first);
        const Eigen::RowVector3d a = complex.points.row(complex.triangles(t, (c + 1) % 3)) - here;
        const Eigen::RowVector3d b = complex.points.row(complex.triangles(t, (c + 2) % 3)) - here;
        corner->second += std::atan2(a.cross(b).norm(), a.dot(b));
      }
    }
  }
  double sharpest = Pi;
  for (const auto& [point, angle] : angles)
  {
    sharpest = std::min(sharpest, angle);
  }
  return sharpest;
}
}

double capSize(const AssemblyComplex& complex, Index face, double size)
{
  const ComplexFace& own = complex.faces[at(face)];
  double perimeter = 0.0;
  for (const std::vector<CurveUse>& loop : own.loops)
  {
    for (const CurveUse& use : loop)
    {
      perimeter += lengthOf(complex, complex.curves[at(use.curve)]);
    }
  }
  const double area =
    surfaceArea(surfacePart(complex.points, complex.triangles, own.triangles).mesh);
  const double width = 2.0 * area / perimeter;
  if (width >= size || sharpestCorner(complex, own) >= SharpCorner)
  {
    return size;
  }
  return std::max(width, LeastShare * size);
}

std::map<Index, double> capCurveSizes(
  const AssemblyComplex& complex, const AssemblyPlan& plan, double size)
{
  std::map<Index, double> sizes;
  for (const SweepLayout& sweep : plan.sweeps)
  {
    for (const std::vector<Index>* cap : { &sweep.sources, &sweep.targets })
    {
      for (const Index face : *cap)
      {
        const double own = capSize(complex, face, size);
        for (const std::vector<CurveUse>& loop : complex.faces[at(face)].loops)
        {
          for (const CurveUse& use : loop)
          {
            double& least = sizes.try_emplace(use.curve, own).first->second;
            least = std::min(least, own);
          }
        }
      }
    }
  }
  return sizes;
}
}

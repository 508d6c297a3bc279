// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/SteadyColumns.h"

#include <algorithm>
#include <cmath>

namespace hexsweep
{
namespace
{
/// Of the way from cap to cap: what an edge may fall back in all.
constexpr double MostFall = 0.1;
/// Of the loop: how far an edge may lie beside the way that it should go. Corners of grooves and of
/// caps that change their shape were seen up to 0.06 beside it, edges that wander from 0.24 on.
constexpr double MostAside = 0.12;

constexpr double SmoothCosine = 0.866; // of 30 degrees

/// Of the heights along an edge: by its length, so that they rise where those of the strip do not.
constexpr double ShareOfLength = 0.02;

/// An edge in a strip: (v, u) from its first point, v without jumps.
using Course = std::vector<Eigen::RowVector2d>;

Course courseOf(const StripColumn& column, const PlanePointsRef& free)
{
  Course course = { Eigen::RowVector2d::Zero() };
  for (std::size_t k = 1; k < column.points.size(); ++k)
  {
    Eigen::RowVector2d step = free.row(column.points[k]) - free.row(column.points[k - 1]);
    step.x() -= std::round(step.x());
    course.push_back(course.back() + step);
  }
  return course;
}

double medianDrift(const std::vector<Course>& courses)
{
  std::vector<double> drifts;
  for (const Course& course : courses)
  {
    drifts.push_back(course.back().x());
  }
  std::sort(drifts.begin(), drifts.end());
  const std::size_t half = drifts.size() / 2;
  return drifts.size() % 2 == 1 ? drifts[half] : 0.5 * (drifts[half - 1] + drifts[half]);
}

/// @param drift of the way that it should go, all the way from cap to cap.
bool isSteady(const Course& course, double drift)
{
  double fall = 0.0;
  double aside = 0.0;
  for (std::size_t k = 1; k < course.size(); ++k)
  {
    fall += std::max(0.0, course[k - 1].y() - course[k].y());
    aside = std::max(aside, std::abs(course[k].x() - drift * course[k].y()));
  }
  return fall <= MostFall && aside <= MostAside;
}
}

std::vector<StripColumn> steadyColumns(
  const std::vector<StripColumn>& columns, const PlanePointsRef& free)
{
  std::vector<Course> courses;
  for (const StripColumn& column : columns)
  {
    courses.push_back(courseOf(column, free));
  }
  std::vector<StripColumn> steady;
  const double usual = courses.empty() ? 0.0 : medianDrift(courses);
  for (std::size_t c = 0; c < columns.size(); ++c)
  {
    // Like the others, or like the strip without edges.
    if (isSteady(courses[c], usual) || isSteady(courses[c], 0.0))
    {
      steady.push_back(columns[c]);
    }
  }
  return steady;
}

std::vector<double> risingHeights(const StripColumn& column, const PlanePointsRef& free)
{
  const std::size_t n = column.points.size();
  std::vector<double> highest;
  for (const Index point : column.points)
  {
    highest.push_back(std::max(free(point, 1), highest.empty() ? 0.0 : highest.back()));
  }
  std::vector<double> heights(n, 1.0);
  double lowest = 1.0;
  for (std::size_t k = n; k-- > 0;)
  {
    lowest = std::min(lowest, free(column.points[k], 1));
    heights[k] = (1.0 - ShareOfLength) * 0.5 * (highest[k] + lowest) + ShareOfLength * column.u[k];
  }
  heights.front() = 0.0;
  heights.back() = 1.0;
  return heights;
}

bool isSmooth(const PointsRef& points, const StripColumn& column)
{
  for (std::size_t k = 1; k + 1 < column.points.size(); ++k)
  {
    const Eigen::RowVector3d here = points.row(column.points[k]);
    const Eigen::RowVector3d in = here - points.row(column.points[k - 1]);
    const Eigen::RowVector3d out = points.row(column.points[k + 1]) - here;
    if (in.dot(out) < SmoothCosine * in.norm() * out.norm())
    {
      return false;
    }
  }
  return true;
}
}

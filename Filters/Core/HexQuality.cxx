// SPDX-License-Identifier: BSD-3-Clause
#include "HexQuality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
using Vector = Eigen::RowVector3d;

// The neighbours of each corner in the order that makes the determinant of the edges to them
// positive in a right-handed hexahedron.
constexpr int Neighbors[8][3] = { { 1, 3, 4 }, { 2, 0, 5 }, { 3, 1, 6 }, { 0, 2, 7 }, { 7, 5, 0 },
  { 4, 6, 1 }, { 5, 7, 2 }, { 6, 4, 3 } };

// The faces at either end of the three axes through the centre.
constexpr int HighFace[3][4] = { { 1, 2, 5, 6 }, { 2, 3, 6, 7 }, { 4, 5, 6, 7 } };
constexpr int LowFace[3][4] = { { 0, 3, 4, 7 }, { 0, 1, 4, 5 }, { 0, 1, 2, 3 } };

struct Frame
{
  Vector u, v, w;

  double determinant() const { return u.dot(v.cross(w)); }

  // The determinant over the product of the lengths. Each vector is scaled by itself: the product
  // of six factors would under- or overflow long before the coordinates do.
  double scaledDeterminant() const
  {
    const double lengths[3] = { u.stableNorm(), v.stableNorm(), w.stableNorm() };
    if (!(lengths[0] > 0.0 && lengths[1] > 0.0 && lengths[2] > 0.0))
    {
      return 0.0;
    }
    const double scaled = (u / lengths[0]).dot((v / lengths[1]).cross(w / lengths[2]));
    return std::clamp(scaled, -1.0, 1.0);
  }

  bool hasZeroEdge() const { return u.isZero(0.0) || v.isZero(0.0) || w.isZero(0.0); }
};

Frame frameAtCorner(const HexCornersRef& corners, int corner)
{
  const int* to = Neighbors[corner];
  return { corners.row(to[0]) - corners.row(corner), corners.row(to[1]) - corners.row(corner),
    corners.row(to[2]) - corners.row(corner) };
}

Frame frameAtCenter(const HexCornersRef& corners)
{
  const auto axis = [&corners](int i) -> Vector {
    const int* high = HighFace[i];
    const int* low = LowFace[i];
    // Differences first: sums of coordinates would lose digits far from the origin.
    return ((corners.row(high[0]) - corners.row(low[0])) +
             (corners.row(high[1]) - corners.row(low[1])) +
             (corners.row(high[2]) - corners.row(low[2])) +
             (corners.row(high[3]) - corners.row(low[3]))) /
      4.0;
  };
  return { axis(0), axis(1), axis(2) };
}
}

Eigen::Matrix<double, 8, 1> cornerJacobians(const HexCornersRef& corners)
{
  Eigen::Matrix<double, 8, 1> jacobians;
  for (int i = 0; i < 8; ++i)
  {
    jacobians[i] = frameAtCorner(corners, i).determinant();
  }
  return jacobians;
}

HexQuality hexQuality(const HexCornersRef& corners)
{
  HexQuality quality;
  if (!corners.allFinite())
  {
    quality.scaledJacobian = std::numeric_limits<double>::quiet_NaN();
    quality.validity = Validity::Degenerate;
    return quality;
  }
  double least = 1.0;
  double most = -1.0;
  bool zeroEdge = false;
  for (int i = 0; i < 8; ++i)
  {
    const Frame frame = frameAtCorner(corners, i);
    const double scaled = frame.scaledDeterminant();
    least = std::min(least, scaled);
    most = std::max(most, scaled);
    zeroEdge = zeroEdge || frame.hasZeroEdge();
  }
  const double center = frameAtCenter(corners).scaledDeterminant();
  quality.scaledJacobian = std::min(least, center);
  quality.insideOut = most < 0.0;
  if (zeroEdge)
  {
    quality.validity = Validity::Degenerate;
  }
  else if (least <= 0.0)
  {
    quality.validity = Validity::InvertedCorner;
  }
  else if (center <= 0.0)
  {
    quality.validity = Validity::InvertedInside;
  }
  return quality;
}

std::vector<HexQuality> hexQualities(const PointsRef& points, const HexesRef& hexes)
{
  std::vector<HexQuality> qualities(static_cast<std::size_t>(hexes.rows()));
  HexCorners corners;
  for (Index h = 0; h < hexes.rows(); ++h)
  {
    for (int i = 0; i < 8; ++i)
    {
      corners.row(i) = points.row(hexes(h, i));
    }
    qualities[static_cast<std::size_t>(h)] = hexQuality(corners);
  }
  return qualities;
}

void HexQualitySummary::add(const HexQuality& quality)
{
  if (quality.validity == Validity::NotJudged)
  {
    return;
  }
  ++hexes;
  inverted +=
    quality.validity == Validity::InvertedCorner || quality.validity == Validity::InvertedInside;
  insideOut += quality.insideOut;
  degenerate += quality.validity == Validity::Degenerate;
  notCertified += quality.validity != Validity::Certified;
  if (std::isfinite(quality.scaledJacobian))
  {
    minScaledJacobian = finiteHexes == 0 ? quality.scaledJacobian
                                         : std::min(minScaledJacobian, quality.scaledJacobian);
    ++finiteHexes;
    sumScaledJacobian += quality.scaledJacobian;
    meanScaledJacobian = sumScaledJacobian / static_cast<double>(finiteHexes);
  }
}

HexQualitySummary summarize(const std::vector<HexQuality>& qualities)
{
  HexQualitySummary summary;
  for (const HexQuality& quality : qualities)
  {
    summary.add(quality);
  }
  return summary;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Hexahedra/HexQuality.h"

#include "Core/Common/Errors.h"
#include "Core/Common/IdRange.h"
#include "Core/Hexahedra/BezierHex.h"
#include "Core/Hexahedra/BezierMinimum.h"
#include "Core/Hexahedra/HexCorner.h"
#include "Core/Hexahedra/HexKernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace hexsweep
{
namespace
{
using Vector = Eigen::RowVector3d;

// The faces at either end of the three axes through the centre.
constexpr int HighFace[3][4] = { { 1, 2, 5, 6 }, { 2, 3, 6, 7 }, { 4, 5, 6, 7 } };
constexpr int LowFace[3][4] = { { 0, 3, 4, 7 }, { 0, 1, 4, 5 }, { 0, 1, 2, 3 } };

HexFrame frameAtCorner(const HexCornersRef& corners, int corner)
{
  return hexFrame([&corners](int i) { return corners.row(i); }, corner);
}

HexFrame frameAtCenter(const HexCornersRef& corners)
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
    const HexFrame frame = frameAtCorner(corners, i);
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

namespace
{
// Whole batches, so that they do not depend on the pieces.
constexpr Index HexesPerPiece = 4096;
static_assert(HexesPerPiece % HexLanesSize == 0);
constexpr Index HexesPerReport = 64 * HexesPerPiece;

// The coordinates of the eight corners of a hexahedron.
using CornerPointers = std::array<const double*, 8>;

double signedRoot(double square)
{
  return std::copysign(std::sqrt(std::min(std::abs(square), 1.0)), square);
}

// Whether the figures are as good as those of hexQuality() and within the error bound of the
// certificate: no edge without length, nothing overflows or underflows.
bool isInRange(const HexFigures<HexLanes>& figures, int lane)
{
  return figures.leastProduct[lane] >= LeastSquaredProduct &&
    figures.edgeProduct[lane] <= GreatestSquaredProduct &&
    figures.sumOfProducts[lane] <= GreatestSquaredProduct;
}

HexQuality qualityFromFigures(const HexFigures<HexLanes>& figures, int lane)
{
  HexQuality quality;
  quality.scaledJacobian =
    signedRoot(std::min(figures.scaledCorner[lane], figures.scaledCenter[lane]));
  quality.insideOut = figures.greatestCorner[lane] < 0.0;
  if (figures.scaledCorner[lane] <= 0.0)
  {
    quality.validity = Validity::InvertedCorner;
  }
  else if (figures.scaledCenter[lane] <= 0.0)
  {
    quality.validity = Validity::InvertedInside;
  }
  return quality;
}

// Scaled Jacobians of less are the rounding of their own computation: such a hexahedron may be
// proved positive in exact numbers, but nothing can be computed with it.
constexpr double LeastScaledJacobian = 1e-14;

enum class Judged
{
  Corners,        // no certificate
  Verdict,        // without the bound
  VerdictAndBound // that is tight
};

// The certificate where the undivided coefficients give it.
std::optional<HexCertificate> certificateFromFigures(
  const HexFigures<HexLanes>& figures, int lane, Judged judged)
{
  const double error = BezierErrorBound * std::sqrt(figures.edgeProduct[lane]);
  const double corner = figures.leastCorner[lane];
  const double least = figures.leastCoefficient[lane];
  const bool isTight =
    judged == Judged::Verdict || corner - least <= JacobianBoundTolerance * std::abs(corner);
  if (isTight && least > error)
  {
    return HexCertificate{ Validity::Certified, least - error };
  }
  if (isTight && corner < -error)
  {
    return HexCertificate{ Validity::InvertedCorner, least - error };
  }
  return std::nullopt;
}

HexCorners copyOf(const CornerPointers& pointers)
{
  HexCorners corners;
  for (std::size_t i = 0; i < 8; ++i)
  {
    corners.row(static_cast<Index>(i)) = Eigen::Map<const Vector>(pointers[i]);
  }
  return corners;
}

HexQuality qualityOf(
  const HexFigures<HexLanes>& figures, int lane, const CornerPointers& corners, Judged judged)
{
  const bool inRange = isInRange(figures, lane);
  HexQuality quality = inRange ? qualityFromFigures(figures, lane) : hexQuality(copyOf(corners));
  if (judged != Judged::Corners)
  {
    std::optional<HexCertificate> certificate;
    if (inRange)
    {
      certificate = certificateFromFigures(figures, lane, judged);
    }
    if (!certificate)
    {
      certificate = certifyHex(copyOf(corners));
    }
    quality.validity = certificate->validity;
    quality.jacobianLowerBound = certificate->jacobianLowerBound;
    const bool isProvedBad =
      quality.validity == Validity::InvertedCorner || quality.validity == Validity::InvertedInside;
    if (!isProvedBad && std::abs(quality.scaledJacobian) < LeastScaledJacobian)
    {
      quality.validity = Validity::Degenerate;
    }
  }
  return quality;
}

// Qualities of the hexahedra [begin, end). cornersOf(h) gives the pointers to the corners of one.
template <typename CornersOf>
void judge(Index begin, Index end, const CornersOf& cornersOf, Judged judged, HexQuality* qualities)
{
  const HexKernels& kernels = hexKernels();
  for (Index first = begin; first < end; first += HexLanesSize)
  {
    // The last batch is filled with repetitions of its first hexahedron.
    std::array<CornerPointers, HexLanesSize> corners;
    const double* pointers[8 * HexLanesSize];
    for (int lane = 0; lane < HexLanesSize; ++lane)
    {
      const std::size_t l = static_cast<std::size_t>(lane);
      corners[l] = cornersOf(first + lane < end ? first + lane : first);
      std::copy(corners[l].begin(), corners[l].end(), pointers + 8 * lane);
    }
    const HexFigures<HexLanes> figures = kernels.measure(pointers);
    for (int lane = 0; lane < HexLanesSize && first + lane < end; ++lane)
    {
      qualities[first + lane] =
        qualityOf(figures, lane, corners[static_cast<std::size_t>(lane)], judged);
    }
  }
}
}

namespace
{
std::vector<HexQuality> judge(const PointsRef& points, const HexesRef& hexes, Judged judged,
  const ParallelFor& parallelFor, const Progress& progress)
{
  checkIds(hexes, points.rows(), "hexahedron");
  std::vector<HexQuality> qualities;
  qualities.reserve(static_cast<std::size_t>(hexes.rows()));
  const auto cornersOf = [&](Index h) {
    CornerPointers pointers;
    for (int i = 0; i < 8; ++i)
    {
      pointers[static_cast<std::size_t>(i)] = points.data() + points.outerStride() * hexes(h, i);
    }
    return pointers;
  };
  for (Index first = 0; first < hexes.rows(); first += HexesPerReport)
  {
    reportProgress(progress, static_cast<double>(first) / static_cast<double>(hexes.rows()));
    qualities.resize(static_cast<std::size_t>(std::min(first + HexesPerReport, hexes.rows())));
    forPieces(parallelFor, std::min(HexesPerReport, hexes.rows() - first), HexesPerPiece,
      [&](Index begin, Index end) {
        judge(first + begin, first + end, cornersOf, judged, qualities.data());
      });
  }
  return qualities;
}
}

std::vector<HexQuality> hexQualities(const PointsRef& points, const HexesRef& hexes, bool certify,
  const ParallelFor& parallelFor, const Progress& progress)
{
  return judge(
    points, hexes, certify ? Judged::VerdictAndBound : Judged::Corners, parallelFor, progress);
}

std::vector<HexQuality> hexVerdicts(const PointsRef& points, const HexesRef& hexes,
  const ParallelFor& parallelFor, const Progress& progress)
{
  return judge(points, hexes, Judged::Verdict, parallelFor, progress);
}

std::vector<HexQuality> hexQualities(const PointsRef& corners, bool certify)
{
  if (corners.rows() % 8 != 0)
  {
    throw InvalidInput("there are " + std::to_string(corners.rows()) +
      " corners, and hexahedra have 8 each. Give all corners of each hexahedron.");
  }
  const Index hexes = corners.rows() / 8;
  std::vector<HexQuality> qualities(static_cast<std::size_t>(hexes));
  const auto cornersOf = [&corners](Index h) {
    CornerPointers pointers;
    for (std::size_t i = 0; i < 8; ++i)
    {
      pointers[i] = corners.data() + corners.outerStride() * (8 * h + static_cast<Index>(i));
    }
    return pointers;
  };
  judge(0, hexes, cornersOf, certify ? Judged::VerdictAndBound : Judged::Corners, qualities.data());
  return qualities;
}

void hexVerdicts(const double* const* corners, Index hexes, HexQuality* verdicts)
{
  const auto cornersOf = [corners](Index h) {
    CornerPointers pointers;
    std::copy(corners + 8 * h, corners + 8 * h + 8, pointers.begin());
    return pointers;
  };
  judge(0, hexes, cornersOf, Judged::Verdict, verdicts);
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
  invertedInside += quality.validity == Validity::InvertedInside;
  insideOut += quality.insideOut;
  degenerate += quality.validity == Validity::Degenerate;
  undecided += quality.validity == Validity::Undecided;
  notCertified += quality.validity != Validity::Certified;
  if (std::isfinite(quality.scaledJacobian))
  {
    minScaledJacobian = this->FiniteHexes == 0
      ? quality.scaledJacobian
      : std::min(minScaledJacobian, quality.scaledJacobian);
    ++this->FiniteHexes;
    this->SumScaledJacobian += quality.scaledJacobian;
    meanScaledJacobian = this->SumScaledJacobian / static_cast<double>(this->FiniteHexes);
  }
  if (!(minJacobianLowerBound <= quality.jacobianLowerBound) &&
    !std::isnan(quality.jacobianLowerBound))
  {
    minJacobianLowerBound = quality.jacobianLowerBound;
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

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/RingParameter.h"

#include "Core/Geometry/BoundarySearch.h"

#include "Core/Common/Errors.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Geometry/TriangleSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
constexpr double SamePlace = 1e-7; // of a ring edge

/// A piece of the ring between two places, as nodes with their parameters.
struct RingPiece
{
  std::vector<double> parameters;
  Points nodes;
};

Eigen::RowVector3d ringPoint(const PointsRef& ring, double s)
{
  const Index n = ring.rows();
  const double edge = std::floor(s);
  const double fraction = s - edge;
  const Index a = ((static_cast<Index>(edge) % n) + n) % n;
  return (1.0 - fraction) * ring.row(a) + fraction * ring.row((a + 1) % n);
}

RingPiece ringPiece(const PointsRef& ring, double from, double to)
{
  RingPiece piece;
  piece.parameters.push_back(from);
  for (double s = std::floor(from) + 1.0; s < to; s += 1.0)
  {
    piece.parameters.push_back(s);
  }
  piece.parameters.push_back(to);
  piece.nodes.resize(static_cast<Index>(piece.parameters.size()), 3);
  for (std::size_t i = 0; i < piece.parameters.size(); ++i)
  {
    piece.nodes.row(static_cast<Index>(i)) = ringPoint(ring, piece.parameters[i]);
  }
  return piece;
}

/// Parameters of the inner points of a chain whose ends lie at the ends of the ring piece,
/// by arc length along the chain.
std::vector<double> placeByLength(const Points& chain, const RingPiece& piece)
{
  const Index count = chain.rows();
  std::vector<double> length(static_cast<std::size_t>(count), 0.0);
  for (Index i = 1; i < count; ++i)
  {
    length[static_cast<std::size_t>(i)] =
      length[static_cast<std::size_t>(i - 1)] + (chain.row(i) - chain.row(i - 1)).norm();
  }
  std::vector<double> places;
  for (Index i = 1; i + 1 < count; ++i)
  {
    const double fraction = length[static_cast<std::size_t>(i)] / length.back();
    places.push_back(
      (1.0 - fraction) * piece.parameters.front() + fraction * piece.parameters.back());
  }
  return places;
}

/// The same by nearest points, never going back along the ring.
std::vector<double> placeByDistance(const Points& chain, const RingPiece& piece)
{
  const Index inner = chain.rows() - 2;
  const Index edges = piece.nodes.rows() - 1;
  Eigen::MatrixXd cost(inner, edges);
  Eigen::MatrixXd place(inner, edges);
  for (Index i = 0; i < inner; ++i)
  {
    for (Index e = 0; e < edges; ++e)
    {
      const TrianglePoint near = closestPointOnTriangle(
        chain.row(i + 1), piece.nodes.row(e), piece.nodes.row(e + 1), piece.nodes.row(e + 1));
      cost(i, e) = near.distance * near.distance;
      const double a = piece.parameters[static_cast<std::size_t>(e)];
      const double b = piece.parameters[static_cast<std::size_t>(e + 1)];
      place(i, e) = near.coordinates[0] * a + (1.0 - near.coordinates[0]) * b;
    }
  }
  // best(i, e): least cost of points 0..i with point i on an edge <= e.
  Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic> chosen(inner, edges);
  Eigen::VectorXd best = Eigen::VectorXd::Zero(edges);
  for (Index i = 0; i < inner; ++i)
  {
    double least = std::numeric_limits<double>::infinity();
    Index edge = 0;
    for (Index e = 0; e < edges; ++e)
    {
      const double total = best[e] + cost(i, e);
      if (total < least)
      {
        least = total;
        edge = e;
      }
      best[e] = least;
      chosen(i, e) = edge;
    }
  }
  std::vector<double> places(static_cast<std::size_t>(inner));
  Index limit = edges - 1;
  for (Index i = inner - 1; i >= 0; --i)
  {
    limit = chosen(i, limit);
    places[static_cast<std::size_t>(i)] = place(i, limit);
  }
  return places;
}

/// Moves places apart that coincide or go back, by a small part of the piece.
void makeStrict(std::vector<double>& places, double from, double to)
{
  const double gap = std::min(1e-3, (to - from) / (4.0 * static_cast<double>(places.size() + 1)));
  double last = from;
  for (double& place : places)
  {
    place = std::max(place, last + gap);
    last = place;
  }
  double next = to;
  for (auto place = places.rbegin(); place != places.rend(); ++place)
  {
    *place = std::min(*place, next - gap);
    next = *place;
  }
}

/// Ring node that each polygon vertex coincides with, or -1.
std::vector<Index> coincidentNodes(
  const PointsRef& polygon, const PointsRef& ring, double matchTolerance)
{
  const Index n = ring.rows();
  Points corners(polygon.rows() * 3, 3);
  for (Index i = 0; i < polygon.rows(); ++i)
  {
    corners.middleRows<3>(3 * i).rowwise() = polygon.row(i);
  }
  const TriangleSearch vertices(std::move(corners));
  std::vector<Index> node(static_cast<std::size_t>(polygon.rows()), -1);
  for (Index j = 0; j < n; ++j)
  {
    const double edge = std::min((ring.row(j) - ring.row((j + 1) % n)).norm(),
      (ring.row(j) - ring.row((j + n - 1) % n)).norm());
    const TrianglePoint near = vertices.closest(ring.row(j));
    if (near.distance <= matchTolerance * edge)
    {
      node[static_cast<std::size_t>(near.triangle)] = j;
    }
  }
  return node;
}

/// Drops coincidences that would make the order run backwards (a vertex that meets a far node).
void keepCyclicOrder(std::vector<Index>& node, Index ringSize)
{
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < node.size(); ++i)
  {
    if (node[i] >= 0)
    {
      found.push_back(i);
    }
  }
  if (found.size() < 3)
  {
    return;
  }
  Index turns = 0;
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    const Index a = node[found[k]];
    const Index b = node[found[(k + 1) % found.size()]];
    turns += ((b - a) % ringSize + ringSize) % ringSize;
  }
  if (turns != ringSize)
  {
    throw InvalidInput("the nodes of a loop come in another order on the cap than on the linking "
                       "sides. Check that the linking sides belong to this cap.");
  }
}
}

std::vector<double> ringParameters(
  const PointsRef& polygon, const PointsRef& ring, double matchTolerance)
{
  const Index m = polygon.rows();
  const Index n = ring.rows();
  std::vector<Index> node = coincidentNodes(polygon, ring, matchTolerance);
  keepCyclicOrder(node, n);

  std::vector<double> result(static_cast<std::size_t>(m), -1.0);
  std::vector<Index> anchors;
  for (Index i = 0; i < m; ++i)
  {
    if (node[static_cast<std::size_t>(i)] >= 0)
    {
      anchors.push_back(i);
      result[static_cast<std::size_t>(i)] = static_cast<double>(node[static_cast<std::size_t>(i)]);
    }
  }
  if (anchors.empty())
  {
    // Nothing coincides: begin at the vertex that is nearest to the ring.
    Points corners(n * 3, 3);
    for (Index j = 0; j < n; ++j)
    {
      corners.row(3 * j) = ring.row(j);
      corners.row(3 * j + 1) = corners.row(3 * j + 2) = ring.row((j + 1) % n);
    }
    const TriangleSearch edges(std::move(corners));
    double least = std::numeric_limits<double>::infinity();
    Index first = 0;
    for (Index i = 0; i < m; ++i)
    {
      const TrianglePoint near = edges.closest(polygon.row(i));
      if (near.distance < least)
      {
        least = near.distance;
        first = i;
        result[static_cast<std::size_t>(i)] =
          static_cast<double>(near.triangle) + (1.0 - near.coordinates[0]);
      }
    }
    anchors.push_back(first);
  }

  for (std::size_t a = 0; a < anchors.size(); ++a)
  {
    const Index begin = anchors[a];
    const bool wraps = a + 1 == anchors.size();
    const Index end = wraps ? anchors.front() + m : anchors[a + 1];
    const Index inner = end - begin - 1;
    if (inner == 0)
    {
      continue;
    }
    const double from = result[static_cast<std::size_t>(begin)];
    double to = result[static_cast<std::size_t>(end % m)];
    to += to <= from ? static_cast<double>(n) : 0.0;
    Points chain(inner + 2, 3);
    for (Index i = 0; i < inner + 2; ++i)
    {
      chain.row(i) = polygon.row((begin + i) % m);
    }
    const RingPiece piece = ringPiece(ring, from, to);
    std::vector<double> places =
      piece.parameters.size() == 2 ? placeByLength(chain, piece) : placeByDistance(chain, piece);
    makeStrict(places, from, to);
    for (Index i = 0; i < inner; ++i)
    {
      result[static_cast<std::size_t>((begin + 1 + i) % m)] = places[static_cast<std::size_t>(i)];
    }
  }
  for (double& s : result)
  {
    s = std::fmod(s, static_cast<double>(n));
  }
  return result;
}

std::vector<double> uniteParameters(
  Index ringSize, const std::vector<const std::vector<double>*>& places)
{
  std::vector<double> all;
  for (Index j = 0; j < ringSize; ++j)
  {
    all.push_back(static_cast<double>(j));
  }
  for (const std::vector<double>* list : places)
  {
    for (const double s : *list)
    {
      if (std::abs(s - std::round(s)) > SamePlace)
      {
        all.push_back(s);
      }
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(
    std::unique(all.begin(), all.end(), [](double a, double b) { return b - a <= SamePlace; }),
    all.end());
  return all;
}

std::size_t unitedPlace(const std::vector<double>& united, Index ringSize, double s)
{
  const auto above = std::lower_bound(united.begin(), united.end(), s);
  const std::size_t high = static_cast<std::size_t>(above - united.begin());
  if (high == united.size())
  {
    return static_cast<double>(ringSize) - s < s - united.back() ? 0 : high - 1;
  }
  return high > 0 && s - united[high - 1] < united[high] - s ? high - 1 : high;
}

std::vector<double> ringLengths(const PointsRef& ring, const std::vector<double>& united)
{
  const std::vector<double> nodeLength = reachedLengths(ring);
  std::vector<double> lengths;
  for (const double s : united)
  {
    const std::size_t edge = static_cast<std::size_t>(s);
    const double fraction = s - static_cast<double>(edge);
    lengths.push_back((1.0 - fraction) * nodeLength[edge] + fraction * nodeLength[edge + 1]);
  }
  lengths.push_back(nodeLength.back());
  return lengths;
}

std::vector<double> ringAngles(const PointsRef& ring, const std::vector<double>& united)
{
  return anglesOfLengths(ringLengths(ring, united));
}

bool runsAlong(const PointsRef& ring, const PointsRef& points, const Loop& loop)
{
  const BoundarySearch search(points, { loop });
  const double nodes = static_cast<double>(loop.size());
  double sum = 0.0;
  double last = search.closest(ring.row(ring.rows() - 1)).position;
  for (Index i = 0; i < ring.rows(); ++i)
  {
    const double position = search.closest(ring.row(i)).position;
    sum += std::remainder(position - last, nodes);
    last = position;
  }
  return sum > 0.0;
}
}

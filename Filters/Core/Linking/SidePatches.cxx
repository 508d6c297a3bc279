// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Linking/SidePatches.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/BoundarySearch.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Surfaces/SeamWelding.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace hexsweep
{
namespace
{
using Edge = std::pair<Index, Index>;

/// Point of the patch at each ring node, or -1.
std::vector<Index> pointsOnRing(
  const PointsRef& points, const PointsRef& ring, double matchTolerance)
{
  Points corners(points.rows() * 3, 3);
  for (Index i = 0; i < points.rows(); ++i)
  {
    corners.middleRows<3>(3 * i).rowwise() = points.row(i);
  }
  const TriangleSearch vertices(std::move(corners));
  const Index n = ring.rows();
  std::vector<Index> found(at(n), -1); // the lowest of coincident ones, as welding keeps it
  for (Index j = 0; j < n; ++j)
  {
    const double edge = std::min((ring.row(j) - ring.row((j + 1) % n)).norm(),
      (ring.row(j) - ring.row((j + n - 1) % n)).norm());
    const TrianglePoint near = vertices.closest(ring.row(j));
    if (near.distance <= matchTolerance * edge)
    {
      found[at(j)] = near.triangle;
    }
  }
  return found;
}

class PatchWalk
{
public:
  explicit PatchWalk(const QuadMesh& patch)
    : Patch(patch)
    , Used(at(patch.quads.rows()), false)
  {
    for (Index q = 0; q < patch.quads.rows(); ++q)
    {
      for (Index c = 0; c < 4; ++c)
      {
        this->QuadsAt[this->edge(patch.quads(q, c), patch.quads(q, (c + 1) % 4))].push_back(q);
      }
    }
  }

  bool hasEdge(Index a, Index b) const { return this->QuadsAt.count(edge(a, b)) > 0; }

  /// Crosses the unused quad at an edge. @return the points across from a and b; -1 if there is no
  /// such quad.
  Edge cross(Index a, Index b)
  {
    for (const Index q : this->QuadsAt.at(edge(a, b)))
    {
      if (this->Used[at(q)])
      {
        continue;
      }
      this->Used[at(q)] = true;
      for (Index c = 0; c < 4; ++c)
      {
        const Index here = this->Patch.quads(q, c);
        const Index next = this->Patch.quads(q, (c + 1) % 4);
        const Index across = this->Patch.quads(q, (c + 2) % 4);
        const Index back = this->Patch.quads(q, (c + 3) % 4);
        if (here == a && next == b)
        {
          return { back, across };
        }
        if (here == b && next == a)
        {
          return { across, back };
        }
      }
    }
    return { -1, -1 };
  }

  Index unused() const { return std::count(this->Used.begin(), this->Used.end(), false); }

private:
  static Edge edge(Index a, Index b) { return std::minmax(a, b); }

  const QuadMesh& Patch;
  std::map<Edge, std::vector<Index>> QuadsAt;
  std::vector<bool> Used;
};

[[noreturn]] void refuse(const QuadMesh& patch, const std::string& why)
{
  throw InvalidInput("quads on a linking side (" + std::to_string(patch.quads.rows()) +
    ", the first at " + describe(patch.points.row(patch.quads(0, 0))) + ") " + why +
    " Their nodes are not kept. To keep them, mesh that face with structured quads that lead to "
    "the "
    "target cap, and the source cap with quads that begin at their nodes.");
}

/// The columns of one patch: patch points by ring node and layer.
std::map<Index, std::vector<Index>> traceOne(
  const QuadMesh& given, const PointsRef& ring, double matchTolerance)
{
  const QuadMesh patch{ given.points, weldLinkingSeams(given.points, given.quads, matchTolerance) };
  const Index n = ring.rows();
  const std::vector<Index> onRing = pointsOnRing(patch.points, ring, matchTolerance);
  PatchWalk walk(patch);
  std::vector<Index> edges; // ring edges at which the patch begins
  std::map<Index, std::vector<Index>> columns;
  for (Index j = 0; j < n; ++j)
  {
    const Index a = onRing[at(j)];
    const Index b = onRing[at((j + 1) % n)];
    if (a >= 0 && b >= 0 && walk.hasEdge(a, b))
    {
      edges.push_back(j);
      columns[j] = { a };
      columns[(j + 1) % n] = { b };
    }
  }
  if (edges.empty())
  {
    refuse(patch, "do not begin at the source quads: none of their edges is an edge there.");
  }
  for (std::size_t layer = 1; walk.unused() > 0; ++layer)
  {
    for (const Index j : edges)
    {
      std::vector<Index>& left = columns[j];
      std::vector<Index>& right = columns[(j + 1) % n];
      const auto [a, b] = walk.cross(left[layer - 1], right[layer - 1]);
      if (a < 0)
      {
        refuse(patch,
          "are not structured: layer " + std::to_string(layer) + " ends at " +
            describe(patch.points.row(left[layer - 1])) + ", while there are quads left.");
      }
      const std::pair<std::vector<Index>*, Index> sides[] = { { &left, a }, { &right, b } };
      for (const auto& [column, next] : sides)
      {
        if (column->size() == layer)
        {
          column->push_back(next);
        }
        else if ((*column)[layer] != next)
        {
          refuse(patch,
            "are not structured: two quads of layer " + std::to_string(layer) + " do not meet at " +
              describe(patch.points.row(next)) + ".");
        }
      }
    }
  }
  return columns;
}

/// Columns must not end below the target cap.
void checkEnds(const QuadMesh& patch, const std::map<Index, std::vector<Index>>& columns,
  const PointsRef& targetLoop, double matchTolerance)
{
  Loop loop(at(targetLoop.rows()));
  std::iota(loop.begin(), loop.end(), Index{ 0 });
  const BoundarySearch search(targetLoop, { loop });
  for (const auto& [j, column] : columns)
  {
    const Eigen::RowVector3d end = patch.points.row(column.back());
    const double step = (end - patch.points.row(column[column.size() - 2])).norm();
    if (search.closest(end).distance > matchTolerance * step)
    {
      refuse(patch,
        "do not reach the target cap: layer " + std::to_string(column.size() - 1) +
          " is the last one and ends at " + describe(end) + ".");
    }
  }
}
}

MeshedColumns tracePatches(const std::vector<QuadMesh>& patches, const PointsRef& ring,
  const PointsRef& targetLoop, double matchTolerance)
{
  MeshedColumns result;
  result.columns.resize(at(ring.rows()));
  Index firstMeshed = -1;
  for (const QuadMesh& patch : patches)
  {
    std::map<Index, std::vector<Index>> columns;
    try
    {
      columns = traceOne(patch, ring, matchTolerance);
      checkEnds(patch, columns, targetLoop, matchTolerance);
    }
    catch (const InvalidInput& error)
    {
      result.refused.emplace_back(error.what());
      continue;
    }
    for (const auto& [j, column] : columns)
    {
      const Index layers = static_cast<Index>(column.size()) - 1;
      if (result.layers != 0 && result.layers != layers)
      {
        throw InvalidInput("two parts of a linking side are meshed already, with " +
          std::to_string(result.layers) + " layers at " + describe(ring.row(firstMeshed)) +
          " and with " + std::to_string(layers) + " layers at " + describe(ring.row(j)) +
          ". Mesh them with the same number of layers, or give one of them as triangles.");
      }
      firstMeshed = firstMeshed < 0 ? j : firstMeshed;
      result.layers = layers;
      Points nodes(layers + 1, 3);
      for (Index k = 0; k <= layers; ++k)
      {
        nodes.row(k) = patch.points.row(column[at(k)]);
      }
      result.columns[at(j)] = std::move(nodes);
    }
  }
  return result;
}

std::vector<double> fractionsBeside(const MeshedColumns& meshed, const std::vector<bool>& isHeld,
  std::size_t column, const std::vector<double>& wanted)
{
  const std::size_t n = isHeld.size();
  const auto isKnown = [&](std::size_t j) { return isHeld[j] || meshed.columns[j].rows() > 0; };
  const auto known = [&](std::size_t j) {
    const Points& nodes = meshed.columns[j];
    std::vector<double> fractions(1, 0.0);
    for (Index k = 1; k < nodes.rows(); ++k)
    {
      fractions.push_back(fractions.back() + (nodes.row(k) - nodes.row(k - 1)).norm());
    }
    const double length = fractions.back();
    for (double& fraction : fractions)
    {
      fraction /= length;
    }
    return nodes.rows() > 0 ? fractions : wanted;
  };
  std::size_t left = 0;
  while (left < n && !isKnown((column + n - left) % n))
  {
    ++left;
  }
  if (meshed.layers == 0 || left == n)
  {
    return wanted;
  }
  std::size_t right = 0;
  while (!isKnown((column + right) % n))
  {
    ++right;
  }
  const std::vector<double> a = known((column + n - left) % n);
  const std::vector<double> b = known((column + right) % n);
  const double weight =
    left == 0 ? 0.0 : static_cast<double>(left) / static_cast<double>(left + right);
  std::vector<double> fractions;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    fractions.push_back((1.0 - weight) * a[k] + weight * b[k]);
  }
  return fractions;
}
}

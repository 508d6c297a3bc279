// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/TargetImprint.h"

#include "Core/CapQuads/CapCurves.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Surfaces/BorderSearch.h"
#include "Core/Surfaces/FaceSides.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace hexsweep
{
namespace
{
/// Of the cap's size: nodes of a curve are on its edges to rounding.
constexpr double ImprintRounding = 1e-10;

/// The borders of the target, their points numbered as they are met.
class BorderCollector
{
public:
  BorderCollector(const Points& points, const std::vector<bool>& onBoundary, double longest)
    : Given(points)
    , OnBoundary(onBoundary)
    , Longest(longest)
  {
  }

  void add(const CapCurve& curve)
  {
    for (std::size_t k = 1; k < curve.points.size(); ++k)
    {
      this->addEdge(curve.points[k - 1], curve.points[k]);
    }
    for (const Index end : { curve.points.front(), curve.points.back() })
    {
      this->Ends.insert(this->idOf(end));
    }
    ++this->Curves;
  }

  void moveTo(TargetImprint& imprint)
  {
    imprint.lines.points.resize(static_cast<Index>(this->Places.size()), 3);
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      imprint.lines.points.row(static_cast<Index>(i)) = this->Places[i];
    }
    imprint.lines.onBoundary = std::move(this->Outer);
    imprint.lines.pieces = std::move(this->Pieces);
    imprint.curveOf = std::move(this->CurveOf);
    imprint.ends.assign(this->Ends.begin(), this->Ends.end());
  }

private:
  Index append(const Eigen::RowVector3d& place, bool outer)
  {
    this->Places.push_back(place);
    this->Outer.push_back(outer);
    return static_cast<Index>(this->Places.size()) - 1;
  }

  Index idOf(Index given)
  {
    const auto known = this->Ids.find(given);
    return known != this->Ids.end()
      ? known->second
      : this->Ids[given] = this->append(this->Given.row(given), this->OnBoundary[at(given)]);
  }

  void addEdge(Index from, Index to)
  {
    const Eigen::RowVector3d a = this->Given.row(from);
    const Eigen::RowVector3d b = this->Given.row(to);
    const Index parts = this->Longest > 0.0
      ? std::max<Index>(1, static_cast<Index>(std::ceil((b - a).norm() / this->Longest)))
      : 1;
    Index last = this->idOf(from);
    for (Index k = 1; k <= parts; ++k)
    {
      const double along = static_cast<double>(k) / static_cast<double>(parts);
      const Index next =
        k < parts ? this->append((1.0 - along) * a + along * b, false) : this->idOf(to);
      this->Pieces.emplace_back(last, next);
      this->CurveOf.push_back(this->Curves);
      last = next;
    }
  }

  const Points& Given;
  const std::vector<bool>& OnBoundary;
  double Longest;
  Index Curves = 0;
  std::map<Index, Index> Ids;
  std::vector<Eigen::RowVector3d> Places;
  std::vector<bool> Outer;
  std::vector<std::pair<Index, Index>> Pieces;
  std::vector<Index> CurveOf;
  std::set<Index> Ends;
};

void collectBorders(const FacedCap& target, double reach, double longest, TargetImprint& imprint)
{
  const TriangleMesh& surface = target.surface;
  const std::vector<Loop> loops =
    checkSurface(surface.triangles, surface.points.rows(), "target cap").loops;
  std::vector<bool> onBoundary(at(surface.points.rows()), false);
  for (const Loop& loop : loops)
  {
    for (const Index point : loop)
    {
      onBoundary[at(point)] = true;
    }
  }
  BorderCollector collector(surface.points, onBoundary, longest);
  for (const CapCurve& curve : traceCapCurves(surface, loops, target.faceIds, {}, reach))
  {
    if (curve.loop < 0)
    {
      collector.add(curve);
    }
  }
  collector.moveTo(imprint);
}

bool isImprinted(const ImprintedSurface& cap, const std::pair<Index, Index>& ends)
{
  const auto found = std::lower_bound(cap.edges.begin(), cap.edges.end(), ends,
    [](const ImprintedEdge& edge, const std::pair<Index, Index>& key) { return edge.ends < key; });
  return found != cap.edges.end() && found->ends == ends;
}

/// By triangle: the first triangle of the region between imprinted edges that it is in.
std::vector<Index> regions(const ImprintedSurface& cap)
{
  DisjointSets sets(cap.mesh.triangles.rows());
  const std::vector<FaceSide> sides = sortedSides(cap.mesh.triangles, cap.mesh.points.rows());
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first == 2 && !isImprinted(cap, { sides[first].low, sides[first].high }))
    {
      sets.join(sides[first].face, sides[first + 1].face);
    }
  });
  std::vector<Index> roots;
  for (Index t = 0; t < cap.mesh.triangles.rows(); ++t)
  {
    roots.push_back(sets.find(t));
  }
  return roots;
}

/// By triangle: the target face that most of its region lies on.
std::vector<Index> targetFaces(
  const ImprintedSurface& cap, const FacedCap& target, const CapMaps& maps)
{
  const Index n = cap.mesh.triangles.rows();
  Points middles(n, 3);
  std::vector<double> areas;
  for (Index t = 0; t < n; ++t)
  {
    const Eigen::RowVector3d a = cap.mesh.points.row(cap.mesh.triangles(t, 0));
    const Eigen::RowVector3d b = cap.mesh.points.row(cap.mesh.triangles(t, 1));
    const Eigen::RowVector3d c = cap.mesh.points.row(cap.mesh.triangles(t, 2));
    middles.row(t) = (a + b + c) / 3.0;
    areas.push_back(0.5 * (b - a).cross(c - a).norm());
  }
  const Points images = maps.toTarget(middles);
  const TriangleSearch search(target.surface.points, target.surface.triangles);
  const std::vector<Index> roots = regions(cap);
  std::map<Index, std::map<Index, double>> shares;
  Index near = -1;
  for (Index t = 0; t < n; ++t)
  {
    near = search.closest(images.row(t), near).triangle;
    shares[roots[at(t)]][target.faceIds[at(near)]] += areas[at(t)];
  }
  std::vector<Index> faces;
  for (Index t = 0; t < n; ++t)
  {
    const std::map<Index, double>& share = shares[roots[at(t)]];
    faces.push_back(std::max_element(share.begin(), share.end(), [](const auto& a, const auto& b) {
      return a.second < b.second;
    })->first);
  }
  return faces;
}

/// The nearest place on each of the target's border curves.
class CurveSearch
{
public:
  explicit CurveSearch(const TargetImprint& imprint)
    : Imprint(imprint)
  {
    for (std::size_t p = 0; p < imprint.curveOf.size(); ++p)
    {
      this->Pieces[imprint.curveOf[p]].push_back(imprint.lines.pieces[p]);
    }
    for (const auto& [curve, pieces] : this->Pieces)
    {
      this->Searches.emplace(curve, edgeSearch(imprint.lines.points, pieces));
    }
  }

  Eigen::RowVector3d closest(Index curve, const Eigen::RowVector3d& place) const
  {
    const TrianglePoint found = this->Searches.at(curve).closest(place);
    const auto& [from, to] = this->Pieces.at(curve)[at(found.triangle)];
    const double along = 1.0 - found.coordinates[0];
    return (1.0 - along) * this->Imprint.lines.points.row(from) +
      along * this->Imprint.lines.points.row(to);
  }

private:
  const TargetImprint& Imprint;
  std::map<Index, std::vector<std::pair<Index, Index>>> Pieces;
  std::map<Index, TriangleSearch> Searches;
};
}

CapMaps mapsThroughDisks(const CapDisk& source, const CapDisk& target)
{
  const auto across = [](const PointsRef& points, const CapDisk& from, const CapDisk& to) {
    const std::vector<bool> all(at(points.rows()), true);
    return projectThroughDisks(points, all, {}, from, to).points;
  };
  return {
    [&source, &target, across](const PointsRef& points) { return across(points, source, target); },
    [&source, &target, across](const PointsRef& points) { return across(points, target, source); }
  };
}

std::vector<Index> TargetImprint::keep() const
{
  std::vector<Index> points;
  for (const Index end : this->ends)
  {
    points.push_back(this->cap.pointOf[at(end)]);
  }
  return points;
}

std::optional<TargetImprint> imprintTarget(const ImprintBase& source, const FacedCap& target,
  const CapMaps& maps, double reach, double longest)
{
  TargetImprint imprint;
  collectBorders(target, reach, longest, imprint);
  if (imprint.lines.pieces.empty())
  {
    return std::nullopt;
  }
  BorderLines onSource = imprint.lines;
  onSource.points = maps.toSource(imprint.lines.points);
  std::optional<ImprintedSurface> cap = imprintBorders(source, onSource);
  if (!cap)
  {
    return std::nullopt;
  }
  imprint.cap = std::move(*cap);
  const std::vector<Index> faces = targetFaces(imprint.cap, target, maps);
  std::map<std::pair<Index, Index>, Index> labelOf;
  std::set<Index> hidden(target.faceIds.begin(), target.faceIds.end());
  for (std::size_t t = 0; t < faces.size(); ++t)
  {
    hidden.erase(faces[t]);
    const Index sourceFace = source.faceIds[at(imprint.cap.triangleOrigin[t])];
    const auto label =
      labelOf.emplace(std::make_pair(sourceFace, faces[t]), static_cast<Index>(labelOf.size()));
    imprint.labels.push_back(label.first->second);
  }
  imprint.hiddenFaces.assign(hidden.begin(), hidden.end());
  return imprint;
}

std::vector<FixedNode> nodesOnBorders(const TargetImprint& imprint, const CapQuads& quads,
  const std::vector<Index>& endNodes, const CapMaps& maps)
{
  const Points& points = quads.mesh.points;
  std::vector<bool> isFree = quads.onCurve;
  for (const Index node : boundaryPoints(sortedSides(quads.mesh.quads, points.rows())))
  {
    isFree[at(node)] = false;
  }
  std::map<Index, Eigen::RowVector3d> places;
  for (std::size_t k = 0; k < endNodes.size(); ++k)
  {
    const bool endsOnLoop = imprint.lines.onBoundary[at(imprint.ends[k])];
    if (isFree[at(endNodes[k])] || endsOnLoop)
    {
      places.emplace(endNodes[k], imprint.lines.points.row(imprint.ends[k]));
    }
  }
  std::vector<std::pair<Index, Index>> ends;
  for (const ImprintedEdge& edge : imprint.cap.edges)
  {
    ends.push_back(edge.ends);
  }
  const TriangleSearch search = edgeSearch(imprint.cap.mesh.points, ends);
  const CurveSearch curves(imprint);
  const double rounding =
    ImprintRounding * (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  const Points images = maps.toTarget(points);
  for (Index node = 0; node < points.rows(); ++node)
  {
    if (!isFree[at(node)] || places.count(node) > 0)
    {
      continue;
    }
    const TrianglePoint found = search.closest(points.row(node));
    if (found.distance <= rounding)
    {
      const Index piece = imprint.cap.edges[at(found.triangle)].piece;
      places.emplace(node, curves.closest(imprint.curveOf[at(piece)], images.row(node)));
    }
  }
  std::vector<FixedNode> nodes;
  for (const auto& [node, place] : places)
  {
    nodes.push_back({ node, place });
  }
  return nodes;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/BoundarySliding.h"

#include "Core/Common/CellPatches.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Interior/SweptHexes.h"
#include "Core/Solids/CageNodes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
using Spot = Eigen::RowVector3d;

constexpr int MostRounds = 6;
constexpr int SweepsPerRound = 8;
constexpr double LeastGain = 1e-3; // of the minimum, for another round
/// Of the scaled Jacobian, above the minimum: hexahedra whose nodes are moved.
constexpr double LowBand = 0.1;
constexpr std::size_t MostLow = 2000;
constexpr double Sharpness = 20.0; // of the soft minimum
/// Of the way to the nearest corner of a hexahedron at a node.
constexpr double Strides[] = { 0.3, 0.1, 0.03, 0.01 };

/// Puts places on the faces of the solid.
class OnFaces
{
public:
  OnFaces(const SolidSurface& solid, const ModelGeometry* geometry)
    : Solid(solid)
    , Geometry(geometry)
    , All(solid.points, solid.triangles)
  {
  }

  std::optional<Spot> nearest(Index faceId, const Spot& place)
  {
    if (this->Geometry)
    {
      // The surface may go on beyond the borders of its face.
      const std::optional<Spot> found = this->Geometry->closestOnFace(faceId, place);
      const bool isWithin =
        found && this->Solid.faceIds[at(this->All.closest(*found).triangle)] == faceId;
      return isWithin ? found : std::nullopt;
    }
    Facets& facets = this->facetsOf(faceId);
    const TrianglePoint found = facets.search->closest(place);
    Spot point = Spot::Zero();
    for (int c = 0; c < 3; ++c)
    {
      point += found.coordinates[c] * this->Solid.points.row(facets.triangles(found.triangle, c));
    }
    return point;
  }

private:
  struct Facets
  {
    Triangles triangles;
    std::unique_ptr<TriangleSearch> search;
  };

  Facets& facetsOf(Index faceId)
  {
    const auto [entry, isNew] = this->Faces.try_emplace(faceId);
    Facets& facets = entry->second;
    if (isNew)
    {
      std::vector<Index> rows;
      for (Index t = 0; t < this->Solid.triangles.rows(); ++t)
      {
        if (this->Solid.faceIds[at(t)] == faceId)
        {
          rows.push_back(t);
        }
      }
      facets.triangles = this->Solid.triangles(rows, Eigen::all);
      facets.search = std::make_unique<TriangleSearch>(this->Solid.points, facets.triangles);
    }
    return facets;
  }

  const SolidSurface& Solid;
  const ModelGeometry* Geometry;
  TriangleSearch All;
  std::map<Index, Facets> Faces;
};

/// The hexahedra of a cage, and which of their nodes may move.
class NodeSliding
{
public:
  NodeSliding(const SolidSurface& solid, const SweepTopology& topology, OnFaces& faces,
    const SolidCage& cage, const Points& points, const GivenQuads& given)
    : Nodes(cageNodes(cage, solid, topology))
    , Faces(faces)
    , Given(given)
    , SourcePoints(cage.source.rows())
    , Hexes(sweptHexes(cage.quads, points, cage.boundary.numberOfLayers()))
    , HexesOf(this->Hexes, points.rows())
    , RowOf(at(points.rows()), -1)
    , Values(at(this->Hexes.rows()))
    , Places(points)
  {
    for (Index h = 0; h < this->Hexes.rows(); ++h)
    {
      this->Values[at(h)] = this->valueOf(h);
    }
    for (std::size_t row = 0; row < this->Nodes.points.size(); ++row)
    {
      this->RowOf[at(this->Nodes.points[row])] = static_cast<Index>(row);
    }
  }

  /// @return whether a boundary node has moved.
  bool sweep(const Progress& progress)
  {
    constexpr std::size_t NodesAPiece = 128;
    const std::vector<Index> nodes = this->nodesToMove();
    bool hasSlid = false;
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      if (i % NodesAPiece == 0)
      {
        reportProgress(progress, static_cast<double>(i) / static_cast<double>(nodes.size()));
      }
      const Index node = nodes[i];
      const Index row = this->RowOf[at(node)];
      if (row < 0)
      {
        this->moveFreely(node);
      }
      else if (this->isWithinFace(row))
      {
        hasSlid = this->moveOnFace(node, row) || hasSlid;
      }
    }
    return hasSlid;
  }

  const Points& points() const { return this->Places; }

  /// Moves the boundary of the cage to where its nodes are now.
  void placeBoundary(SolidCage& cage) const
  {
    Points places = this->Nodes.places;
    for (std::size_t row = 0; row < this->Nodes.points.size(); ++row)
    {
      places.row(static_cast<Index>(row)) = this->Places.row(this->Nodes.points[row]);
    }
    setPlaces(this->Nodes, places, cage);
    cage.isRuled = false;
  }

private:
  double valueOf(Index h) const
  {
    HexCorners corners;
    for (int c = 0; c < 8; ++c)
    {
      corners.row(c) = this->Places.row(this->Hexes(h, c));
    }
    return hexQuality(corners).scaledJacobian;
  }

  /// Of the lowest hexahedra, rising.
  std::vector<Index> nodesToMove() const
  {
    std::vector<Index> order(this->Values.size());
    for (std::size_t h = 0; h < order.size(); ++h)
    {
      order[h] = static_cast<Index>(h);
    }
    const std::size_t most = std::min(MostLow, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most), order.end(),
      [&](Index a, Index b) {
        return std::make_pair(this->Values[at(a)], a) < std::make_pair(this->Values[at(b)], b);
      });
    const double bound = this->Values[at(order.front())] + LowBand;
    std::vector<Index> nodes;
    for (std::size_t i = 0; i < most && this->Values[at(order[i])] <= bound; ++i)
    {
      for (int c = 0; c < 8; ++c)
      {
        nodes.push_back(this->Hexes(order[i], c));
      }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  /// Not on a loop, nor where faces meet.
  bool isWithinFace(Index row) const
  {
    const std::vector<Index>& quads = this->Nodes.quadsOf[at(row)];
    const FacedQuad& first = this->Nodes.quads[at(quads.front())];
    const bool isOfSource = this->Nodes.points[at(row)] < this->SourcePoints;
    if (first.isCap ? isOfSource && this->Given.source : this->Given.sides)
    {
      return false;
    }
    return std::all_of(quads.begin(), quads.end(), [&](Index q) {
      const FacedQuad& quad = this->Nodes.quads[at(q)];
      return quad.faceId == first.faceId && quad.isCap == first.isCap;
    });
  }

  /// To another corner of a hexahedron.
  double nearestCorner(Index node) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Index h : this->HexesOf[node])
    {
      for (const Index other : this->Hexes.row(h))
      {
        if (other != node)
        {
          nearest = std::min(nearest, (this->Places.row(other) - this->Places.row(node)).norm());
        }
      }
    }
    return nearest;
  }

  /// Higher where the hexahedra at a node are better.
  double worth(Index node) const
  {
    double sum = 0.0;
    for (const Index h : this->HexesOf[node])
    {
      sum -= std::exp(-Sharpness * this->valueOf(h));
    }
    return sum;
  }

  /// Takes the place that is worth most. @param candidates must not be where the node is.
  bool takeBest(Index node, const std::vector<Spot>& candidates)
  {
    const Spot here = this->Places.row(node);
    Spot best = here;
    double most = this->worth(node);
    for (const Spot& place : candidates)
    {
      this->Places.row(node) = place;
      const double worth = this->worth(node);
      if (worth > most)
      {
        most = worth;
        best = place;
      }
    }
    this->Places.row(node) = best;
    if (best == here)
    {
      return false;
    }
    for (const Index h : this->HexesOf[node])
    {
      this->Values[at(h)] = this->valueOf(h);
    }
    return true;
  }

  void moveFreely(Index node)
  {
    const double reach = this->nearestCorner(node);
    for (const double stride : Strides)
    {
      std::vector<Spot> candidates;
      for (int axis = 0; axis < 3; ++axis)
      {
        for (const double sign : { -1.0, 1.0 })
        {
          candidates.emplace_back(
            this->Places.row(node) + sign * stride * reach * Spot::Unit(axis));
        }
      }
      if (this->takeBest(node, candidates))
      {
        return;
      }
    }
  }

  bool moveOnFace(Index node, Index row)
  {
    Spot normal = Spot::Zero();
    Index face = -1;
    for (const Index q : this->Nodes.quadsOf[at(row)])
    {
      normal += this->Nodes.quads[at(q)].normal.normalized();
      face = this->Nodes.quads[at(q)].faceId;
    }
    if (!(normal.norm() > 0.0))
    {
      return false;
    }
    const Spot first = normal.normalized().unitOrthogonal();
    const Spot second = normal.normalized().cross(first);
    const double reach = this->nearestCorner(node);
    for (const double stride : Strides)
    {
      std::vector<Spot> candidates;
      for (const auto& [a, b] :
        { std::pair(1.0, 0.0), std::pair(-1.0, 0.0), std::pair(0.0, 1.0), std::pair(0.0, -1.0),
          std::pair(0.7, 0.7), std::pair(-0.7, 0.7), std::pair(0.7, -0.7), std::pair(-0.7, -0.7) })
      {
        const Spot aim = this->Places.row(node) + stride * reach * (a * first + b * second);
        const std::optional<Spot> place = this->Faces.nearest(face, aim);
        if (place && (*place - aim).norm() < stride * reach)
        {
          candidates.push_back(*place);
        }
      }
      if (this->takeBest(node, candidates))
      {
        return true;
      }
    }
    return false;
  }

  CageNodes Nodes;
  OnFaces& Faces;
  GivenQuads Given;
  Index SourcePoints;
  hexsweep::Hexes Hexes;
  CellsAtNodes HexesOf;
  std::vector<Index> RowOf;   // by node of the mesh: of Nodes, -1 inside
  std::vector<double> Values; // scaled Jacobians
  Points Places;
};

HexQualitySummary judged(const SolidCage& cage, const SweepInterior& interior)
{
  return summarize(interior.qualities.empty()
      ? hexQualities(
          interior.points, sweptHexes(cage.quads, interior.points, cage.boundary.numberOfLayers()))
      : interior.qualities);
}

void countMoves(const SolidCage& before, SlidBoundary& slid)
{
  const auto count = [&](const Points& from, const Points& to) {
    const Eigen::VectorXd moves = (to - from).rowwise().norm();
    slid.moved += (moves.array() > 0.0).count();
    slid.greatestMove = std::max(slid.greatestMove, moves.maxCoeff());
  };
  count(before.source, slid.cage.source);
  count(before.target, slid.cage.target);
  count(before.linking.rings.points, slid.cage.linking.rings.points);
}
}

SlidBoundary slideBoundary(const SolidSurface& solid, const SweepTopology& topology,
  const ModelGeometry* geometry, const SolidCage& cage, const GivenQuads& given,
  const std::vector<InteriorStart>& starts, const InteriorOptions& options,
  const Progress& progress)
{
  const auto part = [&](double round) {
    return progressPart(progress, round / (MostRounds + 1.0), (round + 1.0) / (MostRounds + 1.0));
  };
  InteriorOptions own = options;
  own.keepQualities = true;
  own.precision = Precision::Double; // rounded once, in the end
  SweepInterior interior = sweepInterior(cage, starts, own, part(0));
  HexQualitySummary quality = judged(cage, interior);
  SlidBoundary best{ cage, std::move(interior.points), std::move(interior.method) };
  OnFaces faces(solid, geometry);
  for (int round = 1; round <= MostRounds; ++round)
  {
    NodeSliding sliding(solid, topology, faces, best.cage, best.points, given);
    bool hasSlid = false;
    for (int sweep = 0; sweep < SweepsPerRound; ++sweep)
    {
      constexpr double Width = 0.5 / SweepsPerRound;
      hasSlid =
        sliding.sweep(progressPart(part(round), sweep * Width, (sweep + 1) * Width)) || hasSlid;
    }
    if (!hasSlid)
    {
      break;
    }
    try
    {
      SolidCage next = best.cage;
      sliding.placeBoundary(next);
      SweepInterior filled = sweepInterior(next, { startAt("Slid boundary", sliding.points()) },
        own, progressPart(part(round), 0.5, 1.0));
      const HexQualitySummary reached = judged(next, filled);
      const bool fewerBad = reached.notCertified < quality.notCertified;
      const bool higher = reached.notCertified == quality.notCertified &&
        reached.minScaledJacobian > quality.minScaledJacobian + LeastGain &&
        reached.minScaledJacobian + reached.meanScaledJacobian >
          quality.minScaledJacobian + quality.meanScaledJacobian;
      if (!fewerBad && !higher)
      {
        break;
      }
      best.cage = std::move(next);
      best.points = std::move(filled.points);
      quality = reached;
    }
    catch (const InvalidInput&)
    {
      break; // what was reached before stays
    }
    catch (const SolverFailure&)
    {
      break;
    }
  }
  countMoves(cage, best);
  return best;
}
}

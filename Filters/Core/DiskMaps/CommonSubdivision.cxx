// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DiskMaps/CommonSubdivision.h"

#include "Core/Surfaces/CrossedTriangle.h"
#include "Core/Surfaces/MeshEdgeTracing.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace hexsweep
{
namespace
{
using Plane = Eigen::RowVector2d;

/// A point of an intrinsic half-edge in the disk.
Plane onHalfEdge(const IntrinsicTriangulation& intrinsic, DiskDomain domain,
  const PlanePointsRef& disk, const Crossing& crossing)
{
  const Index t = crossing.half / 3;
  const Index c = crossing.half % 3;
  const auto corners = domainCorners(domain, disk, intrinsic.triangles.row(t));
  const Plane place =
    (1.0 - crossing.alongHalf) * corners.row(c) + crossing.alongHalf * corners.row((c + 1) % 3);
  return domain == DiskDomain::Annulus
    ? Plane(std::exp(place.x()) * Plane(std::cos(place.y()), std::sin(place.y())))
    : place;
}

/// Cuts more and more triangles until the map is carried without flips that are its own.
class Cutting
{
public:
  Cutting(const TriangleMesh& mesh, const IntrinsicTriangulation& intrinsic, DiskDomain domain,
    const PlanePointsRef& disk)
    : Mesh(mesh)
    , Domain(domain)
    , Neighbors(triangleNeighbors(mesh.triangles))
    , Traced(traceMeshEdges(intrinsic))
    , TracedSides(Triangles::Constant(mesh.triangles.rows(), 3, -1))
    , Cut(static_cast<std::size_t>(mesh.triangles.rows()), false)
  {
    std::map<std::pair<Index, Index>, Index> numberOf;
    Index count = 0;
    for (std::size_t e = 0; e < this->Traced.size(); ++e)
    {
      numberOf.emplace(
        std::make_pair(this->Traced[e].from, this->Traced[e].to), static_cast<Index>(e));
      count += static_cast<Index>(this->Traced[e].crossings.size());
    }
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      for (Index c = 0; c < 3; ++c)
      {
        const Index a = mesh.triangles(t, c);
        const Index b = mesh.triangles(t, (c + 1) % 3);
        const auto known = numberOf.find({ std::min(a, b), std::max(a, b) });
        this->TracedSides(t, c) = known == numberOf.end() ? -1 : known->second;
      }
    }
    // All points that there could be.
    const Index n = mesh.points.rows();
    this->AllPoints.resize(n + count, 3);
    this->AllPoints.topRows(n) = mesh.points;
    this->AllPlaces.resize(n + count, 2);
    this->AllPlaces.topRows(n) = disk;
    Index point = n;
    for (const TracedEdge& edge : this->Traced)
    {
      this->Inserted.emplace_back();
      for (const Crossing& crossing : edge.crossings)
      {
        this->Inserted.back().push_back(point);
        this->AllPoints.row(point) = (1.0 - crossing.along) * mesh.points.row(edge.from) +
          crossing.along * mesh.points.row(edge.to);
        this->AllPlaces.row(point) = onHalfEdge(intrinsic, domain, disk, crossing);
        ++point;
      }
    }
  }

  CutSurface cut(std::vector<Index> open)
  {
    for (std::size_t rings = 1; !open.empty(); rings *= 2)
    {
      this->addRings(std::move(open), rings);
      this->closeUp();
      this->makePieces();
      open.clear();
      const std::vector<Index> flipped =
        domainTriangles(this->Domain, this->AllPlaces, this->Pieces).flipped;
      for (const Index piece : flipped)
      {
        const Index t = this->Origin[static_cast<std::size_t>(piece)];
        if (!this->isCut(t) && this->hasTracedSide(t) && (open.empty() || open.back() != t))
        {
          open.push_back(t);
        }
      }
    }
    return this->compacted();
  }

private:
  bool isCut(Index t) const { return this->Cut[static_cast<std::size_t>(t)]; }
  bool hasTracedSide(Index t) const { return this->TracedSides.row(t).maxCoeff() >= 0; }

  /// Marks triangles and those around them, as far as crossed edges lead.
  void addRings(std::vector<Index> ring, std::size_t rings)
  {
    for (std::size_t r = 0; r < rings && !ring.empty(); ++r)
    {
      std::vector<Index> next;
      for (const Index t : ring)
      {
        this->Cut[static_cast<std::size_t>(t)] = true;
        for (Index c = 0; c < 3; ++c)
        {
          if (this->TracedSides(t, c) >= 0 && !this->isCut(this->Neighbors(t, c)))
          {
            next.push_back(this->Neighbors(t, c));
          }
        }
      }
      ring = std::move(next);
    }
  }

  /// A triangle with points on two sides or more is cut as well.
  void closeUp()
  {
    this->Wanted.assign(this->Traced.size(), false);
    std::vector<Index> open;
    for (Index t = 0; t < this->Mesh.triangles.rows(); ++t)
    {
      if (this->isCut(t))
      {
        open.push_back(t);
      }
    }
    while (!open.empty())
    {
      const Index t = open.back();
      open.pop_back();
      this->Cut[static_cast<std::size_t>(t)] = true;
      for (Index c = 0; c < 3; ++c)
      {
        const Index side = this->TracedSides(t, c);
        if (side < 0)
        {
          continue;
        }
        this->Wanted[static_cast<std::size_t>(side)] = true;
        const Index neighbor = this->Neighbors(t, c);
        if (!this->isCut(neighbor) && this->numberOfWantedSides(neighbor) > 1)
        {
          open.push_back(neighbor);
        }
      }
    }
  }

  Index numberOfWantedSides(Index t) const
  {
    Index count = 0;
    for (Index c = 0; c < 3; ++c)
    {
      const Index side = this->TracedSides(t, c);
      count += side >= 0 && this->Wanted[static_cast<std::size_t>(side)] ? 1 : 0;
    }
    return count;
  }

  void makePieces()
  {
    std::vector<PieceIds> pieces;
    this->Origin.clear();
    for (Index t = 0; t < this->Mesh.triangles.rows(); ++t)
    {
      const auto corners = this->Mesh.triangles.row(t);
      std::array<std::vector<Index>, 3> sides;
      for (Index c = 0; c < 3; ++c)
      {
        const Index side = this->TracedSides(t, c);
        if (side >= 0 && this->Wanted[static_cast<std::size_t>(side)])
        {
          std::vector<Index>& points = sides[static_cast<std::size_t>(c)];
          points = this->Inserted[static_cast<std::size_t>(side)];
          if (corners[c] > corners[(c + 1) % 3])
          {
            std::reverse(points.begin(), points.end());
          }
        }
      }
      const std::vector<PieceIds> ofTriangle =
        crossedTrianglePieces({ corners[0], corners[1], corners[2] }, sides, this->AllPoints);
      pieces.insert(pieces.end(), ofTriangle.begin(), ofTriangle.end());
      this->Origin.resize(pieces.size(), t);
    }
    this->Pieces.resize(static_cast<Index>(pieces.size()), 3);
    for (std::size_t p = 0; p < pieces.size(); ++p)
    {
      this->Pieces.row(static_cast<Index>(p)) << pieces[p][0], pieces[p][1], pieces[p][2];
    }
  }

  /// The pieces, with the points that they use.
  CutSurface compacted() const
  {
    const Index n = this->Mesh.points.rows();
    std::vector<Index> kept;
    for (Index i = 0; i < n; ++i)
    {
      kept.push_back(i);
    }
    std::vector<Index> number(static_cast<std::size_t>(this->AllPoints.rows()), -1);
    for (std::size_t e = 0; e < this->Inserted.size(); ++e)
    {
      if (this->Wanted[e])
      {
        kept.insert(kept.end(), this->Inserted[e].begin(), this->Inserted[e].end());
      }
    }
    CutSurface result;
    result.mesh.points.resize(static_cast<Index>(kept.size()), 3);
    result.disk.resize(static_cast<Index>(kept.size()), 2);
    for (std::size_t i = 0; i < kept.size(); ++i)
    {
      number[static_cast<std::size_t>(kept[i])] = static_cast<Index>(i);
      result.mesh.points.row(static_cast<Index>(i)) = this->AllPoints.row(kept[i]);
      result.disk.row(static_cast<Index>(i)) = this->AllPlaces.row(kept[i]);
    }
    result.mesh.triangles = this->Pieces;
    for (Index i = 0; i < result.mesh.triangles.size(); ++i)
    {
      Index& id = result.mesh.triangles.data()[i];
      id = number[static_cast<std::size_t>(id)];
    }
    result.triangleOrigin = this->Origin;
    return result;
  }

  const TriangleMesh& Mesh;
  DiskDomain Domain;
  Triangles Neighbors;
  std::vector<TracedEdge> Traced;
  std::vector<std::vector<Index>> Inserted; // points of each traced edge
  Triangles TracedSides;                    // traced edge on side c of triangle t; -1: none
  Points AllPoints;
  PlanePoints AllPlaces;
  std::vector<bool> Cut;    // triangles
  std::vector<bool> Wanted; // traced edges
  Triangles Pieces;
  std::vector<Index> Origin;
};
}

CutSurface cutAlongIntrinsicEdges(const TriangleMesh& mesh, const IntrinsicTriangulation& intrinsic,
  DiskDomain domain, const PlanePointsRef& disk, const std::vector<Index>& triangles)
{
  if (triangles.empty())
  {
    std::vector<Index> origin;
    for (Index t = 0; t < mesh.triangles.rows(); ++t)
    {
      origin.push_back(t);
    }
    return { mesh, origin, disk };
  }
  return Cutting(mesh, intrinsic, domain, disk).cut(triangles);
}
}

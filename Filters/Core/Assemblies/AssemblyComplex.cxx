// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblyComplex.h"

#include "Core/Common/Describe.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/PointGrid.h"
#include "Core/Surfaces/FaceSides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace hexsweep
{
namespace
{
using Place = std::array<double, 3>;
using EdgeEnds = std::pair<Index, Index>; // lower one first

/// Cosine of a turn that makes a point of a curve a corner.
const double CurveCornerCosine = std::cos(30.0 * Pi / 180.0);
/// Oblique to everything that engineers draw along axes.
const Eigen::RowVector3d StartDirection(0.7548776662466927, 0.5698402909980532, 0.3247179572447460);

/// Numbers the places of points, each once.
class PlaceNumbers
{
public:
  Index numberOf(const Eigen::RowVector3d& place)
  {
    const auto [known, isNew] = this->Numbers.try_emplace(
      Place{ place[0], place[1], place[2] }, static_cast<Index>(this->Numbers.size()));
    if (isNew)
    {
      this->Places.push_back(place);
    }
    return known->second;
  }

  Points points() const
  {
    Points result(static_cast<Index>(this->Places.size()), 3);
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      result.row(static_cast<Index>(i)) = this->Places[i];
    }
    return result;
  }

private:
  std::map<Place, Index> Numbers;
  std::vector<Eigen::RowVector3d> Places;
};

std::string nameOfFace(Index id)
{
  return "face " + std::to_string(id);
}

using Corners = std::array<Index, 3>;

/// A triangle of a solid in the numbers of the complex.
struct SolidTriangle
{
  Corners key; ///< the corners, rising
  Index volume;
  Index row;
  bool isEven; ///< whether the corners run as they rise, or turned round from there
};

SolidTriangle solidTriangle(const Corners& corners, Index volume, Index row)
{
  Corners key = corners;
  std::sort(key.begin(), key.end());
  const std::size_t first =
    static_cast<std::size_t>(std::find(corners.begin(), corners.end(), key[0]) - corners.begin());
  return { key, volume, row, corners[(first + 1) % 3] == key[1] };
}

/// By volume and triangle: the triangle of another volume at the same place that faces it.
struct Partner
{
  Index volume = -1;
  Index row = -1;
};

std::vector<std::vector<Partner>> partnersOf(
  const std::vector<const SolidSurface*>& solids, std::vector<SolidTriangle> all)
{
  std::vector<std::vector<Partner>> partners;
  for (const SolidSurface* solid : solids)
  {
    partners.emplace_back(at(solid->triangles.rows()));
  }
  std::sort(all.begin(), all.end(), [](const SolidTriangle& a, const SolidTriangle& b) {
    return std::tie(a.key, a.volume, a.row) < std::tie(b.key, b.volume, b.row);
  });
  for (std::size_t i = 0; i + 1 < all.size(); ++i)
  {
    const SolidTriangle& one = all[i];
    const SolidTriangle& other = all[i + 1];
    if (one.key != other.key)
    {
      continue;
    }
    if (i + 2 < all.size() && all[i + 2].key == one.key)
    {
      const SolidSurface& solid = *solids[at(one.volume)];
      throw InvalidInput(nameOfFace(solid.faceIds[at(one.row)]) + " at " +
        describe(solid.points.row(solid.triangles(one.row, 0))) +
        " belongs to more than two volumes. Check that no body is there twice.");
    }
    // Two that face the same way are the same body twice, and nothing that both share.
    if (one.isEven != other.isEven)
    {
      partners[at(one.volume)][at(one.row)] = { other.volume, other.row };
      partners[at(other.volume)][at(other.row)] = { one.volume, one.row };
    }
  }
  return partners;
}

/// Of triangles with labels: the first triangle of the piece of one label that each is in.
std::vector<Index> piecesOf(
  const Triangles& triangles, Index points, const std::vector<Index>& labels)
{
  DisjointSets pieces(triangles.rows());
  const std::vector<FaceSide> sides = sortedSides(triangles, points);
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
    {
      for (std::size_t j = i + 1; j < last; ++j)
      {
        if (labels[at(sides[i].face)] == labels[at(sides[j].face)])
        {
          pieces.join(sides[i].face, sides[j].face);
        }
      }
    }
  });
  std::vector<Index> result;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    result.push_back(pieces.find(t));
  }
  return result;
}

double shortestEdge(const Points& points, const std::vector<std::vector<Corners>>& triangles)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (const std::vector<Corners>& solid : triangles)
  {
    for (const Corners& corners : solid)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        shortest =
          std::min(shortest, (points.row(corners[c]) - points.row(corners[(c + 1) % 3])).norm());
      }
    }
  }
  return shortest;
}

/// For each point the lowest one that is near it, itself or by others.
std::vector<Index> nearPoints(const Points& points, double radius)
{
  std::vector<Index> ids(at(points.rows()));
  std::iota(ids.begin(), ids.end(), Index(0));
  if (!(radius > 0.0) || !std::isfinite(radius))
  {
    return ids;
  }
  const PointGrid grid(points, ids, radius);
  DisjointSets sets(points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    grid.forEachNear(points.row(i), radius, [&](Index other, double) { sets.join(i, other); });
  }
  for (Index& id : ids)
  {
    id = sets.find(id);
  }
  return ids;
}

/// Collects faces and triangles, volume after volume.
void addSolids(
  const std::vector<const SolidSurface*>& solids, double matchTolerance, AssemblyComplex& complex)
{
  PlaceNumbers places;
  std::vector<std::vector<Corners>> corners;
  std::vector<SolidTriangle> all;
  for (const SolidSurface* const given : solids)
  {
    const SolidSurface& solid = *given;
    corners.emplace_back(at(solid.triangles.rows()));
    for (Index t = 0; t < solid.triangles.rows(); ++t)
    {
      Corners& own = corners.back()[at(t)];
      for (int c = 0; c < 3; ++c)
      {
        own[static_cast<std::size_t>(c)] = places.numberOf(solid.points.row(solid.triangles(t, c)));
      }
    }
  }
  complex.points = places.points();
  const std::vector<Index> merged =
    nearPoints(complex.points, matchTolerance * shortestEdge(complex.points, corners));
  for (std::size_t v = 0; v < solids.size(); ++v)
  {
    for (std::size_t t = 0; t < corners[v].size(); ++t)
    {
      for (Index& corner : corners[v][t])
      {
        corner = merged[at(corner)];
      }
      all.push_back(solidTriangle(corners[v][t], static_cast<Index>(v), static_cast<Index>(t)));
    }
  }
  const std::vector<std::vector<Partner>> partners = partnersOf(solids, std::move(all));

  // What is a face of two volumes is one: by both volumes and both ids.
  using Label = std::array<Index, 4>;
  std::map<Label, Index> numberOf;
  std::vector<Label> labelOf;
  std::vector<Corners> triangles;
  std::vector<Index> labels;
  for (std::size_t v = 0; v < solids.size(); ++v)
  {
    for (std::size_t t = 0; t < corners[v].size(); ++t)
    {
      const Partner& partner = partners[v][t];
      if (partner.volume >= 0 && partner.volume < static_cast<Index>(v))
      {
        continue;
      }
      const Label label{ static_cast<Index>(v), solids[v]->faceIds[t], partner.volume,
        partner.volume < 0 ? 0 : solids[at(partner.volume)]->faceIds[at(partner.row)] };
      const auto [known, isNew] = numberOf.try_emplace(label, static_cast<Index>(labelOf.size()));
      if (isNew)
      {
        labelOf.push_back(label);
      }
      labels.push_back(known->second);
      triangles.push_back(corners[v][t]);
    }
  }
  complex.triangles =
    Eigen::Map<const Triangles>(triangles.front().data(), static_cast<Index>(triangles.size()), 3);
  const std::vector<Index> pieces = piecesOf(complex.triangles, complex.points.rows(), labels);
  std::map<Index, Index> faceOfPiece;
  complex.volumes.resize(solids.size());
  for (std::size_t t = 0; t < labels.size(); ++t)
  {
    const auto [known, isNew] =
      faceOfPiece.try_emplace(pieces[t], static_cast<Index>(complex.faces.size()));
    if (isNew)
    {
      const Label& label = labelOf[at(labels[t])];
      complex.faces.push_back({ label[1], label[3], {}, { label[0] }, {} });
      complex.volumes[at(label[0])].faces.push_back(known->second);
      if (label[2] >= 0)
      {
        complex.faces.back().volumes.push_back(label[2]);
        complex.volumes[at(label[2])].faces.push_back(known->second);
      }
    }
    complex.faces[at(known->second)].triangles.push_back(static_cast<Index>(t));
    complex.faceOf.push_back(known->second);
  }
}

/// The edges at which faces meet, with these faces.
std::map<EdgeEnds, std::vector<Index>> borderEdges(const AssemblyComplex& complex)
{
  std::map<EdgeEnds, std::vector<Index>> borders;
  const std::vector<FaceSide> sides = sortedSides(complex.triangles, complex.points.rows());
  forEachEdge(sides, [&](std::size_t first, std::size_t last) {
    std::vector<Index> faces;
    for (std::size_t s = first; s < last; ++s)
    {
      faces.push_back(complex.faceOf[at(sides[s].face)]);
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    if (faces.size() > 1)
    {
      borders[{ sides[first].low, sides[first].high }] = std::move(faces);
    }
  });
  return borders;
}

/// Follows border edges into curves.
class CurveTracer
{
public:
  explicit CurveTracer(AssemblyComplex& complex)
    : Complex(complex)
    , Borders(borderEdges(complex))
  {
    for (const auto& [ends, faces] : this->Borders)
    {
      this->Beside[ends.first].push_back(ends.second);
      this->Beside[ends.second].push_back(ends.first);
    }
  }

  void trace()
  {
    for (const auto& [point, others] : this->Beside)
    {
      if (this->isVertex(point))
      {
        for (const Index other : others)
        {
          this->follow(point, other);
        }
      }
    }
    // What is left is closed and smooth.
    for (const auto& [ends, faces] : this->Borders)
    {
      if (this->Done.count(ends) == 0)
      {
        this->follow(ends.first, ends.second);
        this->turnToStart(this->Complex.curves.back().points);
      }
    }
  }

private:
  static EdgeEnds edge(Index a, Index b) { return std::minmax(a, b); }

  bool isVertex(Index point) const
  {
    const std::vector<Index>& others = this->Beside.at(point);
    if (others.size() != 2 ||
      this->Borders.at(edge(point, others[0])) != this->Borders.at(edge(point, others[1])))
    {
      return true;
    }
    const Points& points = this->Complex.points;
    const Eigen::RowVector3d in = points.row(point) - points.row(others[0]);
    const Eigen::RowVector3d out = points.row(others[1]) - points.row(point);
    return in.dot(out) < CurveCornerCosine * in.norm() * out.norm();
  }

  void follow(Index from, Index to)
  {
    if (this->Done.count(edge(from, to)) > 0)
    {
      return;
    }
    ComplexCurve curve;
    curve.points = { from, to };
    curve.faces = this->Borders.at(edge(from, to));
    this->Done.insert(edge(from, to));
    while (curve.points.back() != from && !this->isVertex(curve.points.back()))
    {
      const Index here = curve.points.back();
      const std::vector<Index>& others = this->Beside.at(here);
      const Index next = others[0] == curve.points[curve.points.size() - 2] ? others[1] : others[0];
      this->Done.insert(edge(here, next));
      curve.points.push_back(next);
    }
    this->Complex.curves.push_back(std::move(curve));
  }

  void turnToStart(std::vector<Index>& closed) const
  {
    closed.pop_back();
    const auto far = std::max_element(closed.begin(), closed.end(), [&](Index a, Index b) {
      return StartDirection.dot(this->Complex.points.row(a)) <
        StartDirection.dot(this->Complex.points.row(b));
    });
    std::rotate(closed.begin(), far, closed.end());
    closed.push_back(closed.front());
  }

  AssemblyComplex& Complex;
  std::map<EdgeEnds, std::vector<Index>> Borders;
  std::map<Index, std::vector<Index>> Beside;
  std::set<EdgeEnds> Done;
};

/// Finds the loops of each face as chains of curves.
void traceFaceLoops(AssemblyComplex& complex)
{
  struct Step
  {
    Index curve;
    bool reversed;
  };
  // By directed edge: the curve that begins with it.
  std::map<EdgeEnds, Step> begins;
  std::map<EdgeEnds, Step> steps;
  for (std::size_t c = 0; c < complex.curves.size(); ++c)
  {
    const std::vector<Index>& points = complex.curves[c].points;
    const Index row = static_cast<Index>(c);
    begins[{ points[0], points[1] }] = { row, false };
    begins[{ points[points.size() - 1], points[points.size() - 2] }] = { row, true };
  }
  for (ComplexFace& face : complex.faces)
  {
    std::map<EdgeEnds, bool> own;
    for (const Index t : face.triangles)
    {
      for (Index c = 0; c < 3; ++c)
      {
        own[{ complex.triangles(t, c), complex.triangles(t, (c + 1) % 3) }] = true;
      }
    }
    // Uses of curves by their first point.
    std::multimap<Index, CurveUse> uses;
    for (const auto& [edge, there] : own)
    {
      const auto begin = begins.find(edge);
      if (own.count({ edge.second, edge.first }) == 0 && begin != begins.end())
      {
        uses.emplace(edge.first, CurveUse{ begin->second.curve, begin->second.reversed });
      }
    }
    while (!uses.empty())
    {
      const Index start = uses.begin()->first;
      Index here = start;
      face.loops.emplace_back();
      do
      {
        const auto next = uses.find(here);
        if (next == uses.end() || uses.count(here) > 1)
        {
          throw InvalidInput("the border of " + nameOfFace(face.id) + " touches itself at " +
            describe(complex.points.row(here)) + ". Cut the face there in the CAD system.");
        }
        const CurveUse use = next->second;
        uses.erase(next);
        face.loops.back().push_back(use);
        const std::vector<Index>& points = complex.curves[at(use.curve)].points;
        here = use.reversed ? points.front() : points.back();
      } while (here != start);
    }
  }
}
}

AssemblyComplex makeAssemblyComplex(
  const std::vector<const SolidSurface*>& solids, double matchTolerance)
{
  AssemblyComplex complex;
  addSolids(solids, matchTolerance, complex);
  traceCurves(complex);
  return complex;
}

void traceCurves(AssemblyComplex& complex)
{
  complex.curves.clear();
  for (ComplexFace& face : complex.faces)
  {
    face.loops.clear();
  }
  CurveTracer(complex).trace();
  traceFaceLoops(complex);
}

std::vector<Index> rowsOfFaces(
  const AssemblyComplex& complex, Index volume, const std::vector<Index>& ids)
{
  std::vector<Index> rows;
  for (const Index face : complex.volumes[at(volume)].faces)
  {
    if (std::find(ids.begin(), ids.end(), complex.faces[at(face)].idIn(volume)) != ids.end())
    {
      rows.push_back(face);
    }
  }
  return rows;
}

std::vector<Index> idsOfFaces(
  const AssemblyComplex& complex, Index volume, const std::vector<Index>& faces)
{
  std::set<Index> ids;
  for (const Index face : faces)
  {
    ids.insert(complex.faces[at(face)].idIn(volume));
  }
  return { ids.begin(), ids.end() };
}

std::vector<Index> trianglesOfFaces(const AssemblyComplex& complex, const std::vector<Index>& faces)
{
  std::vector<Index> rows;
  for (const Index face : faces)
  {
    const std::vector<Index>& own = complex.faces[at(face)].triangles;
    rows.insert(rows.end(), own.begin(), own.end());
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

SurfacePart partOfVolume(
  const AssemblyComplex& complex, Index volume, const std::vector<Index>& triangles)
{
  SurfacePart part = surfacePart(complex.points, complex.triangles, triangles);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (complex.faces[at(complex.faceOf[at(triangles[t])])].volumes.front() != volume)
    {
      std::swap(part.mesh.triangles(static_cast<Index>(t), 1),
        part.mesh.triangles(static_cast<Index>(t), 2));
    }
  }
  return part;
}

TriangleMesh meshOfFaces(
  const AssemblyComplex& complex, Index volume, const std::vector<Index>& faces)
{
  return partOfVolume(complex, volume, trianglesOfFaces(complex, faces)).mesh;
}

Points placesOf(const AssemblyComplex& complex, const ComplexCurve& curve)
{
  Points places(static_cast<Index>(curve.points.size()), 3);
  for (std::size_t k = 0; k < curve.points.size(); ++k)
  {
    places.row(static_cast<Index>(k)) = complex.points.row(curve.points[k]);
  }
  return places;
}

double lengthOf(const AssemblyComplex& complex, const ComplexCurve& curve)
{
  double length = 0.0;
  for (std::size_t k = 1; k < curve.points.size(); ++k)
  {
    length +=
      (complex.points.row(curve.points[k]) - complex.points.row(curve.points[k - 1])).norm();
  }
  return length;
}
}

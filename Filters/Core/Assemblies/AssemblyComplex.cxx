// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/AssemblyComplex.h"

#include "Core/Assemblies/SharedTriangles.h"
#include "Core/Common/Describe.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Surfaces/FaceSides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
using EdgeEnds = std::pair<Index, Index>; // lower one first

/// Cosine of a turn that makes a point of a curve a corner.
const double CurveCornerCosine = std::cos(30.0 * Pi / 180.0);
/// Oblique to everything that engineers draw along axes.
const Eigen::RowVector3d StartDirection(0.7548776662466927, 0.5698402909980532, 0.3247179572447460);

std::string nameOfFace(Index id)
{
  return "face " + std::to_string(id);
}

/// Collects faces and triangles, volume after volume.
void addSolids(
  const std::vector<const SolidSurface*>& solids, double matchTolerance, AssemblyComplex& complex)
{
  SharedTriangles shared = shareTriangles(solids, matchTolerance);
  complex.points = std::move(shared.points);
  const std::vector<std::vector<TriangleCorners>>& corners = shared.corners;
  const std::vector<std::vector<Partner>>& partners = shared.partners;

  // What is a face of two volumes is one: by both volumes and both ids.
  using Label = std::array<Index, 4>;
  std::map<Label, Index> numberOf;
  std::vector<Label> labelOf;
  std::vector<TriangleCorners> triangles;
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
  // Volumes that lie through each other may have no triangle left.
  complex.triangles = Eigen::Map<const Triangles>(
    triangles.empty() ? nullptr : triangles[0].data(), static_cast<Index>(triangles.size()), 3);
  const std::vector<Index> pieces =
    connectedPieces(complex.triangles, complex.points.rows(), labels);
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
    if (others.size() != 2 || this->Complex.vertices.count(point) > 0 ||
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

std::vector<Index> connectedPieces(
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

Index firstPointOf(const AssemblyComplex& complex, const CurveUse& use)
{
  const std::vector<Index>& points = complex.curves[at(use.curve)].points;
  return use.reversed ? points.back() : points.front();
}

Index lastPointOf(const AssemblyComplex& complex, const CurveUse& use)
{
  return firstPointOf(complex, { use.curve, !use.reversed });
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

double turnOf(const AssemblyComplex& complex, const ComplexCurve& curve)
{
  const Points places = placesOf(complex, curve);
  double turn = 0.0;
  for (Index k = 1; k + 1 < places.rows(); ++k)
  {
    const Eigen::RowVector3d in = places.row(k) - places.row(k - 1);
    const Eigen::RowVector3d out = places.row(k + 1) - places.row(k);
    turn += std::atan2(in.cross(out).norm(), in.dot(out));
  }
  return turn;
}
}

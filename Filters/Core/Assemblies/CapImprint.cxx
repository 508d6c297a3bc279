// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/CapImprint.h"

#include "Core/Assemblies/ComplexCuts.h"
#include "Core/Assemblies/CurveImages.h"
#include "Core/CapQuads/CapCurves.h"
#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Solids/AffineSweep.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Solids/SweepTopology.h"
#include "Core/Solids/TargetImprint.h"
#include "Core/Surfaces/SurfacePart.h"
#include "Core/Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace hexsweep
{
namespace
{
/// Of the wanted edges: borders this near to each other become one.
constexpr double Near = 0.02;
/// Of the wanted edges, and of a border's length: its image is no farther from the curves that it
/// became.
constexpr double FarFromImage = 2.0 * Near;
constexpr double FarFromShort = 0.05;

std::vector<Index> facesOfRows(const AssemblyComplex& complex, const std::vector<Index>& triangles)
{
  std::vector<Index> faces;
  for (const Index t : triangles)
  {
    faces.push_back(complex.faceOf[at(t)]);
  }
  return faces;
}

/// Ends of the curves of a cap, in the numbers of its part.
std::vector<Index> verticesOf(
  const AssemblyComplex& complex, const std::vector<Index>& cap, const SurfacePart& part)
{
  std::set<Index> ends;
  for (const ComplexCurve& curve : complex.curves)
  {
    const bool touches = std::any_of(curve.faces.begin(), curve.faces.end(),
      [&](Index face) { return std::binary_search(cap.begin(), cap.end(), face); });
    if (touches)
    {
      ends.insert(curve.points.front());
      ends.insert(curve.points.back());
    }
  }
  std::vector<Index> own;
  for (const Index end : ends)
  {
    own.push_back(part.idOf(end));
  }
  return own;
}

/// Edges of a cap's boundary that have new points. @param idOf complex point of each of the mesh.
CutEdges cutBoundary(const ImprintedSurface& cap, Index givenPoints, const std::vector<Index>& idOf)
{
  CutEdges cut;
  for (const Loop& loop :
    checkSurface(cap.mesh.triangles, cap.mesh.points.rows(), "source cap").loops)
  {
    const std::size_t n = loop.size();
    for (std::size_t k = 0; k < n; ++k)
    {
      if (loop[k] >= givenPoints)
      {
        continue;
      }
      std::vector<Index> between;
      std::size_t next = (k + 1) % n;
      while (loop[next] >= givenPoints)
      {
        between.push_back(idOf[at(loop[next])]);
        next = (next + 1) % n;
      }
      if (between.empty())
      {
        continue;
      }
      Index from = idOf[at(loop[k])];
      Index to = idOf[at(loop[next])];
      if (from > to)
      {
        std::swap(from, to);
        std::reverse(between.begin(), between.end());
      }
      cut[{ from, to }] = std::move(between);
    }
  }
  return cut;
}

/// The edge that two triangles share, lower end first; nothing where they share none.
std::optional<std::pair<Index, Index>> sharedEdge(const Triangles& triangles, Index t, Index u)
{
  std::vector<Index> shared;
  for (Index c = 0; c < 3; ++c)
  {
    if ((triangles.row(u).array() == triangles(t, c)).any())
    {
      shared.push_back(triangles(t, c));
    }
  }
  return shared.size() == 2
    ? std::optional<std::pair<Index, Index>>(std::minmax(shared[0], shared[1]))
    : std::nullopt;
}

/// Edges inside a cap that have new points: other faces may meet there.
void addCutInside(const ImprintedSurface& cap, const TriangleMesh& given,
  const std::vector<Index>& idOf, CutEdges& cut)
{
  std::map<Index, std::set<Index>> originsAt; // of new points
  for (Index t = 0; t < cap.mesh.triangles.rows(); ++t)
  {
    for (Index c = 0; c < 3; ++c)
    {
      if (cap.mesh.triangles(t, c) >= given.points.rows())
      {
        originsAt[cap.mesh.triangles(t, c)].insert(cap.triangleOrigin[at(t)]);
      }
    }
  }
  std::map<std::pair<Index, Index>, std::vector<Index>> onEdge;
  for (const auto& [point, origins] : originsAt)
  {
    if (origins.size() == 2)
    {
      if (const auto edge = sharedEdge(given.triangles, *origins.begin(), *origins.rbegin()))
      {
        onEdge[*edge].push_back(point);
      }
    }
  }
  for (auto& [edge, points] : onEdge)
  {
    // The cap's numbers rise with the complex's, so lower ends are lower there, too.
    const Eigen::RowVector3d from = given.points.row(edge.first);
    std::sort(points.begin(), points.end(), [&, &cap = cap](Index a, Index b) {
      return (cap.mesh.points.row(a) - from).squaredNorm() <
        (cap.mesh.points.row(b) - from).squaredNorm();
    });
    std::vector<Index>& between = cut[{ idOf[at(edge.first)], idOf[at(edge.second)] }];
    for (const Index point : points)
    {
      between.push_back(idOf[at(point)]);
    }
  }
}

/// Replaces the triangles of a source cap by those that were cut.
void replaceCap(const std::vector<Index>& rows, const SurfacePart& part, Index volume,
  const TargetImprint& imprint, AssemblyComplex& complex)
{
  const Index given = static_cast<Index>(part.points.size());
  const Index added = imprint.cap.mesh.points.rows() - given;
  std::vector<Index> idOf = part.points;
  const Index first = complex.points.rows();
  complex.points.conservativeResize(first + added, Eigen::NoChange);
  complex.points.bottomRows(added) = imprint.cap.mesh.points.bottomRows(added);
  for (Index i = 0; i < added; ++i)
  {
    idOf.push_back(first + i);
  }
  CutEdges cut = cutBoundary(imprint.cap, given, idOf);
  addCutInside(imprint.cap, part.mesh, idOf, cut);
  TriangleList list;
  std::size_t next = 0;
  for (Index t = 0; t < complex.triangles.rows(); ++t)
  {
    if (next < rows.size() && rows[next] == t)
    {
      ++next;
      continue;
    }
    list.addCut({ complex.triangles(t, 0), complex.triangles(t, 1), complex.triangles(t, 2) },
      complex.faceOf[at(t)], cut);
  }
  std::vector<Index> labels; // by face and what lies over it
  std::map<std::pair<Index, Index>, Index> labelOf;
  for (std::size_t t = 0; t < imprint.labels.size(); ++t)
  {
    const Index face = complex.faceOf[at(rows[at(imprint.cap.triangleOrigin[t])])];
    labels.push_back(
      labelOf.try_emplace({ face, imprint.labels[t] }, static_cast<Index>(labelOf.size()))
        .first->second);
  }
  const std::vector<Index> pieces =
    connectedPieces(imprint.cap.mesh.triangles, imprint.cap.mesh.points.rows(), labels);
  std::map<Index, Index> faceOfPiece;
  std::set<Index> kept;
  for (Index t = 0; t < imprint.cap.mesh.triangles.rows(); ++t)
  {
    const Index face = complex.faceOf[at(rows[at(imprint.cap.triangleOrigin[at(t)])])];
    auto known = faceOfPiece.find(pieces[at(t)]);
    if (known == faceOfPiece.end())
    {
      Index row = face;
      if (!kept.insert(face).second)
      {
        row = static_cast<Index>(complex.faces.size());
        complex.faces.push_back({ complex.faces[at(face)].id, complex.faces[at(face)].otherId, {},
          complex.faces[at(face)].volumes, {} });
        for (const Index v : complex.faces.back().volumes)
        {
          complex.volumes[at(v)].faces.push_back(row);
        }
      }
      known = faceOfPiece.emplace(pieces[at(t)], row).first;
    }
    std::array<Index, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      corners[c] = idOf[at(imprint.cap.mesh.triangles(t, static_cast<Index>(c)))];
    }
    if (complex.faces[at(face)].volumes.front() != volume)
    {
      std::swap(corners[1], corners[2]);
    }
    list.add(corners, known->second);
  }
  list.moveTo(complex);
}

/// What a volume's caps are, however faces are cut.
struct CapIds
{
  std::vector<Index> sources;
  std::vector<Index> targets;
};

/// A volume with borders on its target cap that go back to its source cap.
struct BorderedVolume
{
  Index volume;
  const CapIds& ids;
  AffineMap map;  ///< from the source to the target
  AffineMap back; ///< the inverse
};

std::string describeBorders(const CapIds& ids)
{
  return "the borders between " + listFaces(ids.targets) + " at its target";
}

BorderedVolume borderedVolume(
  const AssemblyComplex& complex, Index volume, const CapIds& ids, const SolidSurface& solid)
{
  SweepLayout caps;
  caps.sources = rowsOfFaces(complex, volume, ids.sources);
  caps.targets = rowsOfFaces(complex, volume, ids.targets);
  const std::optional<AffineMap> map = capMapOf(complex, volume, caps, solid);
  if (!map)
  {
    throw ImprintFailure(volume, describeBorders(ids) + " have no image on its source.");
  }
  return { volume, ids, *map, inverse(*map) };
}

void cutSource(const BorderedVolume& own, double size, AssemblyComplex& complex)
{
  const Index volume = own.volume;
  const std::vector<Index> sources = rowsOfFaces(complex, volume, own.ids.sources);
  const std::vector<Index> sourceRows = trianglesOfFaces(complex, sources);
  const std::vector<Index> targetRows =
    trianglesOfFaces(complex, rowsOfFaces(complex, volume, own.ids.targets));
  const SurfacePart source = partOfVolume(complex, volume, sourceRows);
  const SurfacePart target = partOfVolume(complex, volume, targetRows);
  const CapMaps maps{ [&](const PointsRef& points) { return own.map.apply(points); },
    [&](const PointsRef& points) { return own.back.apply(points); } };
  const std::optional<TargetImprint> imprint =
    imprintTarget({ source.mesh, facesOfRows(complex, sourceRows),
                    verticesOf(complex, sources, source), {}, Near * size },
      { target.mesh, facesOfRows(complex, targetRows) }, maps, size);
  if (!imprint)
  {
    throw ImprintFailure(volume, describeBorders(own.ids) + " find no way over its source.");
  }
  replaceCap(sourceRows, source, volume, *imprint, complex);
}

/// A border on the target, the curves that it became, and its image.
struct BorderImage
{
  Index border;
  std::vector<CurveUse> path;
  Eigen::RowVector3d start; ///< of the image
};

/// @throw ImprintFailure where a border became no curves.
std::vector<BorderImage> imagesOfBorders(
  const BorderedVolume& own, double size, const AssemblyComplex& complex)
{
  std::vector<BorderImage> images;
  const std::vector<Index> sources = rowsOfFaces(complex, own.volume, own.ids.sources);
  for (const Index c : innerCurves(complex, rowsOfFaces(complex, own.volume, own.ids.targets)))
  {
    const ComplexCurve& border = complex.curves[at(c)];
    const Points image = own.back.apply(placesOf(complex, border));
    const double tolerance =
      std::min(FarFromImage * size, FarFromShort * ArcLengthChain(image).length());
    images.push_back(
      { c, CurveImages(complex, sources, tolerance).find(image, border.closed()), image.row(0) });
    if (images.back().path.empty())
    {
      throw ImprintFailure(own.volume,
        describeBorders(own.ids) + ", near " + describe(image.row(0)) +
          ", cross those of its source so closely that they cannot be told apart. Move one of them "
          "in the CAD system, or sweep the volume between other caps.");
    }
  }
  return images;
}

/// Ends borders of the target where the curves that they became end: where other borders of the
/// source cross them.
void endBordersLikeImages(const BorderedVolume& own, double size, AssemblyComplex& complex)
{
  std::map<std::pair<Index, Index>, std::map<double, Index>> split; // by edge and share of it
  const std::size_t known = complex.vertices.size();
  std::vector<Eigen::RowVector3d> added;
  for (const BorderImage& image : imagesOfBorders(own, size, complex))
  {
    const ComplexCurve& border = complex.curves[at(image.border)];
    const ArcLengthChain chain(placesOf(complex, border));
    for (std::size_t k = 0; k < image.path.size(); ++k)
    {
      const Index end = firstPointOf(complex, image.path[k]);
      const bool isStart = k == 0 &&
        (!border.closed() || (complex.points.row(end) - image.start).norm() <= Near * size);
      if (isStart)
      {
        continue;
      }
      const ChainPlace place = nearestOnChain(chain, own.map.apply(complex.points.row(end)));
      const Index a = border.points[at(place.edge)];
      const Index b = border.points[at(place.edge + 1)];
      const double length = (complex.points.row(b) - complex.points.row(a)).norm();
      if (std::min(place.along, 1.0 - place.along) * length <= 0.5 * Near * size)
      {
        complex.vertices.insert(place.along < 0.5 ? a : b);
        continue;
      }
      const bool turned = a > b;
      const Index point = complex.points.rows() + static_cast<Index>(added.size());
      const bool isNew = split[std::minmax(a, b)]
                           .try_emplace(turned ? 1.0 - place.along : place.along, point)
                           .second;
      if (isNew)
      {
        added.push_back(chain.at(place.length));
        complex.vertices.insert(point);
      }
    }
  }
  if (complex.vertices.size() == known)
  {
    return;
  }
  const Index first = complex.points.rows();
  complex.points.conservativeResize(first + static_cast<Index>(added.size()), Eigen::NoChange);
  for (std::size_t i = 0; i < added.size(); ++i)
  {
    complex.points.row(first + static_cast<Index>(i)) = added[i];
  }
  CutEdges cut;
  for (const auto& [edge, points] : split)
  {
    for (const auto& [share, point] : points)
    {
      cut[edge].push_back(point);
    }
  }
  cutTriangles(cut, complex);
}

std::vector<CarriedCurve> carriedCurves(
  const BorderedVolume& own, double size, const AssemblyComplex& complex)
{
  std::vector<CarriedCurve> carried;
  for (BorderImage& image : imagesOfBorders(own, size, complex))
  {
    carried.push_back({ std::move(image.path), { image.border, false } });
  }
  return carried;
}
}

std::optional<AffineMap> capMapOf(const AssemblyComplex& complex, Index volume,
  const SweepLayout& layout, const SolidSurface& solid)
{
  try
  {
    const std::optional<AffineSweep> sweep = findAffineSweep(solid,
      sweepBetween(solid, idsOfFaces(complex, volume, layout.sources),
        idsOfFaces(complex, volume, layout.targets)));
    return sweep && isInvertible(sweep->map) ? std::optional<AffineMap>(sweep->map) : std::nullopt;
  }
  catch (const InvalidInput&)
  {
    return std::nullopt;
  }
}

void imprintTargets(const std::vector<const SolidSurface*>& solids, double size,
  AssemblyComplex& complex, AssemblyPlan& plan)
{
  std::vector<CapIds> ids;
  for (std::size_t v = 0; v < plan.sweeps.size(); ++v)
  {
    const SweepLayout& layout = plan.sweeps[v];
    const Index volume = static_cast<Index>(v);
    ids.push_back(
      { idsOfFaces(complex, volume, layout.sources), idsOfFaces(complex, volume, layout.targets) });
  }
  std::vector<BorderedVolume> bordered; // from the ends of the stacks back
  for (auto v = plan.order.rbegin(); v != plan.order.rend(); ++v)
  {
    const CapIds& own = ids[at(*v)];
    if (needsImprint(complex, rowsOfFaces(complex, *v, own.targets)))
    {
      bordered.push_back(borderedVolume(complex, *v, own, *solids[at(*v)]));
      cutSource(bordered.back(), size, complex);
    }
  }
  if (bordered.empty())
  {
    return;
  }
  // Where a border ends goes on from stack to stack, as the quads will.
  for (auto own = bordered.rbegin(); own != bordered.rend(); ++own)
  {
    endBordersLikeImages(*own, size, complex);
  }
  for (std::size_t v = 0; v < plan.sweeps.size(); ++v)
  {
    const Index row = static_cast<Index>(v);
    if (!ids[v].sources.empty()) // else it is left out
    {
      plan.sweeps[v] = layOutSides(complex, row, rowsOfFaces(complex, row, ids[v].sources),
        rowsOfFaces(complex, row, ids[v].targets));
    }
  }
  for (const BorderedVolume& own : bordered)
  {
    plan.sweeps[at(own.volume)].carried = carriedCurves(own, size, complex);
  }
}
}

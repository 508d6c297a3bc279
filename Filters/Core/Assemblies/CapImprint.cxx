// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/CapImprint.h"

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
/// Of a border's length: its image is no farther from the curve that it became.
constexpr double FarFromImage = 0.05;

/// Rows of curves between faces of a cap, whatever else meets there.
std::vector<Index> innerCurves(const AssemblyComplex& complex, const std::vector<Index>& cap)
{
  std::vector<Index> rows;
  for (std::size_t c = 0; c < complex.curves.size(); ++c)
  {
    const std::vector<Index>& faces = complex.curves[c].faces;
    const auto own = std::count_if(faces.begin(), faces.end(),
      [&](Index face) { return std::binary_search(cap.begin(), cap.end(), face); });
    if (own > 1)
    {
      rows.push_back(static_cast<Index>(c));
    }
  }
  return rows;
}

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

/// New points on an edge, from its lower end on.
using CutEdges = std::map<std::pair<Index, Index>, std::vector<Index>>;

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

/// The triangles of a complex while faces of it are replaced.
struct TriangleList
{
  std::vector<std::array<Index, 3>> corners;
  std::vector<Index> faces;

  void add(const std::array<Index, 3>& triangle, Index face)
  {
    this->corners.push_back(triangle);
    this->faces.push_back(face);
  }

  /// A triangle, in pieces where its edges are cut.
  void addCut(const std::array<Index, 3>& triangle, Index face, const CutEdges& cut)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const Index a = triangle[c];
      const Index b = triangle[(c + 1) % 3];
      const Index apex = triangle[(c + 2) % 3];
      const auto found = cut.find(std::minmax({ a, b }));
      if (found == cut.end())
      {
        continue;
      }
      std::vector<Index> chain = found->second;
      if (a > b)
      {
        std::reverse(chain.begin(), chain.end());
      }
      chain.push_back(b);
      Index last = a;
      for (const Index next : chain)
      {
        // The others of its edges may be cut, too.
        this->addCut({ last, next, apex }, face, cut);
        last = next;
      }
      return;
    }
    this->add(triangle, face);
  }
};

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
  std::map<std::pair<Index, Index>, Index> faceOfLabel; // of face and label
  std::set<Index> kept;
  for (Index t = 0; t < imprint.cap.mesh.triangles.rows(); ++t)
  {
    const Index face = complex.faceOf[at(rows[at(imprint.cap.triangleOrigin[at(t)])])];
    const std::pair<Index, Index> key{ face, imprint.labels[at(t)] };
    auto known = faceOfLabel.find(key);
    if (known == faceOfLabel.end())
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
      known = faceOfLabel.emplace(key, row).first;
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
  complex.triangles.resize(static_cast<Index>(list.corners.size()), 3);
  for (ComplexFace& face : complex.faces)
  {
    face.triangles.clear();
  }
  for (std::size_t t = 0; t < list.corners.size(); ++t)
  {
    complex.triangles.row(static_cast<Index>(t)) << list.corners[t][0], list.corners[t][1],
      list.corners[t][2];
    complex.faces[at(list.faces[t])].triangles.push_back(static_cast<Index>(t));
  }
  complex.faceOf = std::move(list.faces);
  traceCurves(complex);
}

double distanceToChain(const Eigen::RowVector3d& place, const Points& chain)
{
  double least = std::numeric_limits<double>::infinity();
  for (Index k = 1; k < chain.rows(); ++k)
  {
    const Eigen::RowVector3d a = chain.row(k - 1);
    const Eigen::RowVector3d edge = chain.row(k) - a;
    const double along = std::clamp((place - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (a + along * edge - place).norm());
  }
  return least;
}

/// The curves of the source cap that a border became.
class ImageFinder
{
public:
  ImageFinder(const AssemblyComplex& complex, const std::vector<Index>& sources)
    : Complex(complex)
  {
    for (const Index c : innerCurves(complex, sources))
    {
      const Points places = placesOf(complex, complex.curves[at(c)]);
      this->Inner.push_back({ c, places, ArcLengthChain(places) });
    }
  }

  /// @param image of a border, on or near the source cap. @return empty where there is none.
  std::vector<CurveUse> find(const Points& image, bool closed) const
  {
    const ArcLengthChain chain(image);
    const double tolerance = FarFromImage * chain.length();
    if (closed)
    {
      for (const Curve& curve : this->Inner)
      {
        const bool fits = this->Complex.curves[at(curve.row)].closed() &&
          (curve.places.row(0) - image.row(0)).norm() < tolerance &&
          this->isBeside(curve, image, tolerance);
        if (fits)
        {
          const Eigen::RowVector3d quarter = chain.at(0.25 * chain.length());
          const double length = curve.chain.length();
          return { { curve.row,
            (curve.chain.at(0.25 * length) - quarter).norm() >
              (curve.chain.at(0.75 * length) - quarter).norm() } };
        }
      }
      return {};
    }
    std::vector<CurveUse> path;
    Eigen::RowVector3d here = image.row(0);
    std::set<Index> used;
    while ((here - image.row(image.rows() - 1)).norm() > tolerance)
    {
      const CurveUse* best = nullptr;
      CurveUse use;
      for (const Curve& curve : this->Inner)
      {
        for (const bool reversed : { false, true })
        {
          const Index first = reversed ? curve.places.rows() - 1 : 0;
          if (used.count(curve.row) == 0 && (curve.places.row(first) - here).norm() < tolerance &&
            this->isBeside(curve, image, tolerance))
          {
            use = { curve.row, reversed };
            best = &use;
          }
        }
      }
      if (!best)
      {
        return {};
      }
      used.insert(use.curve);
      path.push_back(use);
      const std::vector<Index>& points = this->Complex.curves[at(use.curve)].points;
      here = this->Complex.points.row(use.reversed ? points.front() : points.back());
    }
    return path;
  }

private:
  struct Curve
  {
    Index row;
    Points places;
    ArcLengthChain chain;
  };

  bool isBeside(const Curve& curve, const Points& image, double tolerance) const
  {
    for (const double along : { 0.25, 0.5, 0.75 })
    {
      if (distanceToChain(curve.chain.at(along * curve.chain.length()), image) > tolerance)
      {
        return false;
      }
    }
    return true;
  }

  const AssemblyComplex& Complex;
  std::vector<Curve> Inner;
};

/// What a volume's caps are, however faces are cut.
struct CapIds
{
  std::vector<Index> sources;
  std::vector<Index> targets;
};

std::string describeCaps(const CapIds& ids)
{
  return "the borders between " + listFaces(ids.targets) + " at its target";
}

void cutSource(
  const SolidSurface& solid, const CapIds& ids, Index volume, double size, AssemblyComplex& complex)
{
  const std::vector<Index> sources = rowsOfFaces(complex, volume, ids.sources);
  const std::vector<Index> targets = rowsOfFaces(complex, volume, ids.targets);
  SweepLayout caps;
  caps.sources = sources;
  caps.targets = targets;
  const std::optional<AffineMap> map = capMapOf(complex, volume, caps, solid);
  if (!map)
  {
    throw ImprintFailure(volume, describeCaps(ids) + " have no image on its source.");
  }
  const AffineMap back = inverse(*map);
  const std::vector<Index> sourceRows = trianglesOfFaces(complex, sources);
  const std::vector<Index> targetRows = trianglesOfFaces(complex, targets);
  const SurfacePart source = partOfVolume(complex, volume, sourceRows);
  const SurfacePart target = partOfVolume(complex, volume, targetRows);
  const CapMaps maps{ [&](const PointsRef& points) { return map->apply(points); },
    [&](const PointsRef& points) { return back.apply(points); } };
  const std::optional<TargetImprint> imprint =
    imprintTarget({ source.mesh, facesOfRows(complex, sourceRows),
                    verticesOf(complex, sources, source), {}, Near * size },
      { target.mesh, facesOfRows(complex, targetRows) }, maps, size);
  if (!imprint)
  {
    throw ImprintFailure(volume, describeCaps(ids) + " find no way over its source.");
  }
  replaceCap(sourceRows, source, volume, *imprint, complex);
}

std::vector<CarriedCurve> carriedCurves(const SolidSurface& solid, const CapIds& ids, Index volume,
  const SweepLayout& layout, const AssemblyComplex& complex)
{
  const std::optional<AffineMap> map = capMapOf(complex, volume, layout, solid);
  const AffineMap back = inverse(*map);
  const ImageFinder finder(complex, layout.sources);
  std::vector<CarriedCurve> carried;
  for (const Index c : innerCurves(complex, layout.targets))
  {
    const ComplexCurve& border = complex.curves[at(c)];
    const Points image = back.apply(placesOf(complex, border));
    CarriedCurve curve;
    curve.target = { c, false };
    curve.source = finder.find(image, border.closed());
    if (curve.source.empty())
    {
      throw ImprintFailure(volume,
        describeCaps(ids) + ", near " + describe(image.row(0)) +
          ", cross those of its source so closely that they cannot be told apart. Move one of them "
          "in the CAD system, or sweep the volume between other caps.");
    }
    carried.push_back(std::move(curve));
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
  std::set<Index> cut;
  for (auto v = plan.order.rbegin(); v != plan.order.rend(); ++v)
  {
    if (needsImprint(complex, rowsOfFaces(complex, *v, ids[at(*v)].targets)))
    {
      cutSource(*solids[at(*v)], ids[at(*v)], *v, size, complex);
      cut.insert(*v);
    }
  }
  if (cut.empty())
  {
    return;
  }
  for (std::size_t v = 0; v < plan.sweeps.size(); ++v)
  {
    const Index row = static_cast<Index>(v);
    if (ids[v].sources.empty())
    {
      continue; // left out
    }
    plan.sweeps[v] = layOutSides(complex, row, rowsOfFaces(complex, row, ids[v].sources),
      rowsOfFaces(complex, row, ids[v].targets));
    if (cut.count(row) > 0)
    {
      plan.sweeps[v].carried = carriedCurves(*solids[v], ids[v], row, plan.sweeps[v], complex);
    }
  }
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/VolumePieces.h"

#include "Core/Assemblies/CapSections.h"
#include "Core/Assemblies/SharedTriangles.h"
#include "Core/Assemblies/SurfaceRegions.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Stacks/StackFrame.h"
#include "Core/Surfaces/SurfacePart.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace hexsweep
{
namespace
{
/// Of a volume's size: points this near to a plane are on it.
constexpr double OnPlane = 1e-6;
constexpr int ProjectionSteps = 3;

using Edge = std::pair<Index, Index>; // lower end first

/// A triangle of a volume, or of a cut through it.
struct PieceTriangle
{
  TriangleCorners corners;
  Index faceId;
  bool isCut;
};

/// New points on edges.
using SplitEdges = std::map<Edge, Index>;

/// The triangles of all volumes on common points, as they are cut.
class CutVolumes
{
public:
  CutVolumes(const std::vector<AssemblyVolume>& volumes, double matchTolerance)
    : Volumes(volumes)
  {
    std::vector<const SolidSurface*> solids;
    for (const AssemblyVolume& volume : volumes)
    {
      solids.push_back(&volume.surface);
    }
    SharedTriangles shared = shareTriangles(solids, matchTolerance);
    for (Index i = 0; i < shared.points.rows(); ++i)
    {
      this->Places.emplace_back(shared.points.row(i));
    }
    for (std::size_t v = 0; v < volumes.size(); ++v)
    {
      this->Rows.emplace_back();
      this->Boxes.emplace_back();
      for (Index i = 0; i < volumes[v].surface.points.rows(); ++i)
      {
        this->Boxes.back().extend(volumes[v].surface.points.row(i).transpose());
      }
      for (std::size_t t = 0; t < shared.corners[v].size(); ++t)
      {
        this->Rows.back().push_back({ shared.corners[v][t], volumes[v].surface.faceIds[t], false });
        this->NextId = std::max(this->NextId, volumes[v].surface.faceIds[t] + 1);
      }
    }
  }

  /// Cuts a volume at all flat caps between its lowest and its highest place.
  void cut(std::size_t v, const CapLikeFaces& faces)
  {
    const StackFrame frame(faces.direction);
    const Points given = frame.toFrame(this->Volumes[v].surface.points);
    const double size = (given.colwise().maxCoeff() - given.colwise().minCoeff()).norm();
    const double tolerance = OnPlane * size;
    for (const double level : capLevels(this->Volumes[v].surface, faces, given.col(2), tolerance))
    {
      this->cutAt(v, frame, level, tolerance);
    }
  }

  bool isCut(std::size_t v) const
  {
    return std::any_of(this->Rows[v].begin(), this->Rows[v].end(),
      [](const PieceTriangle& triangle) { return triangle.isCut; });
  }

  /// Whether a volume has triangles that it did not have, cut or not.
  bool isSplit(std::size_t v) const
  {
    return static_cast<Index>(this->Rows[v].size()) > this->Volumes[v].surface.triangles.rows();
  }

  /// What a volume's triangles and cuts enclose, from the first triangle on.
  std::vector<SolidSurface> pieces(std::size_t v) const
  {
    std::vector<Index> all(this->Rows[v].size());
    for (std::size_t t = 0; t < all.size(); ++t)
    {
      all[t] = static_cast<Index>(t);
    }
    const SurfacePart part = surfacePart(this->points(), this->triangles(v), all);
    std::vector<SolidSurface> result;
    for (const SurfaceRegion& region : surfaceRegions(part.mesh.points, part.mesh.triangles))
    {
      result.push_back(this->surfaceOf(v, part.mesh.points, region));
    }
    return result;
  }

private:
  Eigen::Map<const Points> points() const
  {
    return { this->Places.front().data(), static_cast<Index>(this->Places.size()), 3 };
  }

  Triangles triangles(std::size_t v) const
  {
    Triangles triangles(static_cast<Index>(this->Rows[v].size()), 3);
    for (std::size_t t = 0; t < this->Rows[v].size(); ++t)
    {
      const TriangleCorners& corners = this->Rows[v][t].corners;
      triangles.row(static_cast<Index>(t)) << corners[0], corners[1], corners[2];
    }
    return triangles;
  }

  SolidSurface surfaceOf(std::size_t v, const Points& points, const SurfaceRegion& region) const
  {
    std::vector<Index> rows(region.rows.size());
    for (std::size_t r = 0; r < rows.size(); ++r)
    {
      rows[r] = static_cast<Index>(r);
    }
    SurfacePart part = surfacePart(points, region.triangles, rows);
    SolidSurface surface;
    surface.points = std::move(part.mesh.points);
    surface.triangles = std::move(part.mesh.triangles);
    for (const Index row : region.rows)
    {
      surface.faceIds.push_back(this->Rows[v][at(row)].faceId);
    }
    surface.cellIds.assign(rows.size(), -1);
    surface.triangleRows.assign(rows.size(), -1);
    surface.pointRows.assign(at(surface.points.rows()), -1);
    surface.facesByAngle = this->Volumes[v].surface.facesByAngle;
    surface.featureAngle = this->Volumes[v].surface.featureAngle;
    return surface;
  }

  void cutAt(std::size_t v, const StackFrame& frame, double level, double tolerance)
  {
    std::vector<Index> outer;
    for (std::size_t t = 0; t < this->Rows[v].size(); ++t)
    {
      if (!this->Rows[v][t].isCut)
      {
        outer.push_back(static_cast<Index>(t));
      }
    }
    const SurfacePart part = surfacePart(this->points(), this->triangles(v), outer);
    const CapSection section =
      sectionAt(frame.toFrame(part.mesh.points), part.mesh.triangles, level, tolerance);
    if (section.triangles.rows() == 0)
    {
      return;
    }
    const std::map<Edge, Index> sides = this->sideOfEdges(v);
    SplitEdges split;
    for (const EdgeCrossing& crossing : section.crossings)
    {
      const Edge edge =
        std::minmax({ part.points[at(crossing.low)], part.points[at(crossing.high)] });
      const Eigen::RowVector3d place =
        (1.0 - crossing.fraction) * part.mesh.points.row(crossing.low) +
        crossing.fraction * part.mesh.points.row(crossing.high);
      split[edge] = static_cast<Index>(this->Places.size());
      const auto side = sides.find(edge);
      this->Places.push_back(side == sides.end()
          ? place
          : this->onSide(v, side->second, frame.direction(), level, edge, place));
    }
    for (std::size_t other = 0; other < this->Rows.size(); ++other)
    {
      if (this->Boxes[other].intersects(this->Boxes[v]))
      {
        splitTriangles(split, this->Rows[other]);
      }
    }
    const Index given = part.mesh.points.rows();
    for (Index t = 0; t < section.triangles.rows(); ++t)
    {
      TriangleCorners corners{};
      for (std::size_t c = 0; c < 3; ++c)
      {
        const Index point = section.triangles(t, static_cast<Index>(c));
        if (point < given)
        {
          corners[c] = part.points[at(point)];
          continue;
        }
        const EdgeCrossing& crossing = section.crossings[at(point - given)];
        corners[c] =
          split.at(std::minmax({ part.points[at(crossing.low)], part.points[at(crossing.high)] }));
      }
      this->Rows[v].push_back({ corners, this->NextId + section.sheetOf[at(t)], true });
    }
    this->NextId += *std::max_element(section.sheetOf.begin(), section.sheetOf.end()) + 1;
  }

  /// The face of each edge that lies inside one.
  std::map<Edge, Index> sideOfEdges(std::size_t v) const
  {
    std::map<Edge, Index> known;
    std::map<Edge, Index> inside;
    for (const PieceTriangle& triangle : this->Rows[v])
    {
      for (std::size_t c = 0; c < 3 && !triangle.isCut; ++c)
      {
        const Edge edge = std::minmax({ triangle.corners[c], triangle.corners[(c + 1) % 3] });
        const auto [first, isNew] = known.try_emplace(edge, triangle.faceId);
        if (!isNew && first->second == triangle.faceId)
        {
          inside[edge] = triangle.faceId;
        }
      }
    }
    return inside;
  }

  /// A place on the true surface of a face and in the plane, if one is found near the edge.
  Eigen::RowVector3d onSide(std::size_t v, Index faceId, const Eigen::RowVector3d& direction,
    double level, const Edge& edge, const Eigen::RowVector3d& place) const
  {
    const ModelGeometry* const geometry = this->Volumes[v].geometry.get();
    Eigen::RowVector3d moved = place;
    for (int step = 0; geometry && step < ProjectionSteps; ++step)
    {
      const std::optional<Eigen::RowVector3d> found = geometry->closestOnFace(faceId, moved);
      if (!found)
      {
        return place;
      }
      moved = *found + (level - found->dot(direction)) * direction;
    }
    const double length = (this->Places[at(edge.second)] - this->Places[at(edge.first)]).norm();
    return (moved - place).norm() < 0.5 * length ? moved : place;
  }

  static void splitTriangles(const SplitEdges& split, std::vector<PieceTriangle>& rows)
  {
    const std::size_t count = rows.size();
    for (std::size_t t = 0; t < count; ++t)
    {
      const PieceTriangle given = rows[t];
      std::array<Index, 3> middle{ -1, -1, -1 }; // of the edge from corner c on
      int found = 0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        const auto known =
          split.find(std::minmax({ given.corners[c], given.corners[(c + 1) % 3] }));
        if (known != split.end())
        {
          middle[c] = known->second;
          ++found;
        }
      }
      if (found == 0)
      {
        continue;
      }
      const std::vector<TriangleCorners> parts = partsOf(given.corners, middle, found);
      rows[t].corners = parts.front();
      for (std::size_t p = 1; p < parts.size(); ++p)
      {
        rows.push_back({ parts[p], given.faceId, given.isCut });
      }
    }
  }

  /// Twin triangles of two volumes, which run opposite ways, get the same parts.
  static std::vector<TriangleCorners> partsOf(
    const TriangleCorners& corners, const std::array<Index, 3>& middle, int found)
  {
    if (found == 3)
    {
      return { { corners[0], middle[0], middle[2] }, { corners[1], middle[1], middle[0] },
        { corners[2], middle[2], middle[1] }, { middle[0], middle[1], middle[2] } };
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      const Index a = corners[c];
      const Index b = corners[(c + 1) % 3];
      const Index far = corners[(c + 2) % 3];
      const Index ab = middle[c];
      const Index farA = middle[(c + 2) % 3];
      if (found == 1 && ab >= 0)
      {
        return { { a, ab, far }, { ab, b, far } };
      }
      if (found == 2 && ab >= 0 && farA >= 0)
      {
        // The diagonal of what is left begins at the lower corner.
        return b < far
          ? std::vector<TriangleCorners>{ { a, ab, farA }, { ab, b, farA }, { b, far, farA } }
          : std::vector<TriangleCorners>{ { a, ab, farA }, { ab, b, far }, { ab, far, farA } };
      }
    }
    return { corners };
  }

  const std::vector<AssemblyVolume>& Volumes;
  std::vector<Eigen::RowVector3d> Places;
  std::vector<std::vector<PieceTriangle>> Rows; // of each volume
  std::vector<Eigen::AlignedBox3d> Boxes;
  Index NextId = 0;
};

/// The direction along which a volume has more than two caps; nothing where it has two, or is none.
std::optional<CapLikeFaces> manyCaps(const AssemblyVolume& volume)
{
  const NamedSweep& named = volume.named;
  if (!volume.problem.empty() || !named.sourceFaceIds.empty() || !named.targetFaceIds.empty())
  {
    return std::nullopt;
  }
  std::vector<CapLikeFaces> ways = stackDirections(volume.surface);
  if (ways.empty() || !ways.front().isStack() || ways.front().isPlain())
  {
    return std::nullopt;
  }
  return std::move(ways.front());
}

/// Caps of a piece along a direction: it is swept between these, either way.
NamedSweep capsOf(const SolidSurface& piece, const Eigen::RowVector3d& direction)
{
  NamedSweep named;
  const CapLikeFaces faces = capLikeFaces(piece, direction);
  if (!faces.isPlain())
  {
    return named;
  }
  for (const StackFace& face : faces.faces)
  {
    if (face.kind == StackFaceKind::Bottom)
    {
      named.sourceFaceIds.push_back(face.id);
    }
    if (face.kind == StackFaceKind::Top)
    {
      named.targetFaceIds.push_back(face.id);
    }
  }
  named.eitherWay = true;
  return named;
}

/// Lowest and highest place of a surface along a direction.
std::pair<double, double> extentOf(const SolidSurface& surface, const Eigen::RowVector3d& direction)
{
  const Eigen::VectorXd heights = surface.points * direction.transpose();
  return { heights.minCoeff(), heights.maxCoeff() };
}

void addPieces(std::vector<SolidSurface> surfaces, const Eigen::RowVector3d& direction,
  const AssemblyVolume& whole, Index row, std::vector<AssemblyVolume>& result)
{
  std::stable_sort(
    surfaces.begin(), surfaces.end(), [&](const SolidSurface& a, const SolidSurface& b) {
      return extentOf(a, direction) < extentOf(b, direction);
    });
  const auto [low, high] = extentOf(whole.surface, direction);
  for (std::size_t p = 0; p < surfaces.size(); ++p)
  {
    AssemblyVolume piece;
    const auto [begin, end] = extentOf(surfaces[p], direction);
    piece.named = capsOf(surfaces[p], direction);
    if (whole.named.layers > 0)
    {
      const double share = static_cast<double>(whole.named.layers) * (end - begin) / (high - low);
      piece.named.layers = std::max<Index>(1, static_cast<Index>(std::llround(share)));
    }
    piece.surface = std::move(surfaces[p]);
    piece.geometry = whole.geometry;
    piece.name = whole.name + ", piece " + std::to_string(p + 1) + " of " +
      std::to_string(surfaces.size()) + ",";
    piece.whole = row;
    result.push_back(std::move(piece));
  }
}
}

std::vector<AssemblyVolume> cutIntoPieces(
  std::vector<AssemblyVolume> volumes, double matchTolerance, const Progress& progress)
{
  std::vector<std::optional<CapLikeFaces>> ways;
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    reportProgress(progress, static_cast<double>(v) / static_cast<double>(volumes.size()));
    ways.push_back(manyCaps(volumes[v]));
  }
  const auto isMany = [](const std::optional<CapLikeFaces>& way) { return way.has_value(); };
  if (std::none_of(ways.begin(), ways.end(), isMany))
  {
    return volumes;
  }
  CutVolumes cut(volumes, matchTolerance);
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    if (ways[v])
    {
      cut.cut(v, *ways[v]);
    }
  }
  std::vector<AssemblyVolume> result;
  for (std::size_t v = 0; v < volumes.size(); ++v)
  {
    if (!cut.isSplit(v))
    {
      result.push_back(volumes[v]);
      continue;
    }
    std::vector<SolidSurface> surfaces = cut.pieces(v);
    if (cut.isCut(v) && surfaces.size() > 1)
    {
      addPieces(std::move(surfaces), ways[v]->direction, volumes[v], static_cast<Index>(v), result);
      continue;
    }
    result.push_back(volumes[v]);
    result.back().surface = std::move(surfaces.front());
  }
  return result;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/StackSweep.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Common/MemoryBudget.h"
#include "Core/Geometry/TriangleSearch.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Solids/SweepSize.h"
#include "Core/Stacks/LeaningSides.h"
#include "Core/Stacks/StackMending.h"
#include "Core/Stacks/StackPlaneMesh.h"
#include "Core/Stacks/StackSnap.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexsweep
{
namespace
{
constexpr double RoughTolerance = 1e-4; // of the extent: before a size is known
constexpr double JoinedLevels = 0.3;    // of the layers' thickness
constexpr double LevelGap = 0.3;        // of the layers' thickness
constexpr double SnapReach = 0.25;      // of the size
constexpr double TellVolume = 0.01;
constexpr const char* FewerHexes =
  "Set Size and LayerSize to larger lengths, or NumberOfLayers to fewer.";
constexpr int SizeTrials = 4;
constexpr double SizeSlack = 1.03;

/// A solid as its stack sees it.
struct PlacedSolid
{
  PlacedSolid(const SolidSurface& solid, const CapLikeFaces& faces)
    : frame(faces.direction)
    , given(frame.toFrame(solid.points))
    , upright(uprightSolid(solid, faces, given))
    , points(upright.points)
    , heights(solid, points, faces)
  {
  }

  double extent() const
  {
    return (this->given.colwise().maxCoeff() - this->given.colwise().minCoeff()).norm();
  }

  StackFrame frame;
  Points given;
  UprightSolid upright;
  Points points; ///< sides that lean are upright
  CapHeights heights;
};

/// All that decides about the mesh's connectivity.
struct StackLayout
{
  StackArrangement arrangement;
  StackLevels levels;
  StackPlaneMesh plane;
  StackSheets sheets;
  StackColumns columns;
};

double thicknessOf(const StackOptions& options, double size)
{
  return options.layerSize > 0.0 ? options.layerSize : size;
}

StackLayout layOut(const SolidSurface& solid, const CapLikeFaces& faces, const PlacedSolid& placed,
  const StackOptions& options, double size, StageClock& clock, const Progress& progress)
{
  StackLayout layout;
  layout.arrangement = arrangeStack(
    solid, faces, placed.frame, placed.points, placed.heights, options.imprintTolerance * size);
  const double thickness = thicknessOf(options, size);
  layout.levels = orderLevels(layout.arrangement, faces, placed.heights,
    layout.arrangement.greatestMove, JoinedLevels * thickness);
  clock.finish("Imprint");
  layout.plane =
    meshStackPlane(layout.arrangement, size, options.chordTolerance, options.parallelFor, progress);
  clock.finish("Quads");
  layout.sheets = placeSheets(
    layout.plane.plane, layout.arrangement, layout.levels, placed.heights, LevelGap * thickness);
  const LayerCounts layers =
    countLayers(layout.plane.plane, layout.levels, layout.sheets, thickness, options.layers);
  checkHexBudget(countHexes(layout.plane.plane, layout.levels, layers), FewerHexes);
  layout.columns =
    makeColumns(layout.plane.plane, layout.arrangement, layout.levels, layout.sheets, layers);
  clock.finish("Columns");
  return layout;
}

/// Faces of the solid behind the outer quads on sides; -1 for those on caps.
std::vector<Index> sideFaces(const SolidSurface& solid, const CapLikeFaces& faces,
  const PointsRef& placed, const StackColumns& columns, const PointsRef& points)
{
  std::vector<Index> rows;
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const std::size_t face = faces.faceOf[static_cast<std::size_t>(t)];
    if (faces.faces[face].kind == StackFaceKind::Side)
    {
      rows.push_back(t);
    }
  }
  std::vector<Index> result(columns.boundary.size(), -1);
  if (rows.empty())
  {
    return result;
  }
  Triangles triangles(static_cast<Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    triangles.row(static_cast<Index>(i)) = solid.triangles.row(rows[i]);
  }
  const TriangleSearch search(placed, triangles);
  Index last = -1;
  for (std::size_t b = 0; b < columns.boundary.size(); ++b)
  {
    const StackQuad& quad = columns.boundary[b];
    if (quad.cap >= 0)
    {
      continue;
    }
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (const Index p : quad.points)
    {
      middle += 0.25 * points.row(p);
    }
    last = search.closest(middle, last).triangle;
    result[b] = solid.faceIds[static_cast<std::size_t>(rows[static_cast<std::size_t>(last)])];
  }
  return result;
}

double enclosedVolume(const PointsRef& points, const TrianglesRef& triangles)
{
  const Eigen::RowVector3d middle = points.colwise().mean();
  double volume = 0.0;
  for (Index t = 0; t < triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = points.row(triangles(t, 0)) - middle;
    const Eigen::RowVector3d b = points.row(triangles(t, 1)) - middle;
    const Eigen::RowVector3d c = points.row(triangles(t, 2)) - middle;
    volume += a.cross(b).dot(c) / 6.0;
  }
  return volume;
}

/// Of what the outer quads enclose, each cut in two.
double enclosedVolume(const PointsRef& points, const std::vector<StackQuad>& quads)
{
  Triangles triangles(2 * static_cast<Index>(quads.size()), 3);
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    const auto& p = quads[q].points;
    triangles.row(2 * static_cast<Index>(q)) << p[0], p[1], p[2];
    triangles.row(2 * static_cast<Index>(q) + 1) << p[0], p[2], p[3];
  }
  return enclosedVolume(points, triangles);
}

void tell(const StackLayout& layout, double size, double solidVolume, StackMesh& mesh)
{
  if (!layout.arrangement.slivers.empty())
  {
    mesh.warnings.push_back(listFaces(layout.arrangement.slivers) +
      " of the solid: narrower than ImprintTolerance times the size, seen along the sweep; the "
      "curves on both sides became one, and there are no quads on " +
      (layout.arrangement.slivers.size() > 1 ? "them." : "it."));
  }
  if (mesh.invertedQuads > 0)
  {
    mesh.warnings.push_back(std::to_string(mesh.invertedQuads) +
      " of the quads that were made across the sweep are inverted: edges of length " +
      describe(size) +
      " are too long for the walls between its curves. Set Size to a smaller "
      "length.");
  }
  if (!(std::abs(mesh.volume - solidVolume) <= TellVolume * solidVolume))
  {
    mesh.warnings.push_back("the hexahedra have a volume of " + describe(mesh.volume) +
      ", the solid has " + describe(solidVolume) +
      ". Set Size to a smaller length, and ImprintTolerance to a smaller value.");
  }
  if (mesh.refusedSize > 0.0)
  {
    mesh.warnings.push_back("hexahedra of size " + describe(mesh.refusedSize) +
      " would be more than " + std::to_string(MostChosenHexes) + ": they are coarser, of size " +
      describe(size) + ". Set Size to choose it.");
  }
}

void checkStackOptions(const CapLikeFaces& faces, const StackOptions& options)
{
  if (!faces.isStack())
  {
    throw InvalidInput(
      "the solid cannot be swept between several caps: " + describeRefusedFaces(faces));
  }
  for (const double size : { options.size, options.layerSize })
  {
    if (!(size >= 0.0) || !std::isfinite(size))
    {
      throw InvalidInput("the size is " + describe(size) +
        ". Set Size and LayerSize to a positive length, or to 0 for one that fits the solid.");
    }
  }
  if (options.layers < 0)
  {
    throw InvalidInput("the number of layers is negative. Set NumberOfLayers to 0 or more.");
  }
  if (!(options.imprintTolerance >= 0.0 && options.imprintTolerance <= 0.5))
  {
    throw InvalidInput("the imprint tolerance is " + describe(options.imprintTolerance) +
      ". Set ImprintTolerance to a share of the size, from 0 to 0.5.");
  }
}

double sizeOf(const SolidSurface& solid, const CapLikeFaces& faces, const PlacedSolid& placed)
{
  return defaultStackSize(arrangeStack(
    solid, faces, placed.frame, placed.points, placed.heights, RoughTolerance * placed.extent()));
}

std::vector<bool> outerPoints(const StackColumns& columns)
{
  std::vector<bool> outer(columns.nodes.size(), false);
  for (const StackQuad& quad : columns.boundary)
  {
    for (const Index p : quad.points)
    {
      outer[static_cast<std::size_t>(p)] = true;
    }
  }
  return outer;
}

void addBoundary(const CapLikeFaces& faces, const StackColumns& columns,
  const std::vector<Index>& sides, StackMesh& mesh)
{
  for (std::size_t b = 0; b < columns.boundary.size(); ++b)
  {
    const StackQuad& quad = columns.boundary[b];
    const bool isCap = quad.cap >= 0;
    const StackFace* face = isCap ? &faces.faces[static_cast<std::size_t>(quad.cap)] : nullptr;
    mesh.boundary.push_back({ quad.points, quad.hex, quad.side, isCap ? face->id : sides[b],
      isCap ? face->kind : StackFaceKind::Side });
  }
}
}

namespace
{
Points columnPointsOf(const StackLayout& layout)
{
  return columnPoints(layout.plane.plane, layout.sheets, layout.columns);
}

/// Puts columns on the true sides that are upright, and caps on theirs.
void snap(const StackOptions& options, const std::vector<Index>& sides, PlacedSolid& placed,
  StackLayout& layout, StackMesh& mesh)
{
  StackPlane& plane = layout.plane.plane;
  NodeSides beside = nodeSides(plane, layout.columns, columnPointsOf(layout), sides);
  for (auto& faces : beside)
  {
    for (const Index id : placed.upright.leaning)
    {
      faces.erase(id);
    }
  }
  const StackSnap result =
    snapToSides(*options.geometry, placed.frame, beside, SnapReach * mesh.size, plane);
  mesh.snapped = result.moved;
  mesh.unsnapped = result.left;
  if (placed.upright.leaning.empty())
  {
    placed.heights.setGeometry(options.geometry, placed.frame);
  }
  layout.sheets = placeSheets(plane, layout.arrangement, layout.levels, placed.heights,
    LevelGap * thicknessOf(options, mesh.size));
}

/// Leans the mesh back on its sides, and puts caps that are not flat where they are then.
void lean(const SolidSurface& solid, const CapLikeFaces& faces, const StackOptions& options,
  const std::vector<Index>& sides, const PlacedSolid& placed, const StackColumns& columns,
  Points& points)
{
  leanBack({ solid, placed.given, placed.frame, placed.upright.leaning, options.geometry }, columns,
    columns.hexes, sides, points);
  CapHeights heights(solid, placed.given, faces);
  heights.setGeometry(options.geometry, placed.frame);
  for (const StackQuad& quad : columns.boundary)
  {
    if (quad.cap < 0 || heights.isFlat(static_cast<std::size_t>(quad.cap)))
    {
      continue;
    }
    for (const Index p : quad.points)
    {
      points(p, 2) = heights.exact(static_cast<std::size_t>(quad.cap), points.row(p).head<2>());
    }
  }
}
}

double chosenStackSize(const SolidSurface& solid, const CapLikeFaces& faces)
{
  return sizeOf(solid, faces, PlacedSolid(solid, faces));
}

StackMesh sweepStack(const SolidSurface& solid, const CapLikeFaces& faces,
  const StackOptions& options, const Progress& progress)
{
  checkStackOptions(faces, options);
  StageClock clock;
  PlacedSolid placed(solid, faces);
  if (options.size > 0.0)
  {
    checkHexBudget(enclosedVolume(solid.points, solid.triangles) / options.size / options.size /
        (options.layers > 0 ? placed.extent() : thicknessOf(options, options.size)),
      FewerHexes);
  }
  StackMesh mesh;
  mesh.size = options.size > 0.0 ? options.size : sizeOf(solid, faces, placed);
  clock.finish("Size");
  const auto lay = [&] {
    return layOut(
      solid, faces, placed, options, mesh.size, clock, progressPart(progress, 0.0, 0.6));
  };
  StackLayout layout = lay();
  for (int trial = 0; trial < SizeTrials && options.size == 0.0; ++trial)
  {
    const double excess = static_cast<double>(layout.columns.hexes.rows()) / MostChosenHexes;
    if (excess <= 1.0)
    {
      break;
    }
    mesh.refusedSize = mesh.refusedSize > 0.0 ? mesh.refusedSize : mesh.size;
    mesh.size *= SizeSlack * std::cbrt(excess);
    layout = lay();
  }
  const std::vector<Index> sides =
    sideFaces(solid, faces, placed.points, layout.columns, columnPointsOf(layout));
  if (options.geometry)
  {
    snap(options, sides, placed, layout, mesh);
    clock.finish("Snap to geometry");
  }
  Points points = columnPointsOf(layout);
  if (!placed.upright.leaning.empty())
  {
    lean(solid, faces, options, sides, placed, layout.columns, points);
    clock.finish("Leaning sides");
  }
  reportProgress(progress, 0.65);
  mesh.hexes = layout.columns.hexes;
  const auto toSpace = [&](const Points& given) {
    return options.toSpace ? options.toSpace(given) : given;
  };
  MendedStack mended =
    mendStack(toSpace(placed.frame.fromFrame(points)), mesh.hexes, outerPoints(layout.columns),
      { options.ensureValid, options.improveQuality, options.parallelFor },
      progressPart(progress, 0.65, 1.0));
  mesh.qualities = std::move(mended.qualities);
  mesh.method = "Columns" + mended.method;
  mesh.volume = enclosedVolume(mended.points, layout.columns.boundary);
  mesh.points = std::move(mended.points);
  clock.finish("Interior");
  for (const ColumnNode& node : layout.columns.nodes)
  {
    mesh.planeNodes.push_back(node.node);
  }
  mesh.quadOf = std::move(layout.columns.quadOf);
  mesh.layerOf = std::move(layout.columns.layerOf);
  mesh.regions = static_cast<Index>(layout.arrangement.stacks.size());
  mesh.levels = layout.levels.count;
  mesh.invertedQuads = layout.plane.inverted;
  mesh.greatestGap = layout.arrangement.greatestGap;
  addBoundary(faces, layout.columns, sides, mesh);
  tell(layout, mesh.size, enclosedVolume(toSpace(solid.points), solid.triangles), mesh);
  mesh.stages = clock.stages();
  return mesh;
}
}

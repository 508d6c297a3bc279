// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Assemblies/TubeGrid.h"

#include "Core/Assemblies/FaceRims.h"
#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Linking/LayerSpacing.h"
#include "Core/Linking/LinkingSideColumns.h"
#include "Core/Linking/RingAlignment.h"
#include "Core/Surfaces/SurfacePart.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <utility>

namespace hexsweep
{
namespace
{
/// Which node of a closed rim each column ends at.
struct RimMatch
{
  Index first = 0;                                           ///< node of column 0
  Index step = 1;                                            ///< 1 or -1
  double distance = std::numeric_limits<double>::infinity(); ///< sum of squares

  Index nodeOf(Index column, Index count) const
  {
    return ((this->first + this->step * column) % count + count) % count;
  }
};

RimMatch nearestMatch(const Points& ends, const Points& rim)
{
  const Index n = ends.rows();
  RimMatch best;
  for (const Index step : { Index(1), Index(-1) })
  {
    for (Index first = 0; first < n; ++first)
    {
      RimMatch match{ first, step, 0.0 };
      for (Index j = 0; j < n && match.distance < best.distance; ++j)
      {
        match.distance += (ends.row(j) - rim.row(match.nodeOf(j, n))).squaredNorm();
      }
      if (match.distance < best.distance)
      {
        best = match;
      }
    }
  }
  return best;
}

/// Turns the ends of columns that nothing holds so that they lie on the rim's nodes.
void turnOnto(LinkingSideColumns& columns, const Points& rim)
{
  const auto distanceFor = [&](double turn) {
    columns.turnEnds(turn);
    const double distance =
      nearestMatch(columns.mesh({ 0.0, 1.0 }).nodes.bottomRows(rim.rows()), rim).distance;
    columns.turnEnds(-turn);
    return distance;
  };
  // Between two nodes there is one best turn; rims are divided evenly, so few trials find it.
  constexpr int Trials = 16;
  const double spacing = 1.0 / static_cast<double>(rim.rows());
  double best = 0.0;
  double least = distanceFor(0.0);
  for (int trial = 1; trial < Trials; ++trial)
  {
    const double turn = spacing * (static_cast<double>(trial) / Trials - 0.5);
    const double distance = distanceFor(turn);
    if (distance < least)
    {
      least = distance;
      best = turn;
    }
  }
  columns.turnEnds(best);
}

/// Of the edges beside it: straight lines between two rims that stay this near to the face are on
/// it.
constexpr double NearFace = 0.1;

/// Rows of places on straight lines from rim to rim; no rows where these leave the face.
Points ruledRows(const Points& bottom, const Points& top, const RimMatch& match, Index layers,
  const FaceProjection& project)
{
  const Index n = bottom.rows();
  Points rows((layers + 1) * n, 3);
  for (Index j = 0; j < n; ++j)
  {
    const Eigen::RowVector3d end = top.row(match.nodeOf(j, n));
    const double spacing = std::max((bottom.row(j) - bottom.row((j + 1) % n)).norm(),
      (end - bottom.row(j)).norm() / static_cast<double>(layers));
    for (Index k = 0; k <= layers; ++k)
    {
      const double along = static_cast<double>(k) / static_cast<double>(layers);
      const Eigen::RowVector3d place = (1.0 - along) * bottom.row(j) + along * end;
      if (project.distance(place) > NearFace * spacing)
      {
        return { 0, 3 };
      }
      rows.row(k * n + j) = place;
    }
  }
  return rows;
}
}

void meshTube(const AssemblyComplex& complex, const AssemblyGeometry& geometry,
  const SideFace& side, Index layers, AssemblyMesh& mesh)
{
  const ComplexFace& face = complex.faces[at(side.face)];
  const FaceRim bottom = faceRim(mesh, side.chains[0], false);
  const FaceRim top = faceRim(mesh, side.chains[2], false);
  const Index n = static_cast<Index>(bottom.nodes.size());
  if (bottom.nodes.size() != top.nodes.size())
  {
    throw InvalidInput(nameOf(face) + " has different numbers of edges on its two loops: " +
      std::to_string(n) + " and " + std::to_string(top.nodes.size()) + ".");
  }
  const SurfacePart part = surfacePart(complex.points, complex.triangles, face.triangles);
  SideTube tube;
  tube.surface = part.mesh;
  for (const CurveUse& use : side.chains[0])
  {
    std::vector<Index> points = complex.curves[at(use.curve)].points;
    if (use.reversed)
    {
      std::reverse(points.begin(), points.end());
    }
    points.pop_back();
    for (const Index point : points)
    {
      tube.sourceLoop.push_back(part.idOf(point));
    }
  }
  const FaceProjection project(complex, geometry, side.face);
  RimMatch match = nearestMatch(bottom.places, top.places);
  Points rows = ruledRows(bottom.places, top.places, match, layers, project);
  if (rows.rows() == 0)
  {
    std::deque<LinkingSideColumns> alone;
    alone.emplace_back(tube, bottom.places);
    if (alone.front().isFree())
    {
      turnOnto(alone.front(), top.places);
    }
    levelRingsWhereBetter(alone);
    shareRingsWhereBetter(alone);
    rows = alone.front().mesh(layerFractions(layers)).nodes;
    match = nearestMatch(rows.bottomRows(n), top.places);
  }
  const Points ends = rows.bottomRows(n);
  NodeGrid grid(layers + 1, n);
  for (Index j = 0; j < n; ++j)
  {
    const Index node = match.nodeOf(j, n);
    const Eigen::RowVector3d missed = top.places.row(node) - ends.row(j);
    grid(0, j) = bottom.nodes[at(j)];
    grid(layers, j) = top.nodes[at(node)];
    for (Index k = 1; k < layers; ++k)
    {
      const double along = static_cast<double>(k) / static_cast<double>(layers);
      const Eigen::RowVector3d here = rows.row(k * n + j);
      const double reach = (here - rows.row((k - 1) * n + j)).norm();
      grid(k, j) = mesh.nodes.add(project(here + along * missed, reach));
    }
  }
  mesh.faces[at(side.face)] = gridQuads(grid, true);
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SolidInput.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Geometry/CoordinateRange.h"
#include "Core/Solids/ClosedSurface.h"
#include "Core/Solids/DegenerateTriangles.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Solids/TouchingSheets.h"
#include "Core/Surfaces/FeatureFaces.h"
#include "Core/Surfaces/OpenEdgeWelding.h"
#include "Core/Surfaces/TriangleAngles.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace hexsweep
{
namespace
{
void checkLength(const std::vector<Index>& ids, Index triangles, const std::string& name)
{
  if (!ids.empty() && static_cast<Index>(ids.size()) != triangles)
  {
    throw InvalidInput("the solid has " + std::to_string(triangles) + " triangles but " +
      std::to_string(ids.size()) + " " + name + " ids. Give one a triangle.");
  }
}

void checkPoints(const SolidInput& input)
{
  for (Index t = 0; t < input.triangles.rows(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      const Index p = input.triangles(t, c);
      if (p < 0 || p >= input.points.rows())
      {
        throw InvalidInput("the solid: triangle " + std::to_string(t) + " names point " +
          std::to_string(p) + ", which does not exist.");
      }
    }
  }
  checkCoordinates(input.points, input.triangles, "solid");
}

void checkTolerance(const SolidOptions& options)
{
  if (!(options.matchTolerance >= 0.0 && options.matchTolerance < 0.5))
  {
    throw InvalidInput("the match tolerance is " + describe(options.matchTolerance) +
      "; it is relative to the local edge length and must lie between 0 and 0.5.");
  }
}

bool isCollapsed(const Eigen::Matrix<Index, 1, 3>& corners)
{
  return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

/// Triangles on the points that are left after merging, and those points numbered anew.
SolidSurface weldedSurface(const SolidInput& input, const std::vector<Index>& welded)
{
  SolidSurface solid;
  std::vector<char> used(welded.size(), 0);
  for (Index t = 0; t < input.triangles.rows(); ++t)
  {
    Eigen::Matrix<Index, 1, 3> corners;
    for (int c = 0; c < 3; ++c)
    {
      const auto p = static_cast<std::size_t>(input.triangles(t, c));
      corners[c] = welded[p];
      solid.mergedPoints += welded[p] != input.triangles(t, c) && !used[p] ? 1 : 0;
      used[p] = 1;
    }
    if (isCollapsed(corners))
    {
      ++solid.collapsedTriangles;
    }
    else
    {
      solid.triangleRows.push_back(t);
    }
  }

  std::vector<Index> number(welded.size(), -1);
  for (const Index t : solid.triangleRows)
  {
    for (int c = 0; c < 3; ++c)
    {
      number[static_cast<std::size_t>(welded[static_cast<std::size_t>(input.triangles(t, c))])] = 0;
    }
  }
  for (std::size_t p = 0; p < number.size(); ++p)
  {
    if (number[p] == 0)
    {
      number[p] = static_cast<Index>(solid.pointRows.size());
      solid.pointRows.push_back(static_cast<Index>(p));
    }
  }
  solid.points.resize(static_cast<Index>(solid.pointRows.size()), 3);
  for (Index p = 0; p < solid.points.rows(); ++p)
  {
    solid.points.row(p) = input.points.row(solid.pointRows[static_cast<std::size_t>(p)]);
  }
  solid.triangles.resize(static_cast<Index>(solid.triangleRows.size()), 3);
  for (Index row = 0; row < solid.triangles.rows(); ++row)
  {
    const Index t = solid.triangleRows[static_cast<std::size_t>(row)];
    for (int c = 0; c < 3; ++c)
    {
      const Index p = welded[static_cast<std::size_t>(input.triangles(t, c))];
      solid.triangles(row, c) = number[static_cast<std::size_t>(p)];
    }
  }
  return solid;
}

/// Faces numbered in the order of their first input cells, whatever the order of the triangles.
std::vector<Index> numberedByCells(
  const std::vector<Index>& cellIds, std::vector<Index> faceOfTriangle, Index first)
{
  std::map<Index, Index> firstCell;
  for (std::size_t t = 0; t < faceOfTriangle.size(); ++t)
  {
    const auto known = firstCell.emplace(faceOfTriangle[t], cellIds[t]).first;
    known->second = std::min(known->second, cellIds[t]);
  }
  std::vector<std::pair<Index, Index>> faces; // first cell, face
  for (const auto& [face, cell] : firstCell)
  {
    faces.emplace_back(cell, face);
  }
  std::sort(faces.begin(), faces.end());
  std::map<Index, Index> number;
  for (const auto& face : faces)
  {
    number.emplace(face.second, first + static_cast<Index>(number.size()));
  }
  for (Index& face : faceOfTriangle)
  {
    face = number.at(face);
  }
  return faceOfTriangle;
}

void checkAreas(const SolidSurface& solid)
{
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    if (!hasWeights(solid.points, solid.triangles.row(t)))
    {
      throw InvalidInput("the solid: " + describeCell(solid, t) + " at " +
        describe(triangleCenter(solid, t)) +
        " is a triangle without area (its corners lie on one line). Remove degenerate cells, or "
        "tessellate the solid again.");
    }
  }
}
}

SolidInput selectTriangles(const SolidInput& input, const std::vector<Index>& rows)
{
  const auto selected = [&](const std::vector<Index>& values) {
    std::vector<Index> result;
    for (std::size_t i = 0; i < rows.size() && !values.empty(); ++i)
    {
      result.push_back(values[static_cast<std::size_t>(rows[i])]);
    }
    return result;
  };
  SolidInput part;
  part.points = input.points;
  part.pointIds = input.pointIds;
  part.triangles = input.triangles(rows, Eigen::all);
  part.faceIds = selected(input.faceIds);
  part.cellIds = input.cellIds.empty() ? rows : selected(input.cellIds);
  part.quads = input.quads;
  part.quadCellIds = input.quadCellIds;
  part.quadOfTriangle = selected(input.quadOfTriangle);
  return part;
}

void checkSolidInput(const SolidInput& input)
{
  if (input.triangles.rows() == 0)
  {
    throw InvalidInput("the solid is empty (no triangles). Connect its closed boundary surface.");
  }
  checkLength(input.faceIds, input.triangles.rows(), "face");
  checkLength(input.cellIds, input.triangles.rows(), "cell");
  checkPoints(input);
}

SolidSurface makeSolidSurface(const SolidInput& input, const SolidOptions& options)
{
  checkSolidInput(input);
  checkTolerance(options);
  SolidSurface solid =
    weldedSurface(input, weldOpenEdges(input.points, input.triangles, options.matchTolerance));
  if (solid.triangles.rows() == 0)
  {
    throw InvalidInput("the solid: all of its " + std::to_string(input.triangles.rows()) +
      " triangles collapse to edges or points. Connect its closed boundary surface.");
  }
  for (const Index t : solid.triangleRows)
  {
    const auto row = static_cast<std::size_t>(t);
    solid.cellIds.push_back(input.cellIds.empty() ? t : input.cellIds[row]);
    if (!input.faceIds.empty())
    {
      solid.faceIds.push_back(input.faceIds[row]);
    }
  }
  solid.flippedTriangles = flipDegenerateTriangles(solid);
  checkAreas(solid);
  if (options.partTouching)
  {
    partTouchingSheets(solid);
  }

  const std::vector<Index> twins = closedTwins(solid);
  checkPointFans(solid, twins);
  const Triangles outward = outwardTriangles(solid, twins);
  solid.turnedTriangles = (outward.col(1).array() != solid.triangles.col(1).array()).count();
  solid.triangles = outward;

  solid.featureAngle = options.featureAngle;
  if (solid.faceIds.empty())
  {
    solid.facesByAngle = true;
    FeatureFaces faces = facesByFeatureAngle(solid.points, solid.triangles, options.featureAngle);
    if (faces.count == 1)
    {
      throw InvalidInput("the solid has no face ids, and the feature angle of " +
        describe(options.featureAngle * 180.0 / Pi) +
        " degrees leaves it one face: its sharpest edge bends by " +
        describe(faces.sharpest * 180.0 / Pi) +
        " degrees. Give each face an id (a cell array), or lower the feature angle below that.");
    }
    solid.faceIds =
      numberedByCells(solid.cellIds, std::move(faces.faceOfTriangle), options.firstFaceId);
  }
  return solid;
}
}

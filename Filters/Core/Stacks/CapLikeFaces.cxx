// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/CapLikeFaces.h"

#include "Core/Common/Constants.h"
#include "Core/Common/DenseAlgebra.h"
#include "Core/Common/Describe.h"
#include "Core/Common/DisjointSets.h"
#include "Core/Solids/SolidMessages.h"
#include "Core/Surfaces/HalfEdgeTriangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexsweep
{
namespace
{
constexpr double Degree = Pi / 180.0;
constexpr double FacetLean = 2.0 * Degree;
constexpr double TriangleLean = 10.0 * Degree;
constexpr double UprightLean = 1.0 * Degree; // of all sides together
constexpr double ChordMean = 6.0 * Degree;
constexpr double ChordLean = 40.0 * Degree;
constexpr double LeastLean = 0.25 * Degree;
constexpr double LeastCap = 8.0 * Degree; // off the direction
constexpr double LeastArea = 1e-5;        // of the face's
constexpr double PlaneFace = 1.0 - 1e-6;
constexpr double RoundFace = 1e-3; // spread along the axis
constexpr double SameDirection = 0.2 * Degree;
constexpr std::size_t MostDirections = 12;

/// Normals of one face, by area.
struct NormalSums
{
  double area = 0.0;
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
};

Eigen::RowVector3d areaVector(const SolidSurface& solid, Index t)
{
  const Eigen::RowVector3d a = solid.points.row(solid.triangles(t, 0));
  const Eigen::RowVector3d b = solid.points.row(solid.triangles(t, 1));
  const Eigen::RowVector3d c = solid.points.row(solid.triangles(t, 2));
  return 0.5 * (b - a).cross(c - a);
}

std::vector<Index> idsOf(const SolidSurface& solid)
{
  std::vector<Index> ids = solid.faceIds;
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::vector<std::size_t> placesOf(const SolidSurface& solid, const std::vector<Index>& ids)
{
  std::vector<std::size_t> places;
  for (const Index id : solid.faceIds)
  {
    places.push_back(
      static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin()));
  }
  return places;
}

/// What decides about one face: sines of the angles of its normals over the plane across.
struct Lean
{
  double area = 0.0;
  double mean = 0.0;  ///< of the absolute values, by area
  double whole = 0.0; ///< of the values, by area
  double least = 1.0;
  double greatest = -1.0;
  /// Whether points lie inside the face. Where none do, chords of its borders make triangles lean
  /// to either side, the more the lower the face is.
  bool hasInnerPoints = false;
};

/// Sets Lean::hasInnerPoints.
void findInnerPoints(
  const SolidSurface& solid, const std::vector<std::size_t>& faceOf, std::vector<Lean>& leans)
{
  constexpr std::size_t None = static_cast<std::size_t>(-1);
  std::vector<std::size_t> faceAt(static_cast<std::size_t>(solid.points.rows()), None);
  std::vector<bool> several(faceAt.size(), false);
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    const std::size_t face = faceOf[static_cast<std::size_t>(t)];
    for (Index c = 0; c < 3; ++c)
    {
      const auto p = static_cast<std::size_t>(solid.triangles(t, c));
      several[p] = several[p] || (faceAt[p] != None && faceAt[p] != face);
      faceAt[p] = face;
    }
  }
  for (std::size_t p = 0; p < faceAt.size(); ++p)
  {
    if (faceAt[p] != None && !several[p])
    {
      leans[faceAt[p]].hasInnerPoints = true;
    }
  }
}

void decide(const Lean& lean, double draft, StackFace& face)
{
  const double most = std::max(std::abs(lean.least), std::abs(lean.greatest));
  if (lean.mean <= std::sin(draft + FacetLean) &&
    most <= std::sin(draft + FacetLean + TriangleLean))
  {
    face.kind = StackFaceKind::Side;
    return;
  }
  const bool isChords = !lean.hasInnerPoints && lean.least < 0.0 && lean.greatest > 0.0;
  if (isChords && std::abs(lean.whole) <= std::sin(draft + FacetLean) &&
    lean.mean <= std::sin(draft + ChordMean) && most <= std::sin(draft + ChordLean))
  {
    face.kind = StackFaceKind::Side;
    return;
  }
  const double cap = std::sin(LeastCap);
  if (lean.least >= cap || lean.greatest <= -cap)
  {
    face.kind = lean.least >= cap ? StackFaceKind::Top : StackFaceKind::Bottom;
    return;
  }
  const auto degrees = [](double sine) {
    return describe(std::round(std::asin(std::clamp(sine, -1.0, 1.0)) / Degree));
  };
  face.problem = lean.least < -cap && lean.greatest > cap ? "faces both ends of the direction"
                                                          : "leans from " + degrees(lean.least) +
      " to " + degrees(lean.greatest) + " degrees, too steep for a cap and too flat for a side";
}

/// Sets of caps that share borders. Caps of different kinds on one border leave no room between.
void joinCaps(const SolidSurface& solid, CapLikeFaces& result)
{
  const HalfEdgeTriangles halfEdges(solid.triangles);
  DisjointSets sets(static_cast<Index>(result.faces.size()));
  for (Index h = 0; h < halfEdges.numberOfHalfEdges(); ++h)
  {
    const Index twin = halfEdges.twin(h);
    if (twin < h)
    {
      continue;
    }
    const std::size_t a = result.faceOf[static_cast<std::size_t>(h / 3)];
    const std::size_t b = result.faceOf[static_cast<std::size_t>(twin / 3)];
    StackFace& first = result.faces[a];
    const StackFace& second = result.faces[b];
    if (first.kind == second.kind)
    {
      sets.join(static_cast<Index>(a), static_cast<Index>(b));
    }
    else if ((first.kind == StackFaceKind::Top && second.kind == StackFaceKind::Bottom) ||
      (first.kind == StackFaceKind::Bottom && second.kind == StackFaceKind::Top))
    {
      first.kind = StackFaceKind::Neither;
      first.problem = "meets " + listFaces({ second.id }) +
        " in an edge that closes the solid to a thickness of 0";
    }
  }
  for (std::size_t f = 0; f < result.faces.size(); ++f)
  {
    const bool isFirst = sets.find(static_cast<Index>(f)) == static_cast<Index>(f);
    result.tops += isFirst && result.faces[f].kind == StackFaceKind::Top ? 1 : 0;
    result.bottoms += isFirst && result.faces[f].kind == StackFaceKind::Bottom ? 1 : 0;
  }
}

/// A direction, and the area of the faces that speak for it.
struct Proposal
{
  Eigen::RowVector3d direction;
  double weight;
};

void propose(Eigen::RowVector3d direction, double weight, std::vector<Proposal>& proposals)
{
  Index longest = 0;
  direction.cwiseAbs().maxCoeff(&longest);
  direction *= direction[longest] < 0.0 ? -1.0 : 1.0;
  for (Proposal& known : proposals)
  {
    const double sine = known.direction.cross(direction).norm();
    if (sine < std::sin(SameDirection))
    {
      known.weight += weight;
      return;
    }
  }
  proposals.push_back({ direction, weight });
}

std::vector<Proposal> proposedDirections(const SolidSurface& solid)
{
  const std::vector<Index> ids = idsOf(solid);
  const std::vector<std::size_t> faceOf = placesOf(solid, ids);
  std::vector<NormalSums> sums(ids.size());
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    NormalSums& sum = sums[faceOf[static_cast<std::size_t>(t)]];
    const Eigen::RowVector3d vector = areaVector(solid, t);
    const double area = vector.norm();
    if (area > 0.0)
    {
      sum.area += area;
      sum.sum += vector;
      sum.spread += vector.transpose() * vector / area;
    }
  }
  // Planes first: facets of round faces lean, and an axis that is found from them is not exact.
  std::vector<Proposal> proposals;
  const auto isPlane = [](const NormalSums& sum) {
    return sum.area > 0.0 && sum.sum.norm() > PlaneFace * sum.area;
  };
  for (const NormalSums& sum : sums)
  {
    if (isPlane(sum))
    {
      propose(sum.sum.normalized(), sum.area, proposals);
    }
  }
  for (const NormalSums& sum : sums)
  {
    if (!(sum.area > 0.0) || isPlane(sum))
    {
      continue;
    }
    const PrincipalAxes normals = principalAxes(sum.spread / sum.area);
    if (normals.values[0] < RoundFace && normals.values[1] > 10.0 * RoundFace)
    {
      propose(normals.axes.col(0).transpose(), sum.area, proposals);
    }
    else if (sum.sum.norm() > 0.5 * sum.area)
    {
      propose(sum.sum.normalized(), 0.1 * sum.area, proposals);
    }
  }
  std::stable_sort(proposals.begin(), proposals.end(),
    [](const Proposal& a, const Proposal& b) { return a.weight > b.weight; });
  proposals.resize(std::min(proposals.size(), 2 * MostDirections));
  return proposals;
}
}

CapLikeFaces capLikeFaces(
  const SolidSurface& solid, const Eigen::RowVector3d& direction, double draft)
{
  CapLikeFaces result;
  result.direction = direction.normalized();
  const std::vector<Index> ids = idsOf(solid);
  result.faceOf = placesOf(solid, ids);
  std::vector<Lean> leans(ids.size());
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    leans[result.faceOf[static_cast<std::size_t>(t)]].area += areaVector(solid, t).norm();
  }
  for (Index t = 0; t < solid.triangles.rows(); ++t)
  {
    Lean& lean = leans[result.faceOf[static_cast<std::size_t>(t)]];
    const Eigen::RowVector3d vector = areaVector(solid, t);
    const double area = vector.norm();
    if (!(area > LeastArea * lean.area))
    {
      continue;
    }
    const double sine = vector.dot(result.direction) / area;
    lean.mean += std::abs(sine) * area / lean.area;
    lean.whole += sine * area / lean.area;
    lean.least = std::min(lean.least, sine);
    lean.greatest = std::max(lean.greatest, sine);
  }
  findInnerPoints(solid, result.faceOf, leans);
  double sideArea = 0.0;
  for (std::size_t f = 0; f < ids.size(); ++f)
  {
    StackFace face;
    face.id = ids[f];
    face.area = leans[f].area;
    decide(leans[f], draft, face);
    if (face.kind == StackFaceKind::Side)
    {
      sideArea += face.area;
      result.sideLean += leans[f].mean * face.area;
    }
    if (face.kind == StackFaceKind::Side && std::abs(leans[f].whole) > std::sin(LeastLean))
    {
      result.leaning.push_back(face.id);
    }
    result.faces.push_back(std::move(face));
  }
  result.sideLean /= std::max(sideArea, std::numeric_limits<double>::min());
  joinCaps(solid, result);
  for (const StackFace& face : result.faces)
  {
    result.refusedArea += face.kind == StackFaceKind::Neither ? face.area : 0.0;
  }
  return result;
}

std::string describeRefusedFaces(const CapLikeFaces& faces, std::size_t limit)
{
  std::string text;
  std::size_t count = 0;
  for (const StackFace& face : faces.faces)
  {
    if (face.kind != StackFaceKind::Neither)
    {
      continue;
    }
    if (++count <= limit)
    {
      text += (count > 1 ? "; " : "") + listFaces({ face.id }) + " " + face.problem;
    }
  }
  if (count > limit)
  {
    text += "; and " + std::to_string(count - limit) + " more";
  }
  return "along " + describe(faces.direction) + " " + text +
    ". Cut the part into pieces that can be swept, at these faces, and mesh them together.";
}

std::vector<CapLikeFaces> stackDirections(const SolidSurface& solid, double draft)
{
  std::vector<CapLikeFaces> result;
  for (const Proposal& proposal : proposedDirections(solid))
  {
    CapLikeFaces faces = capLikeFaces(solid, proposal.direction, draft);
    if (faces.tops > 0 && faces.bottoms > 0)
    {
      result.push_back(std::move(faces));
    }
  }
  std::stable_sort(result.begin(), result.end(), [](const CapLikeFaces& a, const CapLikeFaces& b) {
    const auto rank = [](const CapLikeFaces& faces) {
      return faces.isStack() ? static_cast<double>(faces.tops + faces.bottoms) : 1e9;
    };
    return rank(a) != rank(b) ? rank(a) < rank(b) : a.refusedArea < b.refusedArea;
  });
  result.resize(std::min(result.size(), MostDirections));
  return result;
}
}

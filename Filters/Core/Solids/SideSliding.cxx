// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/SideSliding.h"

#include "Core/Common/Errors.h"
#include "Core/Common/StandardIndex.h"
#include "Core/Geometry/LoopGeometry.h"
#include "Core/Geometry/SurfaceSearch.h"
#include "Core/Interior/BlendInterior.h"
#include "Core/Interior/SideSlides.h"
#include "Core/Linking/RingQuads.h"
#include "Core/Solids/SolidSides.h"

#include <algorithm>

namespace hexsweep
{
namespace
{
constexpr double PoorAtSides = 0.3;
/// Of the corners of the sides' quads: hexahedra are not poor for their sides then.
constexpr double SoundSine = 0.6;
/// Of the least scaled Jacobian by moves inside alone.
constexpr double WorthSliding = 1.25;

/// The side of each row of the boundary's nodes, by number in the topology.
std::vector<Index> sidesOfRows(const SolidCage& cage)
{
  const std::vector<Index> ofLoops = sidesOfLoops(cage);
  std::vector<Index> sides;
  for (std::size_t l = 0; l < cage.loops.size(); ++l)
  {
    sides.insert(sides.end(), cage.loops[l].size(), ofLoops[l]);
  }
  return sides;
}

bool hasPatches(const SolidCageInput& input)
{
  return std::any_of(input.patches.begin(), input.patches.end(),
    [](const std::vector<QuadMesh>& patches) { return !patches.empty(); });
}

/// Takes the rings over from a filled cage. @return the linking nodes that moved.
std::vector<bool> takeRings(const Points& filled, SolidCage& cage)
{
  RingStack& rings = cage.linking.rings;
  std::vector<bool> moved(at(rings.points.rows()), false);
  const Index n = cage.source.rows();
  for (std::size_t l = 0; l < rings.loops.size(); ++l)
  {
    for (Index k = 1; k < rings.numberOfLayers(); ++k)
    {
      for (std::size_t j = 0; j < rings.loops[l].size(); ++j)
      {
        const Index id = rings.tables[l](k, static_cast<Index>(j));
        const Eigen::RowVector3d place = filled.row(k * n + rings.loops[l][j]);
        moved[at(id)] = place != rings.points.row(id);
        rings.points.row(id) = place;
      }
    }
  }
  return moved;
}
}

bool hasSlantedSides(const SolidCage& cage)
{
  const RingStack& rings = cage.linking.rings;
  CornerSines sines;
  for (std::size_t l = 0; l < rings.loops.size(); ++l)
  {
    for (Index k = 0; k < rings.numberOfLayers(); ++k)
    {
      sines.add(cornerSines(ringPoints(rings, l, k), ringPoints(rings, l, k + 1)));
    }
  }
  return sines.least <= SoundSine;
}

std::optional<SolidCage> slideCageSides(const SolidCageInput& input, const SolidCage& cage,
  const ParallelFor& parallelFor, const Progress& progress)
{
  if (cage.isRuled || hasPatches(input) || cage.linking.rings.numberOfLayers() < 2 ||
    !hasSlantedSides(cage))
  {
    return std::nullopt;
  }
  std::vector<SurfaceSearch> searches;
  for (const SideTube& side : solidSides(input.solid, input.topology))
  {
    searches.emplace_back(side.surface);
  }
  const std::vector<Index> sides = sidesOfRows(cage);
  const NearestOnSide nearest = [&](Index row, const Eigen::RowVector3d& place) {
    const Points& edge = cage.linking.edges[at(row)];
    return edge.rows() > 0 ? nearestOnChain(edge, place)
                           : searches[at(sides[at(row)])].project(place, -1).point;
  };
  const Points filled = blendInterior(cage, progressPart(progress, 0.0, 0.1), parallelFor);
  const std::vector<bool> allMove(sides.size(), false);
  const SlidSides slid = slideSides(
    cage, filled, allMove, nearest, PoorAtSides, parallelFor, progressPart(progress, 0.1, 0.6));
  if (slid.least <= 0.0 || slid.least == 1.0)
  {
    return std::nullopt;
  }
  const std::vector<bool> allStay(sides.size(), true);
  const double inside = slideSides(
    cage, filled, allStay, nearest, PoorAtSides, parallelFor, progressPart(progress, 0.6, 1.0))
                          .least;
  if (slid.least < WorthSliding * inside)
  {
    return std::nullopt;
  }
  SolidCage result = cage;
  const std::vector<bool> moved = takeRings(slid.points, result);
  LinkingMesh& linking = result.linking;
  for (Index q = 0; q < linking.quads.rows(); ++q)
  {
    const auto nodes = linking.quads.row(q);
    if (std::any_of(nodes.begin(), nodes.end(), [&](Index id) { return moved[at(id)]; }))
    {
      Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
      for (const Index id : nodes)
      {
        middle += 0.25 * linking.rings.points.row(id);
      }
      linking.quadTriangle[at(q)] =
        searches[at(linking.quadSide[at(q)])].project(middle, -1).triangle;
    }
  }
  result.boundary = gatherSweepBoundary(result.source, result.target, linking.rings);
  return result;
}
}

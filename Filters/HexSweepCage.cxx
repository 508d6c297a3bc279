// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCage.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/RingCollapse.h"
#include "Core/Interior/SweptHexes.h"
#include "Core/Linking/LinkingRings.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "HexSweepBridge.h"

#include <string>
#include <utility>

namespace hexsweep
{
CageInput readCage(vtkDataSet* sourceQuads, vtkDataSet* targetQuads, vtkDataSet* linkingSides,
  double matchTolerance, const Progress& progress)
{
  SurfaceInput source = readQuads(sourceQuads, "source quads");
  SurfaceInput target = readQuads(targetQuads, "target quads");
  reportProgress(progress, 0.2);
  const SurfaceInput linking = readQuads(linkingSides, "linking sides");
  const Index n = source.points.rows();
  if (target.points.rows() != n)
  {
    throw InvalidInput("the target quads do not have the connectivity of the source quads: " +
      std::to_string(target.points.rows()) + " points instead of " + std::to_string(n) +
      ". Make them from the source quads (SweepQuadProjector).");
  }
  reportProgress(progress, 0.4);
  const SurfaceTopology topology = checkSurface(source.faces, n, "source quads");
  checkCap(topology, "source quads");
  CageInput cage;
  cage.quads = source.faces;
  checkSameQuads(cage.quads, Quads(target.faces));

  reportProgress(progress, 0.6);
  const LinkingRings rings = traceLinkingRings(
    source.points, topology.loops, linking.points, Quads(linking.faces), matchTolerance);
  matchTargetLoops(target.points, topology.loops, rings, linking.points, matchTolerance);
  reportProgress(progress, 0.8);
  cage.boundary =
    gatherSweepBoundary(source.points, target.points, topology.loops, rings, linking.points);
  checkRings(cage.boundary, topology.loops);
  cage.source = std::move(source.points);
  cage.target = std::move(target.points);
  cage.sourceCellIds = std::move(source.cellIds);
  return cage;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCage.h"

#include "Core/Common/Errors.h"
#include "Core/Interior/RingCollapse.h"
#include "Core/Interior/SweptHexes.h"
#include "Core/Linking/LinkingRings.h"
#include "Core/Surfaces/SurfaceTopology.h"
#include "HexSweepReader.h"

#include <string>
#include <utility>

namespace hexsweep
{
CageInput readCage(vtkDataSet* sourceQuads, vtkDataSet* targetQuads, vtkDataSet* linkingSides,
  double matchTolerance, const Progress& progress)
{
  QuadInput source = readQuads(sourceQuads, "source quads");
  QuadInput target = readQuads(targetQuads, "target quads");
  reportProgress(progress, 0.2);
  const QuadMesh linking = readQuads(linkingSides, "linking sides").mesh;
  const Index n = source.mesh.points.rows();
  if (target.mesh.points.rows() != n)
  {
    throw InvalidInput("the target quads do not have the connectivity of the source quads: " +
      std::to_string(target.mesh.points.rows()) + " points instead of " + std::to_string(n) +
      ". Make them from the source quads (SweepQuadProjector).");
  }
  reportProgress(progress, 0.4);
  const SurfaceTopology topology = checkSurface(source.mesh.quads, n, "source quads");
  checkCap(topology, "source quads");
  CageInput cage;
  checkSameQuads(source.mesh.quads, target.mesh.quads);

  reportProgress(progress, 0.6);
  const RingStack rings = traceLinkingRings(
    source.mesh.points, topology.loops, linking.points, linking.quads, matchTolerance);
  matchTargetLoops(target.mesh.points, rings, matchTolerance);
  reportProgress(progress, 0.8);
  cage.boundary = gatherSweepBoundary(source.mesh.points, target.mesh.points, rings);
  checkRings(cage.boundary, topology.loops);
  cage.quads = std::move(source.mesh.quads);
  cage.source = std::move(source.mesh.points);
  cage.target = std::move(target.mesh.points);
  cage.sourceCellIds = std::move(source.cellIds);
  return cage;
}
}

// SPDX-License-Identifier: BSD-3-Clause
// HexSweep::Core alone, without VTK: certifies two hexahedra, sweeps a solid that is made here, and
// shows what comes of a solid that is open.
#include "Core/Common/Errors.h"
#include "Core/Hexahedra/HexCertificate.h"
#include "Core/Hexahedra/HexQuality.h"
#include "Core/Interior/InteriorStarts.h"
#include "Core/Interior/SweepInterior.h"
#include "Core/Interior/SweptHexes.h"
#include "Core/Solids/SolidCage.h"
#include "Core/Solids/SolidInput.h"
#include "Core/Solids/SourceQuads.h"
#include "Core/Solids/TargetFaces.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{
using namespace hexsweep;

constexpr Index Bottom = 1;
constexpr Index Top = 2;

/// A square frame whose top is smaller, and turned by 30 degrees: 16 points, 32 triangles, face
/// ids.
SolidInput frame()
{
  SolidInput solid;
  solid.points.resize(16, 3);
  const double pi = std::acos(-1.0);
  for (Index layer = 0; layer < 2; ++layer)
  {
    for (Index ring = 0; ring < 2; ++ring)
    {
      const double radius = (ring == 0 ? 3.0 : 1.5) * (layer == 0 ? 1.0 : 0.8);
      for (Index corner = 0; corner < 4; ++corner)
      {
        const double angle =
          pi * (static_cast<double>(corner) / 2.0 + static_cast<double>(layer) / 6.0);
        solid.points.row(8 * layer + 4 * ring + corner) << radius * std::cos(angle),
          radius * std::sin(angle), 4.0 * static_cast<double>(layer);
      }
    }
  }
  solid.triangles.resize(32, 3);
  Index row = 0;
  const auto addQuad = [&](Index a, Index b, Index c, Index d, Index face) {
    solid.triangles.row(row++) << a, b, c;
    solid.triangles.row(row++) << a, c, d;
    solid.faceIds.insert(solid.faceIds.end(), { face, face });
  };
  for (Index corner = 0; corner < 4; ++corner)
  {
    const Index next = (corner + 1) % 4;
    addQuad(corner, next, 4 + next, 4 + corner, Bottom);
    addQuad(8 + corner, 8 + next, 12 + next, 12 + corner, Top);
    addQuad(corner, next, 8 + next, 8 + corner, 3 + corner);           // outside
    addQuad(4 + corner, 4 + next, 12 + next, 12 + corner, 7 + corner); // round the hole
  }
  return solid;
}

/// A cube, and the same with the two top corners of one edge exchanged.
bool certifyTwo()
{
  HexCorners cube;
  cube << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  HexCorners crossed = cube;
  crossed.row(4).swap(crossed.row(5));
  const HexCertificate good = certifyHex(cube);
  const HexCertificate bad = certifyHex(crossed);
  std::cout << "cube: " << (good.validity == Validity::Certified ? "certified" : "not certified")
            << ", Jacobian at least " << good.jacobianLowerBound << "\n"
            << "crossed: "
            << (bad.validity == Validity::InvertedCorner ? "a corner is inverted" : "?") << "\n";
  return good.validity == Validity::Certified && bad.validity == Validity::InvertedCorner;
}

struct HexMesh
{
  Points points;
  Hexes hexes;
};

/// From the bottom to the cap that fits it, which is found.
HexMesh sweep(const SolidInput& input, Index layers, const Progress& progress)
{
  const SolidSurface solid = makeSolidSurface(input);
  const SweepTopology topology = findSweepTopology(solid, { Bottom });
  const SourceQuads quads = makeSourceQuads(input, solid, topology, 0.4);
  SolidCageInput cageInput{ solid, topology, quads.mesh, {}, {} };
  cageInput.layers.layers = layers;
  const SolidCage cage = makeSolidCage(cageInput, progressPart(progress, 0.0, 0.5));
  const SweepInterior interior = sweepInterior(
    cage, interiorStarts(InteriorKind::Automatic), {}, progressPart(progress, 0.5, 1.0));
  return { interior.points, sweptHexes(cage.quads, interior.points, layers) };
}

bool sweepFrame()
{
  // Return false from here to stop: hexsweep::Aborted is thrown then.
  double done = 0.0;
  const HexMesh mesh = sweep(frame(), 10, [&](double fraction) {
    done = fraction;
    return true;
  });
  const HexQualitySummary summary = summarize(hexQualities(mesh.points, mesh.hexes));
  std::cout << "frame: " << summary.hexes << " hexahedra, " << summary.notCertified
            << " not certified, scaled Jacobian at least " << summary.minScaledJacobian << "\n";
  return summary.hexes > 0 && summary.notCertified == 0 && done == 1.0;
}

bool refuseOpenFrame()
{
  SolidInput open = frame();
  open.triangles.conservativeResize(31, 3);
  open.faceIds.resize(31);
  try
  {
    sweep(open, 10, {});
  }
  catch (const InvalidInput& error)
  {
    std::cout << "open frame: " << error.what() << "\n";
    return true;
  }
  return false;
}
}

int main()
{
  const bool asExpected = certifyTwo() && sweepFrame() && refuseOpenFrame();
  return asExpected ? EXIT_SUCCESS : EXIT_FAILURE;
}

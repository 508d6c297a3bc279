// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the quads of a solid's source cap come from, and which quads its sides bring along.
 * Private to the module.
 */
#ifndef HexSweepSolidQuads_h
#define HexSweepSolidQuads_h

#include "Core/Solids/SweepTopology.h"
#include "HexSweepHexOutput.h"
#include "HexSweepSolidReader.h"

#include <string>
#include <vector>

class vtkDataSet;

namespace hexsweep
{
struct SourceQuads
{
  QuadMesh mesh;
  SourceAttributes attributes;
  std::string origin; ///< for the report: "SourceQuads", "Solid" or "made"
  Index inverted = 0; ///< of quads that were made here
  double size = 0.0;  ///< edge length that these were to have
};

/// Where the borders between the faces of linking sides begin: points of the solid on the loops of
/// the source cap.
std::vector<Index> edgeStarts(const SolidSurface& solid, const SweepTopology& topology);

/**
 * The quads of the input, else those that the solid has on its source faces, else new ones.
 *
 * @param given nullptr: no such input.
 * @param size  of new quads; 0: see defaultQuadSize().
 * @throw InvalidInput when the input is no quad mesh, or for a size out of range.
 */
SourceQuads sourceQuads(vtkDataSet* given, vtkDataSet* solidData, const SolidData& data,
  const SolidSurface& solid, const SweepTopology& topology, double size, const Progress& progress);

/// Degrees: by how much the loops of the source cap turn at most, but for borders between faces;
/// 0 where that is less than 10.
double greatestFacetTurn(const SolidSurface& solid, const SweepTopology& topology);

/// Faces of each side that are meshed with quads.
std::vector<std::vector<QuadMesh>> sidePatches(
  const SolidData& data, const SolidSurface& solid, const SweepTopology& topology);
}

#endif

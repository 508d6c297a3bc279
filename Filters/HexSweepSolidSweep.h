// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief One sweep of a solid, from its caps to hexahedra and their boundary. Private to the
 * module.
 */
#ifndef HexSweepSolidSweep_h
#define HexSweepSolidSweep_h

#include "Core/CapQuads/SweepProjection.h"
#include "Core/Linking/LinkingSides.h"
#include "Core/Solids/SolidInput.h"
#include "Core/Solids/SweepSize.h"
#include "Core/Solids/SweepTopology.h"
#include "Core/Stacks/PickedCaps.h"
#include "HexSweepBodies.h"
#include "HexSweepHexOutput.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkDataSet;
class vtkUnstructuredGrid;

namespace hexsweep
{
/// A body as it was given, and as it was read.
struct SolidToSweep
{
  vtkDataSet* data;
  vtkDataSet* sourceQuads; ///< nullptr: none are given
  const ReadBody& body;
};

/// Of sweeps between several caps, see vtkManyToManySweep.
struct StackSweepSettings
{
  Eigen::RowVector3d direction = Eigen::RowVector3d::Zero(); ///< 0: it is found
  Eigen::RowVector3d axisPoint = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d axisDirection = Eigen::RowVector3d::Zero(); ///< 0: none is given
  double draftAngle = 0.0;                                       ///< degrees
  double imprintTolerance = 0.05;                                ///< see StackOptions
  PickedCaps picked;                                             ///< decide what is found
};

struct SolidSweepSettings
{
  double size = 0.0;           ///< see vtkOneToOneSweep::SetSize()
  double quadSize = 0.0;       ///< not 0: counts instead of `size`
  double chordTolerance = 0.0; ///< see vtkOneToOneSweep::SetChordTolerance()
  /// Where they name neither number, size nor positions, `size` counts.
  LayerRequest layers;
  /// Where nobody asks for a size: more are made coarser.
  Index mostHexes = MostChosenHexes;
  double matchTolerance = 1e-6;
  ProjectionMethod projection = ProjectionMethod::Harmonic;
  Weights weights = Weights::Cotangent;
  TriangulationImprovement improvement = TriangulationImprovement::Automatic;
  bool moveBoundaryNodes = false; ///< see vtkOneToOneSweep::SetMoveBoundaryNodes()
  bool snapToGeometry = true;     ///< see vtkOneToOneSweep::SetSnapToGeometry()
  bool targetIsNamed = false;     ///< one that is not may not lie behind the source
  HexOutputSettings hexes;
  /// Bodies with several caps are swept between all of them; nothing: they are not.
  std::optional<StackSweepSettings> stacks;
  /// Takes what the user should know before the work begins.
  std::function<void(const std::string&)> tell;
};

struct SolidSweepResult
{
  bool valid = false;                ///< no hexahedron is inverted, or not certified
  std::vector<std::string> warnings; ///< what to tell the user, see messageAbout()
};

/**
 * Meshes a body between two caps. Field data of the solid and the report come with the grids, which
 * lie where the body was given; messages lie where it was put.
 *
 * @param stages is told of every stage.
 * @throw InvalidInput as makeSolidCage(), checkFoundTarget() and writeHexes(), and for sizes out of
 *        range; SolverFailure; Aborted.
 */
SolidSweepResult sweepSolid(const SolidToSweep& solid, const SweepTopology& topology,
  const SolidSweepSettings& settings, StageClock& stages, const Progress& progress,
  vtkUnstructuredGrid* hexes, vtkUnstructuredGrid* boundary);
}

#endif

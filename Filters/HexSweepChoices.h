// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The one rule for properties that are one of a few numbers: any number may be set, one that
 * means nothing is an error when the filter runs. Private to the module.
 */
#ifndef HexSweepChoices_h
#define HexSweepChoices_h

#include "Core/CapQuads/SweepProjection.h"

#include <string>
#include <vector>

namespace hexsweep
{
/// @param names of the values 0, 1, ... @throw InvalidInput naming these, for any other value.
void checkChoice(const std::string& property, int value, const std::vector<std::string>& names);

/// @param value a vtkAlgorithm::DesiredOutputPrecision. @throw InvalidInput where it is none.
void checkPrecision(int value);

/// @param value a vtkCageHexInterior::MethodType. @throw InvalidInput where it is none.
void checkInteriorMethod(int value);

/// @param degrees must lie between 0 and 180. @throw InvalidInput where it does not.
void checkFeatureAngle(double degrees);

/// The method of a vtkSweepQuadProjector::MethodType. @throw InvalidInput where it is none.
ProjectionMethod projectionMethod(const std::string& property, int value);

/// Its name, for reports.
std::string nameOf(ProjectionMethod method);

/// The weights of a vtkHarmonicDiskMap::WeightsType. @throw InvalidInput where it is none.
Weights chosenWeights(int value);

/// What a vtkHarmonicDiskMap::ImproveTriangulationType asks for. @throw InvalidInput where it is
/// none.
TriangulationImprovement chosenImprovement(int value);
}

#endif

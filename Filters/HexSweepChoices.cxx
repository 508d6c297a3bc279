// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepChoices.h"

#include "Core/Common/Describe.h"
#include "Core/Common/Errors.h"
#include "Core/Interior/InteriorStarts.h"

namespace hexsweep
{
namespace
{
const std::vector<std::string> ProjectionMethods = { "Harmonic", "PaperHarmonic",
  "AffineLeastSquares" };
}

void checkChoice(const std::string& property, int value, const std::vector<std::string>& names)
{
  const int count = static_cast<int>(names.size());
  if (value >= 0 && value < count)
  {
    return;
  }
  std::string text = property + " " + std::to_string(value) + " does not exist. Choose ";
  for (int i = 0; i < count; ++i)
  {
    text += (i == 0             ? ""
                : i + 1 < count ? ", "
                                : " or ") +
      names[static_cast<std::size_t>(i)] + " (" + std::to_string(i) + ")";
  }
  throw InvalidInput(text + ".");
}

void checkPrecision(int value)
{
  checkChoice("OutputPointsPrecision", value, { "Single", "Double", "Default" });
}

void checkInteriorMethod(int value)
{
  checkChoice("Method", value, interiorMethodNames());
}

void checkFeatureAngle(double degrees)
{
  if (!(degrees > 0.0 && degrees < 180.0))
  {
    throw InvalidInput("FeatureAngle is " + describe(degrees) +
      " degrees. Set it to a number between 0 and 180; 30 is usual.");
  }
}

ProjectionMethod projectionMethod(const std::string& property, int value)
{
  checkChoice(property, value, ProjectionMethods);
  constexpr ProjectionMethod Methods[] = { ProjectionMethod::Harmonic,
    ProjectionMethod::PaperHarmonic, ProjectionMethod::AffineLeastSquares };
  return Methods[value];
}

std::string nameOf(ProjectionMethod method)
{
  return method == ProjectionMethod::Harmonic   ? ProjectionMethods[0]
    : method == ProjectionMethod::PaperHarmonic ? ProjectionMethods[1]
                                                : ProjectionMethods[2];
}

Weights chosenWeights(int value)
{
  checkChoice("Weights", value, { "Cotangent", "MeanValue" });
  return value == 0 ? Weights::Cotangent : Weights::MeanValue;
}

TriangulationImprovement chosenImprovement(int value)
{
  checkChoice("ImproveTriangulation", value, { "Off", "Automatic", "On" });
  constexpr TriangulationImprovement Improvements[] = { TriangulationImprovement::Off,
    TriangulationImprovement::Automatic, TriangulationImprovement::On };
  return Improvements[value];
}
}

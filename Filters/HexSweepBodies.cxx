// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepBodies.h"

#include "Core/Common/Constants.h"
#include "Core/Solids/SolidBodies.h"
#include "Core/Solids/SolidMessages.h"
#include "HexSweepChoices.h"
#include "HexSweepSolidReader.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace hexsweep
{
namespace
{
void checkWanted(const std::vector<SolidBody>& bodies, const std::vector<Index>& wanted)
{
  std::vector<Index> ids;
  for (const SolidBody& body : bodies)
  {
    ids.push_back(body.volumeId);
  }
  for (const Index id : wanted)
  {
    if (std::find(ids.begin(), ids.end(), id) == ids.end())
    {
      throw InvalidInput("the solid has no volume " + std::to_string(id) + ". It has " +
        (ids.size() == 1 ? "volume " : "volumes ") + listIds(ids) + ".");
    }
  }
}

/// @param several whether the solid has other bodies, so that this one needs a name.
ReadBody readBody(const SolidBody& body, bool several, const SolidOptions& options)
{
  ReadBody read;
  read.volumeId = body.volumeId;
  read.name = several ? "volume " + std::to_string(body.volumeId) : "";
  read.solid = canonicalSolid(body.input);
  try
  {
    read.surface = makeSolidSurface(read.solid.input, options);
  }
  catch (const InvalidInput& error)
  {
    read.problem = messageAbout(read, error.what());
  }
  return read;
}
}

std::string messageAbout(const ReadBody& body, const std::string& text)
{
  return (body.name.empty() || text.empty() ? "" : body.name + ": ") +
    reflectedPlaces(text, body.solid.reflection);
}

std::vector<Index> facesOnBody(const ReadBody& body, const std::vector<Index>& faceIds)
{
  if (body.name.empty() || !body.problem.empty())
  {
    return faceIds;
  }
  const std::vector<Index>& all = body.surface.faceIds;
  std::vector<Index> own;
  std::copy_if(faceIds.begin(), faceIds.end(), std::back_inserter(own),
    [&](Index id) { return std::find(all.begin(), all.end(), id) != all.end(); });
  return own;
}

void checkNamedFaces(const std::vector<ReadBody>& bodies, const std::vector<Index>& faceIds)
{
  for (const Index id : faceIds)
  {
    if (std::all_of(bodies.begin(), bodies.end(),
          [&](const ReadBody& body) { return facesOnBody(body, { id }).empty(); }))
    {
      throw InvalidInput("no volume that is to be swept has a face " + std::to_string(id) +
        ". Name faces of these (Solid Faces and `hexsweep faces` list them).");
    }
  }
}

void checkAreSolids(const std::vector<ReadBody>& bodies)
{
  for (const ReadBody& body : bodies)
  {
    if (!body.problem.empty())
    {
      throw InvalidInput(body.problem);
    }
  }
}

SolidOptions solidOptions(double matchTolerance, double featureAngle)
{
  checkFeatureAngle(featureAngle);
  SolidOptions options;
  options.matchTolerance = matchTolerance;
  options.featureAngle = featureAngle * Pi / 180.0;
  return options;
}

std::vector<ReadBody> readBodies(vtkDataSet* data, const std::string& faceIdArray,
  const SolidOptions& options, const std::vector<Index>& wanted)
{
  const SolidData solid = readSolid(data, faceIdArray);
  const std::vector<SolidBody> bodies = solidBodies(solid.surface, solid.volumeIds, options);
  checkWanted(bodies, wanted);
  std::vector<ReadBody> result;
  SolidOptions own = options;
  for (const SolidBody& body : bodies)
  {
    ReadBody read = readBody(body, bodies.size() > 1, own);
    if (read.surface.facesByAngle)
    {
      own.firstFaceId =
        *std::max_element(read.surface.faceIds.begin(), read.surface.faceIds.end()) + 1;
    }
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), body.volumeId) != wanted.end())
    {
      result.push_back(std::move(read));
    }
  }
  if (result.size() == 1 && !result.front().problem.empty())
  {
    throw InvalidInput(result.front().problem);
  }
  return result;
}
}

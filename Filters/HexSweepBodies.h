// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The bodies of a solid, read and ready to be swept. Private to the module.
 */
#ifndef HexSweepBodies_h
#define HexSweepBodies_h

#include "Core/Common/Errors.h"
#include "Core/Geometry/ModelGeometry.h"
#include "Core/Solids/CanonicalSolid.h"

#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataSet;

namespace hexsweep
{
/// One body. What is made of it, and messages about it, lie where `solid.reflection` put it.
struct ReadBody
{
  Index volumeId = 0;
  std::string name; ///< "volume 3"; empty where the solid is one body
  CanonicalSolid solid;
  SolidSurface surface; ///< of `solid.input`; empty where there is a problem with it
  std::string problem;  ///< of one among several bodies: why it is no solid; empty: it is one
  /// The true surfaces, where `solid.reflection` put them; nullptr: they are not known.
  std::shared_ptr<const ModelGeometry> geometry;
};

/// A message about a body with its name, and its places as the user knows them.
std::string messageAbout(const ReadBody& body, const std::string& text);

/// Runs what may throw about a body. @throw what it throws, with messageAbout().
template <typename Call>
auto aboutBody(const ReadBody& body, Call&& call)
{
  try
  {
    return call();
  }
  catch (const InvalidInput& error)
  {
    throw InvalidInput(messageAbout(body, error.what()));
  }
  catch (const SolverFailure& error)
  {
    throw SolverFailure(messageAbout(body, error.what()));
  }
}

/// Those of some faces that a body has.
std::vector<Index> facesOnBody(const ReadBody& body, const std::vector<Index>& faceIds);

/// @throw InvalidInput when there are several bodies, and one of the faces is on none of them.
void checkNamedFaces(const std::vector<ReadBody>& bodies, const std::vector<Index>& faceIds);

/// @throw InvalidInput when one has a problem.
void checkAreSolids(const std::vector<ReadBody>& bodies);

/**
 * The tolerance and the angle (degrees) of a filter's properties.
 *
 * @throw InvalidInput for an angle out of range.
 */
SolidOptions solidOptions(double matchTolerance, double featureAngle);

/**
 * Reads a solid, see readSolid(), solidBodies(), canonicalSolid() and makeSolidSurface(). Bodies
 * are told apart by the cell array `VolumeId` of surface cells where there is one. Faces found by
 * angle have ids that go on from body to body.
 *
 * @param wanted volume ids; empty: all.
 * @throw InvalidInput as these, but for makeSolidSurface() where there are several bodies, and when
 *        no body has a wanted id.
 */
std::vector<ReadBody> readBodies(vtkDataSet* data, const std::string& faceIdArray,
  const SolidOptions& options, const std::vector<Index>& wanted = {});
}

#endif

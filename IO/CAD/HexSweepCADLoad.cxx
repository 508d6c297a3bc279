// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepCADLoad.h"

#include "Core/Common/Errors.h"
#include "HexSweepCADFile.h"
#include "HexSweepCADImprint.h"

#include <TopExp.hxx>

#include <vtksys/MD5.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace hexsweep
{
std::string writtenSettings(const CADSettings& settings)
{
  std::array<char, 64> tolerance{};
  std::snprintf(tolerance.data(), tolerance.size(), "%.17g", settings.imprintTolerance);
  return std::string(settings.imprint ? "1" : "0") + " " + tolerance.data() + " " +
    (settings.heal ? "1" : "0") + " " + settings.lengthUnit;
}

CADSettings settingsFrom(const std::string& text)
{
  CADSettings settings;
  std::istringstream words(text);
  if (!(words >> settings.imprint >> settings.imprintTolerance >> settings.heal))
  {
    throw InvalidInput("the settings of the CAD file cannot be read");
  }
  words >> settings.lengthUnit;
  return settings;
}

CADModel loadCADModel(
  const std::string& fileName, const CADSettings& settings, const Progress& progress)
{
  CADModel model =
    readCADFile(fileName, { settings.lengthUnit, settings.heal }, progressPart(progress, 0.0, 0.7));
  numberFacesAndEdges(model);
  if (settings.imprint && model.solids.size() > 1)
  {
    imprintAndMerge(model, settings.imprintTolerance, progressPart(progress, 0.7, 1.0));
    numberFacesAndEdges(model);
  }
  return model;
}

NumberedSolid numberedSolid(const CADModel& model, std::size_t solid)
{
  NumberedSolid result;
  result.shape = model.solids[solid].shape;
  TopTools_IndexedMapOfShape faces;
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(result.shape, TopAbs_FACE, faces);
  TopExp::MapShapes(result.shape, TopAbs_EDGE, edges);
  for (int f = 1; f <= faces.Extent(); ++f)
  {
    result.faceIds.push_back(model.faces.FindIndex(faces.FindKey(f)));
  }
  for (int e = 1; e <= edges.Extent(); ++e)
  {
    result.edgeIds.push_back(model.edges.FindIndex(edges.FindKey(e)));
  }
  return result;
}

std::string checksumOf(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    throw InvalidInput("the CAD file " + fileName + " is not there any more");
  }
  vtksysMD5* sum = vtksysMD5_New();
  vtksysMD5_Initialize(sum);
  std::vector<char> block(std::size_t{ 1 } << 20);
  while (file)
  {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    const auto count = static_cast<int>(file.gcount());
    if (count > 0)
    {
      vtksysMD5_Append(sum, reinterpret_cast<const unsigned char*>(block.data()), count);
    }
  }
  std::array<char, 32> hex{};
  vtksysMD5_FinalizeHex(sum, hex.data());
  vtksysMD5_Delete(sum);
  return { hex.data(), hex.size() };
}
}

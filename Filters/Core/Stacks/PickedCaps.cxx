// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Stacks/PickedCaps.h"

#include "Core/Solids/SolidMessages.h"

#include <algorithm>
#include <utility>

namespace hexsweep
{
namespace
{
bool areOfKind(
  const std::vector<Index>& picked, const CapLikeFaces& faces, const StackFaceKind kind)
{
  return std::all_of(faces.faces.begin(), faces.faces.end(), [&](const StackFace& face) {
    return face.kind == kind || std::find(picked.begin(), picked.end(), face.id) == picked.end();
  });
}

std::string asCaps(const std::vector<Index>& faces, const char* end)
{
  return listFaces(faces) + " as " + end + (faces.size() > 1 ? " caps" : " cap");
}
}

bool areAtTheirEnds(const PickedCaps& picked, const CapLikeFaces& faces)
{
  return areOfKind(picked.sources, faces, StackFaceKind::Bottom) &&
    areOfKind(picked.targets, faces, StackFaceKind::Top);
}

std::vector<CapLikeFaces> pickedDirections(
  const SolidSurface& solid, const PickedCaps& picked, double draft)
{
  std::vector<CapLikeFaces> fitting;
  for (CapLikeFaces& faces : stackDirections(solid, draft))
  {
    if (!areAtTheirEnds(picked, faces))
    {
      faces = capLikeFaces(solid, -faces.direction, draft);
    }
    if (areAtTheirEnds(picked, faces))
    {
      fitting.push_back(std::move(faces));
    }
  }
  return fitting;
}

std::string describePicked(const PickedCaps& picked)
{
  std::string text = picked.sources.empty() ? "" : asCaps(picked.sources, "source");
  if (!picked.targets.empty())
  {
    text += (text.empty() ? "" : " and ") + asCaps(picked.targets, "target");
  }
  return text;
}
}

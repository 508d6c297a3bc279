// SPDX-License-Identifier: BSD-3-Clause
#include "HexSweepSetNames.h"

#include "Core/Common/Errors.h"
#include "Core/Common/UniqueNames.h"

#include <vtkStringArray.h>

#include <algorithm>
#include <map>

namespace hexsweep
{
namespace
{
/// vtkExodusIIWriter makes a table of names as long as twice the greatest id, which is that of a
/// node set, up to ten times as much.
constexpr vtkIdType GreatestId = 100000;
/// Abaqus takes no more; the other formats do.
constexpr std::size_t LongestName = 80;

/// Without control characters, blanks at its ends, and what vtkExodusIIWriter would take for an id.
std::string cleaned(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127; }, ' ');
  for (std::size_t at = name.find("ID:"); at != std::string::npos; at = name.find("ID:"))
  {
    name[at + 2] = ' ';
  }
  const std::size_t first = name.find_first_not_of(' ');
  return first == std::string::npos ? std::string()
                                    : name.substr(first, name.find_last_not_of(' ') - first + 1);
}

std::string givenName(vtkIdType face, vtkStringArray* names)
{
  const bool has = names && face >= 0 && face < names->GetNumberOfValues();
  return has ? cleaned(names->GetValue(face)) : std::string();
}

std::string listed(const std::vector<SetName>& sets)
{
  std::string text;
  for (const SetName& set : sets)
  {
    text += (text.empty() ? "\"" : ", \"") + set.name + "\"";
  }
  return text;
}

void choose(std::vector<SetName>& sets, const std::string& name, vtkIdType id)
{
  const auto set =
    std::find_if(sets.begin(), sets.end(), [&](const SetName& s) { return s.name == name; });
  if (set == sets.end())
  {
    throw InvalidInput(
      "no set is called \"" + name + "\", whose id was chosen. The sets are " + listed(sets) + ".");
  }
  if (id < 1 || id > GreatestId)
  {
    throw InvalidInput("the id chosen for \"" + name + "\" is " + std::to_string(id) +
      ". Choose one in [1, " + std::to_string(GreatestId) + "].");
  }
  set->id = id;
}

void checkDifferent(const std::vector<SetName>& sets)
{
  std::map<vtkIdType, std::string> taken;
  for (const SetName& set : sets)
  {
    const auto [other, isNew] = taken.emplace(set.id, set.name);
    if (!isNew)
    {
      throw InvalidInput("the sets \"" + other->second + "\" and \"" + set.name +
        "\" would both have the id " + std::to_string(set.id) + ". Choose another one for either.");
    }
  }
}

/// The least power of ten above all ids: the node set of side set 3 is 103 where there are less
/// than a hundred.
vtkIdType idsForNodes(const std::vector<SetName>& sets)
{
  vtkIdType forNodes = 10;
  for (const SetName& set : sets)
  {
    while (forNodes <= set.id)
    {
      forNodes *= 10;
    }
  }
  return forNodes;
}

/// The names without what tells equal ones apart: of faces, then of parts.
std::vector<SetName> plainNames(const std::vector<vtkIdType>& faces, vtkStringArray* faceNames,
  const std::vector<std::string>& parts)
{
  std::vector<std::string> names;
  std::vector<std::string> suffixes;
  for (const vtkIdType face : faces)
  {
    const std::string given = givenName(face, faceNames);
    names.push_back(given.empty() ? "Face " + std::to_string(face) : given);
    suffixes.push_back(" " + std::to_string(face));
  }
  names.insert(names.end(), parts.begin(), parts.end());
  suffixes.resize(names.size());
  std::vector<SetName> sets;
  for (const std::string& name : uniqueNames(names, suffixes, LongestName))
  {
    sets.push_back({ name, 0, 0, {}, {} });
  }
  return sets;
}

void giveIds(
  std::vector<SetName>& sets, const std::vector<vtkIdType>& faces, const ChosenIds& chosen)
{
  const bool facesFit = faces.empty() ||
    (*std::min_element(faces.begin(), faces.end()) >= 1 &&
      *std::max_element(faces.begin(), faces.end()) <= GreatestId);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    sets[i].id = facesFit ? faces[i] : static_cast<vtkIdType>(i) + 1;
  }
  for (const auto& [name, id] : chosen)
  {
    choose(sets, name, id);
  }
  vtkIdType greatest = 0;
  for (const SetName& set : sets)
  {
    greatest = std::max(greatest, set.id);
  }
  for (SetName& set : sets)
  {
    set.id = set.id == 0 ? ++greatest : set.id;
  }
  checkDifferent(sets);
  const vtkIdType forNodes = idsForNodes(sets);
  for (SetName& set : sets)
  {
    set.nodesId = forNodes + set.id;
  }
}
}

std::vector<SetName> nameSets(const std::vector<vtkIdType>& faces, vtkStringArray* faceNames,
  const std::vector<std::string>& parts, const ChosenIds& chosen)
{
  std::vector<SetName> sets = plainNames(faces, faceNames, parts);
  giveIds(sets, faces, chosen);
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    SetName& set = sets[i];
    std::string start = set.name;
    bool hasId = true;
    if (i >= faces.size())
    {
      // vtkExodusIIWriter counts on from the set before.
      hasId = !chosen.empty();
    }
    else if (set.id == faces[i] && givenName(faces[i], faceNames).empty())
    {
      start = "Face";
    }
    set.sidesBlock = start + (hasId ? " ID:" + std::to_string(set.id) : "");
    set.nodesBlock = start + " nodes" + (hasId ? " ID:" + std::to_string(set.nodesId) : "");
  }
  return sets;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Common/UniqueNames.h"

#include <algorithm>
#include <map>

namespace hexsweep
{
namespace
{
std::string upperCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return text;
}

std::string cut(const std::string& text, std::size_t longest)
{
  if (text.size() <= longest)
  {
    return text;
  }
  std::size_t size = longest;
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U)
  {
    --size;
  }
  return text.substr(0, size);
}

std::vector<bool> repeated(const std::vector<std::string>& names)
{
  std::map<std::string, int> counts;
  for (const std::string& name : names)
  {
    ++counts[upperCase(name)];
  }
  std::vector<bool> result;
  for (const std::string& name : names)
  {
    result.push_back(counts[upperCase(name)] > 1);
  }
  return result;
}
}

std::vector<std::string> uniqueNames(const std::vector<std::string>& names,
  const std::vector<std::string>& suffixes, std::size_t longest)
{
  std::vector<std::string> ends(names.size());
  std::vector<std::string> result;
  for (bool changed = true; changed;)
  {
    result.clear();
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      result.push_back(cut(names[i], longest - std::min(longest, ends[i].size())) + ends[i]);
    }
    // A name with its suffix may be that of another one: then both get theirs, once more.
    changed = false;
    const std::vector<bool> isRepeated = repeated(result);
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      if (isRepeated[i] && !suffixes[i].empty() && ends[i].size() + suffixes[i].size() <= longest)
      {
        ends[i] += suffixes[i];
        changed = true;
      }
    }
  }
  return result;
}
}
